#!/usr/bin/env bash
# Tests of the tests: each mutant changes one place of the numeric code; the suite must notice ("killed"). Prints a line
# a mutant, and at the end how many survived; exits with 1 when one did.
#
#   tests/mutants/run.sh [NAME...]     all mutants, or those named; what is done already is not done again
#   tests/mutants/run.sh --fresh       forgets what is done
#   tests/mutants/run.sh --check       only looks whether each still has its line in the source, and whether a suite
#                                      still builds
#
# Results are kept in build/mutants. CXX chooses the compiler.
set -uo pipefail
export LC_ALL=C  # else bash counts letters where it looks for a line

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$root/build/mutants
results=$work/results
cxx=${CXX:-g++}
# Catch2 v3's libraries, or v2's.
catch2=(-lCatch2WithMain)
"$cxx" -x c++ -E -include catch2/catch_test_macros.hpp /dev/null >/dev/null 2>&1 && catch2=(-lCatch2Main -lCatch2)
only_check=0
level=-O1
[[ ${1:-} == --fresh ]] && { rm -rf "$work"; shift; }
[[ ${1:-} == --check ]] && { only_check=1; shift; }
((only_check)) && { work=$(mktemp -d) results=$work/results level=-O0; trap 'rm -rf "$work"' EXIT; }
mkdir -p "$work" && touch "$results"
wanted=("$@")
survived=0
killed=0

# suspect WHO: how suspects.cpp is compiled for a mutant of WHO.
suspect() {
  case $1 in
    mesh | accel | transform | arithmetic) printf '%s\n' "-DSUSPECT=${1^^}" ;;
    Prism | Polygon | Triangle) printf '%s\n' "-DSHAPE_ALONE=$1" ;;
    *) printf '%s\n' "-DSHAPE=$1" ;;
  esac
}

# verdict NAME WHO FLAGS FOLDER: compiles the suspects over FOLDER/src and runs them.
verdict() {
  local log=$work/$1.log program=("$(suspect "$2")" "$root/tests/mutants/suspects.cpp") libraries=(-lgmpxx -lgmp)
  # Whatever concerns no crossing has to get past a test of its own.
  [[ $2 == accel || $2 == mesh ]] && program+=("$4"/src/accel/{binary_tree,mesh_copies,lane_searches,packet_search,reinsertion,search_record,searches_eight,searches_four,searches_masked,spatial_split,structures,wide_search,wide_tree,width}.cpp)
  [[ $2 == splits ]] && program=("-I$root/tests" "$root/tests/accel/wide_tree_test.cpp" "$4"/src/accel/{binary_tree,reinsertion,search_record,spatial_split,wide_tree}.cpp) \
    libraries=("${catch2[@]}")
  [[ $2 == copies ]] && program=("-I$root/tests" "$root/tests/accel/copies_test.cpp" \
    "$4"/src/accel/{accelerator,accelerator_float,accelerator_naive,binary_tree,mesh_copies,lane_searches,packet_search,reinsertion,search_record,searches_eight,searches_four,searches_masked,spatial_split,structures,watched,wide_search,wide_tree,width}.cpp) \
    libraries=("${catch2[@]}")
  [[ $2 == widths ]] && program=("-I$root/tests" "$root/tests/accel/width_test.cpp" \
    "$4"/src/accel/{accelerator,accelerator_float,binary_tree,mesh_copies,lane_searches,packet_search,reinsertion,search_record,searches_eight,searches_four,searches_masked,spatial_split,structures,wide_search,wide_tree,width}.cpp) \
    libraries=("${catch2[@]}")
  [[ $2 == packets ]] && program=("-I$root/tests" "$root/tests/accel/packet_test.cpp" \
    "$4"/src/accel/{accelerator,accelerator_float,binary_tree,library,mesh_copies,lane_searches,packet_search,reinsertion,search_record,searches_eight,searches_four,searches_masked,spatial_split,structures,wide_search,wide_tree,width}.cpp) \
    libraries=("${catch2[@]}")
  [[ $2 == beam_faces ]] && program=("-I$root/tests" -DNDEBUG "$root/tests/trace/beam_faces_test.cpp" "$4"/src/trace/{beam_faces,beam_window}.cpp \
    "$4"/src/accel/{binary_tree,reinsertion,search_record,spatial_split,wide_tree}.cpp) libraries=("${catch2[@]}")
  [[ $2 == cone_bodies ]] && program=("-I$root/tests" "$root/tests/trace/cone_bodies_test.cpp" "$4"/src/trace/{cone_bodies,ray_cone}.cpp) \
    libraries=("${catch2[@]}")
  [[ $2 == uv ]] && program=("-I$root/tests" "$root/tests/shape/uv_test.cpp") libraries=("${catch2[@]}")
  [[ $2 == stack ]] && program=("-I$root/tests" "$root/tests/trace/body_stack_test.cpp") libraries=("${catch2[@]}")
  [[ $2 == photons ]] && program=("-I$root/tests" "$root/tests/trace/photon_map_test.cpp" "$4/src/trace/photon_map.cpp") \
    libraries=("${catch2[@]}")
  [[ $2 == media ]] && program=("-I$root/tests" "$root/tests/trace/"{phase,free_path}_test.cpp "$4/src/math/sampler.cpp") libraries=("${catch2[@]}")
  [[ $2 == dipole ]] && program=("-I$root/tests" "$root/tests/trace/dipole_test.cpp") libraries=("${catch2[@]}")
  [[ $2 == radiosity ]] && program=("-I$root/tests" "$root/tests/trace/form_factor_test.cpp" "$4/src/trace/form_factor.cpp") \
    libraries=("${catch2[@]}")
  [[ $2 == facets ]] && program=("-I$root/tests" "$root/tests/trace/microfacets_test.cpp" "$4/src/trace/microfacets.cpp" "$4/src/math/sampler.cpp") \
    libraries=("${catch2[@]}")
  [[ $2 == matt || $2 == glass ]] && libraries=("${catch2[@]}")
  [[ $2 == matt ]] && program=("-I$root/tests" "$root/tests/trace/rough_diffuse_test.cpp" "$4/src/trace/microfacets.cpp" "$4/src/math/sampler.cpp")
  [[ $2 == glass ]] && program=("-I$root/tests" "$root/tests/trace/rough_dielectric_test.cpp" "$4"/src/trace/{microfacets,rough_dielectric}.cpp "$4/src/math/sampler.cpp")
  [[ $2 == maps ]] && program=("-I$root/tests" "$root/tests/trace/surface_maps_test.cpp" "$4"/src/trace/{surface_maps,microfacets,rough_dielectric}.cpp "$4"/src/{scene/maps,math/sampler}.cpp) \
    libraries=("${catch2[@]}")
  [[ $2 == beams ]] && program=("-I$root/tests" -DRAYWALK_GMP "$root/tests/trace/beam_cut_test.cpp" "$4/src/trace/unfolded_plan.cpp") \
    libraries=("${catch2[@]}" -lgmpxx -lgmp)
  [[ $2 == marks ]] && program=("-I$root/tests" "$root/tests/trace/plan_marks_test.cpp" "$4/src/trace/plan_marks.cpp") libraries=("${catch2[@]}")
  [[ $2 == cones ]] && program=("-I$root/tests" "$root/tests/trace/"{ray_cone,pencil}_test.cpp "$4"/src/{trace/ray_cone,trace/microfacets,math/sampler}.cpp) \
    libraries=("${catch2[@]}")
  [[ $2 == differentials ]] && program=("-I$root/tests" "$root/tests/"{trace/ray_differential,trace/checker_filter,accel/derivative}_test.cpp "$4/src/trace/checker_filter.cpp") \
    libraries=("${catch2[@]}")
  [[ $2 == pyramid ]] && program=("-I$root/tests" "$root/tests/trace/texture_pyramid_test.cpp" "$4/src/trace/texture_pyramid.cpp") \
    libraries=("${catch2[@]}")
  # shellcheck disable=SC2086
  if ! "$cxx" -std=c++20 $level -ffp-contract=off $3 -I"$4/src" "${program[@]}" \
    "$4"/src/{shape/polygon,shape/exactly,shape/mesh,accel/primitives,math/exact,math/motion}.cpp "$work"/elementary_*.o \
    -o "$work/$1.bin" "${libraries[@]}" >"$log" 2>&1; then
    printf 'broken'
    return
  fi
  (ulimit -t 60; exec "$work/$1.bin") >>"$log" 2>&1  # of the processor's time: other processes cannot kill it
  case $? in
    0) printf 'survived' ;;
    126 | 127 | 132) printf 'broken' ;;  # it could not run: this processor lacks an instruction, say
    *) printf 'killed' ;;
  esac
  rm -f "$work/$1.bin"
}

# applies NAME FILE OLD: whether OLD stands exactly once in src/FILE, or no FILE is named; else says so.
applies() {
  local text
  [[ -n $2 ]] || return 0
  text=$(<"$root/src/$2")
  [[ $text == *"$3"* && ${text#*"$3"} != *"$3"* ]] && return
  printf '%-40s does not apply: src/%s does not have its line exactly once\n' "$1" "$2"
  return 1
}

# mutant NAME WHO FILE OLD NEW [FLAGS]: OLD stands exactly once in src/FILE. No FILE: only the compiler's FLAGS differ.
mutant() {
  local name=$1 who=$2 file=$3 old=$4 new=$5 flags=${6:-} known text copy result
  if ((${#wanted[@]} > 0)) && [[ " ${wanted[*]} " != *" $name "* ]]; then return; fi
  applies "$name" "$file" "$old" || { survived=$((survived + 1)); return; }
  ((only_check)) && { killed=$((killed + 1)); return; }
  known=$(sed -n "s/^$name //p" "$results")
  if [[ -z $known ]]; then
    innocent "$who"
    copy=$work/$name
    rm -rf "$copy" && mkdir -p "$copy" && cp -r "$root/src" "$copy/src"
    if [[ -n $file ]]; then
      text=$(<"$copy/src/$file")
      printf '%s\n' "${text/"$old"/"$new"}" >"$copy/src/$file"
    fi
    known=$(verdict "$name" "$who" "$flags" "$copy")
    rm -rf "$copy"
    printf '%s %s\n' "$name" "$known" >>"$results"
  fi
  printf '%-40s %s\n' "$name" "$known"
  if [[ $known == killed ]]; then killed=$((killed + 1)); else survived=$((survived + 1)); fi
}

# innocent WHO: unchanged, the suite must find nothing, or the deaths mean nothing.
innocent() {
  local result
  grep -qx "unchanged_$1 survived" "$results" && return
  result=$(verdict "unchanged_$1" "$1" "" "$root")
  printf '%-40s %s\n' "unchanged_$1" "$result"
  if [[ $result != survived ]]; then
    printf 'the suite breaks without any mutation:\n' >&2
    tail -n 20 "$work/unchanged_$1.log" >&2
    exit 1
  fi
  printf 'unchanged_%s survived\n' "$1" >>"$results"
}

# No mutant is of the elementary functions.
elementary() {
  local file
  for file in "$root"/src/math/elementary/*.cpp; do
    "$cxx" -std=c++20 $level -ffp-contract=off -I"$root/src" -c "$file" -o "$work/elementary_$(basename "$file" .cpp).o" || exit 1
  done
}

elementary
source "$root/tests/mutants/mutants.sh"
if ((only_check)); then
  printf '%s apply, %s do not\n' "$killed" "$survived"
  [[ $(verdict builds uv '' "$root") == survived ]] || { tail -n 20 "$work/builds.log" >&2; exit 1; }
  exit $((survived > 0))
fi
printf '%s killed, %s survived\n' "$killed" "$survived"
((survived == 0))
