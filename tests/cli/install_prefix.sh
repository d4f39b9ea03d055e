#!/usr/bin/env bash
# What `cmake --install` puts into a prefix works there, and is taken out again without a trace.
set -euo pipefail
prefix=$PWD/prefix
manifest=$ELLIPSOID_BUILD/install_manifest.txt

# the list of a true installation from this build is not to be lost
[[ ! -f $manifest ]] || cp "$manifest" true_manifest
give_back() {
  [[ ! -f true_manifest ]] || cp true_manifest "$manifest"
}
trap give_back EXIT

mkdir -p "$prefix/share/doc/other"
touch "$prefix/share/doc/other/file" # of another package
cmake --install "$ELLIPSOID_BUILD" --prefix "$prefix" >install.out

version=$(sed -n 's/.*package_version\[\] = "\(.*\)".*/\1/p' \
  "$ELLIPSOID_SOURCE/src_liggghts/kernel/math/package_version.h")
[[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]]
grep -qx "version: $version" "$ELLIPSOID_SOURCE/.github/CITATION.cff"
grep -qx "## $version" "$ELLIPSOID_SOURCE/src_liggghts/doc/CHANGELOG.md"

"$prefix/bin/liggghts" --version | tee engine.out
grep -qx "liggghts-ellipsoid $version" engine.out
grep -Eqx "host      LIGGGHTS-[A-Z]+ [0-9.]+ .*" engine.out
grep -Eqx "compiler  (g\+\+|clang\+\+) [0-9].*" engine.out
grep -Eqx "MPI       .*[0-9].*" engine.out
grep -Eqx "VTK       (none|[0-9].*)" engine.out
"$prefix/bin/ellipsoid-post" --version | tee tools.out
grep -qx "liggghts-ellipsoid $version" tools.out
"$prefix/bin/liggghts" -help -log none >help.out || true # the host's own exit status here is 1
grep -q -- "--version" help.out
[[ ! -e log.liggghts ]]

# a script from the folder where it was put; its mesh is found
(cd "$prefix/share/liggghts-ellipsoid" && "$prefix/bin/liggghts" -log none -in inputs/hopper.in \
  -var out "$PWD/../../../hopper" -var particles 5 -var fill 1e-4 -var flow 1e-4) >hopper.out
grep -q "^ERROR" hopper.out && exit 1

# the module file sets the paths of the prefix that it lies in
cat >read_module.tcl <<'TCL'
set ModulesCurrentModulefile [lindex $argv 0]
proc module-whatis {text} {}
proc conflict {name} {}
proc setenv {name value} { puts "$name=$value" }
proc prepend-path {name value} { puts "$name+=$value" }
source $ModulesCurrentModulefile
TCL
if command -v tclsh >/dev/null; then
  tclsh read_module.tcl "$prefix/share/modulefiles/liggghts-ellipsoid/$version" | tee module.out
  grep -qx "PATH+=$prefix/bin" module.out
  grep -qx "ELLIPSOID_BIN=$prefix/bin" module.out
else
  echo "no tclsh: the module file is not read"
fi

cmake -D "MANIFEST=$manifest" -P "$ELLIPSOID_SOURCE/.cmake/uninstall.cmake"
left=$(find "$prefix" -type f -printf '%P\n')
[[ $left == share/doc/other/file ]] || {
  echo "left after the uninstallation: $left"
  exit 1
}
[[ ! -e $prefix/share/liggghts-ellipsoid && ! -e $prefix/share/doc/liggghts-ellipsoid ]]
