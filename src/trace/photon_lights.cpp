#include "trace/photon_lights.h"

#include "math/elementary.h"
#include "math/sampling.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

double sum_of(const Rgbd& c) { return c.x + c.y + c.z; }

std::size_t chosen(const std::vector<double>& cdf, double pick) {
  const auto at = std::upper_bound(cdf.begin(), cdf.end(), pick * cdf.back());
  return std::min(static_cast<std::size_t>(at - cdf.begin()), cdf.size() - 1);
}

Vec3d in_plane(double turn) {
  const auto [sin, cos] = portable::sin_cos(2 * pi_v<double> * turn);
  return {cos, sin, 0};
}

/// 1 - cos of the half angle of a lamp's cone; 2 where it shines everywhere.
template <class T>
double width_of(const typename World<T>::Light& lamp) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.cos_outer; }) return 1 - static_cast<double>(kind.cos_outer);
        return 2.0;
      },
      lamp.kind);
}
template <class T>
Vec3d axis_of_cone(const typename World<T>::Light& lamp) {
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.axis; }) return Vec3d(kind.axis);
        return Vec3d(1, 0, 0);
      },
      lamp.kind);
}
/// The half angle in radians of a cone with this 1 - cos.
double half_angle(double width) {
  const double cos = 1 - width;
  return portable::atan2(std::sqrt(std::max(0.0, 1 - cos * cos)), cos);
}

}  // namespace

template <class T>
double PhotonLights<T>::cosines() const {
  return flat_ ? 2 : pi_v<double>;
}
template <class T>
double PhotonLights<T>::directions() const {
  return (flat_ ? 2 : 4) * pi_v<double>;
}

template <class T>
PhotonLights<T>::PhotonLights(const World<T>& world, const Emitters<T>& emitters, bool flat)
    : world_(world), emitters_(emitters), flat_(flat) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  Bounds<double> all;
  for (int id = 0; id < primitives.size(); ++id) {
    const Bounds<T> box = primitives.box(id);
    if (box.bounded()) all.include(Bounds<double>{Vec3d(box.min), Vec3d(box.max)});
  }
  if (!all.empty()) {
    centre_ = 0.5 * (all.min + all.max);
    if (flat) centre_.z = all.min.z = all.max.z = 0;
    radius_ = length(all.max - centre_);
  }
  add_targets();
  for (std::size_t i = 0; i < world.lights.size(); ++i) add(Source::lamp, i, power_of(world.lights[i]));
  if (flat) {
    add_cuts();
    if (!cuts_.empty()) add(Source::emitters, 0, 2 * cosines() * cuts_cdf_.back());
  } else if (!emitters.empty()) {
    double power = 0;
    for (const auto& each : emitters.all())
      power += 2 * cosines() * each.area * sum_of(Rgbd(world.surface(each.primitive).emission));
    add(Source::emitters, 0, power);
  }
  constexpr int looks = 64;
  double radiance = 0;
  for (int i = 0; i < looks; ++i) {
    const Vec2d unit((i % 8 + 0.5) / 8, (i / 8 + 0.5) / 8);
    radiance += sum_of(Rgbd(environment(Vec3<T>(any_direction(unit))))) / looks;
  }
  if (world.sky && !(radiance > 0)) radiance = 1e-3;  // a spot that none of the looks has met
  environment_shines_ = radiance > 0;
  add(Source::environment, 0, directions() * (flat ? 2 * radius_ : pi_v<double> * radius_ * radius_) * radiance);
  double sum = 0;
  for (const Entry& entry : entries_) sum += entry.probability;
  double up_to = 0;
  for (Entry& entry : entries_) {
    entry.probability /= sum;
    cdf_.push_back(up_to += entry.probability);
  }
}

template <class T>
void PhotonLights<T>::add(Source source, std::size_t lamp, double power) {
  if (power > 0) entries_.push_back({source, lamp, power});
}

/// Of a lamp that weakens by a law of its own: of what it would send by the square of the distance so that the middle
/// of the scene receives the same.
template <class T>
double PhotonLights<T>::power_of(const typename World<T>::Light& lamp) const {
  const double power = cosines() * sum_of(Rgbd(lamp.strength));
  if (lamp.is_distant) return power * (flat_ ? 2 * radius_ : pi_v<double> * radius_ * radius_);
  const double width = width_of<T>(lamp);
  const double apart = std::max(length(Vec3d(lamp.place) - centre_), 1e-3 * (radius_ + 1));
  const double law = static_cast<double>(weight_at(lamp, static_cast<T>(apart)));
  return power * law * (flat_ ? 2 * half_angle(width) : 2 * pi_v<double> * width);
}

/// Sides of boxes and prisms that cross the plane upright, and spheres about a point of it.
template <class T>
void PhotonLights<T>::add_cuts() {
  double up_to = 0;
  for (const auto& each : emitters_.all()) {
    Cut cut{{each.primitive, each.part}, each.corner, Vec3d(0.0), 0, 0, 0};
    if (each.is_sphere()) {
      if (each.corner.z != 0) continue;
      cut.radius = each.u.x;
      cut.length = 2 * pi_v<double> * cut.radius;
    } else if (each.is_parallelogram() && each.corner.z * (each.corner + each.u + each.v).z < 0) {
      const bool u_level = each.u.z == 0;
      const Vec3d &level = u_level ? each.u : each.v, &upright = u_level ? each.v : each.u;
      if (level.z != 0 || upright.x != 0 || upright.y != 0) continue;
      cut.from.z = 0;
      cut.along = level;
      cut.length = length(level);
    } else {
      continue;
    }
    cut.probability = cut.length * sum_of(Rgbd(world_.surface(each.primitive).emission));
    cuts_cdf_.push_back(up_to += cut.probability);
    cuts_.push_back(cut);
  }
  for (Cut& cut : cuts_) cut.probability /= up_to;
}

template <class T>
auto PhotonLights<T>::sample_emitter(T pick, T along) const -> std::optional<EmitterPoint<T>> {
  if (cuts_.empty()) return std::nullopt;
  const Cut& cut = cuts_[chosen(cuts_cdf_, static_cast<double>(pick))];
  const T pdf = static_cast<T>(cut.probability / cut.length);
  if (cut.radius > 0) {
    const Vec3d normal = in_plane(static_cast<double>(along));
    return EmitterPoint<T>{Vec3<T>(cut.from + cut.radius * normal), Vec3<T>(normal), cut.departure, pdf};
  }
  const Vec3d normal = normalize(Vec3d(cut.along.y, -cut.along.x, 0));
  return EmitterPoint<T>{Vec3<T>(cut.from + static_cast<double>(along) * cut.along), Vec3<T>(normal), cut.departure,
                         pdf};
}

/// Everything bounded that mirrors or bends light sharply enough for a caustic. Where that is much, one ball about all.
template <class T>
void PhotonLights<T>::add_targets() {
  constexpr std::size_t most = 32;
  const Primitives<T>& primitives = world_.accelerator.primitives();
  Bounds<double> all;
  for (int id = 0; id < primitives.size(); ++id) {
    const auto& surface = world_.surface(id);
    const Bounds<T> box = primitives.box(id);
    if (!box.bounded() || (is_black(surface.reflection) && !surface.transmits)) continue;
    const Bounds<double> own{Vec3d(box.min), Vec3d(box.max)};
    all.include(own);
    if (targets_.size() <= most) {
      Target target{0.5 * (own.min + own.max), 0};
      const Vec3d half = own.max - target.centre;
      const auto* transform = primitives.transform_of(id);
      const bool is_ball = transform == nullptr && std::holds_alternative<Sphere<T>>(primitives.shape(id));
      target.radius = is_ball ? half.x : length(half);
      targets_.push_back(target);
    }
  }
  if (targets_.size() <= most) return;
  const Vec3d centre = 0.5 * (all.min + all.max);
  targets_ = {{centre, length(all.max - centre)}};
}

template <class T>
auto PhotonLights<T>::cone_of(const Target& target, const Vec3d& from) const -> std::optional<Cone> {
  const Vec3d towards = target.centre - from;
  const double distance = length(flat_ ? Vec3d(towards.x, towards.y, 0) : towards);
  double radius = target.radius;
  if (flat_) radius = std::sqrt(std::max(0.0, radius * radius - target.centre.z * target.centre.z));
  if (!(distance > radius) || !(radius > 0)) return std::nullopt;
  const double sin2 = radius * radius / (distance * distance);
  const Vec3d axis = (flat_ ? Vec3d(towards.x, towards.y, 0) : towards) / distance;
  return Cone{axis, sin2 / (1 + std::sqrt(1 - sin2))};
}

/// A direction that was drawn in the cone counts as inside despite rounding.
template <class T>
bool PhotonLights<T>::is_within(const Cone& cone, const Vec3d& direction) {
  constexpr double rounding = 1e-12;
  return dot(direction, cone.axis) >= 1 - cone.width - rounding;
}

template <class T>
double PhotonLights<T>::cone_pdf(const Cone& cone) const {
  return flat_ ? 1 / (2 * half_angle(cone.width)) : uniform_cone_pdf(cone.width);
}

template <class T>
Vec3d PhotonLights<T>::in_cone(const Cone& cone, const Vec2d& unit) const {
  if (!flat_) return normalize(Basis<double>(cone.axis).to_world(sample_uniform_cone(unit, cone.width)));
  const auto [sin, cos] = portable::sin_cos((2 * unit.x - 1) * half_angle(cone.width));
  return cos * cone.axis + sin * Vec3d(-cone.axis.y, cone.axis.x, 0);
}

template <class T>
double PhotonLights<T>::aimed_pdf(const Vec3d& from, const Vec3d& direction) const {
  double sum = 0;
  for (const Target& target : targets_)
    if (const auto cone = cone_of(target, from))
      if (is_within(*cone, direction)) sum += cone_pdf(*cone);
  return sum / static_cast<double>(targets_.size());
}

template <class T>
template <class Base, class BasePdf>
auto PhotonLights<T>::way_from(const Vec3d& from, const T (&u)[draws], Base base, BasePdf base_pdf) const -> Way {
  const Vec2d unit(Vec2<T>(u[5], u[6]));
  std::size_t seen = 0;
  for (const Target& target : targets_) seen += cone_of(target, from).has_value();
  // Inside of one of them nothing is aimed: the mixture has to be the same for all directions.
  if (targets_.empty() || seen < targets_.size()) {
    const Vec3d direction = base(unit);
    return {direction, base_pdf(direction)};
  }
  Vec3d direction;
  if (u[7] < T(0.5)) {
    direction = base(unit);
  } else {
    const auto at = static_cast<std::size_t>(static_cast<double>(u[8]) * static_cast<double>(targets_.size()));
    direction = in_cone(*cone_of(targets_[std::min(at, targets_.size() - 1)], from), unit);
  }
  return {direction, (base_pdf(direction) + aimed_pdf(from, direction)) / 2};
}

template <class T>
Vec3d PhotonLights<T>::any_direction(const Vec2d& unit) const {
  return flat_ ? in_plane(unit.x) : sample_uniform_sphere(unit);
}

/// Where a photon starts that comes from infinitely far away: so far that nothing of interest is behind it, and so that
/// photons in this direction fill the ball about the scene evenly. `direction`: of unit length, towards the source.
template <class T>
Vec3d PhotonLights<T>::far_origin(const Vec3d& direction, const Vec2d& unit) const {
  constexpr double far = 1000;  // radii
  const Vec3d away = centre_ + far * radius_ * direction;
  if (flat_) return away + (2 * unit.x - 1) * radius_ * Vec3d(-direction.y, direction.x, 0);
  const Basis<double> basis(direction);
  const Vec2d disk = sample_concentric_disk(unit);
  return away + radius_ * (disk.x * basis.s + disk.y * basis.t);
}

template <class T>
Rgb<T> PhotonLights<T>::environment(const Vec3<T>& direction) const {
  return world_.background_along(direction);
}

template <class T>
EmittedPhoton<T> PhotonLights<T>::emit(const T (&u)[draws]) const {
  const Entry& entry = entries_[chosen(cdf_, static_cast<double>(u[0]))];
  EmittedPhoton<T> photon;
  switch (entry.source) {
    case Source::lamp:
      photon = from_lamp(world_.lights[entry.lamp], u);
      break;
    case Source::emitters:
      photon = from_emitter(u);
      break;
    case Source::environment:
      photon = from_environment(u);
      break;
  }
  photon.power *= static_cast<T>(1 / entry.probability);
  return photon;
}

template <class T>
EmittedPhoton<T> PhotonLights<T>::from_lamp(const typename World<T>::Light& lamp, const T (&u)[draws]) const {
  const Rgbd intensity = cosines() * Rgbd(lamp.strength);
  const Vec2d place(Vec2<T>(u[3], u[4]));
  EmittedPhoton<T> photon;
  photon.light = lamp.index;
  if (lamp.is_distant) {
    const Vec3d towards(lamp.place);
    photon.origin = Vec3<T>(far_origin(towards, place));
    photon.direction = Vec3<T>(-towards);
    photon.power = Rgb<T>((flat_ ? 2 * radius_ : pi_v<double> * radius_ * radius_) * intensity);
    return photon;
  }
  photon.lamp = &lamp;
  Vec3d origin(lamp.place);
  if (!lamp.is_delta) {
    origin = Vec3d(flat_ ? point_in_plane(lamp, Vec2<T>(place)) : lamp.sample(Vec2<T>(place)));
  }
  photon.origin = Vec3<T>(origin);
  const Cone whole{axis_of_cone<T>(lamp), width_of<T>(lamp)};
  const Way way = way_from(
      origin, u, [&](const Vec2d& unit) { return in_cone(whole, unit); },
      [&](const Vec3d& direction) { return is_within(whole, direction) ? cone_pdf(whole) : 0.0; });
  photon.direction = Vec3<T>(way.direction);
  photon.power = Rgb<T>(intensity / way.pdf);
  if (!lamp.is_isotropic) photon.power *= lamp.falloff(-photon.direction);
  return photon;
}

/// Of a ball, on its circle; of anything else, what it is as seen along z.
template <class T>
Vec3<T> PhotonLights<T>::point_in_plane(const typename World<T>::Light& lamp, const Vec2<T>& unit) const {
  if (std::holds_alternative<SphereLight::Prepared<T>>(lamp.kind))
    return lamp.place + lamp.reach * Vec3<T>(in_plane(static_cast<double>(unit.x)));
  Vec3<T> point = lamp.sample(unit);
  point.z = 0;
  return point;
}

/// Both sides send: a body that is closed lights its own inside too, as paths see it.
template <class T>
EmittedPhoton<T> PhotonLights<T>::from_emitter(const T (&u)[draws]) const {
  EmittedPhoton<T> photon;
  const double side = u[2] < T(0.5) ? 1 : -1;
  const auto leave = [&](const Vec3d& point, const Vec3d& outward, Departure departure, double pdf) {
    const Vec3d normal = side * outward;
    const Way way = way_from(
        point, u,
        [&](const Vec2d& unit) {
          if (!flat_) return normalize(Basis<double>(normal).to_world(sample_cosine_hemisphere(unit)));
          const double sin = 2 * unit.x - 1;
          return std::sqrt(1 - sin * sin) * normal + sin * Vec3d(-normal.y, normal.x, 0);
        },
        [&](const Vec3d& direction) { return std::max(dot(direction, normal), 0.0) / cosines(); });
    const double cos = std::max(dot(way.direction, normal), 0.0);
    photon.origin = Vec3<T>(point);
    photon.direction = Vec3<T>(way.direction);
    photon.departure = departure;
    photon.power = static_cast<T>(cos > 0 ? 2 * cos / (pdf * way.pdf) : 0.0) *
                   world_.emission_at(departure, Vec3<T>(point + outward), -Vec3<T>(outward), T(0));
  };
  if (flat_) {
    const EmitterPoint<T> at = *sample_emitter(u[1], u[3]);
    leave(Vec3d(at.point), Vec3d(at.normal), at.departure, static_cast<double>(at.pdf));
  } else {
    const auto at = emitters_.sample_origin(static_cast<double>(u[1]), Vec2d(Vec2<T>(u[3], u[4])));
    leave(at.point, at.normal, {at.primitive, at.part}, at.pdf);
  }
  return photon;
}

template <class T>
EmittedPhoton<T> PhotonLights<T>::from_environment(const T (&u)[draws]) const {
  const Vec2d place(Vec2<T>(u[3], u[4])), way(Vec2<T>(u[5], u[6]));
  EmittedPhoton<T> photon;
  photon.light = light_of_sky;
  Vec3d towards = any_direction(way);
  double pdf = 1 / directions();
  if (world_.sky && !flat_)
    if (const auto drawn = world_.sky->sample(way)) towards = drawn->direction, pdf = drawn->pdf;
  photon.origin = Vec3<T>(far_origin(towards, place));
  photon.direction = Vec3<T>(-towards);
  const double across = flat_ ? 2 * radius_ : pi_v<double> * radius_ * radius_;
  photon.power = static_cast<T>(across / pdf) * environment(Vec3<T>(towards));
  return photon;
}

template class PhotonLights<float>;
template class PhotonLights<double>;

}  // namespace raywalk
