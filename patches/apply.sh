#!/usr/bin/env bash
# Applies or reverts the patch series beside this script on a LIGGGHTS source tree.
#
#   bash patches/apply.sh COMMAND TREE [KIND]
#
#   COMMAND  check   only the identity check: is TREE the LIGGGHTS this package is made for?
#            status  one line per patch: applied, not applied, or mended (in another way)
#            apply   applies every patch that is not yet in; may be repeated
#            revert  takes every applied patch out again, last one first; may be repeated
#   TREE     the folder that contains src/
#   KIND     only the patches with this `Kind:` line (compile, feature); default: all
#
# Patches are applied without fuzz. All of them are tried before the first file is changed.
set -euo pipefail

readonly expected_version=3.8.0
readonly expected_files=(Make.sh version_liggghts_branch.txt lammps.cpp utils.h finish.cpp
  contact_models.h pair_gran_proxy.h fix_wall_gran.h fix_contact_history.h
  atom_vec_superquadric.h)
series_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

fail() {
  echo "patches/apply.sh: $*" >&2
  exit 1
}

check_identity() {
  local version_file=$tree/src/version_liggghts.txt file version
  [[ -f $version_file ]] ||
    fail "'$tree' is no LIGGGHTS source tree: src/version_liggghts.txt is missing;" \
      "give the folder of LIGGGHTS-PUBLIC $expected_version that contains src/"
  version=$(tr -d '[:space:]' <"$version_file")
  [[ $version == "$expected_version" ]] ||
    fail "'$tree' is LIGGGHTS version '$version', expected $expected_version;" \
      "get LIGGGHTS-PUBLIC $expected_version"
  for file in "${expected_files[@]}"; do
    [[ -f $tree/src/$file ]] ||
      fail "'$tree' lacks src/$file of LIGGGHTS-PUBLIC $expected_version;" \
        "unpack the source again"
  done
}

# header_value PATCH FIELD
header_value() {
  sed -n "/^--- /q; s/^$2: //p" "$1"
}

# strict_patch PATCH OPTION...
strict_patch() {
  local patch_file=$1
  shift
  patch --strip=1 --fuzz=0 --batch --no-backup-if-mismatch --reject-file=- \
    --directory="$tree" --input="$patch_file" "$@"
}

mended_otherwise() {
  local rule file
  rule=$(header_value "$1" Mended-when)
  [[ -n $rule ]] || return 1
  file=$tree/${rule%%: *}
  [[ -f $file ]] && grep -Eq -- "${rule#*: }" "$file"
}

# patch_state PATCH: prints applied, missing, mended or conflict
patch_state() {
  if strict_patch "$1" --forward --dry-run >/dev/null 2>&1; then
    echo missing
  elif strict_patch "$1" --reverse --force --dry-run >/dev/null 2>&1; then
    echo applied
  elif mended_otherwise "$1"; then
    echo mended
  else
    echo conflict
  fi
}

list_series() {
  local file
  for file in "$series_folder"/[0-9][0-9][0-9][0-9]-*.patch; do
    if [[ -z $kind || $(header_value "$file" Kind) == "$kind" ]]; then
      echo "$file"
    fi
  done
}

apply_series() {
  local file state
  local -a missing=()
  for file in "${series[@]}"; do
    state=$(patch_state "$file")
    case $state in
      missing) missing+=("$file") ;;
      applied | mended) echo "already in ($state): $(basename "$file")" ;;
      *)
        fail "$(basename "$file") does not fit '$tree';" \
          "start from an unchanged LIGGGHTS-PUBLIC $expected_version"
        ;;
    esac
  done
  for file in ${missing[@]+"${missing[@]}"}; do
    strict_patch "$file" --forward >/dev/null || fail "$(basename "$file") failed in '$tree'"
    echo "applied: $(basename "$file")"
  done
}

revert_series() {
  local index file
  for ((index = ${#series[@]} - 1; index >= 0; index--)); do
    file=${series[index]}
    if [[ $(patch_state "$file") == applied ]]; then
      strict_patch "$file" --reverse --force >/dev/null ||
        fail "$(basename "$file") could not be taken out of '$tree'"
      echo "reverted: $(basename "$file")"
    else
      echo "not in: $(basename "$file")"
    fi
  done
}

print_status() {
  local file
  for file in "${series[@]}"; do
    echo "$(patch_state "$file"): $(basename "$file")"
  done
}

[[ $# -eq 2 || $# -eq 3 ]] || fail "usage: apply.sh check|status|apply|revert TREE [KIND]"
command -v patch >/dev/null || fail "the program 'patch' is missing; install the package 'patch'"
tree=${2%/}
kind=${3-}
check_identity
mapfile -t series < <(list_series)
case $1 in
  check) ;;
  status) print_status ;;
  apply) apply_series ;;
  revert) revert_series ;;
  *) fail "unknown command '$1'; allowed: check, status, apply, revert" ;;
esac
