#include "inspect/true_surfaces.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace raywalk {

namespace {

/// The primitives, in double.
Primitives<double> widened(const Primitives<float>& primitives) {
  Primitives<double> all;
  const auto wide_map = [](const Affine<float>& m) {
    return Affine<double>{wide(m.x), wide(m.y), wide(m.z), wide(m.move)};
  };
  for (int id = 0; id < primitives.size(); ++id) {
    Shape<double> shape = shape_cast<double>(primitives.shape(id));
    const ObjectTransform<float>* place = primitives.transform_of(id);
    if (place == nullptr)
      all.add(std::move(shape));
    else
      all.add(std::move(shape), {wide_map(place->to_world), wide_map(place->to_object)});
  }
  return all;
}

int largest_axis(const Vec3d& v) {
  const Vec3d size(std::abs(v.x), std::abs(v.y), std::abs(v.z));
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Joins neighbouring ends of one object: at a corner the lines stop one step short of it.
void join_ends(std::vector<SurfaceCut>& cuts, double near) {
  const std::vector<SurfaceCut> before = cuts;
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (const bool front : {true, false}) {
      const Vec2d own = front ? before[i].points.front() : before[i].points.back();
      const Vec2d* nearest = nullptr;
      for (std::size_t j = 0; j < cuts.size(); ++j)
        for (const Vec2d* other : {&before[j].points.front(), &before[j].points.back()})
          if (i != j && before[j].object == before[i].object && length(*other - own) <= near &&
              (nearest == nullptr || length(*other - own) < length(*nearest - own)))
            nearest = other;
      if (nearest == nullptr) continue;
      SurfaceCut& cut = cuts[i];
      cut.points.insert(front ? cut.points.begin() : cut.points.end(), *nearest);
      cut.outwards.insert(front ? cut.outwards.begin() : cut.outwards.end(),
                          front ? before[i].outwards.front() : before[i].outwards.back());
    }
}

}  // namespace

TrueSurfaces::LineHit* TrueSurfaces::LineHit::nearest_in(std::vector<LineHit>& others, double width) const {
  constexpr double steepest = 2.5;
  LineHit* nearest = nullptr;
  for (LineHit& other : others) {
    const bool same = other.cut >= 0 && other.object == object && (other.outwards.y > 0) == (outwards.y > 0);
    const double apart = std::abs(other.at.y - at.y);
    if (same && apart <= steepest * width && (nearest == nullptr || apart < std::abs(nearest->at.y - at.y)))
      nearest = &other;
  }
  return nearest;
}

template <class T>
TrueSurfaces::TrueSurfaces(const std::shared_ptr<const World<T>>& world, T time) : time_(static_cast<double>(time)) {
  object_of_ = [world](int primitive) { return world->object(primitive); };
  if constexpr (std::is_same_v<T, double>)
    accelerator_ = std::shared_ptr<const Accelerator<double>>(world, &world->accelerator);
  else
    accelerator_ = std::make_shared<const Accelerator<double>>(widened(world->accelerator.primitives()));
}

template TrueSurfaces::TrueSurfaces(const std::shared_ptr<const World<float>>&, float);
template TrueSurfaces::TrueSurfaces(const std::shared_ptr<const World<double>>&, double);

std::optional<TrueSurfaces::NearbySurface> TrueSurfaces::beside(int primitive, const Vec3d& place, int axis,
                                                                double spacing) const {
  const Primitives<double>& primitives = accelerator_->primitives();
  // From as close as possible: the shorter the distance, the more fractional digits it has.
  constexpr double first_reach = 64, wider = 64, farthest = 0x1p48;  // spacings
  for (double reach = first_reach * spacing; reach < farthest * spacing; reach *= wider) {
    Ray<double> probe{place, Vec3d(0.0), {}, time_};
    probe.direction[axis] = 1;
    probe.origin[axis] -= reach;
    double from = probe.origin[axis] - place[axis];
    std::optional<NearbySurface> nearest;
    constexpr int max_crossings = 16;
    for (int i = 0; i < max_crossings; ++i) {
      const auto met = primitives.intersect(primitive, probe, reach - from);
      if (!met) break;
      const double way = from + met->t;
      if (!nearest || std::abs(way) < std::abs(nearest->way))
        nearest = NearbySurface{way, primitives.surface_at(primitive, probe, *met).normal};
      from = way;
      probe.origin[axis] += met->t;
      probe.departure = {primitive, met->part};
    }
    if (nearest) return nearest;
  }
  return std::nullopt;
}

std::optional<double> TrueSurfaces::distance(int primitive, const Vec3d& place, const Vec3d& normal,
                                             double spacing) const {
  const int axis = largest_axis(normal);
  const auto surface = beside(primitive, place, axis, spacing);
  if (!surface) return std::nullopt;
  return -surface->way * surface->normal[axis];
}

Vec3d place_on(const Ray<double>& ray, const DoubleDouble& t, const Vec3d& from) {
  Vec3d place;
  for (int axis = 0; axis < 3; ++axis)
    place[axis] = static_cast<double>(t * DoubleDouble(ray.direction[axis]) + DoubleDouble(ray.origin[axis]) -
                                      DoubleDouble(from[axis]));
  return place;
}

std::optional<DoubleDouble> TrueSurfaces::crossing(int primitive, const Ray<double>& ray, double spacing) const {
  const Primitives<double>& primitives = accelerator_->primitives();
  Ray<double> timed = ray;
  timed.time = time_;
  const auto met = primitives.intersect(primitive, timed, infinity<double>);
  if (!met) return std::nullopt;
  DoubleDouble t(met->t);
  const Vec3d normal = primitives.surface_at(primitive, timed, *met).normal;
  // Newton's method: the surface is replaced by its tangent plane at a representable point.
  constexpr int rounds = 3;
  for (int i = 0; i < rounds; ++i) {
    const Vec3d near = timed.at(static_cast<double>(t));
    const int axis = largest_axis(normal);
    const auto surface = beside(primitive, near, axis, spacing);
    if (!surface) break;
    const Vec3d& n = surface->normal;
    const double rate = dot(n, ray.direction), off = dot(n, place_on(timed, t, near)) - surface->way * n[axis];
    const double step = -off / rate;
    if (!std::isfinite(step)) break;
    t = t + DoubleDouble(step);
  }
  return t;
}

std::optional<Hit<double>> TrueSurfaces::closest(Ray<double> ray, double t_max) const {
  ray.time = time_;
  TestCounts uncounted;
  return accelerator_->closest(ray, t_max, uncounted);
}

std::vector<TrueSurfaces::LineHit> TrueSurfaces::met_along(Ray<double> line, const Vec3d& middle, int order, int axis,
                                                           double reach) const {
  std::vector<LineHit> all;
  const double place = line.origin[order] - middle[order];
  double from = line.origin[axis] - middle[axis];
  constexpr int max_crossings = 64;
  for (int crossing = 0; crossing < max_crossings; ++crossing) {
    const auto hit = closest(line, reach - from);
    if (!hit) break;
    const Vec3d normal = accelerator_->primitives().surface_at(hit->primitive, line, {hit->t, hit->part}).normal;
    from += hit->t;
    line.origin[axis] += hit->t;
    line.departure = {hit->primitive, hit->part};
    const Vec2d flat(normal[order], normal[axis]);
    const double size = length(flat);
    // Surfaces nearly parallel to the line are left to the lines across it.
    constexpr double slanted = 0.6;
    if (size > 0 && std::abs(flat.y) >= slanted * size)
      all.push_back({{place, from}, flat / size, object_of_(hit->primitive)});
  }
  return all;
}

std::vector<SurfaceCut> TrueSurfaces::cut(const Vec3d& middle, const DrawnAxes& axes, const Vec2d& reach,
                                          const std::array<int, 2>& lines) const {
  std::vector<SurfaceCut> cuts;
  // Vertical lines find nearly level surfaces, horizontal lines nearly upright ones.
  for (const int along : {1, 0}) {
    const int order = axes[static_cast<std::size_t>(1 - along)], axis = axes[static_cast<std::size_t>(along)];
    const int count = lines[static_cast<std::size_t>(1 - along)];
    const auto drawn = [&](const Vec2d& v) { return along == 1 ? v : Vec2d(v.y, v.x); };
    std::vector<LineHit> last;
    double last_place = -infinity<double>;
    for (int i = 0; i <= count; ++i) {
      Ray<double> line{middle, Vec3d(0.0), {}, time_};
      line.direction[axis] = 1;
      line.origin[order] += reach[1 - along] * (2.0 * i / count - 1);
      line.origin[axis] -= reach[along];
      const double place = line.origin[order] - middle[order];
      if (place == last_place) continue;  // doubles are spaced more widely than the lines
      std::vector<LineHit> now = met_along(line, middle, order, axis, reach[along]);
      for (LineHit& met : now) {
        LineHit* before = met.nearest_in(last, place - last_place);
        met.cut = before != nullptr ? std::exchange(before->cut, -1) : -1;
        if (met.cut < 0) {
          met.cut = static_cast<int>(cuts.size());
          cuts.push_back({met.object, {}, {}});
        }
        SurfaceCut& joined = cuts[static_cast<std::size_t>(met.cut)];
        joined.points.push_back(drawn(met.at));
        joined.outwards.push_back(drawn(met.outwards));
      }
      last = std::move(now);
      last_place = place;
    }
  }
  std::erase_if(cuts, [](const SurfaceCut& line) { return line.points.size() < 2; });
  join_ends(cuts, 2 * std::max(2 * reach.x / lines[0], 2 * reach.y / lines[1]));
  return cuts;
}

}  // namespace raywalk
