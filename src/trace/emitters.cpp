#include "trace/emitters.h"

#include "math/elementary.h"
#include "math/sampling.h"

#include <algorithm>
#include <limits>

namespace raywalk {

namespace {

template <class T>
Affine<double> map_of(const ObjectTransform<T>* place) {
  if (!place) return {};
  const Affine<T>& m = place->to_world;
  return {Vec3d(m.x), Vec3d(m.y), Vec3d(m.z), Vec3d(m.move)};
}

/// Whether all corners turn the same way.
bool convex(const std::vector<Vec3d>& corners) {
  Vec3d normal(0.0);
  const std::size_t n = corners.size();
  for (std::size_t i = 1; i + 1 < n; ++i) normal += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3d along = corners[(i + 1) % n] - corners[i], next = corners[(i + 2) % n] - corners[(i + 1) % n];
    if (dot(cross(along, next), normal) < 0) return false;
    turned += portable::atan2(length(cross(along, next)), dot(along, next));
  }
  return turned < 3 * pi_v<double>;  // a star turns more than once
}

}  // namespace

template <class T>
Emitters<T>::Emitters(const World<T>& world) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  for (int id = 0; id < primitives.own_size(); ++id)  // no copy emits
    if (!is_black(world.surface(id).emission) && !primitives.moves(id)) add(world, id);
  double sum = 0;
  for (Emitter& emitter : emitters_) {
    const Rgbd emission(world.surface(emitter.primitive).emission);
    emitter.probability = emitter.area * (emission.x + emission.y + emission.z);
    sum += emitter.probability;
  }
  double up_to = 0;
  for (Emitter& emitter : emitters_) {
    emitter.probability /= sum;
    cdf_.push_back(up_to += emitter.probability);
  }
}

template <class T>
void Emitters<T>::add_flat(int primitive, int part, Kind kind, const Vec3d& corner, const Vec3d& u, const Vec3d& v) {
  const double parallelogram = length(cross(u, v));
  if (!(parallelogram > 0)) return;
  const double area = kind == Kind::triangle ? parallelogram / 2
                      : kind == Kind::disk   ? pi_v<double> * parallelogram
                                             : parallelogram;
  constexpr double square = 32 * static_cast<double>(std::numeric_limits<T>::epsilon());
  if (kind == Kind::parallelogram && std::abs(dot(u, v)) <= square * length(u) * length(v)) kind = Kind::rectangle;
  emitters_.push_back({kind, primitive, part, corner, u, v, area, 0});
  if (kind == Kind::rectangle) emitters_.back().axes = {u, v};
}

template <class T>
void Emitters<T>::add_polygon(int primitive, int part, const std::vector<Vec3d>& corners) {
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
void Emitters<T>::add(const World<T>& world, int primitive) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  if (primitives.moves(primitive)) return;  // found by BSDF sampling only
  const Affine<double> map = map_of(primitives.transform_of(primitive));
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
        emitters_.push_back({Kind::sphere, primitive, 0, map.point(Vec3d(shape.centre)), Vec3d(radius, 0, 0),
                             Vec3d(0.0), 4 * pi_v<double> * radius * radius, 0});
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
    }  // planes are unbounded, and the others have no simple map from the unit square
  };
  std::visit(add_shape, primitives.shape(primitive));
}

template <class T>
auto Emitters<T>::picked(double pick) const -> const Emitter& {
  const auto at = std::upper_bound(cdf_.begin(), cdf_.end(), pick);
  return emitters_[std::min(static_cast<std::size_t>(at - cdf_.begin()), emitters_.size() - 1)];
}

template <class T>
auto Emitters<T>::sample_origin(double pick, const Vec2d& unit) const -> Origin {
  const Emitter& emitter = picked(pick);
  const double pdf = emitter.probability / emitter.area;
  if (emitter.kind == Kind::sphere) {
    const Vec3d normal = sample_uniform_sphere(unit);
    return {emitter.primitive, emitter.part, emitter.corner + emitter.u.x * normal, normal, pdf};
  }
  Vec2d place = unit;
  if (emitter.kind == Kind::disk) place = sample_concentric_disk(unit);
  if (emitter.kind == Kind::triangle) place = sample_uniform_triangle(unit);
  return {emitter.primitive, emitter.part, emitter.corner + place.x * emitter.u + place.y * emitter.v,
          normalize(cross(emitter.u, emitter.v)), pdf};
}

template <class T>
auto Emitters<T>::sample(const Vec3<T>& from, T pick, const Vec2<T>& u) const -> std::optional<Sample> {
  const Emitter& emitter = picked(static_cast<double>(pick));
  const Vec3d point(from);
  const Vec2d unit(u);
  Vec3d to_light(0.0);
  double pdf = 0;
  const auto by_area = [&](const Vec2d& place) {
    to_light = emitter.corner + place.x * emitter.u + place.y * emitter.v - point;
    pdf = solid_angle_pdf(emitter.probability / emitter.area, to_light, normalize(cross(emitter.u, emitter.v)));
  };
  switch (emitter.kind) {
    case Kind::sphere: {
      const double radius = emitter.u.x;
      const SubtendedCone<double> seen = subtended_cone(point, emitter.corner, radius);
      if (seen.from_inside) {
        const Vec3d normal = sample_uniform_sphere(unit);
        to_light = emitter.corner + radius * normal - point;
        pdf = solid_angle_pdf(emitter.probability / emitter.area, to_light, normal);
        break;
      }
      const Vec3d direction = sample_subtended_cone(unit, point, emitter.corner, seen);
      const Vec3d centre = emitter.corner - point;
      const double middle = dot(direction, centre);
      const Vec3d passes = centre - middle * direction;
      const double near = middle - std::sqrt(std::max(radius * radius - dot(passes, passes), 0.0));
      // For a point on the sphere that rounding put outside, the near crossing is the point itself.
      to_light = (near > 0 ? near : middle) * direction;
      pdf = emitter.probability * uniform_cone_pdf(seen.one_minus_cos);
      break;
    }
    case Kind::disk:
      by_area(sample_concentric_disk(unit));
      break;
    case Kind::triangle:
      by_area(sample_uniform_triangle(unit));
      break;
    case Kind::parallelogram:
      by_area(unit);
      break;
    case Kind::rectangle: {
      const SphericalRectangle seen(point, emitter.corner, emitter.axes);
      if (!seen.usable()) {
        by_area(unit);
        break;
      }
      const Vec2d place = seen.point_at(unit);
      to_light = emitter.corner + place.x * emitter.u + place.y * emitter.v - point;
      pdf = emitter.probability / seen.solid_angle();
      break;
    }
  }
  const T rounded = static_cast<T>(pdf);
  if (!(rounded > 0) || std::isinf(rounded)) return std::nullopt;
  return Sample{emitter.primitive, emitter.part, Vec3<T>(to_light), rounded};
}

template <class T>
auto Emitters<T>::emitter_of(int primitive, int part) const -> const Emitter* {
  auto emitter = std::lower_bound(emitters_.begin(), emitters_.end(), primitive,
                                  [](const Emitter& one, int id) { return one.primitive < id; });
  while (emitter != emitters_.end() && emitter->primitive == primitive && emitter->part != part) ++emitter;
  return emitter != emitters_.end() && emitter->primitive == primitive ? &*emitter : nullptr;
}

template <class T>
T Emitters<T>::pdf(const Vec3<T>& from, int primitive, int part, const Vec3<T>& met, const Vec3<T>& normal) const {
  const Emitter* emitter = emitter_of(primitive, part);
  if (!emitter) return 0;
  const Vec3d point(from);
  // All triangles of one part have the same pdf per area.
  const auto by_area = [&] {
    const double pdf = solid_angle_pdf(emitter->probability / emitter->area, Vec3d(met) - point, Vec3d(normal));
    return std::isinf(pdf) ? 0 : pdf;
  };
  double pdf = 0;
  switch (emitter->kind) {
    case Kind::sphere: {
      const SubtendedCone<double> seen = subtended_cone(point, emitter->corner, emitter->u.x);
      pdf = seen.from_inside ? by_area() : emitter->probability * uniform_cone_pdf(seen.one_minus_cos);
      break;
    }
    case Kind::rectangle: {
      const SphericalRectangle seen(point, emitter->corner, emitter->axes);
      pdf = seen.usable() ? emitter->probability / seen.solid_angle() : by_area();
      break;
    }
    case Kind::disk:
    case Kind::triangle:
    case Kind::parallelogram:
      pdf = by_area();
      break;
  }
  const T rounded = static_cast<T>(pdf);
  return std::isinf(rounded) ? T(0) : rounded;
}

template class Emitters<float>;
template class Emitters<double>;

}  // namespace raywalk
