#!/usr/bin/env bash
# Multi-spheres as rough grains: which friction a smooth ellipsoid needs to resist shear as a multi-sphere does. Runs
# shear.in for the list inputs/roughness/runs.txt by campaign.sh, then takes means, differences and a picture of all runs
# that are finished. May be killed at any moment and started again with the same line.
#
#   bash inputs/roughness.sh FOLDER               runs, tables and picture in FOLDER
#   bash inputs/roughness.sh FOLDER --means       tables and picture of the runs that are finished, nothing run
#   bash inputs/roughness.sh FOLDER --piles       piles of piling.in for the list inputs/roughness/piles.txt, their table
#   bash inputs/roughness.sh --kept [FOLDER]      the tables of the runs kept in inputs/results/roughness, picture in FOLDER
set -euo pipefail
inputs="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
folder=${1:?give a folder for the results, or --kept}
for python in python3 /usr/bin/python3; do # the first one that has numpy
  if "$python" -c "import numpy" 2>/dev/null; then
    break
  fi
done
if [[ ${2-} == --piles ]]; then
  bash "$inputs/campaign.sh" --out "$folder" --list "$inputs/roughness/piles.txt" --jobs 1 -- \
    -var particles 100 -var y0 0.05 -var settle 2 -var E 5e6 -var dt 2.5e-5 -var vtk no
elif [[ $folder != --kept && ${2-} != --means ]]; then
  bash "$inputs/campaign.sh" --out "$folder" --input "$inputs/shear.in" --list "$inputs/roughness/runs.txt" --jobs 1 -- \
    -var aspect 2.35 -var particles 150 -var inertial 0.05 -var strain 5 -var every 200
fi
exec "$python" -B "$inputs/roughness/means.py" "$folder" ${2+"$2"}
