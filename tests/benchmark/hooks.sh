#!/bin/bash
# What the empty observer costs: instructions of the trace phase (callgrind), with the hooks and with the hooks removed
# from the same source. Prints one line a scene; exits 1 when a ratio is above 1.01.
#
#   hooks.sh [BUILD_FOLDER [SCENE...]]
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$source_dir/build/release}
shift || true
[ $# -gt 0 ] || set -- "$source_dir"/scenes/*.toml
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

instructions() {  # PROGRAM SCENE
  valgrind --tool=callgrind --toggle-collect=raywalk_trace_phase --callgrind-out-file="$scratch/out" \
    "$1" "$2" 100x75 >"$scratch/shades" 2>"$scratch/log" || { cat "$scratch/log" >&2; exit 1; }
  sed -n 's/^summary: *//p;s/^totals: *//p' "$scratch/out" | tail -1
}

failed=0
for scene in "$@"; do
  with=$(instructions "$build/benchmark_hooks" "$scene")
  cp "$scratch/shades" "$scratch/shades_with"
  without=$(instructions "$build/benchmark_hooks_removed" "$scene")
  cmp -s "$scratch/shades_with" "$scratch/shades" || { echo "$(basename "$scene"): the two programs disagree" >&2; exit 1; }
  awk -v scene="$(basename "$scene")" -v with="$with" -v without="$without" 'BEGIN {
    printf "%s: %d instructions with hooks, %d without, ratio %.5f (goal: at most 1.01)\n", scene, with, without, with / without
    exit !(with > 0 && without > 0 && with / without <= 1.01) }' || failed=1
done
exit $failed
