#include "trace/path_lights.h"

#include "trace/sampling.h"

#include <algorithm>
#include <limits>

namespace raywalk {

namespace {

template <class T>
Affine<double> map_of(const Placement<T>* place) {
  if (!place) return {};
  const Affine<T>& m = place->to_world;
  return {Vec3d(m.x), Vec3d(m.y), Vec3d(m.z), Vec3d(m.move)};
}

/// Corners of one turn only.
bool convex(const std::vector<Vec3d>& corners) {
  Vec3d normal(0.0);
  const std::size_t n = corners.size();
  for (std::size_t i = 1; i + 1 < n; ++i) normal += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3d along = corners[(i + 1) % n] - corners[i], next = corners[(i + 2) % n] - corners[(i + 1) % n];
    if (dot(cross(along, next), normal) < 0) return false;
    turned += std::atan2(length(cross(along, next)), dot(along, next));
  }
  return turned < 3 * pi_v<double>;  // a star turns more than once
}

}  // namespace

template <class T>
PathLights<T>::PathLights(const World<T>& world) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  for (int id = 0; id < primitives.size(); ++id)
    if (!is_black(world.surface(id).emission) && !primitives.moves(id)) add(world, id);
  double sum = 0;
  for (Piece& piece : pieces_) {
    const Rgbd emission(world.surface(piece.primitive).emission);
    piece.chance = piece.area * (emission.x + emission.y + emission.z);
    sum += piece.chance;
  }
  double up_to = 0;
  for (Piece& piece : pieces_) {
    piece.chance /= sum;
    picks_.push_back(up_to += piece.chance);
  }
}

template <class T>
void PathLights<T>::add_flat(int primitive, int part, Kind kind, const Vec3d& corner, const Vec3d& u, const Vec3d& v) {
  const double parallelogram = length(cross(u, v));
  if (!(parallelogram > 0)) return;
  const double area = kind == Kind::triangle ? parallelogram / 2
                      : kind == Kind::disk   ? pi_v<double> * parallelogram
                                             : parallelogram;
  constexpr double square = 32 * static_cast<double>(std::numeric_limits<T>::epsilon());
  if (kind == Kind::parallelogram && std::abs(dot(u, v)) <= square * length(u) * length(v)) kind = Kind::rectangle;
  pieces_.push_back({kind, primitive, part, corner, u, v, area, 0});
}

template <class T>
void PathLights<T>::add_polygon(int primitive, int part, const std::vector<Vec3d>& corners) {
  if (!convex(corners)) return;
  const Vec3d &origin = corners[0], u = corners[1] - origin;
  if (corners.size() == 4) {
    const Vec3d v = corners[3] - origin, open = corners[2] - (origin + u + v);
    constexpr double closed = 32 * static_cast<double>(std::numeric_limits<T>::epsilon());
    if (length(open) <= closed * (length(u) + length(v)))
      return add_flat(primitive, part, Kind::parallelogram, origin, u, v);
  }
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    add_flat(primitive, part, Kind::triangle, origin, corners[i] - origin, corners[i + 1] - origin);
}

template <class T>
void PathLights<T>::add(const World<T>& world, int primitive) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  if (primitives.moves(primitive)) return;  // found by chance only
  const Affine<double> map = map_of(primitives.place_of(primitive));
  const auto polygon = [&](int part, std::vector<Vec3d> corners) {
    for (Vec3d& corner : corners) corner = map.point(corner);
    add_polygon(primitive, part, corners);
  };
  const auto add_shape = [&](const auto& shape) {
    using S = std::decay_t<decltype(shape)>;
    if constexpr (std::is_same_v<S, Sphere<T>>) {
      const double x = length(map.x), y = length(map.y), z = length(map.z);
      const double slack = 32 * static_cast<double>(std::numeric_limits<T>::epsilon()) * x * x;
      const bool similar = std::abs(x - y) * x <= slack && std::abs(x - z) * x <= slack &&
                           std::abs(dot(map.x, map.y)) <= slack && std::abs(dot(map.y, map.z)) <= slack &&
                           std::abs(dot(map.z, map.x)) <= slack;
      const double radius = x * static_cast<double>(shape.radius);
      if (similar && radius > 0)
        pieces_.push_back({Kind::sphere, primitive, 0, map.point(Vec3d(shape.centre)), Vec3d(radius, 0, 0), Vec3d(0.0),
                           4 * pi_v<double> * radius * radius, 0});
    } else if constexpr (std::is_same_v<S, Disk<T>>) {
      const Basis<double> basis(normalize(Vec3d(shape.normal)));
      const double radius = static_cast<double>(shape.radius);
      add_flat(primitive, 0, Kind::disk, map.point(Vec3d(shape.centre)), map.direction(radius * basis.s),
               map.direction(radius * basis.t));
    } else if constexpr (std::is_same_v<S, Triangle<T>>) {
      polygon(0, {Vec3d(shape.a), Vec3d(shape.b), Vec3d(shape.c)});
    } else if constexpr (std::is_same_v<S, Polygon<T>>) {
      if (shape.holes.empty()) polygon(0, {shape.outline.begin(), shape.outline.end()});
    } else if constexpr (std::is_same_v<S, Box<T>>) {
      for (int part = 0; part < 6; ++part) {
        const int axis = part / 2, one = (axis + 1) % 3, other = (axis + 2) % 3;
        std::vector<Vec3d> corners(4, Vec3d(part % 2 != 0 ? shape.max : shape.min));
        for (std::size_t i = 0; i < 4; ++i) {
          corners[i][one] = (i == 1 || i == 2 ? shape.max : shape.min)[one];
          corners[i][other] = (i >= 2 ? shape.max : shape.min)[other];
        }
        polygon(part, corners);
      }
    } else if constexpr (std::is_same_v<S, Prism<T>>) {
      const double half = static_cast<double>(shape.height) / 2;
      std::vector<Vec3d> top, bottom;
      for (int side = 0; side < shape.sides(); ++side) {
        const Vec2<T>&a = shape.corner(side), &b = shape.corner_after(side);
        top.emplace_back(a.x, a.y, half);
        bottom.emplace_back(a.x, a.y, -half);
        polygon(side, {{a.x, a.y, -half}, {b.x, b.y, -half}, {b.x, b.y, half}, {a.x, a.y, half}});
      }
      polygon(shape.top(), top);
      polygon(shape.bottom(), bottom);
    }  // planes have no end, and no map from the square is known to be simple for the others
  };
  std::visit(add_shape, primitives.shape(primitive));
}

template <class T>
auto PathLights<T>::draw(const Vec3<T>& from, T pick, const Vec2<T>& u) const -> std::optional<Sample> {
  const auto at = std::upper_bound(picks_.begin(), picks_.end(), static_cast<double>(pick));
  const Piece& piece = pieces_[std::min(static_cast<std::size_t>(at - picks_.begin()), pieces_.size() - 1)];
  const Vec3d point(from);
  const Vec2d unit(u);
  Vec3d way(0.0);
  double density = 0;
  const auto by_area = [&](const Vec2d& place) {
    way = piece.corner + place.x * piece.u + place.y * piece.v - point;
    density = solid_angle_density(piece.chance / piece.area, way, normalize(cross(piece.u, piece.v)));
  };
  switch (piece.kind) {
    case Kind::sphere: {
      const double radius = piece.u.x;
      const SphereSeen<double> seen = sphere_seen(point, piece.corner, radius);
      if (seen.from_inside) {
        const Vec3d normal = uniform_sphere(unit);
        way = piece.corner + radius * normal - point;
        density = solid_angle_density(piece.chance / piece.area, way, normal);
        break;
      }
      const Vec3d direction = towards_sphere(unit, point, piece.corner, seen);
      const Vec3d centre = piece.corner - point;
      const double middle = dot(direction, centre);
      const Vec3d passes = centre - middle * direction;
      const double near = middle - std::sqrt(std::max(radius * radius - dot(passes, passes), 0.0));
      // From a point of the sphere itself that rounding put outside, the near crossing is where it stands.
      way = (near > 0 ? near : middle) * direction;
      density = piece.chance * uniform_cone_pdf(seen.one_minus_cos);
      break;
    }
    case Kind::disk:
      by_area(concentric_disk(unit));
      break;
    case Kind::triangle:
      by_area(triangle_weights(unit));
      break;
    case Kind::parallelogram:
      by_area(unit);
      break;
    case Kind::rectangle: {
      const RectangleSeen seen(point, piece.corner, piece.u, piece.v);
      if (!seen.usable()) {
        by_area(unit);
        break;
      }
      const Vec2d place = seen.point_at(unit);
      way = piece.corner + place.x * piece.u + place.y * piece.v - point;
      density = piece.chance / seen.solid_angle();
      break;
    }
  }
  const T rounded = static_cast<T>(density);
  if (!(rounded > 0) || std::isinf(rounded)) return std::nullopt;
  return Sample{piece.primitive, piece.part, Vec3<T>(way), rounded};
}

template <class T>
auto PathLights<T>::piece_of(int primitive, int part) const -> const Piece* {
  auto piece = std::lower_bound(pieces_.begin(), pieces_.end(), primitive,
                                [](const Piece& one, int id) { return one.primitive < id; });
  while (piece != pieces_.end() && piece->primitive == primitive && piece->part != part) ++piece;
  return piece != pieces_.end() && piece->primitive == primitive ? &*piece : nullptr;
}

template <class T>
T PathLights<T>::density(const Vec3<T>& from, int primitive, int part, const Vec3<T>& met,
                         const Vec3<T>& normal) const {
  const Piece* piece = piece_of(primitive, part);
  if (!piece) return 0;
  const Vec3d point(from);
  // Of the triangles that make up one part, each has the same density by area.
  const auto by_area = [&] {
    const double density = solid_angle_density(piece->chance / piece->area, Vec3d(met) - point, Vec3d(normal));
    return std::isinf(density) ? 0 : density;
  };
  double density = 0;
  switch (piece->kind) {
    case Kind::sphere: {
      const SphereSeen<double> seen = sphere_seen(point, piece->corner, piece->u.x);
      density = seen.from_inside ? by_area() : piece->chance * uniform_cone_pdf(seen.one_minus_cos);
      break;
    }
    case Kind::rectangle: {
      const RectangleSeen seen(point, piece->corner, piece->u, piece->v);
      density = seen.usable() ? piece->chance / seen.solid_angle() : by_area();
      break;
    }
    case Kind::disk:
    case Kind::triangle:
    case Kind::parallelogram:
      density = by_area();
      break;
  }
  const T rounded = static_cast<T>(density);
  return std::isinf(rounded) ? T(0) : rounded;
}

template class PathLights<float>;
template class PathLights<double>;

}  // namespace raywalk
