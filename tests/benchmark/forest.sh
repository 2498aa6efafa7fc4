#!/bin/bash
# What 10,000 copies of a mesh take: a forest of balls of 70,000 triangles each, made, read and rendered at 512x384 with
# the program's own threads. Prints the peak of memory, seconds and what a ray meets; exits 1 above 1 GiB.
#
#   forest.sh [BUILD_FOLDER [MESH [UP]]]
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build=$(realpath "${1:-$source_dir/build/release}")
mesh=${2:-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [ -z "$mesh" ]; then
  mesh=$scratch/ball.ply
  "$build/raywalk" generate mesh --count 70000 -o "$mesh"
fi
"$build/raywalk" generate forest --count 10000 --mesh "$mesh" --up "${3:-z}" -o "$scratch/forest.toml"
python3 - "$build/raywalk" "$scratch" <<'PYTHON'
import json, resource, subprocess, sys, time
program, scratch = sys.argv[1:]
begin = time.time()
subprocess.run([program, "render", scratch + "/forest.toml", "-o", scratch + "/forest.png", "--quiet",
                "--stats", scratch + "/stats.json"], check=True)
seconds, peak = time.time() - begin, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
print(f"10,000 copies: {peak:.0f} MiB at most, {seconds:.1f} s in all")
print("goal met: below 1024 MiB" if peak < 1024 else "goal missed: below 1024 MiB")
sys.exit(peak >= 1024)
PYTHON
