#!/usr/bin/env bash
# Measures the window under software OpenGL: seconds until the first frame, and the processor time it takes when
# nothing happens. Usage: tests/benchmark/window.sh [RAYWALK [SCENE]]; needs xvfb. Exits 1 when a goal is missed.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
raywalk=${1:-$root/build/release/raywalk}
scene=${2:-$root/scenes/classic.toml}
# Runs in a display of its own; $1 is what to measure.
measure() {
  LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1280x800x24 -noreset" \
    bash "$here/window.sh" --inside "$1" "$raywalk" "$scene" "$folder"
}

number() { sed -n "s/.*\"$1\": \([0-9.]*\).*/\1/p" "$2" | head -n 1; }

if [[ ${1:-} == --inside ]]; then
  what=$2 raywalk=$3 scene=$4 folder=$5
  rm -f "$folder/report.json"
  begun=$(date +%s.%N)
  "$raywalk" "$scene" --report "$folder/report.json" --state-dir "$folder/state" &
  id=$!
  until [[ -s $folder/report.json ]]; do sleep 0.01; done
  if [[ $what == first ]]; then
    # The report follows the third frame, so that the whole start is an upper bound.
    printf '%s %.3f\n' "$(number first_frame "$folder/report.json")" "$(awk "BEGIN { print $(date +%s.%N) - $begun }")"
  else
    until grep -q '"finished": true' "$folder/report.json" && grep -q '"idle": true' "$folder/report.json"; do sleep 0.2; done
    sleep 1
    ticks() { awk '{print $14 + $15}' "/proc/$id/stat"; }
    before=$(ticks)
    sleep 20
    printf '%.2f\n' "$(awk "BEGIN { print ($(ticks) - $before) / 20 * 100 / $(getconf CLK_TCK) }")"
  fi
  kill "$id"
  wait "$id" 2>/dev/null || true
  exit
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
read -r first whole < <(for _ in 1 2 3 4 5; do measure first; done | sort -n | sed -n 3p)
idle=$(measure idle)
printf 'first frame: %s s (goal: under 1); settled %s s after the program was started (medians of 5)\n' "$first" "$whole"
printf 'idle: %s %% of one processor over 20 s (goal: under 1)\n' "$idle"
awk "BEGIN { exit !($first < 1 && $idle < 1) }"
