# Helpers of the tests in this folder; to be sourced.
set -euo pipefail

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# expect_output PATTERN COMMAND...: COMMAND succeeds and prints something that matches
expect_output() {
  local pattern=$1 output
  shift
  output=$("$@" 2>&1) || fail "'$*' failed: $output"
  grep -Eq -- "$pattern" <<<"$output" || fail "'$*' printed no '$pattern': $output"
}

# expect_refusal PATTERN COMMAND...: COMMAND fails and prints something that matches
expect_refusal() {
  local pattern=$1 output
  shift
  if output=$("$@" 2>&1); then
    fail "'$*' succeeded, although it must be refused: $output"
  fi
  grep -Eq -- "$pattern" <<<"$(tr '\n' ' ' <<<"$output" | tr -s ' ')" ||
    fail "'$*' printed no '$pattern': $output"
}

pristine=$ELLIPSOID_BUILD/liggghts/pristine

# fresh_tree NAME: a copy of the host as it came, in the folder NAME
fresh_tree() {
  rm -rf "$1"
  cp -r "$pristine" "$1"
}

# mend_as_upstream TREE: the two lines as the newest public 3.8.0 tree has them
mend_as_upstream() {
  sed -i -E 's|^( *)return static_cast< std::ostringstream.*|\1std::ostringstream ss;\n\1ss << std::dec << a;\n\1return ss.str();|' "$1/src/utils.h"
  sed -i -E 's|(numneigh) > 0\)|\1)|' "$1/src/finish.cpp"
}

# made_tree FOLDER BRANCH VERSION [VARIANT...]: a small tree that the series fits
made_tree() {
  rm -rf "$1"
  python3 "$ELLIPSOID_SOURCE/tests/patches/_made_tree.py" "$@"
}
