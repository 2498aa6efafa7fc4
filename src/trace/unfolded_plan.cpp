#include "trace/unfolded_plan.h"

#include "math/overloaded.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raywalk {

using detail::ExactLine;
using detail::ExactPoint;

namespace {

ExactPoint exact(const Vec2d& v) { return {v.x, v.y}; }
ExactPoint operator+(const ExactPoint& a, const ExactPoint& b) { return {a.x + b.x, a.y + b.y}; }
ExactPoint operator-(const ExactPoint& a, const ExactPoint& b) { return {a.x - b.x, a.y - b.y}; }
ExactPoint operator*(const ExactPoint& a, const Expansion& by) { return {a.x * by, a.y * by}; }
Expansion dot(const ExactPoint& a, const ExactPoint& b) { return a.x * b.x + a.y * b.y; }
Expansion cross(const ExactPoint& a, const ExactPoint& b) { return a.x * b.y - a.y * b.x; }
ExactPoint turned_left(const ExactPoint& a) { return {-a.y, a.x}; }

/// The power of two that brings x, which is not 0, to [1, 2); or as near as a power does that is a normal number.
double to_unit(double x) { return std::ldexp(1.0, -std::clamp(std::ilogb(x), -1000, 1000)); }

/// With a normal of about unit length, whatever that of the outline is: products of several of them neither over- nor
/// underflow. A power of two changes no bit of what is computed with it.
ExactLine line_of(const ExactPoint& normal, const Expansion& offset) {
  const double size = std::max(std::abs(normal.x.rounded().hi), std::abs(normal.y.rounded().hi));
  if (size == 0) return {normal, offset};
  const Expansion by = to_unit(size);
  return {normal * by, offset * by};
}
ExactLine line_through(const ExactPoint& from, const ExactPoint& to) {
  return line_of(turned_left(to - from), cross(to, from));
}
ExactLine line_of(const Outline& straight) {
  if (const auto* wall = std::get_if<OutlineWall>(&straight.shape)) {
    const ExactPoint normal = exact(wall->normal);
    return line_of(normal, dot(normal, exact(wall->point)));
  }
  const auto& side = std::get<OutlineSide>(straight.shape);
  return line_through(exact(side.from), exact(side.to));
}

Place place_of(DoubleDouble x) {
  constexpr double coarse = 0x1p52, fine = 0x1p104;
  const double high = std::nearbyint(x.hi * coarse) / coarse;
  return {high, std::nearbyint(((x.hi - high) + x.lo) * fine) / fine};
}

constexpr double least_width = 0x1p-98;  ///< what lies nearer together is one place

/// Roots of equations in the place x, those between 0 and 1.
class Roots {
 public:
  /// of (1 - x) a + x b
  void linear(const Expansion& a, const Expansion& b) {
    if (a.sign() * b.sign() >= 0) return;
    add(a.rounded() / (a - b).rounded());
  }
  /// of (1 - x)^2 a + 2 (1 - x) x b + x^2 c
  void quadratic(const Expansion& a, const Expansion& b, const Expansion& c) {
    const Expansion discriminant = b * b - a * c;
    if (discriminant.sign() < 0) return;
    const Expansion half = b - a, square = c - b - half;  // square x^2 + 2 half x + a
    const DoubleDouble root = sqrt(discriminant.rounded());
    // The sum that does not cancel; the other root by the product of both.
    const DoubleDouble sum = half.sign() < 0 ? root - half.rounded() : -(half.rounded() + root);
    if (square.sign() != 0) add(sum / square.rounded());
    if (sum.hi != 0) add(a.rounded() / sum);
  }
  [[nodiscard]] std::vector<Place>& places() { return places_; }

 private:
  void add(DoubleDouble x) {
    if (x.hi > 0 && x.hi <= 1) places_.push_back(place_of(x));
  }
  std::vector<Place> places_;
};

/// Those of a part but for its ends, in order, each once.
std::vector<Place> inside(const BeamPart& part, const std::vector<Place>& places) {
  std::vector<Place> edges;
  for (const Place& edge : places)
    if (edge - part.begin > least_width && part.end - edge > least_width) edges.push_back(edge);
  std::sort(edges.begin(), edges.end());
  edges.erase(
      std::unique(edges.begin(), edges.end(), [](const Place& a, const Place& b) { return !(b - a > least_width); }),
      edges.end());
  return edges;
}

}  // namespace

Place middle(const Place& a, const Place& b) { return {(a.high + b.high) / 2, (a.low + b.low) / 2}; }

UnfoldedPlan::UnfoldedPlan(const std::vector<Outline>& outlines, const Vec2d& eye) : outlines_(&outlines), eye_(eye) {
  for (const Outline& outline : outlines) seen_.push_back(seen(outline));
}

UnfoldedPlan UnfoldedPlan::mirrored(int outline) const {
  UnfoldedPlan plan(*this);
  plan.mirror_ = seen_[static_cast<std::size_t>(outline)], plan.mirror_outline_ = outline;
  // What is seen in the mirror is the plan reflected in it first, and then in those before it.
  const ExactLine line = line_of((*outlines_)[static_cast<std::size_t>(outline)]);
  const Expansion square = dot(line.normal, line.normal);
  const double scale = scale_ * square.rounded().hi, by = scale > 0 ? to_unit(scale) : 1;
  plan.scale_ = scale * by;
  plan.mirrors_.push_back({outline, line, square * by, 2 * by});
  // The mirror itself in the scale of what is seen beyond it.
  const Expansion& size = plan.mirrors_.back().size;
  Seen& mirror = *plan.mirror_;
  mirror.from = mirror.from * size, mirror.to = mirror.to * size;
  mirror.normal = mirror.normal * size;
  mirror.offset = mirror.offset * size * size;
  plan.seen_.clear();
  for (const Outline& each : *outlines_) plan.seen_.push_back(plan.seen(each));
  return plan;
}

UnfoldedPlan UnfoldedPlan::beyond(int outline, const Vec2d& eye) const {
  UnfoldedPlan plan(*outlines_, eye);
  plan.mirror_ = plan.seen_[static_cast<std::size_t>(outline)], plan.mirror_outline_ = outline;
  return plan;
}

bool UnfoldedPlan::has_another_upon(int outline) const {
  const auto index = static_cast<std::size_t>(outline);
  const Seen& one = seen_[index];
  const auto on_line = [](const ExactPoint& point, const Seen& line) {
    return (dot(line.normal, point) - line.offset).sign() == 0;
  };
  const auto range = [&](const Outline& of, const Vec2d& along) {
    const auto& side = std::get<OutlineSide>(of.shape);
    return std::minmax({dot(along, side.from), dot(along, side.to)});
  };
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Seen& other = seen_[i];
    if (!other.straight || (*outlines_)[i].object == (*outlines_)[index].object) continue;
    if (one.endless && other.endless) {
      const ExactPoint apart = one.normal * other.offset - other.normal * one.offset;
      if (cross(one.normal, other.normal).sign() == 0 && apart.x.sign() == 0 && apart.y.sign() == 0) return true;
    } else if (one.endless || other.endless) {
      const Seen &wall = one.endless ? one : other, &side = one.endless ? other : one;
      if (on_line(side.from, wall) && on_line(side.to, wall)) return true;
    } else if (on_line(other.from, one) && on_line(other.to, one)) {
      const auto& side = std::get<OutlineSide>((*outlines_)[index].shape);
      const auto [low, high] = range((*outlines_)[index], side.to - side.from);
      const auto [other_low, other_high] = range((*outlines_)[i], side.to - side.from);
      if (low < other_high && other_low < high) return true;
    }
  }
  return false;
}

/// Through the mirrors from the last one on.
ExactPoint UnfoldedPlan::unfolded(const Vec2d& original, bool is_direction, Expansion& scale) const {
  ExactPoint point = exact(original);
  scale = 1.0;
  for (auto mirror = mirrors_.rbegin(); mirror != mirrors_.rend(); ++mirror) {
    const auto& [normal, offset] = mirror->line;
    const Expansion across = is_direction ? dot(normal, point) : dot(normal, point) - offset * scale;
    point = point * mirror->size - normal * (across * mirror->twice);
    scale = scale * mirror->size;
  }
  if (!is_direction) point = point - exact(eye_) * scale;
  return point;
}

auto UnfoldedPlan::seen(const Outline& outline) const -> Seen {
  Expansion scale = 1.0;
  const auto unfold = [&](const Vec2d& point, bool is_direction) { return unfolded(point, is_direction, scale); };
  Seen seen{};
  seen.straight = outline.is_straight();
  seen.endless = std::holds_alternative<OutlineWall>(outline.shape);
  std::visit(Overloaded{
                 [&](const OutlineSide& side) {
                   seen.from = unfold(side.from, false);
                   seen.to = unfold(side.to, false);
                   const ExactLine line = line_through(seen.from, seen.to);
                   seen.normal = line.normal, seen.offset = line.offset;
                   seen.low = {std::min(side.from.x, side.to.x), std::min(side.from.y, side.to.y)};
                   seen.high = {std::max(side.from.x, side.to.x), std::max(side.from.y, side.to.y)};
                 },
                 [&](const OutlineWall& wall) {
                   const ExactPoint normal = unfold(wall.normal, true);
                   const ExactLine line = line_of(normal, dot(normal, unfold(wall.point, false)));
                   seen.normal = line.normal, seen.offset = line.offset;
                   seen.low = Vec2d(-std::numeric_limits<double>::infinity());
                   seen.high = -seen.low;
                 },
                 [&](const OutlineCircle& circle) {
                   seen.centre = unfold(circle.centre, false);
                   const Expansion radius = scale * circle.radius;
                   seen.square = radius * radius;
                   seen.low = circle.centre - circle.radius, seen.high = circle.centre + circle.radius;
                 },
             },
             outline.shape);
  return seen;
}

/// A superset of the places where what is seen changes: the directions of corners, those that touch circles, those of
/// the points where outlines cross each other, and those parallel to walls.
std::vector<Place> UnfoldedPlan::breaks(const PixelFan& fan, const Stop& stop) const {
  const ExactPoint begin = exact(fan.begin), end = exact(fan.end);
  Roots roots;
  const auto parallel = [&](const ExactPoint& across) { roots.linear(dot(across, begin), dot(across, end)); };
  // p(d)^2 = square q(d) . q(d), both linear in the direction d: by their values at both ends of the fan.
  const auto equal = [&](const ExactPoint& p0, const ExactPoint& p1, const Expansion& square, const ExactPoint& q0,
                         const ExactPoint& q1) {
    roots.quadratic(dot(p0, p0) - square * dot(q0, q0), dot(p0, p1) - square * dot(q0, q1),
                    dot(p1, p1) - square * dot(q1, q1));
  };
  // Where the ray meets the line at a point of the circle.
  const auto line_meets_circle = [&](const ExactPoint& normal, const Expansion& offset, const Seen& circle) {
    const Expansion n0 = dot(normal, begin), n1 = dot(normal, end);
    equal(begin * offset - circle.centre * n0, end * offset - circle.centre * n1, circle.square, {n0, 0.0}, {n1, 0.0});
  };
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    stop.check();
    const Seen& one = seen_[i];
    if (!one.straight) {
      equal({cross(begin, one.centre), 0.0}, {cross(end, one.centre), 0.0}, one.square, begin, end);
    } else if (one.endless) {
      parallel(one.normal);
    } else {
      parallel(turned_left(one.from)), parallel(turned_left(one.to));
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Seen& other = seen_[j];
      if ((*outlines_)[i].object == (*outlines_)[j].object) continue;
      if (one.high.x < other.low.x || other.high.x < one.low.x || one.high.y < other.low.y || other.high.y < one.low.y)
        continue;
      if (one.straight && other.straight) {
        parallel(other.normal * one.offset - one.normal * other.offset);
      } else if (one.straight) {
        line_meets_circle(one.normal, one.offset, other);
      } else if (other.straight) {
        line_meets_circle(other.normal, other.offset, one);
      } else {
        // Two circles cross on their radical line.
        const ExactPoint normal = (one.centre - other.centre) * 2.0;
        const Expansion offset =
            other.square - one.square + dot(one.centre, one.centre) - dot(other.centre, other.centre);
        line_meets_circle(normal, offset, one);
      }
    }
  }
  return std::move(roots.places());
}

/// Of the rays d of the fan, that at d meets the straight outline in offset d / (normal . d); so the point, and the way
/// from a light to it, times (normal . d), is linear in d.
std::vector<Place> UnfoldedPlan::shadow_edges(const PixelFan& fan, const BeamPart& part, const PlanLight& light,
                                              const Stop& stop) const {
  const ExactPoint begin = exact(fan.begin), end = exact(fan.end);
  const Seen& surface = seen_[static_cast<std::size_t>(part.outline)];
  const Expansion n0 = dot(surface.normal, begin), n1 = dot(surface.normal, end);
  Expansion scale;
  const ExactPoint place = unfolded(light.place, light.is_distant, scale);
  Roots roots;
  const auto way_from = [&](const ExactPoint& start) {
    return std::pair{begin * surface.offset - start * n0, end * surface.offset - start * n1};
  };
  const auto corner = [&](const ExactPoint& at) {
    const auto [w0, w1] = way_from(light.is_distant ? at : place);
    const ExactPoint along = light.is_distant ? place : at - place;
    roots.linear(cross(w0, along), cross(w1, along));
  };
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Seen& outline = seen_[i];
    stop.check();
    if (static_cast<int>(i) == part.outline) continue;
    if (outline.straight) {
      if (!outline.endless) corner(outline.from), corner(outline.to);
    } else if (light.is_distant) {
      // As far from the ray of light through the centre as the radius.
      const auto [w0, w1] = way_from(outline.centre);
      const Expansion c0 = cross(w0, place), c1 = cross(w1, place), square = outline.square * dot(place, place);
      roots.quadratic(c0 * c0 - square * n0 * n0, c0 * c1 - square * n0 * n1, c1 * c1 - square * n1 * n1);
    } else {
      const auto [w0, w1] = way_from(place);
      const ExactPoint centre = outline.centre - place;
      const Expansion c0 = cross(w0, centre), c1 = cross(w1, centre);
      roots.quadratic(c0 * c0 - outline.square * dot(w0, w0), c0 * c1 - outline.square * dot(w0, w1),
                      c1 * c1 - outline.square * dot(w1, w1));
    }
  }
  return inside(part, roots.places());
}

std::vector<Place> UnfoldedPlan::places_of(const PixelFan& fan, const BeamPart& part,
                                           const std::vector<Vec2d>& points) const {
  Roots roots;
  for (const Vec2d& point : points) {
    Expansion scale;
    const ExactPoint across = turned_left(unfolded(point, false, scale));
    roots.linear(dot(across, exact(fan.begin)), dot(across, exact(fan.end)));
  }
  return inside(part, roots.places());
}

/// To the nearest point of an outline that lies beyond the eye, or beyond the last mirror.
auto UnfoldedPlan::distance(const Seen& outline, const ExactPoint& direction, const std::optional<Distance>& beyond,
                            bool* far_side) const -> std::optional<Distance> {
  constexpr double alike = 0x1p-90;
  const auto lies_beyond = [&](const Distance& at) {
    return beyond ? static_cast<double>(at - *beyond) > alike * beyond->hi : at.hi > 0;
  };
  if (outline.straight) {
    const Expansion slope = dot(outline.normal, direction);
    if (slope.sign() * outline.offset.sign() <= 0) return std::nullopt;
    if (!outline.endless && (cross(direction, outline.from).sign() > 0) == (cross(direction, outline.to).sign() > 0))
      return std::nullopt;
    const Distance at = outline.offset.rounded() / slope.rounded();
    return lies_beyond(at) ? std::optional(at) : std::nullopt;
  }
  const Expansion along = dot(outline.centre, direction), square = dot(direction, direction);
  const Expansion outside = dot(outline.centre, outline.centre) - outline.square;
  const Expansion discriminant = along * along - square * outside;
  if (discriminant.sign() <= 0) return std::nullopt;
  const Distance root = sqrt(discriminant.rounded());
  const Distance sum = along.sign() < 0 ? along.rounded() - root : along.rounded() + root;
  const Distance by_sum = sum / square.rounded(), by_product = outside.rounded() / sum;
  const Distance near = along.sign() < 0 ? by_sum : by_product, far = along.sign() < 0 ? by_product : by_sum;
  *far_side = !lies_beyond(near);
  if (!*far_side) return near;
  return lies_beyond(far) ? std::optional(far) : std::nullopt;
}

auto UnfoldedPlan::nearest(const ExactPoint& direction) const -> Nearest {
  constexpr double alike = 0x1p-90;
  std::optional<Distance> mirror;
  if (mirror_) mirror = mirror_->offset.rounded() / dot(mirror_->normal, direction).rounded();
  Nearest nearest;
  std::optional<Distance> least;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    if (static_cast<int>(i) == mirror_outline_) continue;
    bool far_side = false;
    const std::optional<Distance> at = distance(seen_[i], direction, mirror, &far_side);
    // Outlines that lie upon each other: the first of them.
    if (!at || (least && !(static_cast<double>(*least - *at) > alike * least->hi))) continue;
    least = at;
    nearest = {static_cast<int>(i), far_side};
  }
  return nearest;
}

std::vector<BeamPart> UnfoldedPlan::cut(const PixelFan& fan, const Place& begin, const Place& end,
                                        const Stop& stop) const {
  std::vector<Place> places = breaks(fan, stop);
  std::sort(places.begin(), places.end());
  std::vector<BeamPart> parts;
  bool far_side = false;  // of the last part
  const auto add = [&](const Place& from, const Place& to) {
    stop.check();
    const Place at = middle(from, to);
    const Expansion x = Expansion(at.high) + at.low;
    const ExactPoint direction = exact(fan.begin) + (exact(fan.end) - exact(fan.begin)) * x;
    const Nearest found = nearest(direction);
    if (!parts.empty() && parts.back().outline == found.outline && far_side == found.far_side)
      parts.back().end = to;
    else
      parts.push_back({from, to, found.outline});
    far_side = found.far_side;
  };
  Place last = begin;
  for (const Place& place : places) {
    if (!(place - last > least_width) || !(end - place > least_width)) continue;
    add(last, place);
    last = place;
  }
  add(last, end);
  return parts;
}

Vec2d UnfoldedPlan::folded(Vec2d point, bool is_direction) const {
  for (const Mirror& mirror : mirrors_) {
    const ExactLine& line = mirror.line;
    const ExactPoint exactly = exact(point);
    const Expansion across = is_direction ? dot(line.normal, exactly) : dot(line.normal, exactly) - line.offset;
    const DoubleDouble size = dot(line.normal, line.normal).rounded();
    const auto moved = [&](double from, const Expansion& along) {
      return static_cast<double>(DoubleDouble(from) - DoubleDouble(2) * across.rounded() * along.rounded() / size);
    };
    point = {moved(point.x, line.normal.x), moved(point.y, line.normal.y)};
  }
  return point;
}

Vec2d UnfoldedPlan::start(const Vec2d& direction) const {
  if (!mirror_) return eye_;
  const ExactPoint exactly = exact(direction);
  const double t = static_cast<double>(mirror_->offset.rounded() / dot(mirror_->normal, exactly).rounded()) / scale_;
  return folded(eye_ + t * direction, false);
}

Vec2d UnfoldedPlan::leaving(const Vec2d& direction) const { return folded(direction, true); }

Vec2d UnfoldedPlan::end(const PixelFan& fan, const BeamPart& part, const Place& place) const {
  const Vec2d direction = fan.at(place);
  const Seen& outline = seen_[static_cast<std::size_t>(part.outline)];
  const ExactPoint exactly = exact(direction);
  double t = 0;
  if (outline.straight) {
    t = static_cast<double>(outline.offset.rounded() / dot(outline.normal, exactly).rounded());
  } else {
    // At its ends a ray may pass by for rounding: there it touches.
    const Expansion along = dot(outline.centre, exactly), square = dot(exactly, exactly);
    const Expansion outside = dot(outline.centre, outline.centre) - outline.square;
    const Expansion discriminant = along * along - square * outside;
    std::optional<Distance> mirror;
    if (mirror_) mirror = mirror_->offset.rounded() / dot(mirror_->normal, exactly).rounded();
    bool far_side = false;
    const std::optional<Distance> at =
        discriminant.sign() > 0 ? distance(outline, exactly, mirror, &far_side) : std::nullopt;
    t = static_cast<double>(at.value_or(along.rounded() / square.rounded()));
  }
  return folded(eye_ + t / scale_ * direction, false);
}

Vec2d UnfoldedPlan::virtual_eye() const { return folded(eye_, false); }

}  // namespace raywalk
