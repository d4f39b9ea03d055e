#!/usr/bin/env bash
# From a fresh clone to a small pile and its figures: installs what is missing, builds, runs
# inputs/piling.in, and post-processes it. A second call builds nothing again.
#
#   bash inputs/quickstart.sh [CMAKE_OPTION...]
set -euo pipefail
# shellcheck source=setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# a tenth of the paper's pile, dropped from a third of its height: comes to rest within a minute
readonly particles=100 drop_height=0.05 settling_time=3 time_step=5e-6
output=$repository/out/quickstart

run_piling() {
  local vtk=no
  if grep -q '^ELLIPSOID_VTK:BOOL=ON$' "$build/CMakeCache.txt"; then
    vtk=yes
  fi
  rm -rf "$output"
  mkdir -p "$output"
  # run where the host's own log file does not disturb: in the output folder
  (cd "$output" && "$build/bin/liggghts" -in "$repository/inputs/piling.in" -var out "$output" \
    -var particles "$particles" -var y0 "$drop_height" -var settle "$settling_time" \
    -var dt "$time_step" -var vtk "$vtk" -var dump_time 0.5 -var thermo_time 0.5)
}

post_process() {
  "$build/bin/ellipsoid-post" pile --one-run "$output"/pile.*.dump --csv "$output/pile.csv" \
    --picture "$output/pile.png"
}

say_what_next() {
  cat <<TEXT

Where everything is
  engine, tools   $build/bin
  this run        $output  (log.piling, pile.*.dump, pile.csv, pile.png)
  input script    $repository/inputs/piling.in  (its header explains every variable)

What to try next
  another seed    build/bin/liggghts -in inputs/piling.in -var seed 2 -var particles 100 -var y0 0.05 -var settle 3 -var dt 5e-6 -var out out/seed2
  multi-spheres   the same with  -var surface multisphere -var subspheres 5
  the paper's     build/bin/liggghts -in inputs/piling.in -var dt 5e-6 -var out out/paper   (1000 particles, about 20 minutes)
  many piles      bash inputs/campaign.sh --out out/campaign --seeds "1 2 3" -- -var particles 100 -var y0 0.05 -var settle 3 -var dt 5e-6
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
