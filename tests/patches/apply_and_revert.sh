# The series applies, reverts to the pristine tree, may be repeated, recognises what is in
# already, and refuses what it is not made for without changing anything.
source "$ELLIPSOID_SOURCE/tests/patches/_assert.sh"
apply=(bash "$ELLIPSOID_SOURCE/patches/apply.sh")
mapfile -t series < <(ls "$ELLIPSOID_SOURCE"/patches/*.patch)

same() {
  diff -r "$1" "$2" || fail "$1 and $2 differ: $3"
}

fresh_tree tree
if grep -q 'numneigh > 0' tree/src/finish.cpp; then
  echo "-- apply, repeat, revert, repeat"
  "${apply[@]}" apply tree
  touched=$({ diff -rq "$pristine" tree || true; } | wc -l)
  patched_files=$(cat "${series[@]}" | grep '^+++ ' | sort -u | wc -l)
  [[ $touched -eq $patched_files ]] || fail "$touched files changed, the series has $patched_files"
  cp -r tree applied_once
  for _ in "${series[@]}"; do
    expect_output "already in \(applied\): 0001" "${apply[@]}" apply tree
  done
  same applied_once tree "a second call changed something"
  [[ $("${apply[@]}" status tree | grep -c '^applied: ') -eq ${#series[@]} ]] || fail "status"
  "${apply[@]}" revert tree
  same "$pristine" tree "revert does not give the pristine tree back"
  expect_output "not in: 0001" "${apply[@]}" revert tree
  same "$pristine" tree "a second revert changed something"

  echo "-- one patch is in already"
  patch --quiet --fuzz=0 -p1 -d tree <"${series[1]}"
  expect_output "already in \(applied\): 0002" "${apply[@]}" apply tree
  same applied_once tree "applying the rest gives another tree"

  echo "-- one kind only"
  fresh_tree compiling
  "${apply[@]}" apply compiling compile
  "${apply[@]}" revert compiling
  same "$pristine" compiling "compile fixes do not revert"
fi

echo "-- the two lines are mended as in the newest public tree"
fresh_tree mended
mend_as_upstream mended
cp -r mended mended_before
expect_output "already in \(mended\): 0001" "${apply[@]}" apply mended compile
expect_output "mended: 0002" "${apply[@]}" status mended
same mended_before mended "mended lines were touched"
"${apply[@]}" revert mended
same mended_before mended "revert touched lines that are not from a patch"

echo "-- a tree in which a patch does not fit is refused and left alone"
fresh_tree changed
sed -i 's/numneigh > 0)/numneigh  > 0)/; s/numneigh)/numneigh  )/' changed/src/finish.cpp
cp -r changed changed_before
expect_refusal "0002.* does not fit" "${apply[@]}" apply changed
same changed_before changed "a refused series changed something"

echo "-- wrong trees"
expect_refusal "is no LIGGGHTS source tree" "${apply[@]}" apply "$ELLIPSOID_SOURCE"
fresh_tree wrong
echo 3.7.0 >wrong/src/version_liggghts.txt
expect_refusal "version '3.7.0', expected 3.8.0" "${apply[@]}" apply wrong
fresh_tree wrong
rm wrong/src/pair_gran_proxy.h
expect_refusal "lacks src/pair_gran_proxy.h" "${apply[@]}" apply wrong
expect_refusal "unknown command 'undo'" "${apply[@]}" undo tree
echo "passed"
