#!/usr/bin/env bash
# Gets the upstream tarball of Debian's source package `liggghts`.
#
#   bash patches/fetch_debian_source.sh FOLDER
#
# The tarball lands in FOLDER. The machine's own apt source entries are copied into FOLDER/apt
# and switched there to source packages; apt's lists, caches and state live there too. Nothing
# of the system's apt configuration is read-write touched; neither root nor sudo is needed.
set -euo pipefail

readonly tarball=liggghts_3.8.0+repack1.orig.tar.xz
readonly sha256=c18721d9a870c5170f03b91e4f1ffe13335c66ed1f0ff2c64ebd3be91c37867a
# Another folder than the machine's own can be named, for tests.
apt_configuration=${ELLIPSOID_APT_CONFIGURATION:-/etc/apt}

fail() {
  echo "patches/fetch_debian_source.sh: $*" >&2
  exit 1
}

verify_tarball() {
  local found
  found=$(sha256sum "$folder/$tarball" | cut -d ' ' -f 1)
  [[ $found == "$sha256" ]] ||
    fail "SHA-256 of $folder/$tarball is $found, expected $sha256; delete the file and try" \
      "again, or give your own LIGGGHTS-PUBLIC 3.8.0 with -DLIGGGHTS_SOURCE=FOLDER_OR_TARBALL"
}

# copy_source_entries: apt reads only *.list and *.sources; other names are left alone
copy_source_entries() {
  local file
  mkdir -p "$private/parts" "$private/lists/partial" "$private/cache/archives/partial" \
    "$private/state"
  rm -f "$private"/parts/*
  : >"$private/state/status"
  for file in "$apt_configuration/sources.list" "$apt_configuration"/sources.list.d/*.list; do
    [[ -f $file ]] || continue
    sed -E 's/^[[:space:]]*deb[[:space:]]/deb-src /' "$file" |
      awk '!/^deb-src / || !seen[$0]++' >"$private/parts/$(basename "$file" .list).list"
  done
  for file in "$apt_configuration"/sources.list.d/*.sources; do
    [[ -f $file ]] || continue
    sed -E 's/^([Tt]ypes):.*/\1: deb-src/' "$file" >"$private/parts/$(basename "$file")"
  done
  [[ -n $(ls -A "$private/parts") ]] ||
    fail "no apt source entries in $apt_configuration (sources.list, sources.list.d);" \
      "give LIGGGHTS-PUBLIC 3.8.0 with -DLIGGGHTS_SOURCE=FOLDER_OR_TARBALL"
}

private_apt_get() {
  apt-get --quiet=2 \
    -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$private/parts" \
    -o "Dir::State=$private/state" -o "Dir::State::lists=$private/lists" \
    -o "Dir::State::status=$private/state/status" -o "Dir::Cache=$private/cache" \
    -o "APT::Sandbox::User=$(id -un)" -o Acquire::Languages=none -o Acquire::Retries=3 \
    -o APT::Update::Post-Invoke::= -o APT::Update::Post-Invoke-Success::= "$@"
}

download_tarball() {
  command -v apt-get >/dev/null ||
    fail "apt-get is missing, so Debian's source package cannot be had;" \
      "give LIGGGHTS-PUBLIC 3.8.0 with -DLIGGGHTS_SOURCE=FOLDER_OR_TARBALL"
  copy_source_entries
  echo "reading the list of Debian source packages"
  private_apt_get update || fail "apt-get update failed (see above); is there a network?"
  echo "downloading $tarball"
  (cd "$folder" && private_apt_get source --download-only --tar-only liggghts) ||
    fail "apt-get source failed (see above); does one of the apt source entries offer the" \
      "source package 'liggghts'? Else use -DLIGGGHTS_SOURCE=FOLDER_OR_TARBALL"
  [[ -f $folder/$tarball ]] ||
    fail "the source package offers another version than $tarball;" \
      "give LIGGGHTS-PUBLIC 3.8.0 with -DLIGGGHTS_SOURCE=FOLDER_OR_TARBALL"
}

[[ $# -eq 1 ]] || fail "usage: fetch_debian_source.sh FOLDER"
mkdir -p "$1"
folder=$(cd "$1" && pwd)
private=$folder/apt
[[ -f $folder/$tarball ]] || download_tarball
verify_tarball
rm -rf "$private"
