#!/usr/bin/env bash
# Runs an input script for a matrix of values and seeds, several at a time, measures each run, and ends in
# tables. May be killed at any moment and started again with the same line. What it takes and what it writes:
# inputs/README.md, or
#
#   bash inputs/campaign.sh --help
set -euo pipefail
exec python3 -B "$(dirname "${BASH_SOURCE[0]}")/campaign/main.py" "$@"
