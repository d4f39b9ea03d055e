#!/usr/bin/env bash
# One script of inputs/ under Slurm, on several cores. Submit from the repository; what follows the name
# of this file goes to liggghts:
#
#   sbatch --ntasks=4 inputs/batch_slurm.sh -in inputs/mixture.in -var particles 5000 -var out out/mixture
#
# What one should see: slurm-NUMBER.out with the thermo output, results in the folder of `-var out`.
# Without Slurm, `bash inputs/batch_slurm.sh -in ...` runs the same on two cores.
#
# Lines to change: the time limit, the number of tasks (a rank per 500 to 1000 particles and more pays
# off), the place of the engine. A long run should write restart files (see inputs/restart.in);
# --requeue starts the same command again when a node is lost.
# For many runs of the piling problem use inputs/campaign_slurm.sh.
#SBATCH --job-name=ellipsoids
#SBATCH --ntasks=2
#SBATCH --cpus-per-task=1
#SBATCH --time=12:00:00
#SBATCH --output=slurm-%j.out
#SBATCH --requeue
set -euo pipefail
cd "${SLURM_SUBMIT_DIR:-.}"
engine=${ELLIPSOID_BIN:-build/bin}/liggghts
if [[ $# -eq 0 || ! -x $engine ]]; then
  echo "batch_slurm.sh: wanted are the engine '$engine' (build it, or set ELLIPSOID_BIN to its folder)" \
    "and its arguments, such as -in inputs/mixture.in" >&2
  exit 2
fi
exec mpirun -np "${SLURM_NTASKS:-2}" "$engine" "$@"
