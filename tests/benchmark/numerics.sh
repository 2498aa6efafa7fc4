#!/bin/bash
# What robust numerics cost against naive ones: the ratio of instructions (callgrind) and of seconds (the median of
# runs in turns), for each shape and for the shipped scenes that the tracer renders. Exits 1 when the instructions of
# all scenes together are above 1.2 times the naive ones.
#
#   numerics.sh [BUILD_FOLDER [SCENE...]]
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$source_dir/build/release}
shift || true
[ $# -gt 0 ] || set -- $(grep -L 'integrator *= *"path"' "$source_dir"/scenes/*.toml)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
program=$build/benchmark_numerics

instructions() {  # WHAT robust|naive AMOUNT
  valgrind --tool=callgrind --toggle-collect=raywalk_trace_phase --callgrind-out-file="$scratch/out" \
    "$program" "$@" >/dev/null 2>"$scratch/log" || { cat "$scratch/log" >&2; exit 1; }
  sed -n 's/^summary: *//p;s/^totals: *//p' "$scratch/out" | tail -1
}

all_robust=0 all_naive=0
line() {  # WHAT COUNTED TIMED UNITS
  local robust naive seconds
  robust=$(instructions "$1" robust "$2")
  naive=$(instructions "$1" naive "$2")
  seconds=$("$program" "$1" ratio "$3" 2>/dev/null)
  all_robust=$((all_robust + robust)) all_naive=$((all_naive + naive))
  awk -v what="$(basename "$1" .toml)" -v robust="$robust" -v naive="$naive" -v seconds="$seconds" -v units="$4" 'BEGIN {
    printf "%-24s %10.1f %10.1f   %5.2f   %5.2f\n", what, robust / units, naive / units, robust / naive, seconds }'
}

printf '%-24s %10s %10s   %5s   %5s\n' 'instructions a ray' robust naive ratio seconds
for shape in $("$program"); do line "$shape" 5000 100000 5000; done
printf '\n%-24s %10s %10s   %5s   %5s\n' 'instructions a pixel' robust naive ratio seconds
all_robust=0 all_naive=0
for scene in "$@"; do line "$scene" 60x45 200x150 2700; done
awk -v robust="$all_robust" -v naive="$all_naive" 'BEGIN {
  printf "\nall scenes: ratio %.3f (goal: at most 1.2)\n", robust / naive
  exit !(naive > 0 && robust / naive <= 1.2) }'
