#!/bin/bash
# The race against the program of P. Shirley, T. Black and S. Hollasch, "Ray Tracing in One Weekend" (release 4): the
# picture on its cover, of 500 spheres, at equal size, samples and longest path, one thread each.
#
#   rtiow.sh [BUILD_FOLDER [RUNS [CHECKOUT]]]
#
# CHECKOUT is the book's repository, which is not part of this one; RTIOW_SOURCE in the environment when left out:
#   git clone --branch release https://github.com/RayTracing/raytracing.github.io
# Its src/InOneWeekend is compiled with -O3 -DNDEBUG. Where its spheres lie follows from its rand(): its main.cc is
# compiled a second time, with a camera that writes our scene instead of rendering.
#
# Not the same in both: the book's fuzz adds a random vector, ours is microfacets (GGX) whose median ray is as far off;
# the book takes Schlick's approximation, we take Fresnel's equations; the book's sky goes on below the horizon, where
# ours is even; we also send a ray to the sky from every matt point, and end paths by Russian roulette. The mean
# colours have to agree within 2%, and the means of 8 x 5 parts of the picture within 6%.
#
# Runs take turns, each with a seed of its own, and the medians of processor seconds of the whole programs are compared;
# goal: at most a tenth of the book's. The variance of a pixel is half the mean square of what differs between the first
# two runs; times that, the ratio is that of seconds to equal error. Exits 1 when the goal is missed or
# the pictures differ, 2 when something is missing. Environment: RAYWALK_RACE_SCALE (a share of the samples: 0.1 to try
# the script).
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build=$(realpath -m "${1:-$source_dir/build/release}")
runs=${2:-5}
checkout=${3:-${RTIOW_SOURCE:-}}
goal=0.1 width=400 height=225 depth=50
samples=$(awk -v scale="${RAYWALK_RACE_SCALE:-1}" 'BEGIN { s = int(100 * scale); print (s < 1 ? 1 : s) }')

missing() { echo "rtiow.sh: $1" >&2; exit 2; }
[ -x "$build/raywalk" ] || missing "there is no $build/raywalk (build the release preset first)"
[ -n "$checkout" ] || missing "RTIOW_SOURCE is no checkout of the book's repository (see the head of this script)"
book=$checkout/src/InOneWeekend
[ -e "$book/main.cc" ] || missing "there is no $book/main.cc (see the head of this script)"
grep -q defocus_angle "$book/main.cc" || missing "$book/main.cc is not of release 4 (it has no defocus_angle)"
command -v g++ >/dev/null || missing "g++ is not installed (Debian: apt-get install g++)"
command -v python3 >/dev/null || missing "python3 is not installed (Debian: apt-get install python3)"
[[ $runs =~ ^[1-9][0-9]*$ ]] || missing "RUNS is \"$runs\" (expected a whole number from 1 on)"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

sed -E -e "s/(image_width *= *)[0-9]+/\1$width/" -e "s/(samples_per_pixel *= *)[0-9]+/\1$samples/" \
  -e "s/(max_depth *= *)[0-9]+/\1$depth/" -e 's/camera cam;/std::srand(std::atoi(std::getenv("RTIOW_SEED"))); &/' \
  "$book/main.cc" >"$scratch/main.cc"

# The camera that writes the scene; it takes the place of the book's, whose header thinks that it was read before.
cat >"$scratch/writer.cc" <<'CPLUSPLUS'
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>
#define private public  // The book's spheres and materials keep their numbers to themselves.
#include "rtweekend.h"

#include "hittable.h"
#include "hittable_list.h"
#include "material.h"
#include "sphere.h"
#define CAMERA_H
class camera {
 public:
  double aspect_ratio, vfov, defocus_angle, focus_dist;
  int image_width, samples_per_pixel, max_depth;
  point3 lookfrom, lookat;
  vec3 vup;

  static void list(const char* key, const vec3& v) {
    std::printf("%s = [%.17g, %.17g, %.17g]\n", key, v[0], v[1], v[2]);
  }

  void render(const hittable_list& world) {
    std::printf("title = \"The cover of a weekend\"\ndescription = \"Spheres by chance.\"\n");
    std::printf("background = [0.76, 0.856, 1]\n[sky]\ntype = \"gradient\"\n");
    std::printf("horizon = [0.75, 0.85, 1]\nzenith = [0.5, 0.7, 1]\nup = [0, 1, 0]\n[camera]\n");
    list("eye", lookfrom), list("look_at", lookat), list("up", vup);
    std::printf("fov = %g\nfov_axis = \"y\"\naperture = %.17g\nfocus = %g\n", vfov,
                focus_dist * std::tan(degrees_to_radians(defocus_angle / 2)), focus_dist);
    std::printf("[image]\nwidth = %d\nheight = %d\n", image_width, int(image_width / aspect_ratio));
    std::printf("[render]\nintegrator = \"path\"\nsampler = \"sobol\"\nsamples = %d\npath_length = %d\n",
                samples_per_pixel, max_depth);
    int number = 0;
    for (const auto& object : world.objects) {
      const auto& ball = dynamic_cast<const sphere&>(*object);
      std::printf("[[object]]\nname = \"Ball %d\"\ntype = \"sphere\"\nradius = %.17g\n", ++number, ball.radius);
      list("centre", ball.center);
      std::printf("[object.material]\n");
      const material* kind = ball.mat.get();
      if (const auto* matt = dynamic_cast<const lambertian*>(kind)) {
        list("diffuse", matt->albedo);
      } else if (const auto* mirror = dynamic_cast<const metal*>(kind)) {
        // The median distance of a point on the unit sphere from an axis is 0.866; that of a facet's ray, 2 alpha.
        std::printf("diffuse = 0\nroughness = %.17g\n", mirror->fuzz * 0.433);
        list("reflection", mirror->albedo);
      } else if (const auto* glass = dynamic_cast<const dielectric*>(kind)) {
        std::printf("diffuse = 0\ntransmission = 1\ndielectric = true\n");
        std::printf("ior = %.17g\n", glass->refraction_index);
      }
    }
  }
};
#include "main.cc"
CPLUSPLUS

g++ -std=c++17 -O3 -DNDEBUG -w "-I$book" "$scratch/main.cc" -o "$scratch/book" ||
  missing "the book's program does not compile"
g++ -std=c++17 -O3 -DNDEBUG -w "-I$book" "-I$scratch" "$scratch/writer.cc" -o "$scratch/writer" ||
  missing "the book's scene cannot be written (is the checkout of release 4?)"
RTIOW_SEED=1 "$scratch/writer" >"$scratch/cover.toml"

# seconds COMMAND...: runs it, and prints its processor seconds.
seconds() {
  local TIMEFORMAT='%U %S'
  { time "$@" >"$scratch/out" 2>"$scratch/log"; } 2>"$scratch/time" || {
    cat "$scratch/log" >&2
    missing "$1 failed"
  }
  awk '{ print $1 + $2 }' "$scratch/time"
}
median() {
  sort -g "$1" | awk '{ v[NR] = $1 } END { if (NR == 0) exit 1
    printf "%.6g", NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'
}

for ((run = 1; run <= runs; ++run)); do
  for precision in double float; do
    seconds "$build/raywalk" render "$scratch/cover.toml" -o "$scratch/$run.pfm" --precision "$precision" --threads 1 \
      --seed "$run" --quiet >>"$scratch/$precision"
  done
  RTIOW_SEED=$run seconds "$scratch/book" >>"$scratch/book.seconds"
  mv "$scratch/out" "$scratch/$run.ppm"
done

# The book's picture has 8 bits and a gamma of 2; ours gets as much.
failed=0
python3 - "$scratch" "$runs" <<'PYTHON' || failed=1
import array, math, sys

scratch, runs = sys.argv[1], int(sys.argv[2])

def linear(values):
    return [((value + 0.5) / 256) ** 2 for value in values]

def book(run):
    with open(f"{scratch}/{run}.ppm") as file:
        width, height, _, *values = map(int, file.read().split()[1:])
    return width, height, linear(values)

def ours(run):
    with open(f"{scratch}/{run}.pfm", "rb") as file:
        assert file.readline() == b"PF\n"
        width, height = map(int, file.readline().split())
        file.readline()
        upward = array.array("f", file.read())
    rows = [upward[3 * width * y:][:3 * width] for y in reversed(range(height))]
    return width, height, linear(int(256 * min(math.sqrt(max(v, 0)), 0.999)) for row in rows for v in row)

width, height, our_picture = ours(1)
their_width, their_height, their_picture = book(1)
assert (width, height) == (their_width, their_height)

def mean(picture, channel, x0=0, x1=width, y0=0, y1=height):
    return sum(sum(picture[3 * (y * width + x0) + channel:3 * (y * width + x1):3]) for y in range(y0, y1)) / (
        (x1 - x0) * (y1 - y0))

colours = [[mean(picture, channel) for channel in range(3)] for picture in (our_picture, their_picture)]
worst = max(abs(a / b - 1) for a, b in zip(*colours))
wide, high = width // 8, height // 5
parts = [(x, x + wide, y, y + high) for y in range(0, height, high) for x in range(0, width, wide)]
off = sorted(abs(sum(mean(our_picture, channel, *part) for channel in range(3)) /
                 sum(mean(their_picture, channel, *part) for channel in range(3)) - 1) for part in parts)
print("mean colours " + " and ".join("(%.4f, %.4f, %.4f)" % tuple(colour) for colour in colours) +
      f", {100 * worst:.2f}% apart; 40 parts differ by {100 * off[20]:.2f}% (median), {100 * off[-1]:.2f}% at most")
if runs > 1:
    variances = [sum((a - b) ** 2 for a, b in zip(first, read(2)[2])) / (2 * len(first))
                 for first, read in ((our_picture, ours), (their_picture, book))]
    with open(f"{scratch}/errors", "w") as file:
        print(variances[0] / variances[1], file=file)
    print("variance of a pixel %.3g and %.3g" % tuple(variances))
sys.exit(worst > 0.02 or off[-1] > 0.06)
PYTHON
((failed)) && echo "rtiow.sh: the pictures differ" >&2

errors=$(cat "$scratch/errors" 2>/dev/null || true)  # none of a single run
printf '%-7s %11s %11s %7s  goal: at most %s\n' scalar raywalk book ratio $goal
for precision in double float; do
  awk -v precision="$precision" -v goal="$goal" -v errors="$errors" \
    -v ours="$(median "$scratch/$precision")" -v theirs="$(median "$scratch/book.seconds")" 'BEGIN {
      ratio = theirs > 0 ? ours / theirs : 1
      met = ratio > goal ? "missed" : "met"
      printf "%-7s %9.3f s %9.3f s %7.3f  %s", precision, ours, theirs, ratio, met
      print (errors == "" ? "" : sprintf("; to equal error %.3f", ratio * errors))
      exit met == "missed"
    }' || failed=1
done
echo "medians of $runs interleaved runs, one thread, processor seconds of the whole programs," \
  "$width x $height pixels of $samples samples"
exit $failed
