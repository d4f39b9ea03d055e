#!/usr/bin/env bash
# A small campaign that is killed on the way and started again gives the same figures, to the last
# digit, as one that was left alone.
set -euo pipefail
variables=(-var particles 60 -var y0 0.04 -var dt 1e-5 -var settle 1.2 -var dump_time 0.5
  -var restart_time 0.05 -var vtk no)
rest=270000 # step at which the particles lie on each other
matrix=(--surfaces "smooth 5" --seeds "1 2")

campaign() {
  bash "$ELLIPSOID_SOURCE/inputs/campaign.sh" --out "$1" "${matrix[@]}" --jobs 2 -- "${variables[@]}"
}

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# newest_step FOLDER: of its restart files, which end with length, step and checksum
newest_step() {
  local newest=0 step
  for file in "$1"/restart.1 "$1"/restart.2; do
    [[ -s $file ]] || continue
    step=$(tail -c 16 "$file" | od -A n -t d8 -N 8)
    [[ $step -le $newest ]] || newest=$((step))
  done
  echo "$newest"
}

echo "--- left alone"
campaign alone
[[ -s alone/report.html && -s alone/summary.csv ]] || fail "no report"
grep -q "LIGGGHTS (Version .*liggghts-ellipsoid" alone/report.html ||
  fail "the report does not name the engine's version"

echo "--- killed"
setsid bash "$ELLIPSOID_SOURCE/inputs/campaign.sh" --out killed "${matrix[@]}" --jobs 2 -- \
  "${variables[@]}" >killed.out 2>&1 &
campaign_group=$!
for _ in $(seq 12000); do
  [[ $(newest_step killed/smooth_seed1) -lt $rest ]] || break
  sleep 0.02
done
kill -KILL -- "-$campaign_group"
wait "$campaign_group" 2>/dev/null || true
[[ ! -e killed/smooth_seed1/pile.csv ]] || fail "the run was over before it could be killed"

echo "--- resumed"
campaign killed
for run in smooth_seed1 smooth_seed2 ms5_seed1 ms5_seed2; do
  # all columns but the first, which is the name of the run
  cmp <(cut -d, -f2- "alone/$run/pile.csv") <(cut -d, -f2- "killed/$run/pile.csv") ||
    fail "$run differs"
done

# the first line of the resumed run: step, time, particles, two energies, pairs that touch
read -r step _ _ _ _ pairs _ < <(awk '/^ *Step / { getline; first = $0 } END { print first }' \
  killed/smooth_seed1/log.piling)
echo "smooth_seed1 went on from step $step with $pairs pairs in contact"
[[ $step -ge $rest && $pairs -gt 0 ]] || fail "no contact at the interruption"

echo "--- interrupted politely: the engine ends with status 0, the run is not measured"
one=(--surfaces smooth --seeds 1)
setsid bash "$ELLIPSOID_SOURCE/inputs/campaign.sh" --out polite "${one[@]}" --jobs 1 -- \
  "${variables[@]}" >polite.out 2>&1 &
polite_group=$!
for _ in $(seq 12000); do
  [[ $(newest_step polite/smooth_seed1) -lt 60000 ]] || break # there is a frame with particles
  sleep 0.02
done
pkill -TERM --pgroup "$polite_group" -x liggghts || fail "the run was over before it could be interrupted"
if wait "$polite_group"; then
  fail "an interrupted run counts as finished"
fi
grep -q "smooth_seed1: interrupted before its end" polite.out || fail "nothing is said: $(cat polite.out)"
[[ ! -e polite/smooth_seed1/pile.csv && ! -e polite/report.html ]] || fail "it was measured"
"$ELLIPSOID_BIN/ellipsoid-post" pile --one-run polite/smooth_seed1/pile.*.dump --csv early.csv --quiet \
  2>message || true
grep -q "the run is not complete: .* reached step" message || fail "pile does not say it: $(cat message)"
bash "$ELLIPSOID_SOURCE/inputs/campaign.sh" --out polite "${one[@]}" --jobs 1 -- "${variables[@]}"
cmp <(cut -d, -f2- alone/smooth_seed1/pile.csv) <(cut -d, -f2- polite/smooth_seed1/pile.csv) ||
  fail "the interrupted run differs"

echo "--- wrong use"
for wrong in "a b" 'a$(touch executed)' 'a;b' "a'b"; do
  if bash "$ELLIPSOID_SOURCE/inputs/campaign.sh" --out "$wrong" "${one[@]}" >/dev/null 2>message; then
    fail "the path '$wrong' was accepted"
  fi
  [[ $(wc -l <message) -eq 1 ]] && grep -q "the path '.*' has blanks or signs" message ||
    fail "no word of the path: $(cat message)"
done
[[ ! -e executed ]] || fail "a path was executed"
if (cd "$ELLIPSOID_SOURCE/inputs" && "$ELLIPSOID_BIN/liggghts" -in piling.in -log none \
  -var out "$OLDPWD/a b" >"$OLDPWD/message" 2>&1); then
  fail "the engine took a path with a blank"
fi
grep -q "make_folder takes one path without blanks" message || fail "the reason is not said: $(cat message)"
"$ELLIPSOID_BIN/liggghts" -in "$ELLIPSOID_SOURCE/inputs/piling.in" -log none -screen none "${variables[@]}" \
  -var particles 1 -var settle 1e-4 -var interval 1e-4 -var out 'x;echo>executed' >message 2>&1 ||
  true
[[ ! -e executed ]] || fail "the engine executed a path"
if bash "$ELLIPSOID_SOURCE/inputs/campaign.sh" --out x --surfaces round 2>message; then
  fail "a wrong surface was accepted"
fi
grep -q "surface 'round' is neither" message || fail "the message does not say what is wrong"
for wrong in 4 3.5 0; do
  if bash "$ELLIPSOID_SOURCE/inputs/campaign.sh" --out x --surfaces "smooth $wrong" 2>message; then
    fail "surface $wrong was accepted"
  fi
  grep -q "surface '$wrong' is neither .* odd" message || fail "no word of the odd number"
done
if bash "$ELLIPSOID_SOURCE/inputs/campaign.sh" --out x --surfaces "smooth 5" --seeds 7 --jobs 2 -- \
  -var dt -1 >broken.out 2>message; then
  fail "a campaign whose runs stop was a success"
fi
grep -q "2 of the 2 runs did not finish" message || fail "stopped runs are counted wrongly: $(cat message)"
[[ $(grep -c "^    ERROR" broken.out) -eq 2 ]] || fail "the engine's message is not shown"
echo "passed"
