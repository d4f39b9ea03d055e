#!/usr/bin/env bash
# What a particle and a time step cost: all shapes side by side, as ratios to spheres.
#
#   bash tests/bench/run.sh                 everything, less than 20 minutes on an idle machine
#   bash tests/bench/run.sh --short         a minute or two
#   bash tests/bench/run.sh --help          cases, shapes, repeats, where time goes
#
# Needs a configured build folder `build`. Results: build/bench/table.md, table.csv and figures.csv.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(cd "$here/../.." && pwd)/build
python=$(sed -n 's/^ELLIPSOID_PYTHON:[A-Z]*=//p' "$build/CMakeCache.txt")

cmake --build "$build" --target liggghts ellipsoid-post >"$build/bench.log" || {
  tail "$build/bench.log" >&2
  exit 1
}
# Open MPI refuses to start as root or with more ranks than cores unless told to.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe PRTE_MCA_hwloc_default_binding_policy=none
export PYTHONDONTWRITEBYTECODE=1
exec "${python:-python3}" "$here/bench.py" --engine "$build/bin/liggghts" --out "$build/bench" "$@"
