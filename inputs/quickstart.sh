#!/usr/bin/env bash
# From a fresh clone to a small pile and its figures: installs what is missing, builds, runs
# inputs/piling.in, and post-processes it. A second call builds nothing again.
#
#   bash inputs/quickstart.sh [CMAKE_OPTION...]
set -euo pipefail
# shellcheck source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

readonly particles=100 time_step=5e-6
output=$repository/out/quickstart

run_piling() {
  mkdir -p "$output"
  "$build/bin/liggghts" -log "$output/log.liggghts" -in "$repository/inputs/piling.in" \
    -var particles "$particles" -var dt "$time_step" -var out "$output"
}

post_process() {
  "$build/bin/ellipsoid-post" pile "$output"/*.dump --picture "$output/pile.svg"
}

say_what_next() {
  cat <<TEXT

Where everything is
  engine, tools   $build/bin
  this run        $output  (log.liggghts, dumps for text tools and for ParaView, picture)
  input script    $repository/inputs/piling.in  (its header explains every variable)

What to try next
  another seed    build/bin/liggghts -in inputs/piling.in -var seed 2 -var out out/seed2
  on 2 cores      mpirun -np 2 build/bin/liggghts -in inputs/piling.in -var out out/two
  more figures    build/bin/ellipsoid-post --help
  all tests       bash tests/run.sh
TEXT
}

stage "1/5 Packages"
install_missing_packages "$@"
stage "2/5 Configuring; LIGGGHTS is fetched the first time"
configure "$@"
stage "3/5 Building the engine and the tools"
build_targets liggghts ellipsoid-post
stage "4/5 Running a pile of $particles particles, about a minute"
run_piling
stage "5/5 Angle of repose, porosity, coordination number, picture"
post_process
say_what_next
stage "Done"
