#include "check/spawn.h"

#include "check/shape_family.h"

#include <type_traits>

namespace raywalk::check {

std::vector<Family> spawn_families() {
  Family family{"spawned", "", {}}, prisms{"spawned_polygon", "", {}};
  for_each_shape([&]<template <class> class S>() {
    add_lines<S>(std::is_same_v<S<double>, Prism<double>> ? prisms : family, std::string(shape_name(S<double>{})),
                 []<class Shape, class T>(auto... range) { return spawn<Shape, T>(range...); });
  });
  return {family, prisms};
}

}  // namespace raywalk::check
