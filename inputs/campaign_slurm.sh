#!/usr/bin/env bash
# The matrix of inputs/campaign.sh as a Slurm job array, one run per task; the same options. Submit from the
# repository, for example
#
#   options=(--out out/campaign --surfaces "smooth 5" --seeds "1 2" -- -var particles 1000 -var dt 5e-6)
#   sbatch --array=0-$(($(bash inputs/campaign.sh --count "${options[@]}") - 1)) inputs/campaign_slurm.sh "${options[@]}"
#
# A task that was killed or ran out of time goes on where it stopped when it is submitted again. When all are
# finished, `bash inputs/campaign.sh "${options[@]}"` makes the tables.
#SBATCH --job-name=campaign
#SBATCH --ntasks=1
#SBATCH --time=24:00:00
#SBATCH --requeue
set -euo pipefail
cd "${SLURM_SUBMIT_DIR:-.}"
: "${SLURM_ARRAY_TASK_ID:?submit this with sbatch --array=0-N}"
[[ $# -gt 0 ]] || set -- --out out/campaign --surfaces "smooth 5" --seeds "1 2" -- -var particles 1000 -var dt 5e-6
exec bash inputs/campaign.sh --jobs 1 --only "$SLURM_ARRAY_TASK_ID" "$@"
