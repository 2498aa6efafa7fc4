// Prisms to test with, and an oracle that answers face by face.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "shape/meet.h"
#include "shape/numbers.h"
#include "shape/prism.h"

namespace raywalk::test {

using Long = long double;

// Polygons of all kinds; each is tried in both windings.
inline const std::vector<std::vector<Vec2d>> polygons{
    {{0, 0}, {4, 0}, {0, 3}},                                                                // triangle
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},                                                    // square
    {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},                                        // L
    {{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},                        // U
    {{0, 2}, {-0.5, 0.5}, {-2, 0}, {-0.5, -0.5}, {0, -2}, {0.5, -0.5}, {2, 0}, {0.5, 0.5}},  // star
    {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}},                                        // collinear corners
    {{0, 0}, {5, 0.001}, {5, 0.002}},                                                        // sliver
    {{0, 0}, {2, 1}, {0, 2}, {0.5, 1}},                                                      // arrowhead
};

template <class T>
Prism<T> prism_of(const std::vector<Vec2d>& corners, double height, bool clockwise) {
  Prism<T> prism;
  for (const Vec2d& corner : corners) prism.corners.emplace_back(corner);
  if (clockwise) std::reverse(prism.corners.begin(), prism.corners.end());
  prism.height = static_cast<T>(height);
  return prism;
}

struct Point {
  Long x, y;
};
inline Long cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
template <class T>
Point operator-(const Vec2<T>& a, const Point& b) {
  return {static_cast<Long>(a.x) - b.x, static_cast<Long>(a.y) - b.y};
}

template <class T>
bool contains(const Prism<T>& prism, const Point& p) {
  bool inside = false;
  for (int i = 0; i < prism.sides(); ++i) {
    const Point a = prism.corner(i) - p, b = prism.corner_after(i) - p;
    if ((a.y > 0) != (b.y > 0) && (cross(a, b) > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

// How far a point of the plan is from the outline.
template <class T>
Long distance_to_outline(const Prism<T>& prism, const Point& p) {
  Long least = std::numeric_limits<Long>::infinity();
  for (int i = 0; i < prism.sides(); ++i) {
    const Point a = prism.corner(i) - p, b = prism.corner_after(i) - p, edge{b.x - a.x, b.y - a.y};
    const Long s = -(a.x * edge.x + a.y * edge.y) / (edge.x * edge.x + edge.y * edge.y);
    const Long k = std::clamp<Long>(s, 0, 1);
    least = std::min(least, std::hypot(a.x + k * edge.x, a.y + k * edge.y));
  }
  return least;
}

// The oracle: every face by itself, in long double. `sure` is false where a hit lies so near an edge that either face,
// or none, would be right.
struct Answer {
  std::optional<Long> t;
  int part = -1;
  bool sure = true;
};

template <class T>
Answer face_by_face(const Prism<T>& prism, const Ray<T>& ray, int departed_part = no_part) {
  const Point o{ray.origin.x, ray.origin.y}, d{ray.direction.x, ray.direction.y};
  const Long oz = ray.origin.z, dz = ray.direction.z, half = static_cast<Long>(prism.height) / 2;
  const Long margin = 1000 * static_cast<Long>(std::numeric_limits<T>::epsilon());
  Answer answer;
  const auto offer = [&](Long t, int part, Long slack) {
    if (part == departed_part || t < -margin) return;
    if (std::abs(t) < margin) answer.sure = false;
    if (std::abs(slack) < margin) answer.sure = false;
    if (slack > 0 && t > 0 && (!answer.t || t < *answer.t)) answer.t = t, answer.part = part;
  };
  for (int i = 0; i < prism.sides(); ++i) {
    const Point a = prism.corner(i) - o, edge = prism.corner_after(i) - Point{prism.corner(i).x, prism.corner(i).y};
    const Long rate = cross(d, edge);
    if (rate == 0) continue;
    const Long t = cross(a, edge) / rate, s = cross(a, d) / rate;
    const Long size = std::hypot(edge.x, edge.y);
    offer(t, i, std::min({s * size, (1 - s) * size, half - std::abs(oz + t * dz)}));
  }
  for (const int part : {prism.top(), prism.bottom()}) {
    if (dz == 0) continue;
    const Long t = ((part == prism.top() ? half : -half) - oz) / dz;
    const Point p{o.x + t * d.x, o.y + t * d.y};
    const Long distance = distance_to_outline(prism, p);
    offer(t, part, contains(prism, p) ? distance : -distance);
  }
  return answer;
}

// A point well inside the solid.
template <class T>
Vec3<T> point_inside(const Prism<T>& prism, Numbers& next, Long margin) {
  const Bounds<T> box = bounds(prism);
  for (;;) {
    const Vec3d low(box.min), high(box.max);
    const double x = next.real(low.x, high.x), y = next.real(low.y, high.y), z = next.real(low.z, high.z);
    const Vec3<T> p(Vec3d(x, y, z));
    const Point at{p.x, p.y};
    if (contains(prism, at) && distance_to_outline(prism, at) > margin &&
        static_cast<Long>(prism.height) / 2 - std::abs(static_cast<Long>(p.z)) > margin)
      return p;
  }
}

template <class T>
void compare(const Prism<T>& prism, const Ray<T>& ray, int& wrong, int& unsure, int& hits) {
  const Answer expected = face_by_face(prism, ray);
  const auto got = meet(prism, ray);
  if (!expected.sure) {
    ++unsure;
    return;
  }
  hits += expected.t.has_value();
  if (got.has_value() != expected.t.has_value() || (got && got->part != expected.part)) {
    ++wrong;
  } else if (got) {
    const Long error = std::abs(static_cast<Long>(got->t) - *expected.t) / *expected.t;
    wrong += error > 1e4L * std::numeric_limits<T>::epsilon();
  }
}

}  // namespace raywalk::test
