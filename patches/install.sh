#!/usr/bin/env bash
# Puts this package into a LIGGGHTS tree that is built by the host's own make.
#
#   bash patches/install.sh TREE            sources and patches; may be repeated
#   bash patches/install.sh --remove TREE   takes everything back
#
#   TREE   the folder that contains src/; not of LIGGGHTS-PFM, which takes this package by CMake only
#
# Afterwards `make auto`, `make mpi` or any other of the host's targets, in TREE/src, gives an engine
# with the styles of this package. What is put there:
#   src/*.h, *.cpp            the adapters, and the sources of the kernel
#   src/liggghts_ellipsoid/   the headers of the kernel, the patches, and the list of all these files
#   src/Makefile.package      flags that this package needs, in front of PKG_INC
#   src/style_contact_model_user.whitelist   the combinations of contact models of this package
# and the changes by patches/apply.sh. After an update of this package, patches that are others now are taken
# out by the ones that were kept in the tree, before the new ones go in. A file of the tree that is in the way, or one of these files
# that was changed since, is left alone and named.
set -euo pipefail

package=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly flags="-std=c++17 -DSUPERQUADRIC_ACTIVE_FLAG -DNONSPHERICAL_ACTIVE_FLAG \
-I../liggghts_ellipsoid -ffp-contract=off -fno-math-errno -fno-trapping-math"
readonly own_folder=liggghts_ellipsoid
readonly whitelist=style_contact_model_user.whitelist

fail() {
  echo "patches/install.sh: $*" >&2
  exit 1
}

# list_files: `SOURCE<tab>PLACE` of every file, the place below TREE/src
list_files() {
  local file
  find "$package/src_liggghts" -mindepth 2 -maxdepth 2 '(' -name '*.h' -o -name '*.cpp' ')' \
    -not -path '*/kernel/*' | sort | while read -r file; do
    printf '%s\t%s\n' "$file" "$(basename "$file")"
  done
  (cd "$package/src_liggghts/kernel" && find . -name '*.cpp' -o -name '*.h') | sort |
    while read -r file; do
      case $file in
        *.h) printf '%s\t%s\n' "$package/src_liggghts/kernel/${file#./}" "$own_folder/${file#./}" ;;
        *) printf '%s\t%s\n' "$package/src_liggghts/kernel/${file#./}" "$(basename "$file")" ;;
      esac
    done
}

# is_ours PLACE: is the file there as this script has put it?
is_ours() {
  [[ -f $list ]] && grep -Fxq "$(sha256sum "$src/$1" | cut -d ' ' -f 1)  $1" "$list"
}

# check_room PLACE...: nothing of the user's is to be lost
check_room() {
  local place
  for place in "$@"; do
    [[ ! -e $src/$place ]] || is_ours "$place" ||
      fail "'$src/$place' is in the way: it is not as this script put it there;" \
        "move it away and try again"
  done
}

copy_files() {
  local source place old
  local -a sources=() places=() listed=()
  while IFS=$'\t' read -r source place; do
    sources+=("$source")
    places+=("$place")
  done < <(list_files)
  check_room "${places[@]}"
  if [[ -f $list ]]; then # files of an earlier version
    mapfile -t listed < <(cut -c 67- "$list")
    for old in "${listed[@]}"; do
      [[ " ${places[*]} " == *" $old "* || ! -e $src/$old ]] || ! is_ours "$old" || rm "$src/$old"
    done
  fi
  mkdir -p "$src/$own_folder"
  for ((k = 0; k < ${#places[@]}; k++)); do
    mkdir -p "$(dirname "$src/${places[k]}")"
    cmp -s "${sources[k]}" "$src/${places[k]}" || cp "${sources[k]}" "$src/${places[k]}"
  done
  (cd "$src" && sha256sum "${places[@]}") >"$list"
  echo "copied: ${#places[@]} files to $src, see $list"
}

remove_files() {
  local old
  local -a listed=()
  mapfile -t listed < <(cut -c 67- "$list")
  for old in "${listed[@]}"; do
    if [[ ! -e $src/$old ]]; then
      continue
    elif is_ours "$old"; then
      rm "$src/$old"
    else
      echo "kept, it was changed: $src/$old"
    fi
  done
  rm "$list"
  find "$src/$own_folder" -depth -type d -empty -delete
  echo "removed: ${#listed[@]} files from $src"
}

# kept_series_differs: is the tree patched by another series than this package's?
kept_series_differs() {
  local patch
  [[ -d $kept ]] || return 1
  for patch in "$package"/patches/*.patch "$kept"/*.patch; do
    cmp -s "$package/patches/${patch##*/}" "$kept/${patch##*/}" || return 0
  done
  return 1
}

# apply_patches: those of an earlier version go out first, and come back where the new ones do not fit
apply_patches() {
  local differs=no
  if kept_series_differs; then
    differs=yes
    bash "$kept/apply.sh" revert "$tree" >/dev/null
    echo "reverted: the patches of an earlier version of this package"
  fi
  if ! bash "$package/patches/apply.sh" apply "$tree" | grep -v '^host: '; then
    [[ $differs == no ]] || bash "$kept/apply.sh" apply "$tree" >/dev/null
    exit 1
  fi
  rm -rf "$kept"
  mkdir -p "$kept"
  cp "$package/patches/apply.sh" "$package"/patches/*.patch "$kept"
}

# revert_patches: by the series that is in the tree
revert_patches() {
  local series=$package/patches
  [[ ! -d $kept ]] || series=$kept
  bash "$series/apply.sh" revert "$tree" | grep -v '^host: \|^not in: ' || true
  rm -rf "$kept"
}

add_flags() {
  local file=$src/Makefile.package
  if [[ ! -f $file ]]; then
    cp "$src/Makefile.package.empty" "$file"
    mkdir -p "$src/$own_folder"
    touch "$new_makefile"
  fi
  grep -q '^PKG_INC =' "$file" || fail "'$file' has no line 'PKG_INC ='; add one"
  if ! grep -Fq -- "$flags" "$file"; then
    sed -i "s|^PKG_INC =|&\t$flags|" "$file"
    echo "added: flags to $file"
  fi
}

remove_flags() {
  local file=$src/Makefile.package
  [[ -f $file ]] || return 0
  sed -i "s|^PKG_INC =\t$flags|PKG_INC =|" "$file"
  if [[ -e $new_makefile ]]; then
    rm "$new_makefile"
    ! cmp -s "$file" "$src/Makefile.package.empty" || rm "$file"
  fi
}

# The host reads the list line by line and needs an end of line after the last one.
add_models() {
  local line
  while read -r line; do
    grep -Fxqs -- "$line" "$src/$whitelist" || echo "$line" >>"$src/$whitelist"
  done < <(own_models)
}

remove_models() {
  [[ -f $src/$whitelist ]] || return 0
  grep -Fxvf <(own_models) "$src/$whitelist" >"$src/$whitelist.rest" || true
  mv "$src/$whitelist.rest" "$src/$whitelist"
  [[ -s $src/$whitelist ]] || rm "$src/$whitelist"
}

# remark_on_make_auto: of a Makefile.auto from before GNU make 4.3, whose tests of MPI and VTK fail since
remark_on_make_auto() {
  local file=$src/MAKE/Makefile.auto
  if grep -qsF "'\\#include" "$file"; then
    echo "remark: 'make auto' of this tree stops with GNU make 4.3 or newer, with this package or without; mend it by:" \
      "sed -i -e '1i H := \\\\#' -e 's/\\\\#/\$H/g' $file"
  fi
}

own_models() {
  grep -o 'GRAN_MODEL(.*)' "$package/src_liggghts/models/$whitelist"
}

remove=no
if [[ ${1-} == --remove ]]; then
  remove=yes
  shift
fi
[[ $# -eq 1 ]] || fail "usage: install.sh [--remove] TREE"
tree=${1%/}
src=$tree/src
list=$src/$own_folder/files.txt
kept=$src/$own_folder/patches
new_makefile=$src/$own_folder/new_makefile_package # there if the tree had no Makefile.package
if [[ $remove == yes ]]; then
  bash "$package/patches/apply.sh" check "$tree"
  [[ -f $list ]] || fail "'$tree' has nothing of this package: $list is missing"
  revert_patches
  remove_flags
  remove_files
  remove_models
else
  bash "$package/patches/apply.sh" check "$tree"
  [[ -f $src/Makefile.package.empty || -f $src/Makefile.package ]] ||
    fail "'$src' has neither Makefile.package nor Makefile.package.empty: is it the host's whole src/?"
  [[ $(head -n 1 "$src/version_liggghts_branch.txt") != LIGGGHTS-PFM ]] ||
    fail "'$tree' is LIGGGHTS-PFM, which takes this package by CMake only:" \
      "cmake --preset release -DLIGGGHTS_SOURCE=$tree"
  mapfile -t places < <(list_files | cut -f 2)
  check_room "${places[@]}"
  apply_patches
  copy_files
  add_flags
  add_models
  remark_on_make_auto
  echo "Now build in $src as always, for example: make mpi"
fi
