#include "trace/cone_cover.h"

#include "math/elementary.h"
#include "math/overloaded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace raywalk {

namespace {

/// Smaller parts are nothing.
constexpr double least_share = 1e-12;

/// Of what a shape covers: the middle of a stretch of the unit disc along `direction`, from `begin` to `end`.
void place_on(ConePart& part, const Vec2d& direction, double begin, double end) {
  begin = std::clamp(begin, -1.0, 1.0), end = std::clamp(end, -1.0, 1.0);
  part.place = (begin + end) / 2 * direction;
}

/// How large a cone is that has this share of another.
double size_of(double share, bool flat) { return flat ? share : std::sqrt(share); }

// ---- Spheres

/// a u^2 - 2 b u + c <= 0: the rays along one line through the disc that meet a ball.
struct Silhouette {
  double a, b, c;
  Vec2d direction;  ///< of that line, towards the ball's centre
};

Silhouette silhouette_of(const RayCone& cone, const ConeBall& ball) {
  const Vec3d to_centre = ball.centre - cone.origin;
  const double depth = dot(to_centre, cone.axis);
  Vec2d off{dot(to_centre, cone.right), cone.flat ? 0 : dot(to_centre, cone.up)};
  double distance = length(off);
  Vec2d direction = distance > 0 ? off / distance : Vec2d(1, 0);
  if (cone.flat) direction = {1, 0}, distance = off.x;
  const double radius = cone.radius_at(depth), reach = ball.radius * ball.radius;
  return {radius * radius - reach * cone.spread * cone.spread, distance * radius,
          (distance - ball.radius) * (distance + ball.radius), direction};
}

/// t of a ray to a ball: where it enters or, from inside, where it leaves.
std::optional<double> reach_ball(const RayCone& cone, const ConeBall& ball, const Vec2d& place, bool inside) {
  const Vec3d direction = cone.direction(place), to_centre = ball.centre - cone.start(place);
  const double square = dot(direction, direction), along = dot(direction, to_centre) / square;
  const Vec3d nearest = to_centre - along * direction;
  const double left = ball.radius * ball.radius - dot(nearest, nearest);
  // Where rounding puts a ray beside what it touches, it touches it.
  const double half = left > 0 ? std::sqrt(left / square) : 0;
  const double t = inside ? along + half : along - half;
  return t > 0 ? std::optional(t) : std::nullopt;
}

/// Whether a ray goes towards a ball, and not away from it.
bool approaches(const RayCone& cone, const ConeBall& ball, const Vec2d& place) {
  return dot(cone.direction(place), ball.centre - cone.start(place)) > 0;
}

/// Of the rays along a line, those from -1 to `low` and from `high` to 1 are on lines that meet the ball: but of one
/// side or both it may lie behind where they start. Where a cone opens only one side goes towards it.
void cover_beside_gap(ConePart& part, const ConeBall& ball, const RayCone& cone, const Vec2d& direction, double low,
                      double high) {
  double most = 0;
  part.cover = 0;
  for (const auto& [begin, end] : {std::pair(-1.0, std::min(low, 1.0)), std::pair(std::max(high, -1.0), 1.0)}) {
    if (!(begin < end) || !approaches(cone, ball, (begin + end) / 2 * direction)) continue;
    const double share = cone.flat ? (end - begin) / 2 : share_beyond(end == 1 ? begin : -end);
    part.cover += share;
    if (share > most) most = share, place_on(part, direction, begin, end);
  }
  part.cover = std::min(part.cover, 1.0);
}

void cover(std::vector<ConePart>& parts, const ConeBall& ball, const RayCone& cone, bool leaves) {
  const Vec3d to_centre = ball.centre - cone.origin;
  ConePart part;
  part.inside = leaves ? dot(cone.axis, to_centre) > 0 : length(to_centre) < ball.radius * (1 - 1e-12);
  if (leaves && !part.inside) return;
  if (!part.inside) {
    // Wide cones meet balls whose centre is level with their start, or behind it: each ray has its own t.
    const auto [a, b, c, direction] = silhouette_of(cone, ball);
    const double discriminant = b * b - a * c;
    part.cover = c <= 0 ? 1 : 0;  // without a root all of the line meets it, or nothing
    if (discriminant > 0) {
      const double root = std::sqrt(discriminant), sum = b < 0 ? b - root : b + root;
      // The far one is nowhere where a is 0: only the near one is an edge then.
      const double near_one = c / sum, far_one = sum / a;
      if (a > 0) {
        const double begin = std::min(near_one, far_one), end = std::max(near_one, far_one);
        place_on(part, direction, begin, end);
        if (cone.flat)
          part.cover = std::max(std::min(end, 1.0) - std::max(begin, -1.0), 0.0) / 2;
        else if (end - begin < 1e8)
          part.cover = share_of_disc(std::abs(begin + end) / 2, (end - begin) / 2);
        else  // a straight edge, before rounding makes it a coarse one
          part.cover = share_beyond(std::abs(begin) < std::abs(end) ? begin : -end);
      } else if (a < 0) {
        // The cone comes to a point in or beside it.
        cover_beside_gap(part, ball, cone, direction, std::min(near_one, far_one), std::max(near_one, far_one));
      } else if (b > 0) {
        cover_beside_gap(part, ball, cone, direction, -1, near_one);
      } else {
        cover_beside_gap(part, ball, cone, direction, near_one, 1);
      }
    }
    if (!(part.cover > least_share)) return;
  }
  if (part.inside && leaves) part.cover = 1;
  const auto t = reach_ball(cone, ball, part.place, part.inside);
  if (!t) return;
  part.t = *t;
  parts.push_back(part);
}

// ---- Planes

double reach_plane(const RayCone& cone, const Vec3d& point, const Vec3d& normal, const Vec2d& place) {
  return dot(point - cone.start(place), normal) / dot(cone.direction(place), normal);
}

void cover(std::vector<ConePart>& parts, const ConeWall& wall, const RayCone& cone, bool leaves, double depth) {
  if (leaves) return;
  double height = dot(cone.origin - wall.point, wall.normal);
  const Vec3d down = height < 0 ? wall.normal : -wall.normal;
  height = std::abs(height);
  Vec2d across{dot(cone.right, down), cone.flat ? 0 : dot(cone.up, down)};
  const double size = length(across);
  const Vec2d direction = size > 0 ? across / size : Vec2d(1, 0);
  // A ray meets the plane if it goes down, or down by more than its height: falls + slope x > 0 at x along `direction`.
  const bool endless = std::isinf(depth);
  const double falls = endless ? dot(cone.axis, down) : depth * dot(cone.axis, down) - height;
  const double slope = size * (endless ? cone.spread : cone.radius_at(depth));
  ConePart part;
  double begin = -1, end = 1;
  if (std::abs(falls) >= std::abs(slope)) {
    part.cover = falls > 0 ? 1 : 0;
  } else if (slope > 0) {
    begin = -falls / slope;
    part.cover = cone.flat ? (1 - begin) / 2 : share_beyond(begin);
  } else {
    end = -falls / slope;
    part.cover = cone.flat ? (end + 1) / 2 : share_beyond(-end);
  }
  if (!(part.cover > least_share)) return;
  place_on(part, direction, begin, end);
  part.t = reach_plane(cone, wall.point, wall.normal, part.place);
  if (part.t > 0 && std::isfinite(part.t)) parts.push_back(part);
}

// ---- Faces

/// A corner as the cone sees it: (x, y) across the axis, z its depth.
std::vector<Vec3d> seen_from(const RayCone& cone, const std::vector<Vec3d>& corners) {
  std::vector<Vec3d> seen;
  for (const Vec3d& corner : corners) {
    const Vec3d to = corner - cone.origin;
    seen.push_back({dot(to, cone.right), cone.flat ? 0 : dot(to, cone.up), dot(to, cone.axis)});
  }
  return seen;
}

/// The part of a loop, or of a side, where `inside` is at least 0.
template <class Inside>
std::vector<Vec3d> clipped(const std::vector<Vec3d>& loop, Inside inside) {
  std::vector<Vec3d> kept;
  const std::size_t sides = loop.size() == 2 ? 1 : loop.size();
  for (std::size_t i = 0; i < sides; ++i) {
    const Vec3d &from = loop[i], &to = loop[(i + 1) % loop.size()];
    const double a = inside(from), b = inside(to);
    if (a >= 0) kept.push_back(from);
    if ((a >= 0) != (b >= 0)) kept.push_back(from + a / (a - b) * (to - from));
    if (loop.size() == 2 && b >= 0) kept.push_back(to);
  }
  return kept;
}

/// The loop in the unit disc's plane: once for what is before the point that the cone may come to, once for what is
/// behind it.
std::array<std::vector<Vec2d>, 2> projected(const RayCone& cone, std::vector<Vec3d> loop, double depth) {
  double far = 0;
  for (const Vec3d& corner : loop) far = std::max(far, std::abs(corner.z) + length(Vec2d(corner.x, corner.y)));
  const double nearest = 1e-9 * far, narrowest = 1e-9 * std::max(std::abs(cone.spread) * far, cone.radius);
  loop = clipped(loop, [&](const Vec3d& p) { return p.z - nearest; });
  if (std::isfinite(depth)) loop = clipped(loop, [&](const Vec3d& p) { return depth - p.z; });
  std::array<std::vector<Vec2d>, 2> places;
  for (const double side : {1.0, -1.0}) {
    if (loop.empty()) continue;
    for (const Vec3d& p : clipped(loop, [&](const Vec3d& at) { return side * cone.radius_at(at.z) - narrowest; }))
      places[side > 0 ? 0 : 1].push_back(Vec2d(p.x, p.y) / cone.radius_at(p.z));
  }
  return places;
}

/// The middle of the corners of a polygon, cut to a polygon within the disc.
std::optional<Vec2d> middle_of(const std::vector<Vec2d>& polygon) {
  constexpr int corners = 24;
  std::vector<Vec3d> rest;
  for (const Vec2d& place : polygon) rest.push_back({place.x, place.y, 0});
  for (int i = 0; i < corners && !rest.empty(); ++i) {
    const auto [sin, cos] = portable::sin_cos(2 * std::numbers::pi * i / corners);
    rest = clipped(rest, [&, s = sin, c = cos](const Vec3d& p) { return 1 - (p.x * c + p.y * s); });
  }
  double twice = 0;
  Vec2d sum{0};
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const Vec2d a = plan(rest[i]) - plan(rest[0]), b = plan(rest[(i + 1) % rest.size()]) - plan(rest[0]);
    twice += cross(a, b);
    sum += cross(a, b) / 3 * (a + b);
  }
  if (twice == 0) return std::nullopt;
  return plan(rest[0]) + sum / twice;
}

/// How far the cone's middle starts from a face's plane, on its outer side.
double height_over(const ConeFace& face, const RayCone& cone) {
  return dot(cone.origin - face.loops.front().front(), face.normal);
}

/// Which rays of a cone meet a face: all, or those that go into its solid or come out of it there.
enum class Crossing { any, in, out };

/// A disc square to the axis is one in the unit disc's plane, too: its share has a closed form.
bool is_square_disc(const ConeFace& face, const RayCone& cone) {
  constexpr double square = 1e-9;  // a tilt of this changes the share by no more
  return face.disc && !cone.flat && length(cross(cone.axis, face.normal)) < square;
}

std::optional<ConePart> covered_by_square_disc(const ConeFace& face, const RayCone& cone, double depth) {
  const Vec3d to_centre = face.disc->centre - cone.origin;
  const double along = dot(to_centre, cone.axis), width = cone.radius_at(along);
  if (!(along > 0 && along < depth)) return std::nullopt;
  const Vec2d off{dot(to_centre, cone.right), dot(to_centre, cone.up)};
  const double distance = length(off), radius = face.disc->radius, narrow = 1e-9 * cone.radius;
  ConePart part;
  part.part = face.part;
  part.t = along;
  // Where the cone comes to a point, that is in the disc or not.
  if (std::abs(width) <= narrow) return distance < radius ? std::optional(part) : std::nullopt;
  part.cover = share_of_disc(distance / std::abs(width), radius / std::abs(width));
  if (!(part.cover > least_share)) return std::nullopt;
  const Vec2d direction = distance > 0 ? off / distance : Vec2d(1, 0);
  place_on(part, direction, (distance - radius) / width, (distance + radius) / width);
  return part;
}

std::optional<ConePart> covered_by(const ConeFace& face, const RayCone& cone, Crossing crossing, double depth) {
  if (is_square_disc(face, cone)) return covered_by_square_disc(face, cone, depth);
  // Rays cross a plane as seen from the point that they come from or go to, which is not where they start: of
  // direction(u) the part along the normal is `across` / radius_at(depth of the plane), for all u.
  const double across = cone.radius * dot(cone.axis, face.normal) - cone.spread * height_over(face, cone);
  ConePart part;
  part.part = face.part;
  part.cover = 0;
  double most = 0;
  bool outline = true;
  for (const std::vector<Vec3d>& loop : face.loops) {
    const auto both = projected(cone, seen_from(cone, loop), depth);
    for (const int side : {0, 1}) {
      const std::vector<Vec2d>& places = both[static_cast<std::size_t>(side)];
      const double outward = side == 0 ? across : -across;
      if (crossing != Crossing::any && !(crossing == Crossing::in ? outward < 0 : outward > 0)) continue;
      if (places.size() < 2) continue;
      double share = 0;
      std::optional<Vec2d> middle;
      if (cone.flat) {
        const auto [low, high] = std::minmax(places[0].x, places[1].x);
        const double begin = std::clamp(low, -1.0, 1.0), end = std::clamp(high, -1.0, 1.0);
        share = (end - begin) / 2;
        middle = Vec2d((begin + end) / 2, 0);
      } else {
        double twice = 0;
        for (std::size_t i = 0; i < places.size(); ++i)
          twice += twice_area_of_side(places[i], places[(i + 1) % places.size()]);
        share = std::abs(twice) / (2 * std::numbers::pi);
        if (outline) middle = middle_of(places);
      }
      part.cover += outline ? share : -share;
      if (outline && middle && share > most) most = share, part.place = *middle;
    }
    outline = false;
  }
  part.cover = std::clamp(part.cover, 0.0, 1.0);
  if (!(part.cover > least_share)) return std::nullopt;
  const double long_place = length(part.place);
  if (long_place > 1) part.place = part.place / long_place;
  part.t = reach_plane(cone, face.loops.front().front(), face.normal, part.place);
  if (!(part.t > 0) || !std::isfinite(part.t)) return std::nullopt;
  return part;
}

void cover(std::vector<ConePart>& parts, const ConeFaces& body, const RayCone& cone, const ConeLeaves* leaves,
           double depth) {
  const auto is_left = [&](const ConeFace& face) { return leaves != nullptr && face.part == leaves->part; };
  // The cone's middle ray says where it starts. In a face's plane, as on it, by where it goes.
  bool inside = body.closed;
  for (const ConeFace& face : body.faces) {
    const double height = is_left(face) ? 0 : height_over(face, cone);
    inside = inside && (height < 0 || (height == 0 && dot(cone.axis, face.normal) < 0));
  }
  // From outside a convex solid is not met by what leaves it.
  if (leaves != nullptr && !inside) return;
  double sum = 0;
  const std::size_t first = parts.size();
  const Crossing crossing = !body.closed ? Crossing::any : inside ? Crossing::out : Crossing::in;
  for (const ConeFace& face : body.faces) {
    if (is_left(face)) continue;
    auto part = covered_by(face, cone, crossing, depth);
    if (!part) continue;
    part->inside = inside;
    sum += part->cover;
    parts.push_back(*part);
  }
  // Rounding, and faces seen along their edge, may make it more than all.
  if (sum > 1 || (inside && std::isinf(depth) && sum > 0))
    for (std::size_t i = first; i < parts.size(); ++i) parts[i].cover /= sum;
}

// ---- All together

/// t of a ray of the cone to the object of a part, taken as endless.
double reach(const ConeBodies& bodies, const RayCone& cone, const ConePart& part, const Vec2d& place) {
  const ConeBody& body = bodies[part.body];
  return std::visit(
      Overloaded{
          [&](const ConeBall& ball) { return reach_ball(cone, ball, place, part.inside).value_or(part.t); },
          [&](const ConeWall& wall) { return reach_plane(cone, wall.point, wall.normal, place); },
          [&](const ConeFaces& faces) {
            for (const ConeFace& face : faces.faces)
              if (face.part == part.part) return reach_plane(cone, face.loops.front().front(), face.normal, place);
            return part.t;
          },
      },
      body.shape);
}

/// What one object covers: its faces side by side.
struct Cover {
  std::size_t first, last;
  double cover = 0;
};

/// Whether one is before the other: along a ray in the middle of the smaller one, for the larger one is there, too.
bool is_before(const ConeBodies& bodies, const RayCone& cone, const ConePart& one, const ConePart& other) {
  const bool one_is_smaller = one.cover <= other.cover;
  const ConePart &small = one_is_smaller ? one : other, &large = one_is_smaller ? other : one;
  const double behind = reach(bodies, cone, large, small.place);
  const bool small_first = !(behind > 0) || small.t < behind;
  return one_is_smaller == small_first;
}

const ConePart& largest(const std::vector<ConePart>& parts, const Cover& group) {
  return *std::max_element(parts.begin() + static_cast<std::ptrdiff_t>(group.first),
                           parts.begin() + static_cast<std::ptrdiff_t>(group.last),
                           [](const ConePart& a, const ConePart& b) { return a.cover < b.cover; });
}

}  // namespace

std::vector<ConePart> meet_cone(const ConeBodies& bodies, const RayCone& cone, const ConeLeaves& leaves, double depth,
                                TestCounts& counts) {
  std::vector<ConePart> parts;
  const std::vector<int> near = bodies.near(cone, depth);
  counts.primitives += near.size();
  for (const int i : near) {
    const bool left = bodies[i].object == leaves.object;
    const std::size_t first = parts.size();
    std::visit(Overloaded{
                   [&](const ConeBall& ball) { cover(parts, ball, cone, left); },
                   [&](const ConeWall& wall) { cover(parts, wall, cone, left, depth); },
                   [&](const ConeFaces& faces) { cover(parts, faces, cone, left ? &leaves : nullptr, depth); },
               },
               bodies[i].shape);
    std::erase_if(parts, [&](const ConePart& part) { return part.body < 0 && part.t >= depth; });
    for (std::size_t k = first; k < parts.size(); ++k) {
      parts[k].body = i;
      parts[k].size = size_of(parts[k].cover, cone.flat);
    }
  }
  return parts;
}

std::vector<ConePart> cover_cone(const ConeBodies& bodies, const RayCone& cone, const ConeLeaves& leaves,
                                 TestCounts& counts) {
  std::vector<ConePart> parts = meet_cone(bodies, cone, leaves, infinity<double>, counts);
  std::vector<Cover> groups;
  for (std::size_t first = 0; first < parts.size();) {
    Cover group{first, first};
    for (; group.last < parts.size() && parts[group.last].body == parts[first].body; ++group.last)
      group.cover += parts[group.last].cover;
    group.cover = std::min(group.cover, 1.0);
    first = group.last;
    // Into its place: not sorted by a library, for what is before what need not be an order.
    std::size_t at = groups.size();
    groups.push_back(group);
    while (at > 0 && is_before(bodies, cone, largest(parts, groups[at]), largest(parts, groups[at - 1]))) {
      std::swap(groups[at], groups[at - 1]);
      --at;
    }
  }
  std::vector<ConePart> seen;
  double left = 1;
  for (const Cover& group : groups) {
    if (!(left > least_share)) break;
    for (std::size_t k = group.first; k < group.last; ++k) {
      parts[k].share = left * parts[k].cover;
      seen.push_back(parts[k]);
    }
    left *= 1 - group.cover;
  }
  if (left > least_share || seen.empty()) {
    ConePart rest;
    rest.cover = rest.share = left;
    seen.push_back(rest);
  }
  return seen;
}

}  // namespace raywalk
