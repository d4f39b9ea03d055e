# The series applies, reverts to the pristine tree, may be repeated, recognises what is in already,
# and refuses what it is not made for without changing anything: on the host of this build, and on
# small made trees that look like each of the known ones.
source "$ELLIPSOID_SOURCE/tests/patches/_assert.sh"
apply=(bash "$ELLIPSOID_SOURCE/patches/apply.sh")
mapfile -t series < <(cd "$ELLIPSOID_SOURCE/patches" && ls | sed -nE 's/^([0-9]{4}[^.]*)\.patch$/\1/p')

same() {
  diff -r "$1" "$2" || fail "$1 and $2 differ: $3"
}

# count STATE TREE [KIND]: how many patches are in this state?
count() {
  "${apply[@]}" status "${@:2}" | grep -c "^$1: " || true
}

# there_and_back TREE [KIND]: apply, repeat, revert, repeat
there_and_back() {
  local missing
  rm -rf before applied_once
  cp -r "$1" before
  missing=$(count missing "$@")
  [[ $missing -gt 0 ]] || fail "nothing is to be applied to $1"
  "${apply[@]}" apply "$@"
  cp -r "$1" applied_once
  [[ $(count applied "$@") -eq $missing ]] || fail "not all of $missing patches are applied"
  expect_output "already in" "${apply[@]}" apply "$@"
  same applied_once "$1" "a second call changed something"
  "${apply[@]}" revert "$@" >/dev/null
  same before "$1" "revert does not give the tree back"
  expect_output "not in: ${series[0]}" "${apply[@]}" revert "$@"
  same before "$1" "a second revert changed something"
}

echo "-- the host of this build"
fresh_tree tree
there_and_back tree
for kind in compile upstream; do
  "${apply[@]}" apply tree $kind >/dev/null
  "${apply[@]}" revert tree $kind >/dev/null
  same before tree "patches of the kind $kind do not revert"
done

echo "-- made trees"
made_tree debian LIGGGHTS-PUBLIC 3.8.0
expect_output "^host: LIGGGHTS-PUBLIC 3.8.0 \(the release of 2017, as in Debian\)" "${apply[@]}" status debian
[[ $(count missing debian) -eq ${#series[@]} ]] || fail "not all patches fit: $("${apply[@]}" status debian)"
there_and_back debian
touched=$({ diff -rq debian applied_once || true; } | wc -l)
patched_files=$(cd "$ELLIPSOID_SOURCE/patches" && cat "${series[@]/%/.patch}" | grep '^+++ ' | sort -u | wc -l)
[[ $touched -eq $patched_files ]] || fail "$touched files changed, the series has $patched_files"
made_tree pici LIGGGHTS-PUBLIC 3.8.0 pici github
echo '"quat4"' >>pici/src/variable.cpp
made_tree inl LIGGGHTS-INL 4.0.0 inl
echo 'restart(char *, const Version &)' >>inl/src/fix.h
made_tree pfm LIGGGHTS-PFM 24.01 pfm
readonly pfm_variants="0005 0014 0015 0016 0023 0043 0049 0057 0060 0071 0072 0073 0074 0075 0076 0081 "
for name in pici inl pfm; do
  expect_output "^host: LIGGGHTS-[A-Z]* [0-9.]* " "${apply[@]}" check $name
  variants=$("${apply[@]}" status $name | sed -nE "s/^missing: ([0-9]*)-.*\.[a-z]+\.patch/\1/p" | tr '\n' ' ')
  [[ $name:$variants == "pici:0002 0049 " || $name:$variants == "inl:0007 0012 0016 0021 0057 0071 0072 0075 " ||
    $name:$variants == "pfm:$pfm_variants" ]] ||
    fail "other variants than expected are taken for $name: $variants"
  there_and_back $name
done
touch pici/src/jkr_lookup_table.h
expect_output "^host: .*PICI-LIGGGHTS" "${apply[@]}" check pici

echo "-- the three known forms of both compile fixes"
for form in '    ss << std::dec << a;' '   return std::to_string(a);'; do
  rm -rf mended && cp -r debian mended
  FORM=$form perl -pi -e 's/^.*static_cast< std::ostringstream &.*$/$ENV{FORM}/' mended/src/utils.h
  expect_output "^mended: 0001" "${apply[@]}" status mended compile
  there_and_back mended compile
done
for form in 'numneigh' 'numneigh != nullptr' 'inum > 0'; do
  rm -rf mended && cp -r debian mended
  sed -i "s/numneigh > 0/$form/" mended/src/finish.cpp
  expect_output "^mended: 0002" "${apply[@]}" status mended compile
  there_and_back mended compile
done
rm -rf mended && cp -r debian mended
sed -i 's/neighbor->lists\[m\]->numneigh > 0/*(neighbor->lists[m]->numneigh) > 0/' mended/src/finish.cpp
expect_output "^missing: 0002.*\.pici\.patch" "${apply[@]}" status mended compile
there_and_back mended compile
sed -i 's/^.*static_cast< std::ostringstream &.*$/    return other(a);/' mended/src/utils.h
expect_output "^needless: 0001" "${apply[@]}" status mended compile
echo 'int_to_string' >>mended/src/utils.h
expect_output "^conflict: 0001" "${apply[@]}" status mended compile

echo "-- one patch is in already"
rm -rf mended && cp -r debian mended
patch --quiet --fuzz=0 -p1 -d mended <"$ELLIPSOID_SOURCE/patches/${series[1]}.patch"
expect_output "already in \(applied\): 0002" "${apply[@]}" apply mended
"${apply[@]}" apply debian >/dev/null
same debian mended "applying the rest gives another tree"
"${apply[@]}" revert debian >/dev/null

echo "-- a tree in which a patch does not fit, or fits at two places, is refused and left alone"
rm -rf changed && cp -r debian changed
sed -i 's/numneigh > 0)/numneigh  > 0)/' changed/src/finish.cpp
cp -r changed changed_before
expect_refusal "0002.* does not fit" "${apply[@]}" apply changed
same changed_before changed "a refused series changed something"
rm -rf changed changed_before && cp -r debian changed
sed 's/^.*finish.*$//' debian/src/finish.cpp >>changed/src/finish.cpp
cp -r changed changed_before
expect_refusal "0002.* does not fit" "${apply[@]}" apply changed
same changed_before changed "a refused series changed something"

echo "-- wrong trees"
expect_refusal "is no LIGGGHTS source tree" "${apply[@]}" apply "$ELLIPSOID_SOURCE"
made_tree wrong LIGGGHTS-PUBLIC 3.7.0
expect_refusal "is LIGGGHTS-PUBLIC 3.7.0, which is not known; allowed: LIGGGHTS-PUBLIC 3.8.0, .*LIGGGHTS-INL 4.0.0" \
  "${apply[@]}" apply wrong
made_tree wrong LIGGGHTS-INL 3.8.0
expect_refusal "is LIGGGHTS-INL 3.8.0, which is not known" "${apply[@]}" apply wrong
made_tree wrong LIGGGHTS-PFM 23.02
expect_refusal "is LIGGGHTS-PFM 23.02, which is not known" "${apply[@]}" apply wrong
made_tree wrong LIGGGHTS-PUBLIC 3.8.0
rm wrong/src/pair_gran_proxy.h
expect_refusal "lacks src/pair_gran_proxy.h" "${apply[@]}" apply wrong
expect_refusal "unknown command 'undo'" "${apply[@]}" undo debian
echo "passed"
