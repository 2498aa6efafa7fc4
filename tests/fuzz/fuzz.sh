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
all=(toml picture nff test obj mtl ply gltf texture pfm exr lesson words demo state)
names=("$@")
((${#names[@]})) || names=("${all[@]}")
build=$source_dir/build/fuzz
cd "$source_dir"
cmake --preset fuzz ${CLANG:+-DCMAKE_CXX_COMPILER="$CLANG"} >/dev/null
cmake --build "$build" --target "${names[@]/#/fuzz_}" >&2

# fuzz NAME: one fuzzer for its time; a line of what came of it. Fails when something broke.
fuzz() {
  local name=$1 log=$build/fuzz-$1.log seeds=$source_dir/tests/fuzz/seeds/$1 dict=$source_dir/tests/fuzz/$1.dict corpus
  case $name in
    toml | picture) seeds=$source_dir/scenes dict=$source_dir/tests/fuzz/toml.dict ;;
    lesson | words) seeds=$source_dir/lessons ;;
  esac
  corpus=$build/corpus-$name
  mkdir -p "$corpus"
  local options=("-max_total_time=$seconds" -max_len=20000 -timeout=10 -rss_limit_mb=2048
    "-artifact_prefix=$build/$name-" -print_final_stats=1)
  [[ -f $dict ]] && options+=("-dict=$dict")
  if (cd "$build" && "./fuzz_$name" "${options[@]}" "$corpus" "$seeds") >"$log" 2>&1; then
    printf 'fuzz_%s: %s inputs, none broke it\n' "$name" "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")"
  else
    tail -n 30 "$log" >&2
    printf 'fuzz_%s: broken; the whole log is %s\n' "$name" "$log" >&2
    return 1
  fi
}

failed=0
running=0
for name in "${names[@]}"; do
  if ((running >= ${JOBS:-$(nproc)})); then
    wait -n || failed=1
    running=$((running - 1))
  fi
  fuzz "$name" &
  running=$((running + 1))
done
while ((running > 0)); do
  wait -n || failed=1
  running=$((running - 1))
done
exit $failed
