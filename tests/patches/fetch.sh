# Debian's tarball is fetched with a private copy of the apt source entries, and verified.
# A program that only takes notes stands in for apt-get; no network is used.
source "$ELLIPSOID_SOURCE/tests/patches/_assert.sh"
fetch=(bash "$ELLIPSOID_SOURCE/patches/fetch_debian_source.sh")
tarball=liggghts_3.8.0+repack1.orig.tar.xz

mkdir -p etc/sources.list.d programs
cat >etc/sources.list <<'LIST'
# deb http://one.example/debian old main
deb http://one.example/debian bookworm main
deb [arch=amd64 signed-by=/k.gpg] http://two.example/debian bookworm main
deb-src http://one.example/debian bookworm main
LIST
cat >etc/sources.list.d/three.sources <<'LIST'
Types: deb
URIs: http://three.example/debian
Suites: bookworm bookworm-updates
Components: main
Signed-By: /k.gpg

Types: deb deb-src
URIs: http://four.example/debian
Suites: bookworm
Components: main
Enabled: no
LIST
echo 'deb http://five.example/debian x main' >etc/sources.list.d/five.list.disabled
echo 'deb http://six.example/debian x main' >etc/sources.list.d/six.list
cp -r etc etc_before

cat >programs/apt-get <<'PROGRAM'
#!/usr/bin/env bash
echo "$@" >>"$NOTES/calls"
for option in "$@"; do
  case $option in
    Dir::Etc::sourceparts=*) rm -rf "$NOTES/parts" && cp -r "${option#*=}" "$NOTES/parts" ;;
    source) echo "not the tarball" >liggghts_3.8.0+repack1.orig.tar.xz ;;
  esac
done
PROGRAM
chmod +x programs/apt-get
mkdir notes
export NOTES=$PWD/notes PATH=$PWD/programs:$PATH ELLIPSOID_APT_CONFIGURATION=$PWD/etc

echo "-- another content than expected is refused"
expect_refusal "SHA-256 of .*orig.tar.xz is [0-9a-f]{64}, expected c18721d9" "${fetch[@]}" "a folder"
expect_refusal "SHA-256 of .*orig.tar.xz is" "${fetch[@]}" "a folder"
[[ $(grep -c ' source --download-only --tar-only liggghts' notes/calls) -eq 1 ]] ||
  fail "apt-get source was called another number of times than once: $(cat notes/calls)"

echo "-- the private source entries"
diff -r etc_before etc || fail "the machine's own entries were changed"
[[ $(ls notes/parts | tr '\n' ' ') == "six.list sources.list three.sources " ]] ||
  fail "entries that apt does not read were used: $(ls notes/parts)"
diff notes/parts/sources.list - <<'LIST' || fail "one-line entries"
# deb http://one.example/debian old main
deb-src http://one.example/debian bookworm main
deb-src [arch=amd64 signed-by=/k.gpg] http://two.example/debian bookworm main
LIST
diff notes/parts/three.sources <(sed 's/^Types:.*/Types: deb-src/' etc/sources.list.d/three.sources) ||
  fail "deb822 entries"
grep -Eo 'Dir::[A-Za-z:]+=[^ ]*' notes/calls | sort -u | grep -v '=/dev/null$' |
  while read -r setting; do
    [[ $setting == *"=$PWD/a" ]] || fail "apt-get was pointed outside of the folder: $setting"
  done

echo "-- no entries, no apt-get"
rm -rf etc && mkdir etc
expect_refusal "no apt source entries in .*-DLIGGGHTS_SOURCE" "${fetch[@]}" nothing
printf '#!/bin/sh\nexit 100\n' >programs/apt-get
mkdir -p etc && echo 'deb http://one.example/debian x main' >etc/sources.list
expect_refusal "apt-get update failed" "${fetch[@]}" failing

echo "-- a tarball that is there is not fetched again"
kept=$ELLIPSOID_BUILD/liggghts/download/$tarball
if [[ -f $kept ]]; then
  mkdir present && cp "$kept" present
  "${fetch[@]}" present || fail "the kept tarball was refused"
  [[ $(ls present) == "$tarball" ]] || fail "more than the tarball is left: $(ls present)"
fi
echo "passed"
