#!/usr/bin/env bash
# clang-tidy's checks of the project's .clang-tidy: the whole kernel, and what differs from the branch
# main. All of the project's own files: ELLIPSOID_TIDY=all.
set -euo pipefail
readonly skipped=77

if ! command -v clang-tidy >/dev/null; then
  echo "not checked: clang-tidy is missing (Debian: clang-tidy)"
  exit "$skipped"
fi
if ! clang-tidy --version | grep -Eq "version (14|19)\."; then
  echo "not checked: $(clang-tidy --version | grep -o 'version [0-9.]*'); the list is for 14 and 19"
  exit "$skipped"
fi

# compiled_files: the project's own files among those that this build compiles
compiled_files() {
  sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$ELLIPSOID_BUILD/compile_commands.json" |
    grep "^$ELLIPSOID_SOURCE/\(src_liggghts\|postprocess\|tests\)/" | sort -u
}

changed_files() {
  git -C "$ELLIPSOID_SOURCE" diff --name-only --diff-filter=d main -- '*.cpp' 2>/dev/null |
    sed "s|^|$ELLIPSOID_SOURCE/|" || true
}

# chosen_files: one per line
chosen_files() {
  if [[ ${ELLIPSOID_TIDY-} == all ]]; then
    compiled_files
  else
    compiled_files | grep "/src_liggghts/kernel/"
    compiled_files | grep -Fx -f <(changed_files) || true
  fi | sort -u
}

# tidy FOLDER_OF_COMPILE_COMMANDS: the files on its standard input
tidy() {
  xargs -P 2 -n 4 clang-tidy -p "$1" --quiet --extra-arg=-Wno-error \
    --header-filter="^$ELLIPSOID_SOURCE/(src_liggghts|postprocess|tests)/" 2>/dev/null
}

chosen_files >files.txt
[[ $(wc -l <files.txt) -ge 15 ]]
tidy "$ELLIPSOID_BUILD" <files.txt || exit 1

# the check sees what it should
cp "$ELLIPSOID_SOURCE/.clang-tidy" .
printf 'struct A { virtual int f(double x); };\nstruct B : A { int f(double x); };\nint B::f(double x) { int n = x; return n; }\n' >fault.cpp
echo '[{"directory": "'"$PWD"'", "file": "fault.cpp", "command": "c++ -std=c++17 -c fault.cpp"}]' \
  >compile_commands.json
if echo fault.cpp | tidy . >found.txt; then
  echo "this test does not notice a faulty file"
  exit 1
fi
grep -q modernize-use-override found.txt
grep -q narrowing found.txt
echo "$(wc -l <files.txt) files"
