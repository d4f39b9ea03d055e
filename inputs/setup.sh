# shellcheck shell=bash
# Set-up shared by inputs/quickstart.sh and tests/run.sh: packages, configuration, build.
# To be sourced. All functions work from the root of the repository.

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case $repository in
  *[[:space:]\'\"\`\$\\\;\&\|\<\>\(\)\*\?\#\!]*)
    echo "The path of this clone, '$repository', has blanks or signs that the host's build cannot use: move it." >&2
    exit 1
    ;;
esac
build=$repository/build
start_seconds=$SECONDS
setup_log=$build/setup.log # what package managers and compilers say
mkdir -p "$build"
: >"$setup_log"
cmake_options=() # those that the machine calls for

wanted_packages=(build-essential cmake ninja-build ccache patch xz-utils ca-certificates
  openmpi-bin libopenmpi-dev libeigen3-dev libcli11-dev libfmt-dev nlohmann-json3-dev zlib1g-dev
  libbz2-dev liblzma-dev libzstd-dev
  libcairo2-dev libnanoflann-dev voro++-dev pkg-config libgtest-dev python3 python3-numpy)
vtk_packages=(libvtk9-dev)

# seconds_text SECONDS: as minutes:seconds
seconds_text() {
  printf '%d:%02d' $(($1 / 60)) $(($1 % 60))
}

# stage TEXT: says what begins now, and how long everything before took
stage() {
  printf '\n=== %s (%s since the start)\n' "$*" "$(seconds_text $((SECONDS - start_seconds)))"
}

# as_root COMMAND...
as_root() {
  if [[ $(id -u) -eq 0 ]]; then
    "$@"
  else
    sudo "$@"
  fi
}

# need_root PACKAGE...: asks for sudo's password now, where the question can be seen
need_root() {
  if [[ $(id -u) -ne 0 ]] && ! { command -v sudo >/dev/null && sudo --validate; }; then
    echo "Packages are missing, and only root can install them; have this run, then come back:" \
      "apt-get install --no-install-recommends $*" >&2
    return 1
  fi
}

is_installed() {
  [[ $(dpkg-query --show --showformat='${Status}' "$1" 2>/dev/null) == *"ok installed" ]]
}

# progress_of LINE: sets `progress` where a line of apt-get, CMake, Ninja or make tells how far it is
progress_of() {
  case $1 in
    *" newly installed, "*)
      [[ $1 =~ ([0-9]+)" upgraded, "([0-9]+)" newly" ]] &&
        package_count=$((BASH_REMATCH[1] + BASH_REMATCH[2]))
      ;;
    Get:*) [[ $1 =~ ^Get:([0-9]+) ]] && progress="fetched ${BASH_REMATCH[1]} of $package_count" ;;
    "Unpacking "*) progress="package $((unpacked += 1)) of $package_count unpacked" ;;
    "Setting up "*) progress="package $((set_up += 1)) of $package_count set up" ;;
    "-- "*) progress=${1#-- } ;;
    "["*) [[ $1 =~ ^\[([0-9]+)/([0-9]+)\] ]] &&
      progress="file ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}" ||
      [[ ! $1 =~ ^\[\ *([0-9]+%)\] ]] || progress=${BASH_REMATCH[1]} ;;
  esac
}

# show_progress: one line that is written over and over on a terminal, else a line every 30 s
show_progress() {
  local line rest="" progress="begun" package_count="?" unpacked=0 set_up=0 status
  local began=$SECONDS shown=$SECONDS on_terminal=""
  [[ -t 1 && -z ${CI-} ]] && on_terminal=yes
  while true; do
    status=0
    IFS= read -r -t 1 line || status=$?
    rest+=$line
    if [[ $status -eq 0 ]]; then
      progress_of "$rest" || true
      rest=""
    elif [[ $status -le 128 ]]; then # end of the input, no timeout
      break
    fi
    if [[ $on_terminal && $SECONDS -gt $shown ]]; then
      printf '\r\033[K  %.90s, %s' "$progress" "$(seconds_text $((SECONDS - began)))"
      shown=$SECONDS
    elif [[ $((SECONDS - shown)) -ge 30 ]]; then
      printf '  %s, %s\n' "$progress" "$(seconds_text $((SECONDS - began)))"
      shown=$SECONDS
    fi
  done
  [[ -z $on_terminal ]] || printf '\r\033[K'
  printf '  %.90s, %s\n' "$progress" "$(seconds_text $((SECONDS - began)))"
}

# quietly COMMAND...: what it prints goes to the log; after a failure its last lines are shown
quietly() {
  local before status
  mkdir -p "$build"
  printf '\n##### %s\n' "$*" >>"$setup_log"
  before=$(wc -l <"$setup_log")
  status=0
  "$@" 2>&1 </dev/null | tee -a "$setup_log" | show_progress || status=${PIPESTATUS[0]}
  if [[ $status -ne 0 ]]; then
    tail -n "+$((before + 1))" "$setup_log" | tail -n 30 >&2
    printf 'Failed with exit status %d. The last lines are above; all of it: %s\n' \
      "$status" "$setup_log" >&2
  fi
  return "$status"
}

# apt_can_install PACKAGE...: can they be installed, with nothing else removed for them?
apt_can_install() {
  apt-get --simulate --no-remove --no-install-recommends install "$@" >>"$setup_log" 2>&1
}

# what_bars PACKAGE...: the installed packages that would have to go, or that apt names in its refusal
what_bars() {
  { LC_ALL=C apt-get --simulate --yes --no-install-recommends install "$@" 2>&1 || true; } |
    sed -n -E 's/^Remv ([^ ]+).*/\1/p; s/^ *([^ :]+) : (Conflicts|Breaks): .*/\1/p' |
    sort -u | paste --serial --delimiters=' '
}

# vtk_or_without VALUE PACKAGE...: VALUE of -DELLIPSOID_VTK, packages that are installed with it. Where VTK's packages
# conflict with what is installed, one line says so, and the build goes on without VTK unless it was asked for.
vtk_or_without() {
  local vtk_option=$1 barring
  shift
  if apt_can_install "$@" "${vtk_packages[@]}" || { [[ $# -gt 0 ]] && ! apt_can_install "$@"; }; then
    return # what apt then says is not about VTK
  fi
  barring=$(what_bars "$@" "${vtk_packages[@]}")
  barring=${barring:-some package that is installed here}
  if [[ $vtk_option == ON ]]; then
    echo "VTK cannot be had: ${vtk_packages[*]} is refused by apt beside $barring: remove that, or" \
      "leave VTK out with -DELLIPSOID_VTK=OFF." >&2
    return 1
  fi
  cmake_options+=(-DELLIPSOID_VTK=OFF)
  echo "VTK is left out: ${vtk_packages[*]} is refused by apt beside $barring. The engine then" \
    "writes no VTK files; to have them, remove $barring and run this again."
}

# option_value NAME CMAKE_OPTION...: the value of the last -DNAME=VALUE
option_value() {
  local option value=""
  for option in "${@:2}"; do
    [[ $option != "-D$1="* ]] || value=${option#*=}
  done
  echo "$value"
}

missing_of() {
  local package
  for package in "$@"; do
    is_installed "$package" || echo "$package"
  done
}

# install_missing_packages [CMAKE_OPTION...]: the options tell whether VTK is wanted
install_missing_packages() {
  local vtk_option
  local -a missing missing_vtk=()
  vtk_option=$(option_value ELLIPSOID_VTK "$@")
  [[ $vtk_option == OFF ]] || missing_vtk=("${vtk_packages[@]}")
  if ! command -v dpkg-query >/dev/null; then
    echo "This is no Debian system; these must be there already:" \
      "${wanted_packages[*]} ${missing_vtk[*]-}"
    return
  fi
  mapfile -t missing < <(missing_of "${wanted_packages[@]}")
  mapfile -t missing_vtk < <(missing_of ${missing_vtk[@]+"${missing_vtk[@]}"})
  if [[ ${#missing[@]} -eq 0 && ${#missing_vtk[@]} -eq 0 ]]; then
    echo "All packages are there; nothing to install."
    return
  fi
  need_root "${missing[@]}" "${missing_vtk[@]}"
  quietly as_root apt-get update
  if [[ ${#missing_vtk[@]} -gt 0 ]]; then
    vtk_or_without "$vtk_option" "${missing[@]}"
    [[ $(option_value ELLIPSOID_VTK "${cmake_options[@]}") == OFF ]] || missing+=("${missing_vtk[@]}")
  fi
  [[ ${#missing[@]} -gt 0 ]] || return 0
  echo "Installing with apt-get: ${missing[*]}"
  quietly as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-remove --no-install-recommends "${missing[@]}"
}

# configure [CMAKE_OPTION...]
configure() {
  if command -v ninja >/dev/null && [[ ! -f $build/CMakeCache.txt ]]; then
    cmake_options+=(-G Ninja)
  fi
  if [[ -n ${CI-} ]]; then # developers hear of a new warning before users do
    cmake_options+=(-DELLIPSOID_WARNINGS_AS_ERRORS=ON)
  fi
  (cd "$repository" && quietly cmake --preset release "${cmake_options[@]}" "$@")
}

# build_targets TARGET...
build_targets() {
  quietly cmake --build "$build" --parallel "$(nproc)" --target "$@"
}
