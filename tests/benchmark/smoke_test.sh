#!/bin/bash
# The benchmark programs run on a small scene and say what they should; no figure is judged.
set -euo pipefail
[ -n "${RAYWALK_BIN:-}" ] || { echo "no program to find the benchmarks beside"; exit 1; }
folder=$(dirname "$RAYWALK_BIN")
scene=$RAYWALK_SOURCE_DIR/scenes/classic.toml

with=$("$folder/benchmark_hooks" "$scene" 20x15)
without=$("$folder/benchmark_hooks_removed" "$scene" 20x15)
[ -n "$with" ] && [ "$with" = "$without" ] || { echo "with hooks: $with, without: $without"; exit 1; }

# Whether the goal is met is not asked: the machine may be busy, the build slow.
strip=$("$folder/benchmark_strip" "$scene" 1) || [ $? -eq 1 ]
grep -Eq '^[0-9]{4,} steps recorded in [0-9.]+ ms' <<<"$strip" || { echo "unexpected: $strip"; exit 1; }

live=$("$folder/benchmark_live" "$scene" 3) || [ $? -eq 1 ]
grep -Eq '^[0-9]{2,} items in a live frame: [0-9.]+ ms' <<<"$live" || { echo "unexpected: $live"; exit 1; }

photons=$("$folder/benchmark_photons" 1 8) || [ $? -eq 1 ]
grep -Eq '^map of 1000 photons: built in [0-9.]+ s' <<<"$photons" || { echo "unexpected: $photons"; exit 1; }
grep -Eq '^[0-9]+ photons in the plan: a step in [0-9.]+ ms' <<<"$photons" || { echo "unexpected: $photons"; exit 1; }

growth=$("$folder/benchmark_growth" 1000) || [ $? -eq 1 ]
grep -Eq "clusters: kdtree costs more|trees grow no faster" <<<"$growth" || { echo "unexpected: $growth"; exit 1; }

for numerics in robust naive; do
  "$folder/benchmark_numerics" sphere $numerics 100 | grep -Eq '^[0-9.]+$' || { echo "no sum of $numerics spheres"; exit 1; }
done
"$folder/benchmark_numerics" "$scene" ratio 8x6 | grep -Eq '^[0-9.]+$' || { echo "no ratio"; exit 1; }

if "$folder/benchmark_hooks" /nowhere.toml 2>/dev/null; then echo "no scene, but no error"; exit 1; fi

race=$("$folder/benchmark_mesh_race" 1 1 slivers)
grep -Eq '^slivers: 38400 triangles$' <<<"$race" || { echo "unexpected: $race"; exit 1; }
grep -Eq '^bounce 1 +[0-9.]+ \( +0\)' <<<"$race" || { echo "unexpected: $race"; exit 1; }

# A mesh of one triangle instead of the room: the mesh and the folder that holds it are not shipped.
mesh=$(mktemp --suffix=.ply)
trap 'rm -f "$mesh"' EXIT
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n-9 0 0\n9 0 0\n0 9 0\n3 0 1 2\n' >"$mesh"
bunny=$("$folder/benchmark_bunny_room" "$mesh" 16x16 1 1 1)
grep -Eq '^float  paths +[0-9.]+ million rays/s' <<<"$bunny" || { echo "unexpected: $bunny"; exit 1; }
