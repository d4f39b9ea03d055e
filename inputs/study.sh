#!/usr/bin/env bash
# The paper's study from the runs that are kept in inputs/results: table of the runs, means with confidence
# intervals, figures 10 to 15, the line's fit and the porosity read in other ways, the paper's statements tested.
#
#   bash inputs/study.sh                      figures into inputs/results/study, tables into src_liggghts/doc/study.md
#   bash inputs/study.sh --out FOLDER         all of it into another folder
#   bash inputs/study.sh --add FOLDER --commit HASH     takes finished runs of campaign.sh into inputs/results first
set -euo pipefail
# the first python3 that has numpy: a user's own one in front of the path may lack it
for python in python3 /usr/bin/python3; do
  if "$python" -c "import numpy" 2>/dev/null; then
    break
  fi
done
exec "$python" -B "$(dirname "${BASH_SOURCE[0]}")/study/main.py" "$@"
