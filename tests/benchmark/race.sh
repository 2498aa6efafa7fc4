#!/bin/bash
# The races against POV-Ray 3.7: the same scene, one thread, each program's own trace time.
#
#   race.sh [BUILD_FOLDER [RUNS [SCENE...]]]      scenes: whitted1 whitted9 balls dist; all when left out
#
#   whitted1   Whitted's spheres, 1 sample a pixel
#   whitted9   the same, 9 samples a pixel
#   balls      the sphereflake of 7,381 spheres; POV-Ray's scene is written by `raywalk convert`
#   dist       Whitted's spheres under an area light of 4 x 4 samples, through a lens of 16 samples
#
# Runs take turns with POV-Ray's, so that a busy machine slows both, and medians are compared. Exits 1 when a ratio is
# above the goal, 2 when something is missing. Environment: RAYWALK_SHARED_DIR (with data/*.pov and *.nff; else the
# folder `shared` beside the source), RAYWALK_RACE_SCALE (a share of each picture's side: 0.1 to try the script).
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$source_dir/build/release}
runs=${2:-5}
shift $(($# < 2 ? $# : 2))
scenes=("$@")
((${#scenes[@]})) || scenes=(whitted1 whitted9 balls dist)
goal=0.25

shared=${RAYWALK_SHARED_DIR:-}
for folder in "$source_dir/../shared" "$source_dir/../../shared"; do
  [ -n "$shared" ] || { [ -d "$folder/data" ] && shared=$folder; } || true
done
data=$shared/data
need() { [ -e "$1" ] || { echo "race.sh: there is no $1 ($2)" >&2; exit 2; }; }
need "$build/raywalk" "build the release preset first"
command -v povray >/dev/null || { echo "race.sh: povray is not installed (Debian: apt-get install povray)" >&2; exit 2; }
[[ $runs =~ ^[1-9][0-9]*$ ]] || { echo "race.sh: RUNS is \"$runs\" (expected a whole number from 1 on)" >&2; exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

scaled() { awk -v side="$1" -v scale="${RAYWALK_RACE_SCALE:-1}" 'BEGIN { printf "%d", side * scale < 1 ? 1 : side * scale }'; }
median() {
  sort -g "$1" | awk '{ v[NR] = $1 } END { if (NR == 0) exit 1
    printf "%.4f", NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'
}

# ours KEY SCENE ARGS...: one run of raywalk; its trace time goes to KEY.trace, the processor time of the whole process
# to KEY.processor.
ours() {
  local key=$1 scene=$2 status=0
  shift 2
  TIMEFORMAT='%U'
  { time "$build/raywalk" render "$scene" -o "$scratch/ours.pfm" --threads 1 --stats "$scratch/stats.json" "$@" \
      >"$scratch/log" 2>&1; } 2>"$scratch/user" || status=$?
  if ((status)); then
    cat "$scratch/log" >&2
    echo "race.sh: raywalk failed on $scene" >&2
    exit 2
  fi
  sed -n 's/.*"trace": *\([0-9.e+-]*\).*/\1/p' "$scratch/stats.json" >>"$scratch/$key.trace"
  cat "$scratch/user" >>"$scratch/$key.processor"
}

# theirs KEY SCENE.pov SIZE ARGS...: one run of POV-Ray.
theirs() {
  local key=$1 scene=$2 side=$3
  shift 3
  if ! povray "+I$scene" "+O$scratch/theirs.png" "+W$side" "+H$side" +WT1 -D "$@" >"$scratch/log" 2>&1; then
    cat "$scratch/log" >&2
    echo "race.sh: povray failed on $scene" >&2
    exit 2
  fi
  # "Trace Time:  0 hours 0 minutes 4 seconds (4.123 seconds)" and "using 1 thread(s) with 4.056 CPU-seconds total"
  sed -n 's/^ *Trace Time: .*(\([0-9.]*\) seconds).*/\1/p' "$scratch/log" >>"$scratch/$key.trace"
  awk '/Trace Time:/ { getline; if (match($0, /[0-9.]+ CPU-seconds/)) print substr($0, RSTART, RLENGTH) + 0 }' \
    "$scratch/log" >>"$scratch/$key.processor"
}

# race NAME SIDE OURS THEIRS.pov "OUR ARGS" "POV ARGS"
race() {
  local name=$1 side scene=$3 pov=$4 our_args pov_args precision run
  side=$(scaled "$2")
  read -ra our_args <<<"$5"
  read -ra pov_args <<<"$6"
  need "$scene" "see the head of this script"
  need "$pov" "see the head of this script"
  for ((run = 1; run <= runs; ++run)); do
    for precision in double float; do
      ours "$name.$precision" "$scene" --size "${side}x$side" --precision "$precision" "${our_args[@]}"
    done
    theirs "$name.povray" "$pov" "$side" "${pov_args[@]}"
  done
  for precision in double float; do
    local kind
    for kind in trace processor; do
      awk -v name="$name" -v kind="$kind" -v precision="$precision" -v side="$side" -v goal="$goal" \
        -v ours="$(median "$scratch/$name.$precision.$kind")" -v theirs="$(median "$scratch/$name.povray.$kind")" \
        'BEGIN {
          ratio = theirs > 0 ? sprintf("%.3f", ours / theirs) : "-"
          met = kind != "trace" ? "" : ratio == "-" || ratio > goal ? "missed" : "met"
          printf "%-9s %5d %-7s %-10s %9.3f s %9.3f s %7s  %s\n", name, side, precision, kind, ours, theirs, ratio, met
          exit met == "missed"
        }' || failed=1
    done
  done
}

failed=0
printf '%-9s %5s %-7s %-10s %11s %11s %7s  goal: at most %s\n' scene side scalar time raywalk povray ratio $goal
for scene in "${scenes[@]}"; do
  case $scene in
    whitted1) race whitted1 2048 "$source_dir/scenes/whitted.toml" "$data/whitted.pov" "--spp 1" "-A" ;;
    whitted9) race whitted9 1024 "$source_dir/scenes/whitted.toml" "$data/whitted.pov" "--spp 9" "+A0.0 +AM1 +R3" ;;
    balls)
      need "$data/balls.nff" "see the head of this script"
      "$build/raywalk" convert "$data/balls.nff" "$scratch/balls.pov"
      race balls 1024 "$data/balls.nff" "$scratch/balls.pov" "" "-A"
      ;;
    dist) race dist 256 "$source_dir/tests/benchmark/dist.toml" "$data/dist.pov" "--spp 16" "-A" ;;
    *) echo "race.sh: there is no race $scene (expected whitted1, whitted9, balls or dist)" >&2; exit 2 ;;
  esac
done
echo "medians of $runs interleaved runs, one thread; processor: of raywalk's whole process, of POV-Ray's tracing"
exit $failed
