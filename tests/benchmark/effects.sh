#!/bin/bash
# What an effect costs a scene that does not call for it: instructions of the trace phase (callgrind), against the same
# source with the effect's code removed. Prints one line for each effect and scene; exits 1 when a ratio is
# above 1.001. Indirect light has a procedure of its own (trace/path.h): nothing of it stands in the tracer.
#
#   effects.sh [BUILD_FOLDER [SCENE...]]
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build=$(realpath "${1:-$source_dir/build/release}")
shift || true
[ $# -gt 0 ] || set -- "$source_dir"/scenes/{appel,classic,mirrors,glass,gloss,penumbra,hard/facing_mirrors,hard/nested_glass}.toml
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
effects=(shadows reflection refraction gloss translucency penumbra depth_of_field motion_blur antialiasing textures sky filtering microfacets maps)
cmake --build "$build" --target benchmark_hooks "${effects[@]/#/benchmark_without_}" >"$scratch/build" ||
  { cat "$scratch/build" >&2; exit 1; }

instructions() {  # PROGRAM SCENE
  valgrind --tool=callgrind --toggle-collect=raywalk_trace_phase --callgrind-out-file="$scratch/out" \
    "$1" "$2" 100x75 >"$scratch/shades" 2>"$scratch/log" || { cat "$scratch/log" >&2; exit 1; }
  sed -n 's/^summary: *//p;s/^totals: *//p' "$scratch/out" | tail -1
}

failed=0
for scene in "$@"; do
  unused=$("$build/raywalk" info "$scene" 2>/dev/null | sed -n 's/^  \([a-z_]*\) *none: .*/\1/p')
  with=$(instructions "$build/benchmark_hooks" "$scene")
  mv "$scratch/shades" "$scratch/shades_with"
  for effect in "${effects[@]}"; do
    grep -qx "$effect" <<<"$unused" || continue
    without=$(instructions "$build/benchmark_without_$effect" "$scene")
    cmp -s "$scratch/shades_with" "$scratch/shades" || { echo "$scene: the programs disagree without $effect" >&2; exit 1; }
    awk -v scene="$(basename "$scene")" -v effect="$effect" -v with="$with" -v without="$without" 'BEGIN {
      printf "%-20s %-14s %10.0f instructions, without its code %10.0f, ratio %.5f\n", scene, effect, with, without, with / without
      exit !(with > 0 && without > 0 && with / without <= 1.001) }' || failed=1
  done
done
[ $failed -eq 0 ] && echo "goal met: at most 1.001" || echo "goal missed: at most 1.001"
exit $failed
