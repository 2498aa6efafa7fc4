#include "check/normal.h"

#include "check/shape_family.h"

namespace raywalk::check {

std::vector<Family> normal_families() {
  Family family{"normals", "", {}};
  for_each_shape([&]<template <class> class S>() {
    add_lines<S>(family, std::string(shape_name(S<double>{})),
                 []<class Shape, class T>(auto... range) { return try_normals<Shape, T>(range...); });
  });
  return {family};
}

}  // namespace raywalk::check
