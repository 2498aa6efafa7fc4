#!/usr/bin/env bash
# What is installed of the library is enough for a program of somebody else: its example is built against it and runs.
set -euo pipefail

build=$(dirname "$RAYWALK_BIN")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --component library --prefix "$work/installed" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cmake -S "$RAYWALK_SOURCE_DIR/tests/library/example" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/installed" \
  >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
cmake --build "$work/build" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
"$work/build/example" >"$work/drawn"
diff - "$work/drawn" <<'DRAWN'
......................
..+++++++++++++++++#..
..+++++++++++++++###..
..+++++++++++++#####..
..+++++++++++#######..
..+++++++++#########..
..+++++++###########..
..+++++#############..
..+++###############..
..+#################..
......................
DRAWN

# Another minor version may be another interface.
mkdir "$work/later"
printf 'cmake_minimum_required(VERSION 3.20)\nproject(later LANGUAGES CXX)\nfind_package(raywalk 0.2 REQUIRED)\n' >"$work/later/CMakeLists.txt"
if cmake -S "$work/later" -B "$work/later/build" -DCMAKE_PREFIX_PATH="$work/installed" >"$work/log" 2>&1; then
  echo "version 0.2 was found where 0.1 is installed" >&2
  exit 1
fi
