#!/usr/bin/env bash
# The numbers hold however they are compiled: g++ and clang, without and with full optimisation, for any x86-64 processor
# and with AVX2 and FMA. In each of the eight builds the hard-case suite and the tests of the floors that compute run
# (invariants 1 to 3 of CONTRIBUTING.md are among them), and the shipped scenes give the same pictures, bit for bit. A ninth
# build lets the compiler fuse multiplications and additions: what meshes promise must hold even so.
#
#   tests/builds/run.sh [NAME...]  all builds, or those named: g++-O0, g++-O0-fma, g++-O3, ... clang-O3-fma, contracted
#
# RAYS: of each family of the suite, 300000 when left out. CLANG: the name of clang. Built in build/builds.
set -uo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$root/build/builds
rays=${RAYS:-300000}
clang=${CLANG:-clang++-19}
wanted=("$@")
failed=0
first=
floors='^(math|shape|accel|trace|render|check)$'

# build NAME COMPILER FLAGS [OPTIONS...]: configures and builds without the window.
build() {
  local build=$work/$1 targets=(numbers)
  [[ $1 == contracted ]] || targets+=(test_math test_shape test_accel test_trace test_render test_check)
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$2" -DCMAKE_BUILD_TYPE=Measured \
    -DCMAKE_CXX_FLAGS_MEASURED="$3" -DRAYWALK_GUI=OFF -DRAYWALK_TESTS=ON "${@:4}" >"$build.log" 2>&1 &&
    cmake --build "$build" --target "${targets[@]}" >>"$build.log" 2>&1
}

# verdict NAME WHAT: prints and counts.
verdict() {
  printf '%-14s %s\n' "$1" "$2"
  [[ $2 == ok ]] || failed=$((failed + 1))
}

# try NAME COMPILER FLAGS [OPTIONS...]
try() {
  local name=$1
  ((${#wanted[@]} == 0)) || [[ " ${wanted[*]} " == *" $name "* ]] || return 0
  mkdir -p "$work"
  if ! build "$@"; then
    verdict "$name" "does not build: see $work/$name.log"
  elif [[ $name == contracted ]]; then
    if "$work/$name/numbers" suite "$rays" mesh >>"$work/$name.log" 2>&1; then
      verdict "$name" ok
    else
      verdict "$name" "meshes leak: see $work/$name.log"
    fi
  elif ! "$work/$name/numbers" suite "$rays" >>"$work/$name.log" 2>&1; then
    verdict "$name" "the hard-case suite broke: see $work/$name.log"
  elif ! ctest --test-dir "$work/$name" -R "$floors" -j "$(nproc)" --output-on-failure >>"$work/$name.log" 2>&1; then
    verdict "$name" "a test failed: see $work/$name.log"
  elif ! "$work/$name/numbers" pictures "$root"/scenes/*.toml "$root"/scenes/hard/*.toml >"$work/$name.sums"; then
    verdict "$name" "a scene could not be rendered"
  elif [[ -n $first ]] && ! diff "$first" "$work/$name.sums" >>"$work/$name.log"; then
    verdict "$name" "its pictures are not those of the first build: see $work/$name.log"
  else
    first=${first:-$work/$name.sums}
    verdict "$name" ok
  fi
}

for compiler in g++ "$clang"; do
  for level in O0 O3; do
    try "${compiler%++*}++-$level" "$compiler" "-$level"
    try "${compiler%++*}++-$level-fma" "$compiler" "-$level -mavx2 -mfma"
  done
done
try contracted g++ "-O3 -mavx2 -mfma" -DRAYWALK_CONTRACT=fast
exit $((failed > 0))
