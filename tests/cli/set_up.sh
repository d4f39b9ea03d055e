#!/usr/bin/env bash
# inputs/setup.sh with an apt that plays a machine with Debian's ParaView, one that fails, and one
# that has everything: what is installed, what is said, what goes to the log.
set -euo pipefail
mkdir -p tree/inputs stubs
cp "$ELLIPSOID_SOURCE/inputs/setup.sh" tree/inputs

# An apt-get that refuses VTK beside ParaView, in apt's own words, unless NO_CONFLICT is set; installs
# three packages, or fails where BROKEN is set. Nothing is installed according to dpkg-query.
cat >stubs/apt-get <<'STUB'
#!/bin/bash
echo "apt-get $*" >>"$CALLS"
if [[ $* == *libvtk9-dev* && -z $NO_CONFLICT ]]; then
  echo "The following packages have unmet dependencies:"
  echo " python3-paraview : Conflicts: python3-vtk9 but 9.1.0 is to be installed"
  echo "E: Error, pkgProblemResolver::Resolve generated breaks, this may be caused by held packages."
  exit 100
fi
[[ $* == *--simulate* || $* == update* ]] && exit
echo "0 upgraded, 3 newly installed, 0 to remove and 0 not upgraded."
for step in 1 2 3; do echo "Unpacking package-$step (1.0) ..."; done
[[ -z $BROKEN ]] || { echo "E: the disk is full"; exit 7; }
for step in 1 2 3; do echo "Setting up package-$step (1.0) ..."; done
STUB
printf '#!/bin/bash\nexit 1\n' >stubs/dpkg-query
printf '#!/bin/bash\n[[ $1 != --validate ]] || exit 0\nexec "$@"\n' >stubs/sudo
chmod +x stubs/*

# set_up [NAME=VALUE...] -- [CMAKE_OPTION...]: output to out.txt, the exit status to status
set_up() {
  local -a variables=()
  while [[ $1 != -- ]]; do
    variables+=("$1")
    shift
  done
  shift
  : >calls.txt
  status=0
  env PATH="$PWD/stubs:$PATH" CALLS="$PWD/calls.txt" NO_CONFLICT="" BROKEN="" "${variables[@]}" \
    bash -euo pipefail -c 'source tree/inputs/setup.sh; install_missing_packages "$@"
      echo "options: ${cmake_options[*]-}"' set_up "$@" >out.txt 2>&1 || status=$?
}

expect() {
  grep -Eq -- "$1" "$2" || {
    echo "'$1' is missing in $2:"
    cat "$2"
    exit 1
  }
}

echo "-- ParaView stands in the way: the build goes on without VTK"
set_up --
[[ $status -eq 0 ]]
expect "^VTK is left out: libvtk9-dev is refused by apt beside python3-paraview\..* remove python3-paraview" out.txt
expect "^options: -DELLIPSOID_VTK=OFF$" out.txt
expect "install .*--no-remove .* cmake" calls.txt
[[ $(grep -c "Unpacking" out.txt) -eq 0 && $(grep -c $'\r' out.txt) -eq 0 ]]
expect "^Unpacking package-3" tree/build/setup.log

echo "-- VTK was asked for: one line, and nothing is installed"
set_up -- -DELLIPSOID_VTK=ON
[[ $status -ne 0 ]]
expect "^VTK cannot be had: .*python3-paraview.*-DELLIPSOID_VTK=OFF" out.txt
[[ $(grep -cv -e --simulate -e update calls.txt) -eq 0 ]]

echo "-- VTK is not wanted, or nothing stands in the way"
set_up -- -DELLIPSOID_VTK=OFF
[[ $status -eq 0 && $(grep -c libvtk9 calls.txt) -eq 0 ]]
set_up NO_CONFLICT=1 --
[[ $status -eq 0 ]]
expect "^options: $" out.txt
expect "install .*--no-remove .*libvtk9-dev" calls.txt

echo "-- a failure: apt's last lines, and where all of it is"
set_up NO_CONFLICT=1 BROKEN=1 --
[[ $status -eq 7 ]]
expect "^E: the disk is full$" out.txt
expect "^Failed with exit status 7\. .*/tree/build/setup\.log$" out.txt

echo "-- progress on a terminal: one line that is written over"
if command -v script >/dev/null; then
  cat >slow.sh <<'SLOW'
source tree/inputs/setup.sh
slow() { for file in 1 2 3 4; do echo "[$file/4] Building CXX object"; sleep 0.6; done; }
quietly slow
SLOW
  env -u CI script --quiet --command "bash -euo pipefail slow.sh" /dev/null >terminal.txt
  expect $'\r.*file [234] of 4, 0:0[1-9]' terminal.txt
  [[ $(grep -c "Building" terminal.txt) -eq 0 ]]
fi
echo "passed"
