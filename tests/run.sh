#!/usr/bin/env bash
# Sets everything up, builds, and runs all tests. Ends with CTest's own summary.
#
#   bash tests/run.sh [CMAKE_OPTION...]      for example -DELLIPSOID_VTK=OFF
#
# With CI set in the environment, warnings are errors, and progress is a line every 30 s.
set -euo pipefail
# shellcheck source=../inputs/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../inputs/setup.sh"

# what checks the sources and the pages, and what films are joined with
wanted_packages+=(chromium ffmpeg clang-format clang-tidy python3-sphinx python3-myst-parser python3-sphinx-rtd-theme)

stage "1/4 Packages"
install_missing_packages "$@"
stage "2/4 Configuring; LIGGGHTS is fetched the first time"
configure "$@"
stage "3/4 Building the engine, the tools, the tests and the unpatched engine"
build_targets all liggghts_stock
stage "4/4 Testing"
exec ctest --test-dir "$build" --output-on-failure --no-tests=error --parallel 2
