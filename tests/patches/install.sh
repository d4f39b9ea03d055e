# patches/install.sh puts sources and patches into a tree, may be repeated, takes everything back, and
# leaves alone what is not its own. On a small made tree; no compiler is run.
source "$ELLIPSOID_SOURCE/tests/patches/_assert.sh"
install=(bash "$ELLIPSOID_SOURCE/patches/install.sh")

same() {
  diff -r "$1" "$2" || fail "$1 and $2 differ: $3"
}

# fresh TREE: as the host is delivered
fresh() {
  made_tree "$1" LIGGGHTS-PUBLIC 3.8.0
  printf '# libraries\n\nPKG_INC =   \nPKG_PATH =  \n' >"$1/src/Makefile.package.empty"
}

echo "-- there and back"
fresh tree
cp -r tree before
expect_output "^applied: 0001" "${install[@]}" tree
cp -r tree once
expect_output "^already in \(applied\): 0001" "${install[@]}" tree
same once tree "a second call changed something"
[[ -f tree/src/pair_gran_ellipsoid.cpp && -f tree/src/ellipsoid_contact.cpp ]] || fail "sources are missing"
[[ -f tree/src/liggghts_ellipsoid/ellipsoid/ellipsoid_contact.h ]] || fail "kernel headers are missing"
grep -q '^PKG_INC =.-std=c++17 .*-DSUPERQUADRIC_ACTIVE_FLAG' tree/src/Makefile.package || fail "flags"
while read -r include; do # what is included by a room is there
  [[ -f tree/src/liggghts_ellipsoid/$include ]] || fail "'$include' is not where it is looked for"
done < <(cat tree/src/*.cpp tree/src/*.h tree/src/liggghts_ellipsoid/*/*.h |
  sed -nE 's|^#include "([a-z_]+/[a-z_0-9]+\.h)".*|\1|p' | sort -u)
expect_output "^reverted: 0001" "${install[@]}" --remove tree
same before tree "taking back does not give the tree back"
expect_refusal "has nothing of this package" "${install[@]}" --remove tree
same before tree "taking back twice changed something"

echo "-- the user's own settings stay"
fresh tree
printf 'PKG_INC = -I../../lib/poems \n' >tree/src/Makefile.package
echo 'GRAN_MODEL(HOOKE, TANGENTIAL_OFF, COHESION_OFF, ROLLING_OFF, SURFACE_DEFAULT)' \
  >tree/src/style_contact_model_user.whitelist
rm -rf before && cp -r tree before
"${install[@]}" tree >/dev/null
grep -q '^PKG_INC =.-std=c++17 .* -I../../lib/poems' tree/src/Makefile.package || fail "flags of the user"
[[ $(grep -c SURFACE_SMOOTH tree/src/style_contact_model_user.whitelist) -ge 1 ]] || fail "no models"
expect_output "^removed: " "${install[@]}" --remove tree
same before tree "taking back does not give the user's settings back"

echo "-- a Makefile.package that the tree came with stays"
fresh tree
cp tree/src/Makefile.package.empty tree/src/Makefile.package
rm -rf before && cp -r tree before
"${install[@]}" tree >/dev/null
expect_output "^removed: " "${install[@]}" --remove tree
same before tree "taking back does not give the tree back"

echo "-- a Makefile.auto that GNU make 4.3 does not read any more"
fresh tree
mkdir tree/src/MAKE
printf '%s\n' "TMP := \$(shell echo '\\#include <mpi.h>')" >tree/src/MAKE/Makefile.auto
expect_output "^remark: 'make auto' of this tree stops with GNU make 4.3" "${install[@]}" tree
eval "$("${install[@]}" tree | sed -n 's/^remark: .* mend it by: //p')"
[[ $(cat tree/src/MAKE/Makefile.auto) == 'H := \#'$'\n'"TMP := \$(shell echo '\$Hinclude <mpi.h>')" ]] ||
  fail "the remark's command makes: $(cat tree/src/MAKE/Makefile.auto)"
! "${install[@]}" tree | grep "^remark" || fail "a remark on a mended file"

echo "-- a file of an earlier version goes, a changed one is left alone"
fresh tree
"${install[@]}" tree >/dev/null
echo "// old" >tree/src/was_there_before.cpp
(cd tree/src && sha256sum was_there_before.cpp) >>tree/src/liggghts_ellipsoid/files.txt
"${install[@]}" tree >/dev/null
[[ ! -e tree/src/was_there_before.cpp ]] || fail "a file of an earlier version is still there"
echo "// mine" >>tree/src/fix_insert_drop.cpp
rm -rf once && cp -r tree once
expect_refusal "fix_insert_drop.cpp' is in the way: it is not as this script put it" "${install[@]}" tree
same once tree "a refused call changed something"
expect_output "^kept, it was changed: .*fix_insert_drop.cpp" "${install[@]}" --remove tree
[[ -f tree/src/fix_insert_drop.cpp && ! -e tree/src/pair_gran_ellipsoid.cpp ]] || fail "wrong files are left"

echo "-- an update in which a patch has other lines"
fresh tree
rm -rf before earlier && cp -r tree before
mkdir earlier && cp -r "$ELLIPSOID_SOURCE/patches" "$ELLIPSOID_SOURCE/src_liggghts" earlier
sed -i '/^+++/!s|^+\(.*[;{]\)$|+\1 // of an earlier version|' earlier/patches/0001-*.patch
bash earlier/patches/install.sh tree >/dev/null
grep -rq "of an earlier version" tree/src/utils.h || fail "the earlier version is not in"
expect_output "^reverted: the patches of an earlier version" "${install[@]}" tree
! grep -q "of an earlier version" tree/src/utils.h || fail "lines of the earlier version are left"
fresh once
"${install[@]}" once >/dev/null
same once tree "an update is not the same as the new version alone"
bash earlier/patches/install.sh tree >/dev/null
expect_output "^removed: " "${install[@]}" --remove tree
same before tree "taking back an earlier version does not give the tree back"

echo "-- an update that does not fit leaves the earlier version"
bash earlier/patches/install.sh tree >/dev/null
rm -rf once && cp -r tree once
rm -rf later && cp -r earlier later
sed -i '/^---/!s|^-|-unknown |' later/patches/0002-finish-pointer-comparison-compiles.patch
expect_refusal "0002.* does not fit" bash later/patches/install.sh tree
same once tree "a refused update changed something"

echo "-- refused"
fresh tree
echo "// of somebody else" >tree/src/whole_files.h
rm -rf before && cp -r tree before
expect_refusal "whole_files.h' is in the way" "${install[@]}" tree
same before tree "a refused call changed something"
fresh tree
sed -i 's/numneigh > 0)/numneigh  > 0)/' tree/src/finish.cpp
rm -rf before && cp -r tree before
expect_refusal "0002.* does not fit" "${install[@]}" tree
same before tree "a refused call changed something"
expect_refusal "is no LIGGGHTS source tree" "${install[@]}" "$ELLIPSOID_SOURCE"
expect_refusal "usage: install.sh" "${install[@]}"
echo "-- LIGGGHTS-PFM is refused"
made_tree pfm LIGGGHTS-PFM 24.01 pfm
printf 'PKG_INC =   \n' >pfm/src/Makefile.package
cp -r pfm pfm_before
expect_refusal "is LIGGGHTS-PFM, which takes this package by CMake only: cmake " "${install[@]}" pfm
same pfm_before pfm "a refused tree was changed"
echo "passed"
