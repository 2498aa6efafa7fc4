#!/bin/bash
# Fuzzes every reader, and "read a scene, then trace it", with the address and undefined-behaviour sanitizers.
#
#   fuzz.sh [SECONDS [NAME...]]      10 seconds each when left out; NAMEs: see `all` below
#
# What breaks one is left beside the fuzzers, in build/fuzz, as crash-... or timeout-...; run the fuzzer on that file
# alone to see it again. What was found worth keeping stays in build/fuzz/corpus-NAME for the next time. JOBS fuzzers run
# side by side, as many as there are processors when it is left out.
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
seconds=${1:-10}
shift || true
all=(toml picture nff test obj mtl ply gltf texture pfm hdr exr lesson words demo link patch packed state)
names=("$@")
((${#names[@]})) || names=("${all[@]}")
build=$source_dir/build/fuzz
cd "$source_dir"
cmake --preset fuzz ${CLANG:+-DCMAKE_CXX_COMPILER="$CLANG"} >/dev/null
cmake --build "$build" --target "${names[@]/#/fuzz_}" >&2

failed=0
running=0
for name in "${names[@]}"; do
  if ((running >= ${JOBS:-$(nproc)})); then
    wait -n || failed=1
    running=$((running - 1))
  fi
  "$source_dir/tests/fuzz/one.sh" "$build" "$name" "$seconds" &
  running=$((running + 1))
done
while ((running > 0)); do
  wait -n || failed=1
  running=$((running - 1))
done
exit $failed
