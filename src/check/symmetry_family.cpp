#include "check/symmetry.h"

#include "check/shape_family.h"

namespace raywalk::check {

namespace {

[[nodiscard]] Family family_of(const char* name, Symmetry symmetry) {
  Family family{name, "", {}};
  for_each_shape([&]<template <class> class S>() {
    add_lines<S>(family, std::string(shape_name(S<double>{})), [symmetry]<class Shape, class T>(auto... range) {
      return keep_symmetry<Shape, T>(symmetry, range...);
    });
  });
  return family;
}

}  // namespace

std::vector<Family> symmetry_families() {
  return {family_of("permuted", Symmetry::permuted), family_of("reversed", Symmetry::reversed)};
}

}  // namespace raywalk::check
