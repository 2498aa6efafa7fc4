#!/bin/bash
# The race against Blender's Cycles on the CPU: the bunny in a closed room of 69,642 triangles (data/bunny_room.ply),
# path-traced on one thread. Geometry, camera, light, albedo, box filter and longest path are the same; cycles.py is
# Blender's side, and switches off what changes the picture: denoiser, adaptive sampling, clamping, light threshold.
#
#   cycles.sh [BUILD_FOLDER [RUNS]]
#
# First both render the room with many samples: their mean luminance has to agree within 2%, and so have the means of
# 8 x 8 parts of the picture within 5%, or it is not the same scene. Then runs take turns, and medians are compared:
#
#   tracing      processor seconds of a picture, less those of one with 1 sample (which has loading and building in it),
#                and so much more as the share of that sample; goal: at most half of Cycles'
#   equal error  the same times the mean squared error at as many samples, each against its own reference: the ratio
#                of seconds to equal error, were errors to fall as with independent samples
#   equal rays   tracing, but with paths of 4 rays that no roulette ends: both form the same number of rays
#
# Else paths have at most 10 rays, and each program ends some before by its own Russian roulette, Cycles fewer. Exits 1
# when the goal is missed or the pictures differ, 2 when something is missing. Environment: RAYWALK_SHARED_DIR (with
# data/bunny_room.ply; else the folder `shared` beside the source), RAYWALK_RACE_SCALE (a share of each picture's side:
# 0.1 to try the script).
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build=$(realpath -m "${1:-$source_dir/build/release}")
runs=${2:-5}
goal=0.5 samples=16 reference_samples=512
length=10   # most rays of a path
certain=0   # bounces of Cycles before its roulette; ours begins after 4 rays

shared=${RAYWALK_SHARED_DIR:-}
for folder in "$source_dir/../shared" "$source_dir/../../shared"; do
  [ -n "$shared" ] || { [ -d "$folder/data" ] && shared=$folder; } || true
done
mesh=$shared/data/bunny_room.ply
missing() { echo "cycles.sh: $1" >&2; exit 2; }
[ -x "$build/raywalk" ] || missing "there is no $build/raywalk (build the release preset first)"
[ -e "$mesh" ] || missing "there is no $mesh (see the head of this script)"
command -v blender >/dev/null || missing "blender is not installed (Debian: apt-get install blender)"
command -v python3 >/dev/null || missing "python3 is not installed (Debian: apt-get install python3)"
[[ $runs =~ ^[1-9][0-9]*$ ]] || missing "RUNS is \"$runs\" (expected a whole number from 1 on)"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

scaled() {
  awk -v side="$1" -v scale="${RAYWALK_RACE_SCALE:-1}" 'BEGIN { s = int(side * scale / 8) * 8; print (s < 8 ? 8 : s) }'
}
side=$(scaled 512)
small=$(scaled 128)

cp "$mesh" "$scratch/room.ply"
cat >"$scratch/room.toml" <<'ROOM'
title = "Bunny room"
description = "The Stanford bunny in a closed room, lit by a square below its ceiling."

[camera]
eye = [2.4184, 6.36349, 10.4013]
look_at = [-1.0816, 3.86349, -0.0987129]
up = [0, 1, 0]
fov = 50
fov_axis = "y"

[render]
integrator = "path"
sampler = "sobol"

[[object]]
name = "Room"
type = "mesh"
file = "room.ply"
smooth = false
material = { diffuse = 0.7 }

[[object]]
name = "Light"
type = "flat_polygon"
corners = [
  [-3.7216, 15.8633, -2.73871], [1.5584, 15.8633, -2.73871], [1.5584, 15.8633, 2.54129], [-3.7216, 15.8633, 2.54129],
]
material = { diffuse = 0, emission = 20 }
ROOM

# ours PICTURE PRECISION SIDE SEED SAMPLES: one run of raywalk; prints its processor seconds.
ours() {
  local TIMEFORMAT='%U %S'
  { time "$build/raywalk" render "$scratch/room.toml" -o "$scratch/$1.pfm" --threads 1 --path-length "$length" --quiet \
      --precision "$2" --size "$3x$3" --seed "$4" --spp "$5" >"$scratch/log" 2>&1; } 2>"$scratch/time" || {
    cat "$scratch/log" >&2
    missing "raywalk failed"
  }
  awk '{ print $1 + $2 }' "$scratch/time"
}

# theirs PICTURE SIDE SEED SAMPLES...: one run of Blender; prints the processor seconds for each number of samples.
theirs() {
  local picture=$1 side=$2 seed=$3
  shift 3
  rm -f "$scratch/$picture.pfm"
  # The first bounce of Blender follows the second ray, and the ray after the last one still meets the light.
  blender -b --factory-startup -noaudio -P "$source_dir/tests/benchmark/cycles.py" -- "$scratch/room.ply" \
    "$scratch/$picture.pfm" "$side" $((length - 2)) "$certain" "$seed" "$@" >"$scratch/log" 2>&1 || true
  if [ ! -e "$scratch/$picture.pfm" ]; then
    cat "$scratch/log" >&2
    missing "blender failed"
  fi
  sed -n 's/^cycles [0-9]* //p' "$scratch/log"
}

cat >"$scratch/pictures.py" <<'PYTHON'
import array, sys

def read(path):
    with open(path, "rb") as file:
        assert file.readline() == b"PF\n"
        width, height = map(int, file.readline().split())
        file.readline()
        values = array.array("f", file.read())
    return width, [0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in zip(values[0::3], values[1::3], values[2::3])]

(side, ours), (_, theirs) = read(sys.argv[2]), read(sys.argv[3])
if sys.argv[1] == "mse":
    print(sum((a - b) ** 2 for a, b in zip(ours, theirs)) / len(ours))
else:
    part = side // 8
    def mean(picture, column, row):
        rows = range(row * part, (row + 1) * part)
        return sum(sum(picture[y * side + column * part:][:part]) for y in rows) / part ** 2
    means = [(mean(ours, x, y), mean(theirs, x, y)) for y in range(8) for x in range(8)]
    off = sorted(abs(a / b - 1) for a, b in means)
    whole = sum(ours) / sum(theirs) - 1
    print(f"mean luminance {sum(ours) / len(ours):.4f}, {sum(theirs) / len(theirs):.4f}: {100 * whole:+.2f}%; "
          f"64 parts of it differ by {100 * off[32]:.2f}% (median), {100 * off[-1]:.2f}% at most")
    sys.exit(abs(whole) > 0.02 or off[-1] > 0.05)
PYTHON
pictures() { python3 "$scratch/pictures.py" "$@"; }
median() {
  sort -g "$1" | awk '{ v[NR] = $1 } END { if (NR == 0) exit 1
    printf "%.6g", NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'
}
tracing() {
  awk -v one="$1" -v all="$2" -v samples="$samples" 'BEGIN { print (all - one) * samples / (samples - 1) }'
}
# our_tracing PRECISION SEED, their_tracing SEED: processor seconds of tracing at full size
our_tracing() {
  tracing "$(ours picture "$1" "$side" "$2" 1)" "$(ours picture "$1" "$side" "$2" "$samples")"
}
their_tracing() {
  local seconds
  seconds=$(theirs their_picture "$side" "$1" 1 "$samples")
  # shellcheck disable=SC2086  # two numbers
  tracing $seconds
}

failed=0
echo "the same scene, $small x $small pixels of $reference_samples samples:"
ours reference double "$small" 1000 "$reference_samples" >/dev/null
theirs their_reference "$small" 1000 "$reference_samples" >/dev/null
pictures same "$scratch/reference.pfm" "$scratch/their_reference.pfm" ||
  { echo "cycles.sh: the pictures differ" >&2; exit 1; }

for ((run = 1; run <= runs; ++run)); do
  for precision in double float; do
    our_tracing "$precision" "$run" >>"$scratch/$precision.seconds"
    ours small "$precision" "$small" "$run" "$samples" >/dev/null
    pictures mse "$scratch/small.pfm" "$scratch/reference.pfm" >>"$scratch/$precision.error"
  done
  their_tracing "$run" >>"$scratch/cycles.seconds"
  theirs their_small "$small" "$run" "$samples" >/dev/null
  pictures mse "$scratch/their_small.pfm" "$scratch/their_reference.pfm" >>"$scratch/cycles.error"
done
length=4 certain=4
for ((run = 1; run <= runs; ++run)); do
  for precision in double float; do our_tracing "$precision" "$run" >>"$scratch/$precision.equal"; done
  their_tracing "$run" >>"$scratch/cycles.equal"
done

printf '%-12s %-7s %11s %11s %7s  goal: at most %s\n' figure scalar raywalk cycles ratio $goal
for precision in double float; do
  awk -v precision="$precision" -v goal="$goal" \
    -v ours="$(median "$scratch/$precision.seconds")" -v theirs="$(median "$scratch/cycles.seconds")" \
    -v our_error="$(median "$scratch/$precision.error")" -v their_error="$(median "$scratch/cycles.error")" \
    -v our_equal="$(median "$scratch/$precision.equal")" -v their_equal="$(median "$scratch/cycles.equal")" \
    'BEGIN {
      if (ours <= 0 || theirs <= 0 || their_equal <= 0) { print "too short to be measured"; exit 1 }
      ratio = ours / theirs
      errors = our_error / their_error
      met = ratio > goal ? "missed" : "met"
      printf "%-12s %-7s %9.3f s %9.3f s %7.3f  %s\n", "tracing", precision, ours, theirs, ratio, met
      printf "%-12s %-7s %11.6f %11.6f %7.3f\n", "error (MSE)", precision, our_error, their_error, errors
      printf "%-12s %-7s %11s %11s %7.3f\n", "equal error", precision, "", "", ratio * errors
      printf "%-12s %-7s %9.3f s %9.3f s %7.3f\n", "equal rays", precision, our_equal, their_equal,
        our_equal / their_equal
      exit met == "missed"
    }' || failed=1
done
echo "medians of $runs interleaved runs, one thread, $side x $side pixels of $samples samples"
exit $failed
