#!/usr/bin/env bash
# Runs inputs/piling.in for a matrix of surfaces and seeds, several at a time, and ends in a report.
#
#   bash inputs/campaign.sh --out DIR [--surfaces "smooth 5 17"] [--seeds "1 2 3"] [--jobs N]
#                           [--only K] [-- -var NAME VALUE ...]
#
#   --surfaces  "smooth", or the number N of sub-spheres of multi-sphere particles; default: smooth 5
#   --seeds     default: 1 2
#   --jobs      runs at a time; default: the number of processors
#   --only K    only run number K (from 0) of the matrix, without the report: for job arrays
#   after --    variables of inputs/piling.in for all runs, for example -var particles 1000 -var dt 5e-6
#
# May be killed at any moment and started again: finished runs are kept, the others go on from their
# last restart file. Each run has a folder DIR/SURFACE_seedS with all that piling.in writes there. Only
# runs that came to their end are measured: the engine ends with status 0 after SIGTERM and Ctrl-C too,
# but its last restart file, restart.end, is only there at the end.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
engine=${ELLIPSOID_BIN:-$repository/build/bin}/liggghts
tools=${ELLIPSOID_BIN:-$repository/build/bin}/ellipsoid-post
out="" surfaces="smooth 5" seeds="1 2" jobs=$(nproc) only=""
variables=()

fail() {
  echo "campaign.sh: $*" >&2
  exit 2
}

while [[ $# -gt 0 ]]; do
  [[ $1 == -- || $# -ge 2 ]] || fail "option '$1' lacks its value; see the head of this file"
  case $1 in
    --out) out=$2 ;;
    --surfaces) surfaces=$2 ;;
    --seeds) seeds=$2 ;;
    --jobs) jobs=$2 ;;
    --only) only=$2 ;;
    --)
      shift
      variables=("$@")
      break
      ;;
    *) fail "unknown option '$1', allowed are --out, --surfaces, --seeds, --jobs, --only, --" ;;
  esac
  shift 2
done
[[ -n $out ]] || fail "option --out is missing; say where the results go"
[[ $jobs =~ ^[1-9][0-9]*$ ]] || fail "--jobs is '$jobs', allowed is an integer > 0"
[[ -x $engine ]] || fail "there is no engine at $engine; build it (bash inputs/quickstart.sh)"
# safe PATH: what the engine's scripts can use as a name
safe() {
  [[ $1 =~ ^[A-Za-z0-9._/+,:=@%~^-]+$ ]] ||
    fail "the path '$1' has blanks or signs that the engine's scripts cannot use; choose letters, digits and . _ / + , : = @ % ~ ^ - only"
}
safe "$out"
case $out in
  /*) ;;
  *) safe "$PWD/$out" ;;
esac
mkdir -p "$out"
out=$(cd "$out" && pwd)

matrix=()
for surface in $surfaces; do
  [[ $surface == smooth || $surface =~ ^[0-9]*[13579]$ ]] ||
    fail "surface '$surface' is neither 'smooth' nor an odd number of sub-spheres; correct --surfaces"
  for seed in $seeds; do
    [[ $seed =~ ^[1-9][0-9]*$ ]] || fail "seed '$seed' is no integer > 0; correct --seeds"
    matrix+=("$surface $seed")
  done
done
if [[ -n $only ]]; then
  [[ $only =~ ^[0-9]+$ && $only -lt ${#matrix[@]} ]] ||
    fail "--only is '$only', allowed is 0 to $((${#matrix[@]} - 1))"
  matrix=("${matrix[$only]}")
fi

# folder_of SURFACE SEED: the run's folder
folder_of() {
  if [[ $1 == smooth ]]; then
    echo "$out/smooth_seed$2"
  else
    echo "$out/ms$1_seed$2"
  fi
}

# finished_runs: how many runs of the matrix have their figures
finished_runs() {
  local entry count=0
  for entry in "${matrix[@]}"; do
    # shellcheck disable=SC2086 # surface and seed are two words
    [[ ! -s $(folder_of $entry)/pile.csv ]] || count=$((count + 1))
  done
  echo "$count"
}

# newest_restart FOLDER: the younger one of the two restart files that the run writes in turn
newest_restart() {
  local newest=""
  for file in "$1"/restart.1 "$1"/restart.2; do
    if [[ -s $file && (-z $newest || $file -nt $newest) ]]; then
      newest=$file
    fi
  done
  echo "$newest"
}

# run_one SURFACE SEED: one run, from wherever it stopped, and its figures
run_one() {
  local surface=$1 seed=$2 name folder restart started=$SECONDS
  folder=$(folder_of "$surface" "$seed")
  name=$(basename "$folder")
  if [[ -s $folder/pile.csv ]]; then
    echo "  $name: was finished before"
    return
  fi
  mkdir -p "$folder"
  # piling.in appends to its log: which engine ran comes first, for the report
  if [[ ! -e $folder/log.piling ]]; then
    { "$engine" -help 2>/dev/null </dev/null || true; } | sed -n 1p >"$folder/log.piling"
  fi
  local -a arguments=(-var seed "$seed" -var out "$folder")
  if [[ $surface != smooth ]]; then
    arguments+=(-var surface multisphere -var subspheres "$surface")
  fi
  # the younger restart file may be cut off when the run was killed: then the older one serves
  local -a starts=()
  restart=$(newest_restart "$folder")
  if [[ -n $restart ]]; then
    starts+=("$restart")
    local older=$folder/restart.1
    [[ $restart != "$older" ]] || older=$folder/restart.2
    [[ ! -s $older ]] || starts+=("$older")
  fi
  starts+=("")
  local start
  rm -f "$folder/restart.end"
  for start in "${starts[@]}"; do
    local -a from=()
    [[ -z $start ]] || from=(-var go_on yes -var restart_from "$start")
    if (cd "$folder" && "$engine" -in "$repository/inputs/piling.in" -log none -screen none \
      "${arguments[@]}" "${from[@]}" ${variables[@]+"${variables[@]}"}) \
      >>"$folder/output" 2>&1 </dev/null; then
      if [[ ! -s $folder/restart.end ]]; then
        echo "  $name: interrupted before its end; the same line goes on with it"
        return 1
      fi
      "$tools" pile --one-run "$folder"/pile.*.dump --quiet --csv "$folder/pile.csv.part" \
        --picture "$folder/pile.svg" >>"$folder/output" 2>&1
      mv "$folder/pile.csv.part" "$folder/pile.csv"
      echo "  $name: finished after $((SECONDS - started)) s"
      return
    fi
    echo "  $name: stopped${start:+ when going on from $(basename "$start")}; see $folder/log.piling and output"
    { grep -h '^ERROR' "$folder/log.piling" "$folder/output" || true; } | tail -n 1 | sed 's/^/    /'
  done
  return 1
}

say_progress() {
  local finished seconds=$((SECONDS - begin)) left=""
  finished=$(finished_runs)
  local fresh=$((finished - finished_before))
  if [[ $fresh -gt 0 ]]; then
    left=", about $((seconds * (${#matrix[@]} - finished) / fresh)) s left"
  fi
  echo "  $finished of ${#matrix[@]} runs finished, ${seconds} s$left"
}

begin=$SECONDS
finished_before=$(finished_runs)
echo "=== ${#matrix[@]} runs, $jobs at a time, in $out"
for entry in "${matrix[@]}"; do
  while [[ $(jobs -rp | wc -l) -ge $jobs ]]; do
    wait -n || true
    say_progress
  done
  read -r surface seed <<<"$entry"
  run_one "$surface" "$seed" &
done
while [[ -n $(jobs -rp) ]]; do
  wait -n || true
  say_progress
done
missing=$((${#matrix[@]} - $(finished_runs)))
[[ $missing -eq 0 ]] || fail "$missing of the ${#matrix[@]} runs did not finish"
[[ -z $only ]] || exit 0

echo "=== Means and margins"
"$tools" summary "$out"/*/pile.csv --csv "$out/summary.csv"
echo "=== Report"
final_frames=()
for entry in "${matrix[@]}"; do
  # shellcheck disable=SC2086 # surface and seed are two words
  folder=$(folder_of $entry)
  final_frames+=("$(printf '%s\n' "$folder"/pile.*.dump | sort | tail -n 1)")
done
"$tools" report --each-file "${final_frames[@]}" --output "$out/report.html" --quiet
echo "$out/report.html"
