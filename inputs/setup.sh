# Set-up shared by inputs/quickstart.sh and tests/run.sh: packages, configuration, build.
# To be sourced. All functions work from the root of the repository.

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$repository/build
start_seconds=$SECONDS

build_packages=(build-essential cmake ninja-build ccache patch xz-utils ca-certificates
  openmpi-bin libopenmpi-dev libeigen3-dev libcli11-dev libfmt-dev nlohmann-json3-dev zlib1g-dev
  libcairo2-dev pkg-config libgtest-dev python3 python3-numpy)
vtk_packages=(libvtk9-dev)

# stage TEXT: says what begins now, and how long everything before took
stage() {
  printf '\n=== %s (%d:%02d since the start)\n' "$*" \
    $(((SECONDS - start_seconds) / 60)) $(((SECONDS - start_seconds) % 60))
}

# as_root COMMAND...
as_root() {
  if [[ $(id -u) -eq 0 ]]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "Root is needed for '$*', and sudo is missing: run it as root, then come back." >&2
    return 1
  fi
}

is_installed() {
  [[ $(dpkg-query --show --showformat='${Status}' "$1" 2>/dev/null) == *"ok installed" ]]
}

# install_missing_packages [CMAKE_OPTION...]: the options tell whether VTK is wanted
install_missing_packages() {
  local package
  local -a wanted=("${build_packages[@]}") missing=()
  if [[ " $* " != *" -DELLIPSOID_VTK=OFF "* ]]; then
    wanted+=("${vtk_packages[@]}")
  fi
  if ! command -v dpkg-query >/dev/null; then
    echo "This is no Debian system; these must be there already: ${wanted[*]}"
    return
  fi
  for package in "${wanted[@]}"; do
    is_installed "$package" || missing+=("$package")
  done
  if [[ ${#missing[@]} -eq 0 ]]; then
    echo "All ${#wanted[@]} packages are there; nothing to install."
    return
  fi
  echo "Installing with apt-get: ${missing[*]}"
  as_root apt-get update --quiet
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet --no-install-recommends "${missing[@]}"
}

# configure [CMAKE_OPTION...]
configure() {
  local -a generator=()
  if command -v ninja >/dev/null && [[ ! -f $build/CMakeCache.txt ]]; then
    generator=(-G Ninja)
  fi
  (cd "$repository" && cmake --preset release "${generator[@]}" "$@")
}

# build_targets TARGET...
build_targets() {
  cmake --build "$build" --parallel "$(nproc)" --target "$@"
}
