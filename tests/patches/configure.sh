# -DLIGGGHTS_SOURCE= takes a folder or a tarball after an identity check; a second
# configuration needs no network and changes no file that is compiled.
source "$ELLIPSOID_SOURCE/tests/patches/_assert.sh"

# configure SOURCE: into the folder b
configure() {
  cmake -S "$ELLIPSOID_SOURCE" -B b -DELLIPSOID_VTK=OFF -DELLIPSOID_TESTS=OFF \
    "-DLIGGGHTS_SOURCE=$1"
}

# times: of all files that the engine is compiled from
times() {
  find b/liggghts/patched/src b/liggghts/stock/src -name '*.[ch]*' ! -type l -printf '%P %T@\n' | sort
}

echo "-- wrong sources"
expect_refusal "LIGGGHTS_SOURCE='/nowhere/at/all' does not exist" configure /nowhere/at/all
expect_refusal "is no LIGGGHTS source tree" configure "$ELLIPSOID_SOURCE/patches"
fresh_tree old
echo 3.7.0 >old/src/version_liggghts.txt
expect_refusal "is LIGGGHTS-PUBLIC 3.7.0, which is not known" configure "$PWD/old"
expect_refusal "is LIGGGHTS-PUBLIC 3.7.0, which is not known" configure "$PWD/old"
mkdir empty && tar -cJf empty.tar.xz empty
expect_refusal "is no tarball of LIGGGHTS" configure "$PWD/empty.tar.xz"

echo "-- the newest public tree, in which the two lines are mended, as a folder"
fresh_tree mended
mend_as_upstream mended
expect_output "already in \(mended\): 0001" configure "$PWD/mended"
cmp b/liggghts/patched/src/finish.cpp mended/src/finish.cpp || fail "a mended file was changed"
times >before

echo "-- a second configuration changes nothing, and only what changed later"
configure "$PWD/mended" >second 2>&1 || fail "$(cat second)"
! grep -q Patching second || fail "patched again: $(cat second)"
times >after
diff before after || fail "a second configuration touched files that are compiled"
echo "// a remark" >>mended/src/fix_gravity.cpp
configure "$PWD/mended" >third 2>&1 || fail "$(cat third)"
times >after
[[ $({ diff before after || true; } | grep -c '^>') -eq 2 ]] ||
  fail "one edit must touch one file in both trees: $(diff before after)"

echo "-- a tarball"
tar -cJf mended.tar.xz mended
expect_output "Unpacking LIGGGHTS from .*mended.tar.xz" configure "$PWD/mended.tar.xz"
times >again
diff after again || fail "the same files from a tarball count as changed"

echo "-- Debian's tarball that is kept in the build tree needs no network"
kept=$ELLIPSOID_BUILD/liggghts/download/liggghts_3.8.0+repack1.orig.tar.xz
if [[ -f $kept ]]; then
  mkdir -p b/liggghts/download programs && cp "$kept" b/liggghts/download
  printf '#!/bin/sh\nexit 100\n' >programs/apt-get
  chmod +x programs/apt-get
  PATH=$PWD/programs:$PATH expect_output "Unpacking LIGGGHTS from .*orig.tar.xz" configure ""
fi
echo "passed"
