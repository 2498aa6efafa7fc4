#include "inspect/microscope.h"

#include "inspect/retraced_ray.h"
#include "trace/shadow_transmittance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

namespace raywalk {

namespace {

template <class T>
double spacing_in(double x) {
  const T size = std::abs(static_cast<T>(x));
  return static_cast<double>(std::nextafter(size, infinity<T>)) - static_cast<double>(size);
}

template <class T>
constexpr Precision precision_of = std::is_same_v<T, float> ? Precision::float_ : Precision::double_;

template <class T>
double largest_spacing(const Vec3<T>& place) {
  return spacing_in<T>(static_cast<double>(std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)})));
}

template <class T>
Ray<double> wide_ray(const Ray<T>& ray) {
  return {wide(ray.origin), wide(ray.direction), ray.departure, static_cast<double>(ray.time)};
}
template <class T>
Ray<double> wide_ray(const NaiveRay<T>& ray) {
  return wide_ray(ray.plain());
}

/// Views along the axis that is least aligned with surface and ray; the last one if equal.
DrawnAxes axes_for(const Vec3d& normal, const Vec3d& direction) {
  constexpr double ray_counts = 0.3;
  int hidden = 2;
  const auto runs = [&](int axis) { return std::abs(normal[axis]) + ray_counts * std::abs(direction[axis]); };
  for (const int axis : {1, 0})
    if (runs(axis) < runs(hidden)) hidden = axis;
  return hidden == 2 ? DrawnAxes{0, 1} : hidden == 1 ? DrawnAxes{0, 2} : DrawnAxes{1, 2};
}

template <class T>
std::vector<double> numbers_in(double x, double reach, std::size_t most) {
  const T middle = static_cast<T>(x);
  std::vector<double> below, above;
  const auto gather = [&](std::vector<double>& side, T towards) {
    for (T number = std::nextafter(middle, towards); std::isfinite(number); number = std::nextafter(number, towards)) {
      const double off = static_cast<double>(number) - x;
      if (std::abs(off) > reach || below.size() + above.size() > most) return;
      side.push_back(off);
    }
  };
  gather(below, -infinity<T>);
  gather(above, infinity<T>);
  if (below.size() + above.size() + 1 > most) return {};
  std::vector<double> all(below.rbegin(), below.rend());
  all.push_back(static_cast<double>(middle) - x);
  all.insert(all.end(), above.begin(), above.end());
  return all;
}

}  // namespace

double spacing_at(double x, Precision precision) {
  switch (precision) {
    case Precision::float_:
      return spacing_in<float>(x);
    case Precision::double_:
      return spacing_in<double>(x);
  }
  return 0;
}

std::vector<double> numbers_about(double x, double reach, Precision precision, std::size_t most) {
  switch (precision) {
    case Precision::float_:
      return numbers_in<float>(x, reach, most);
    case Precision::double_:
      return numbers_in<double>(x, reach, most);
  }
  return {};
}

/// A recording's scene, prepared for tracing again.
template <class T>
struct Microscope::PreparedScene {
  PreparedScene(const Scene& walked, const Timeline& recorded)
      : scene(walked),
        timeline(recorded),
        world(std::make_shared<const World<T>>(scene)),
        camera(camera_of<T>(walked, recorded)) {}

  Scene scene;
  const Timeline& timeline;
  std::shared_ptr<const World<T>> world;
  RayGenerator<T> camera;
  std::shared_ptr<const TrueSurfaces> surfaces;  ///< as they stand at `time`
  T time = 0;

  using HitSurface = SurfaceHit<T>;

  [[nodiscard]] const Primitives<T>& primitives() const { return world->accelerator.primitives(); }
  [[nodiscard]] bool is_naive() const { return world->numerics == Numerics::naive; }
  [[nodiscard]] const RayRecord& record(int ray) const { return timeline.rays()[static_cast<std::size_t>(ray)]; }

  template <class AnyRay>
  [[nodiscard]] std::optional<HitSurface> find(const AnyRay& ray) const {
    return find_surface(*world, ray);
  }

  [[nodiscard]] std::shared_ptr<const Specimen> examine(int ray);

 private:
  void survey(T now);
  [[nodiscard]] std::shared_ptr<const Specimen> passed_by(int number, const Ray<T>& ray);
  static void set_numbers(Specimen& specimen);
  template <class AnyRay>
  [[nodiscard]] Reading read(const AnyRay& ray, const HitSurface& found) const;
  template <class AnyRay>
  void follow(Reading& reading, const AnyRay& ray, const HitSurface& found, const HitSurface& robust,
              const HitSurface& recorded, int number) const;
  [[nodiscard]] std::optional<Hit<T>> truly_met(RayKind kind, const Ray<T>& ray, T t_max) const;
};

template <class T>
template <class AnyRay>
Reading Microscope::PreparedScene<T>::read(const AnyRay& ray, const HitSurface& found) const {
  const double spacing = largest_spacing(found.point.position);
  Reading reading;
  reading.t = static_cast<double>(found.hit.t);
  reading.object = world->object(found.hit.primitive);
  reading.point = wide(found.point.position);
  reading.off = surfaces->distance(found.hit.primitive, reading.point, wide(found.point.normal), spacing);
  if (const auto t = surfaces->crossing(found.hit.primitive, wide_ray(ray), spacing))
    reading.t_error = static_cast<double>(DoubleDouble(reading.t) - *t) / spacing_in<T>(reading.t);
  return reading;
}

/// The robust search itself skips filtering objects, which let shadow rays through.
template <class T>
std::optional<Hit<T>> Microscope::PreparedScene<T>::truly_met(RayKind kind, const Ray<T>& ray, T t_max) const {
  if (kind == RayKind::shadow && !world->shadow_roles.empty()) return first_blocker(*world, ray, t_max);
  const auto hit = surfaces->closest(wide_ray(ray), static_cast<double>(t_max));
  if (!hit) return std::nullopt;
  return Hit<T>{static_cast<T>(hit->t), hit->primitive, hit->part};
}

/// Traces the recorded rays from this reading's spawn points. `robust`: the reading that the truth is computed from;
/// `recorded`: the recorded origins.
template <class T>
template <class AnyRay>
void Microscope::PreparedScene<T>::follow(Reading& reading, const AnyRay& ray, const HitSurface& found,
                                          const HitSurface& robust, const HitSurface& recorded, int number) const {
  const double spacing = largest_spacing(found.point.position);
  const auto surface_of = [&](int primitive) { return primitives().first_equal(primitive); };
  const auto leave = [&]<class Any>(const HitSurface& from, const Vec3<T>& direction) {
    return spawn_ray<Any>(*world, from.point.position, from.point.normal, {from.hit.primitive, from.hit.part},
                          direction, ray.time);
  };
  const auto add_start = [&](const Vec3<T>& direction) {
    const Vec3d place = wide(leave.template operator()<AnyRay>(found, direction).origin);
    reading.starts.push_back({place, surfaces->distance(found.hit.primitive, place, wide(found.point.normal), spacing),
                              dot(found.point.normal, direction) > 0});
  };
  add_start(-ray.direction);
  for (const RayRecord& next : timeline.rays()) {
    if (next.parent != number || !next.formed) continue;
    const auto& formed = std::get<RayFormed>(timeline.event(next.formed_at - 1).detail);
    const Vec3d light = wide(recorded.point.position) + next.direction;
    const auto direction_from = [&](const HitSurface& from) {
      const bool own = from.point.position == recorded.point.position || !formed.light_at_end;
      return own ? Vec3<T>(next.direction) : Vec3<T>(light) - from.point.position;
    };
    const T t_max = formed.light_at_end ? T(1) : infinity<T>;
    const AnyRay leaves = leave.template operator()<AnyRay>(found, direction_from(found));
    TestCounts uncounted;
    const auto met = next.kind == RayKind::shadow ? first_blocker(*world, leaves, t_max)
                                                  : world->accelerator.closest(leaves, t_max, uncounted);
    const auto truth = truly_met(next.kind, leave.template operator()<Ray<T>>(robust, direction_from(robust)), t_max);
    const bool same =
        met.has_value() == truth.has_value() && (!met || surface_of(met->primitive) == surface_of(truth->primitive));
    const bool own = met && surface_of(met->primitive) == surface_of(found.hit.primitive);
    // Across a body, a ray rightly meets its own surface again, but not at once.
    const bool at_once = own && !(same && met->t > truth->t / 2);

    auto of_kind = std::find_if(reading.spawned.begin(), reading.spawned.end(),
                                [&](const SpawnedRays& rays) { return rays.kind == next.kind; });
    if (of_kind == reading.spawned.end())
      of_kind = reading.spawned.insert(of_kind, {next.kind, 0, 0, 0, wide(leaves.origin), wide(leaves.direction)});
    ++of_kind->count;
    of_kind->hit_own += at_once;
    of_kind->astray += !at_once && !same;
    const bool onwards = (dot(found.point.normal, leaves.direction) > 0) != reading.starts.front().outwards;
    if (onwards && reading.starts.size() == 1) add_start(leaves.direction);
  }
}

/// Moving objects use the scene's own numbers, because a float world does not hold their position at one time; so do
/// large meshes, to save memory.
template <class T>
void Microscope::PreparedScene<T>::survey(T now) {
  time = now;
  constexpr int many = 50000;
  bool as_given = primitives().size() > many;
  for (int id = 0; id < primitives().size() && !as_given; ++id) as_given = primitives().moves(id);
  if (std::is_same_v<T, float> && as_given)
    surfaces =
        std::make_shared<const TrueSurfaces>(std::make_shared<const World<double>>(scene), static_cast<double>(now));
  else
    surfaces = std::make_shared<const TrueSurfaces>(world, now);
}

/// Beside a coordinate of 0 numbers lie closer than anything that is computed from the ray's: there the spacing of its
/// t stands for theirs.
template <class T>
void Microscope::PreparedScene<T>::set_numbers(Specimen& specimen) {
  for (int axis = 0; axis < 3; ++axis) specimen.spacing[axis] = spacing_in<T>(specimen.focus[axis]);
  for (const int axis : specimen.axes) specimen.ulp = std::max(specimen.ulp, specimen.spacing[axis]);
  const double of_t = spacing_in<T>(length(specimen.focus - specimen.origin) / length(specimen.direction));
  if (specimen.ulp < 1e-6 * of_t) specimen.ulp = of_t;
}

/// Of spheres alone, where a ray that is off by a hair is a lesson: at rest, and not transformed.
template <class T>
std::shared_ptr<const Specimen> Microscope::PreparedScene<T>::passed_by(int number, const Ray<T>& ray) {
  const Ray<double> line = wide_ray(ray);
  auto specimen = std::make_shared<Specimen>();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const auto* sphere = std::get_if<Sphere<double>>(&object.shape);
    if (sphere == nullptr || !object.transform.empty() || !object.motion.empty()) continue;
    const double t = dot(sphere->centre - line.origin, line.direction) / dot(line.direction, line.direction);
    const Vec3d next = line.at(t), out = next - sphere->centre;
    const double gap = length(out) - sphere->radius;
    if (!(t > 0 && gap > 0) || (specimen->passed >= 0 && gap >= specimen->gap)) continue;
    specimen->passed = static_cast<int>(i);
    specimen->gap = gap;
    specimen->normal = out / length(out);
    specimen->focus = sphere->centre + sphere->radius * specimen->normal;
    specimen->on_ray = gap * specimen->normal;
  }
  if (specimen->passed < 0) return nullptr;
  if (!surfaces || ray.time != time) survey(ray.time);
  specimen->ray = number;
  specimen->kind = record(number).kind;
  specimen->precision = precision_of<T>;
  specimen->surfaces = surfaces;
  specimen->origin = line.origin, specimen->direction = line.direction;
  specimen->axes = axes_for(specimen->normal, specimen->direction);
  set_numbers(*specimen);
  return specimen;
}

template <class T>
std::shared_ptr<const Specimen> Microscope::PreparedScene<T>::examine(int number) {
  const auto twins = retraced_ray(*world, camera, timeline, number);
  if (!twins) return nullptr;
  const auto robust = find(twins->robust), naive = find(twins->naive);
  if (!robust && !naive) return record(number).parent < 0 ? passed_by(number, twins->robust) : nullptr;
  if (!surfaces || twins->robust.time != time) survey(twins->robust.time);
  const HitSurface& best = robust ? *robust : *naive;
  const std::optional<HitSurface>& recorded = is_naive() ? naive : robust;
  const auto reading = [&](const auto& ray, const std::optional<HitSurface>& found) -> std::optional<Reading> {
    if (!found) return std::nullopt;
    Reading made = read(ray, *found);
    follow(made, ray, *found, best, recorded.value_or(best), number);
    return made;
  };
  auto specimen = std::make_shared<Specimen>();
  specimen->ray = number;
  specimen->kind = record(number).kind;
  specimen->precision = precision_of<T>;
  specimen->surfaces = surfaces;
  specimen->robust = reading(twins->robust, robust);
  specimen->naive = reading(twins->naive, naive);

  const Ray<T> ray = robust ? twins->robust : twins->naive.plain();
  const Ray<double> line = wide_ray(ray);
  specimen->origin = line.origin, specimen->direction = line.direction;
  specimen->focus = wide(best.point.position);
  specimen->normal = wide(best.point.normal);
  specimen->axes = axes_for(specimen->normal, specimen->direction);
  set_numbers(*specimen);
  specimen->on_ray = place_on(line, DoubleDouble(static_cast<double>(best.hit.t)), specimen->focus);
  if (const auto t = surfaces->crossing(best.hit.primitive, line, largest_spacing(best.point.position)))
    specimen->crossing = place_on(line, *t, specimen->focus);

  if (robust && specimen->robust->t_error) {
    const Vec3<T> along = robust->hit.t * ray.direction, computed = ray.at(robust->hit.t);
    const double t_error =
        std::max(std::abs(*specimen->robust->t_error), 0.5) * spacing_in<T>(static_cast<double>(robust->hit.t));
    for (int axis = 0; axis < 3; ++axis)
      specimen->error_box[axis] = std::abs(line.direction[axis]) * t_error +
                                  spacing_in<T>(static_cast<double>(along[axis])) / 2 +
                                  spacing_in<T>(static_cast<double>(computed[axis])) / 2 +
                                  std::abs(specimen->focus[axis] - static_cast<double>(computed[axis]));
  }
  return specimen;
}

std::shared_ptr<const Specimen> Microscope::look(const std::shared_ptr<const Timeline>& timeline, int position,
                                                 const Scene& scene, Precision precision) {
  if (timeline != timeline_) {
    timeline_ = timeline;
    specimens_.assign(timeline->rays().size(), nullptr);
    looked_at_.assign(timeline->rays().size(), false);
    switch (precision) {
      case Precision::float_:
        prepared_ = std::make_shared<PreparedScene<float>>(scene, *timeline);
        break;
      case Precision::double_:
        prepared_ = std::make_shared<PreparedScene<double>>(scene, *timeline);
        break;
    }
  }
  for (int ray = timeline->current_ray(position); ray >= 0;) {
    const RayRecord& record = timeline->rays()[static_cast<std::size_t>(ray)];
    const auto index = static_cast<std::size_t>(ray);
    if (record.formed && record.kind != RayKind::shadow && record.found_at <= position) {
      if (!looked_at_[index]) {
        specimens_[index] = std::visit([&](const auto& prepared) { return prepared->examine(ray); }, prepared_);
        looked_at_[index] = true;
      }
      if (specimens_[index]) return specimens_[index];
    }
    ray = record.parent;
  }
  return nullptr;
}

}  // namespace raywalk
