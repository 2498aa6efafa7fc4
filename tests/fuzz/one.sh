#!/bin/bash
# One fuzzer for its time; prints a line of what came of it, exits with 1 when something broke.
#
#   one.sh BUILD_FOLDER NAME SECONDS
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build=$1 name=$2 seconds=$3
log=$build/fuzz-$name.log corpus=$build/corpus-$name
seeds=$source_dir/tests/fuzz/seeds/$name dict=$source_dir/tests/fuzz/$name.dict
case $name in
  toml | picture) seeds=$source_dir/scenes dict=$source_dir/tests/fuzz/toml.dict ;;
  link) seeds=$source_dir/tests/view/links ;;
  lesson | words) seeds=$source_dir/lessons ;;
esac
mkdir -p "$corpus"
options=("-max_total_time=$seconds" -max_len=20000 -timeout=10 -rss_limit_mb=2048 "-artifact_prefix=$build/$name-"
  -print_final_stats=1)
[[ -f $dict ]] && options+=("-dict=$dict")
cd "$build"
if "./fuzz_$name" "${options[@]}" "$corpus" "$seeds" >"$log" 2>&1; then
  printf 'fuzz_%s: %s inputs, none broke it\n' "$name" "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")"
else
  tail -n 30 "$log" >&2
  printf 'fuzz_%s: broken; the whole log is %s\n' "$name" "$log" >&2
  exit 1
fi
