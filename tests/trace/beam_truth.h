#pragma once
// The truth about beams in the plan: rationals and roots of 320 bits, by the points that a drawing would be made of,
// where trace/unfolded_plan.h solves equations for places.

#include "check/rational.h"
#include "trace/unfolded_plan.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace raywalk::test {

class BeamTruth {
 public:
  using Real = mpf_class;
  struct Point {
    Real x{0, bits}, y{0, bits};
  };
  struct Part {
    Real begin{0, bits}, end{0, bits};
    int outline = -1;
  };

  /// Through `mirrors`, met one after the other.
  BeamTruth(const std::vector<Outline>& outlines, const Vec2d& eye, const std::vector<int>& mirrors = {}) {
    const Point from = point(eye);
    Point seen_from = from;
    for (const Outline& each : outlines) lines_.push_back(in_place(each));
    std::vector<Item> images = lines_;
    for (std::size_t i = mirrors.size(); i-- > 0;)
      for (Item& item : images) reflect(item, lines_[static_cast<std::size_t>(mirrors[i])]);
    if (!mirrors.empty()) {
      // The last mirror, in those before it.
      Item last = lines_[static_cast<std::size_t>(mirrors.back())];
      for (std::size_t i = mirrors.size() - 1; i-- > 0;) reflect(last, lines_[static_cast<std::size_t>(mirrors[i])]);
      mirror_ = relative(last, from);
      own_ = mirrors.back();
    }
    for (const Item& item : images) items_.push_back(relative(item, from));
    objects_.reserve(outlines.size());
    for (const Outline& each : outlines) objects_.push_back(each.object);
  }

  [[nodiscard]] std::vector<Part> cut(const PixelFan& fan, const Real& begin, const Real& end) const {
    const Point d0 = point(fan.begin), d1 = point(fan.end);
    const Real one_place = Real(1, bits) >> 98;  // as the header says
    std::vector<Real> places{begin, end};
    const auto towards = [&](const Point& at) {
      const Real a = cross(d0, at), b = cross(d1, at);
      if (a == b) return;
      const Real x = a / (a - b);
      if (x - begin > one_place && end - x > one_place) places.push_back(x);
    };
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const Item& one = items_[i];
      if (one.is_circle) {
        const Real outside = dot(one.a, one.a) - one.radius * one.radius;
        if (outside >= 0) {
          const Real along = sqrt(outside);
          for (const int side : {-1, 1})
            towards({one.a.x * along - side * one.radius * one.a.y, one.a.y * along + side * one.radius * one.a.x});
        }
      } else if (one.endless) {
        towards(minus(one.b, one.a));
      } else {
        towards(one.a), towards(one.b);
      }
      for (std::size_t j = 0; j < i; ++j)
        for (const Point& at : crossings(one, items_[j])) towards(at);
    }
    std::sort(places.begin(), places.end());
    std::vector<Part> parts;
    Real last = places.front();
    for (const Real& place : places) {
      if (place - last <= one_place) continue;
      const Real x = (last + place) / 2;
      const Point direction{d0.x + x * (d1.x - d0.x), d0.y + x * (d1.y - d0.y)};
      const std::pair<int, bool> found = nearest(direction);
      if (!parts.empty() && parts.back().outline == found.first && far_ == found.second)
        parts.back().end = place;
      else
        parts.push_back({last, place, found.first});
      far_ = found.second;
      last = place;
    }
    return parts;
  }

 private:
  static constexpr unsigned bits = check::root_bits;
  struct Item {
    bool is_circle = false, endless = false;
    Point a, b;  ///< a side's ends, two points of a wall; a circle's centre is `a`
    Real radius{0, bits};
  };

  static Point point(const Vec2d& v) { return {Real(v.x, bits), Real(v.y, bits)}; }
  static Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
  static Real dot(const Point& a, const Point& b) { return Real(a.x * b.x + a.y * b.y); }
  static Real cross(const Point& a, const Point& b) { return Real(a.x * b.y - a.y * b.x); }
  static Item in_place(const Outline& outline) {
    Item item;
    if (const auto* side = std::get_if<OutlineSide>(&outline.shape))
      item.a = point(side->from), item.b = point(side->to);
    if (const auto* wall = std::get_if<OutlineWall>(&outline.shape)) {
      item.endless = true;
      item.a = point(wall->point);
      item.b = {item.a.x - Real(wall->normal.y, bits), item.a.y + Real(wall->normal.x, bits)};
    }
    if (const auto* circle = std::get_if<OutlineCircle>(&outline.shape)) {
      item.is_circle = true;
      item.a = point(circle->centre);
      item.radius = Real(circle->radius, bits);
    }
    return item;
  }
  static Item relative(Item item, const Point& eye) {
    item.a = minus(item.a, eye), item.b = minus(item.b, eye);
    return item;
  }
  static void reflect(Item& item, const Item& mirror) {
    const Point along = minus(mirror.b, mirror.a);
    for (Point* each : {&item.a, &item.b}) {
      const Point from = minus(*each, mirror.a);
      const Real foot = dot(from, along) / dot(along, along);
      *each = {2 * (mirror.a.x + foot * along.x) - each->x, 2 * (mirror.a.y + foot * along.y) - each->y};
    }
  }
  static std::vector<Point> line_meets_circle(const Point& a, const Point& b, const Item& circle) {
    const Point along = minus(b, a), from = minus(a, circle.a);
    const Real qa = dot(along, along), qb = dot(from, along), qc = dot(from, from) - circle.radius * circle.radius;
    const Real discriminant = qb * qb - qa * qc;
    if (discriminant < 0) return {};
    std::vector<Point> met;
    for (const int side : {-1, 1}) {
      const Real t = (side * sqrt(discriminant) - qb) / qa;
      met.push_back({a.x + t * along.x, a.y + t * along.y});
    }
    return met;
  }
  static std::vector<Point> crossings(const Item& one, const Item& other) {
    if (!one.is_circle && !other.is_circle) {
      const Point along = minus(one.b, one.a), across = minus(other.b, other.a);
      const Real both = cross(along, across);
      if (both == 0) return {};
      const Real t = cross(minus(other.a, one.a), across) / both;
      return {{one.a.x + t * along.x, one.a.y + t * along.y}};
    }
    if (!one.is_circle) return line_meets_circle(one.a, one.b, other);
    if (!other.is_circle) return line_meets_circle(other.a, other.b, one);
    const Point apart = minus(other.a, one.a);
    const Real square = dot(apart, apart);
    if (square == 0) return {};
    const Real t = (square + one.radius * one.radius - other.radius * other.radius) / (2 * square);
    const Point foot{one.a.x + t * apart.x, one.a.y + t * apart.y};
    return line_meets_circle(foot, {foot.x - apart.y, foot.y + apart.x}, one);
  }
  static std::optional<Real> straight(const Item& item, const Point& direction) {
    const Point along = minus(item.b, item.a);
    const Real both = cross(direction, along);
    if (both == 0) return std::nullopt;
    const Real u = cross(item.a, direction) / both;
    if (!item.endless && (u < 0 || u > 1)) return std::nullopt;
    return Real(cross(item.a, along) / both);
  }
  [[nodiscard]] std::pair<int, bool> nearest(const Point& direction) const {
    const Real alike = Real(1, bits) >> 200;
    Real beyond(0, bits);
    if (mirror_) {
      Item line = *mirror_;
      line.endless = true;
      beyond = straight(line, direction).value_or(beyond);
    }
    std::pair<int, bool> nearest{-1, false};
    Real least(0, bits);
    const auto offer = [&](std::size_t i, const Real& t, bool far_side) {
      if (t - beyond <= alike || (nearest.first >= 0 && t > least - alike)) return false;
      nearest = {static_cast<int>(i), far_side};
      least = t;
      return true;
    };
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (static_cast<int>(i) == own_) continue;
      const Item& item = items_[i];
      if (!item.is_circle) {
        if (const auto t = straight(item, direction)) offer(i, *t, false);
        continue;
      }
      const Real a = dot(direction, direction), b = dot(direction, item.a),
                 c = dot(item.a, item.a) - item.radius * item.radius, discriminant = b * b - a * c;
      if (discriminant <= 0) continue;
      const Real root = sqrt(discriminant), near = (b - root) / a, far = (b + root) / a;
      offer(i, near, false);
      if (near - beyond <= alike) offer(i, far, true);
    }
    return nearest;
  }

  std::vector<Item> lines_, items_;
  std::vector<int> objects_;
  std::optional<Item> mirror_;
  int own_ = -1;
  mutable bool far_ = false;
};

}  // namespace raywalk::test
