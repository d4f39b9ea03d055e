#!/usr/bin/env bash
# The matrix of inputs/campaign.sh as a Slurm job array, one run per task. Submit from the repository:
#
#   sbatch --array=0-3 inputs/campaign_slurm.sh            (4 runs: 2 surfaces x 2 seeds)
#
# A task that was killed or ran out of time goes on where it stopped when it is submitted again. When
# all are finished, the same `bash inputs/campaign.sh` line without --only makes the report.
#SBATCH --job-name=piling
#SBATCH --ntasks=1
#SBATCH --time=24:00:00
#SBATCH --requeue
set -euo pipefail
cd "${SLURM_SUBMIT_DIR:-.}"
: "${SLURM_ARRAY_TASK_ID:?submit this with sbatch --array=0-N}"
exec bash inputs/campaign.sh --out out/campaign --surfaces "smooth 5" --seeds "1 2" --jobs 1 \
  --only "$SLURM_ARRAY_TASK_ID" -- -var particles 1000 -var dt 5e-6
