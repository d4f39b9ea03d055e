#!/usr/bin/env bash
# Every C++ file stands as clang-format 14 writes it by the project's .clang-format. Other versions
# write some lines in another way, so that they do not check.
set -euo pipefail
readonly wanted=14 skipped=77

formatter=""
for candidate in "clang-format-$wanted" clang-format; do
  if command -v "$candidate" >/dev/null && "$candidate" --version | grep -q " version $wanted\."; then
    formatter=$candidate
    break
  fi
done
if [[ -z $formatter ]]; then
  echo "the format is not checked: clang-format $wanted is missing (Debian 12: clang-format)"
  exit "$skipped"
fi

mapfile -t files < <(find "$ELLIPSOID_SOURCE/src_liggghts" "$ELLIPSOID_SOURCE/postprocess" \
  "$ELLIPSOID_SOURCE/tests" -name '*.cpp' -o -name '*.h')
[[ ${#files[@]} -gt 200 ]]
"$formatter" --style=file --dry-run --Werror "${files[@]}" || {
  echo "some of ${#files[@]} files differ from the format; run: $formatter -i FILE"
  exit 1
}

# the check sees what it should
if printf 'namespace ellipsoid {\nint   f( );\n}\n' |
  "$formatter" --style=file --assume-filename="$ELLIPSOID_SOURCE/fault.h" --dry-run --Werror 2>/dev/null; then
  echo "this test does not notice a file out of format"
  exit 1
fi
echo "${#files[@]} files"
