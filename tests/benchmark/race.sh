#!/bin/bash
# The race against POV-Ray: the Whitted scene at 2048x2048, 1 sample, one thread, each program's own trace time.
# Runs take turns; medians are compared. Exits 1 when the ratio is above 0.5.
#
#   race.sh [BUILD_FOLDER [RUNS [WHITTED.pov]]]
#
# The .pov file is looked for in RAYWALK_SHARED_DIR/data, else in ../shared/data beside the source folder.
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$source_dir/build/release}
runs=${2:-5}
shared=${RAYWALK_SHARED_DIR:-$(dirname "$source_dir")/shared}
pov=${3:-$shared/data/whitted.pov}
size=${RAYWALK_RACE_SIZE:-2048}
[ -f "$pov" ] || { echo "no $pov: pass the scene as the third argument" >&2; exit 2; }
command -v povray >/dev/null || { echo "povray is not installed (Debian: apt-get install povray)" >&2; exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

median() { sort -n "$1" | awk '{ v[NR] = $1 } END { printf "%.3f", NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'; }

for ((run = 1; run <= runs; ++run)); do
  for precision in double float; do
    # Through `time`: the processor time of the whole process, for machines that are busy with other things.
    { TIMEFORMAT=%U; time "$build/raywalk" render "$source_dir/scenes/whitted.toml" -o "$scratch/ours.pfm" \
        --size "${size}x$size" --spp 1 --threads 1 --precision $precision --stats "$scratch/stats.json" \
        >/dev/null 2>"$scratch/log" || { cat "$scratch/log" >&2; exit 1; } ; } 2>"$scratch/user"
    sed -n 's/.*"trace": *\([0-9.e+-]*\).*/\1/p' "$scratch/stats.json" >>"$scratch/trace.$precision"
    cat "$scratch/user" >>"$scratch/processor.$precision"
  done
  povray "+I$pov" "+O$scratch/theirs.png" "+W$size" "+H$size" -A +WT1 -D >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; exit 1; }
  # "Trace Time:  0 hours 0 minutes 4 seconds (4.123 seconds)" and "using 1 thread(s) with 4.056 CPU-seconds total"
  sed -n 's/^ *Trace Time: .*(\([0-9.]*\) seconds).*/\1/p' "$scratch/log" >>"$scratch/trace.povray"
  awk '/Trace Time:/ { getline; if (match($0, /[0-9.]+ CPU-seconds/)) print substr($0, RSTART, RLENGTH) + 0 }' "$scratch/log" \
    >>"$scratch/processor.povray"
done

failed=0
for kind in trace processor; do
  theirs=$(median "$scratch/$kind.povray")
  for precision in double float; do
    ours=$(median "$scratch/$kind.$precision")
    awk -v kind=$kind -v precision=$precision -v ours="$ours" -v theirs="$theirs" -v runs="$runs" 'BEGIN {
      what = kind == "trace" ? "trace time" : "processor time (ours: of the whole process)"
      printf "%s: raywalk %s %.3f s, povray %.3f s, ratio %.3f (medians of %d; goal: at most 0.5)\n", what, precision, ours, theirs, ours / theirs, runs
      exit !(ours / theirs <= 0.5) }' || { [ $kind = trace ] && failed=1; }
  done
done
exit $failed
