#!/bin/bash
# Fuzzes the readers of scenes: TOML, NFF and the course format, with the address and undefined-behaviour sanitizers.
#
#   fuzz.sh [SECONDS [FORMAT...]]      10 seconds each when left out; formats: toml nff test
#
# What breaks a reader is left beside the fuzzers, in build/fuzz, as crash-... or timeout-...; run the fuzzer on that
# file alone to see it again. What was found worth keeping stays in build/fuzz/corpus-FORMAT for the next time.
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
seconds=${1:-10}
shift || true
formats=("$@")
((${#formats[@]})) || formats=(toml nff test)
build=$source_dir/build/fuzz
cd "$source_dir"
cmake --preset fuzz ${CLANG:+-DCMAKE_CXX_COMPILER="$CLANG"} >/dev/null
cmake --build "$build" --target "${formats[@]/#/fuzz_}" >&2
failed=0
for format in "${formats[@]}"; do
  corpus=$build/corpus-$format
  mkdir -p "$corpus"
  seeds=("$source_dir/tests/fuzz/seeds/$format")
  [ "$format" = toml ] && seeds=("$source_dir/scenes")
  log=$build/fuzz-$format.log
  if "$build/fuzz_$format" -max_total_time="$seconds" -max_len=20000 -timeout=10 -rss_limit_mb=2048 \
      -dict="$source_dir/tests/fuzz/$format.dict" -artifact_prefix="$build/" -print_final_stats=1 \
      "$corpus" "${seeds[@]}" >"$log" 2>&1; then
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    echo "fuzz_$format: $runs texts, none broke the reader"
  else
    tail -n 30 "$log" >&2
    echo "fuzz_$format: broken; the whole log is $log" >&2
    failed=1
  fi
done
exit $failed
