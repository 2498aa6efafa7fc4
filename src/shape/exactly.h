#pragma once
// Where rounding could decide, exact arithmetic does: few rays need it, so it is compiled once, in exactly.cpp, away
// from the searches, and where the program has to travel before it runs, small rather than fast.

#include "shape/box.h"
#include "shape/disk.h"
#include "shape/polygon.h"
#include "shape/prism.h"
#include "shape/quadric.h"
#include "shape/sphere.h"
#include "shape/triangle.h"

namespace raywalk::detail {

/// All of it in scalar type T, which is compiled here; or elsewhere, if `away` is `extern`.
#define RAYWALK_EXACTLY(away, T)                                                                                       \
  away template Roots roots_exactly(const Sphere<T>&, const Ray<T>&);                                                  \
  away template std::optional<BoxInterval> exact_interval(const Box<T>&, const Ray<T>&, int);                          \
  away template bool exactly_inside(const Disk<T>&, const Ray<T>&);                                                    \
  away template bool exactly_inside(const Polygon<T>&, const Ray<T>&, const Vec3d&, int, int);                         \
  away template std::optional<Intersection<T>> intersect_exactly(const Prism<T>&, const Ray<T>&, T);                   \
  away template std::optional<Intersection<T>> intersect_exactly(const Triangle<T>&, const Vec3d&, const Vec3d&, T);   \
  away template std::optional<Intersection<T>> intersect_exactly(const Ellipsoid<T>&, const Ray<T>&, T, int);          \
  away template std::optional<Intersection<T>> intersect_exactly(const EllipticParaboloid<T>&, const Ray<T>&, T, int); \
  away template std::optional<Intersection<T>> intersect_exactly(const Cone<T>&, const Ray<T>&, T, int);               \
  away template std::optional<Intersection<T>> intersect_exactly(const Cylinder<T>&, const Ray<T>&, T, int);           \
  away template std::optional<Intersection<T>> intersect_exactly(const HyperboloidOneSheet<T>&, const Ray<T>&, T,      \
                                                                 int);                                                 \
  away template std::optional<Intersection<T>> intersect_exactly(const HyperboloidTwoSheets<T>&, const Ray<T>&, T, int);
RAYWALK_EXACTLY(extern, float)
RAYWALK_EXACTLY(extern, double)

}  // namespace raywalk::detail
