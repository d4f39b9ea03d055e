#!/usr/bin/env bash
# Applies or reverts the patch series beside this script on a LIGGGHTS source tree.
#
#   bash patches/apply.sh COMMAND TREE [KIND]
#
#   COMMAND  check   only the identity check; prints which LIGGGHTS TREE is
#            status  the same, and one line per patch: applied, not applied, mended (in another
#                    way) or needless (the tree lacks what the patch mends)
#            apply   applies every patch that is not yet in; may be repeated
#            revert  takes every applied patch out again, last one first; may be repeated
#   TREE     the folder that contains src/
#   KIND     only the patches with this `Kind:` line (compile, upstream, feature); default: all
#
# A patch NNNN-name.patch may have variants NNNN-name.HOST.patch for trees with other lines; the
# lines of the tree decide which one is taken. Patches are applied without fuzz, and only where
# the lines that they change stand at a single place of the file. All of them are tried before
# the first file is changed.
#
# Fields in front of a patch: `Why:`, `Kind:`, and, each as often as needed,
#   Mended-when: FILE: REGEX         the patch counts as in where all such rules hold
#   Needless-without: FILE: REGEX    nothing is to be done where no line of FILE is like this
#   Only-with: FILE: REGEX           a variant is for trees where a line of FILE is like this
set -euo pipefail

readonly known_hosts="LIGGGHTS-PUBLIC 3.8.0, LIGGGHTS-INL 4.0.0, LIGGGHTS-PFM 24.01"
readonly expected_files=(Make.sh version_liggghts_branch.txt lammps.cpp utils.h finish.cpp
  contact_models.h pair_gran_proxy.h fix_wall_gran.h fix_contact_history.h
  atom_vec_superquadric.h)
series_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

fail() {
  echo "patches/apply.sh: $*" >&2
  exit 1
}

# first_line FILE: without spaces; empty where there is no file
first_line() {
  [[ ! -f $1 ]] || head -n 1 "$1" | tr -d '[:space:]'
}

check_identity() {
  local file
  [[ -f $tree/src/version_liggghts.txt ]] ||
    fail "'$tree' is no LIGGGHTS source tree: src/version_liggghts.txt is missing;" \
      "give the folder that contains src/, of one of: $known_hosts"
  host="$(first_line "$tree/src/version_liggghts_branch.txt")"
  host="${host:-LIGGGHTS} $(first_line "$tree/src/version_liggghts.txt")"
  [[ ", $known_hosts," == *", $host,"* ]] ||
    fail "'$tree' is $host, which is not known; allowed: $known_hosts; get one of these"
  for file in "${expected_files[@]}"; do
    [[ -f $tree/src/$file ]] ||
      fail "'$tree' lacks src/$file of $host; unpack the source again"
  done
}

# Which of the trees of this name it is, by what came in later.
describe_host() {
  local which="another state than the known ones"
  if [[ -f $tree/src/jkr_lookup_table.h ]]; then
    which="PICI-LIGGGHTS"
  elif [[ $host != "LIGGGHTS-PUBLIC 3.8.0" ]]; then
    which="as on GitHub"
  elif [[ -f $tree/src/fix_sph_integrity.h ]]; then
    which="GitHub, 2020 or later"
  elif grep -q 'static_cast< std::ostringstream & >' "$tree/src/utils.h"; then
    which="the release of 2017, as in Debian"
  fi
  echo "host: $host ($which)"
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

# places_are_unique PATCH: do the old lines of every hunk stand at one place of their file?
places_are_unique() {
  awk -v tree="$tree" '
    function count_places(   first, k, places) {
      if (!old_count) return
      for (first = 1; first + old_count - 1 <= line_count; first++) {
        for (k = 1; k <= old_count && lines[first + k - 1] == old[k]; k++);
        places += k > old_count
      }
      if (places != 1) ambiguous = 1
      old_count = 0
    }
    /^--- / { count_places(); in_hunk = 0; next }
    /^\+\+\+ / {
      file = tree "/" substr($2, 3)
      for (line_count = 0; (getline text < file) > 0;) lines[++line_count] = text ""
      close(file)
      next
    }
    /^@@ / { count_places(); in_hunk = 1; next }
    in_hunk && /^[ -]/ { old[++old_count] = substr($0, 2) "" }
    END { count_places(); exit ambiguous }' "$1"
}

# has_line RULE: does a file of the tree have such a line? RULE is `FILE: REGEX`
has_line() {
  [[ -f $tree/${1%%: *} ]] && grep -Eq -- "${1#*: }" "$tree/${1%%: *}"
}

# mended_otherwise PATCH: do all its rules hold?
mended_otherwise() {
  local rule
  local -a rules
  mapfile -t rules < <(header_value "$1" Mended-when)
  for rule in ${rules[@]+"${rules[@]}"}; do
    has_line "$rule" || return 1
  done
  [[ ${#rules[@]} -gt 0 ]]
}

needless() {
  local rule
  while read -r rule; do
    has_line "$rule" || return 0
  done < <(header_value "$1" Needless-without)
  return 1
}

# look_at NAME: sets `state` (applied, missing, mended, needless, conflict) and `chosen`, the
# patch or the variant of it that is or can be applied
look_at() {
  local name=$1
  local -a variants
  mapfile -t variants < <(list_files "$name")
  for chosen in "${variants[@]}"; do
    state=applied
    ! strict_patch "$chosen" --reverse --force --dry-run >/dev/null 2>&1 || return 0
  done
  for chosen in "${variants[@]}"; do
    state=missing
    ! strict_patch "$chosen" --forward --dry-run >/dev/null 2>&1 ||
      ! places_are_unique "$chosen" || return 0
  done
  for chosen in "${variants[@]}"; do
    state=mended
    ! mended_otherwise "$chosen" || return 0
    state=needless
    ! needless "$chosen" || return 0
  done
  chosen=$name
  state=conflict
}

# list_files NAME: those variants of the patch that are for such a tree, then the patch itself
list_files() {
  local file rule
  for file in "$series_folder/$1".*.patch "$series_folder/$1.patch"; do
    [[ -f $file ]] || continue
    rule=$(header_value "$file" Only-with)
    if [[ -z $rule ]] || has_line "$rule"; then
      echo "$file"
    fi
  done
}

# the names of all patches of the kind that is asked for
list_series() {
  local name
  for name in $(cd "$series_folder" && ls | sed -nE 's/^([0-9]{4}-[^.]+)\..*patch$/\1/p' | sort -u); do
    if [[ -z $kind ]] || header_value "$(list_files "$name" | tail -n 1)" Kind | grep -qx "$kind"; then
      echo "$name"
    fi
  done
}

apply_series() {
  local name file
  local -a missing=()
  for name in "${series[@]}"; do
    look_at "$name"
    case $state in
      missing) missing+=("$chosen") ;;
      applied | mended) echo "already in ($state): $(basename "$chosen")" ;;
      needless) echo "needless: $(basename "$chosen")" ;;
      *)
        fail "$name does not fit '$tree' ($host);" \
          "start from an unchanged tree of one of: $known_hosts"
        ;;
    esac
  done
  for file in ${missing[@]+"${missing[@]}"}; do
    strict_patch "$file" --forward >/dev/null || fail "$(basename "$file") failed in '$tree'"
    echo "applied: $(basename "$file")"
  done
}

revert_series() {
  local index
  for ((index = ${#series[@]} - 1; index >= 0; index--)); do
    look_at "${series[index]}"
    if [[ $state == applied ]]; then
      strict_patch "$chosen" --reverse --force >/dev/null ||
        fail "$(basename "$chosen") could not be taken out of '$tree'"
      echo "reverted: $(basename "$chosen")"
    else
      echo "not in: ${series[index]}"
    fi
  done
}

print_status() {
  local name
  for name in "${series[@]}"; do
    look_at "$name"
    echo "$state: $(basename "$chosen")"
  done
}

[[ $# -eq 2 || $# -eq 3 ]] || fail "usage: apply.sh check|status|apply|revert TREE [KIND]"
command -v patch >/dev/null || fail "the program 'patch' is missing; install the package 'patch'"
tree=${2%/}
kind=${3-}
check_identity
describe_host
mapfile -t series < <(list_series)
case $1 in
  check) ;;
  status) print_status ;;
  apply) apply_series ;;
  revert) revert_series ;;
  *) fail "unknown command '$1'; allowed: check, status, apply, revert" ;;
esac
