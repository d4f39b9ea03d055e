#!/usr/bin/env bash
# The engine has the prefetches of the pair loops: g++ removes those that it takes for without effect, and results stay
# right without them.
set -euo pipefail
found=$(objdump -d --no-show-raw-insn "$ELLIPSOID_BIN/liggghts" | grep -cE '[[:space:]](prefetch|prfm)') || true
echo "$found prefetches"
[[ $found -ge 10 ]] || {
  echo "fewer than 10 prefetches in the engine: see src_liggghts/kernel/vectorised/prefetch.h" >&2
  exit 1
}
