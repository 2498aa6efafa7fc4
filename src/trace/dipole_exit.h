#pragma once
// Where light comes out of a body that it went into, drawn by the dipole: A. King, C. Kulla, A. Conty and M. Fajardo,
// "BSSRDF Importance Sampling", SIGGRAPH Talks 2013. A distance is drawn by what comes out there of a flat surface.
// Probes look for what of the body's surface is so far away, one along each of three axes; what could have been found
// along the others too, or drawn for other channels, is weighed against that by multiple importance sampling.
//
// A probe is as long as is needed for each place of the surface to be found along some axis. Of all places found, one
// is drawn by what it brings.

#include "trace/spawn_ray.h"
#include "trace/world.h"

#include <array>
#include <cmath>
#include <optional>

namespace raywalk {

template <class T>
struct DipoleExit {
  const Dipole<T>* dipole;
  Departure departure;
  Vec3<T> position, normal;  ///< normal: unit, outward
  Vec3<T> shading_normal;    ///< unit, interpolated on smooth meshes
  T distance;                ///< from where it went in
  Rgb<T> weight;             ///< R_d of this distance, over the pdf per area with which the place was drawn
};

/// Where light went in.
template <class T>
struct DipoleEntry {
  int primitive;
  Vec3<T> position, normal;  ///< normal: unit, outward
  T time;
};

/// Drawn in [0, 1).
template <class T>
struct DipoleDraws {
  T channel, among;
  Vec2<T> place;
};

/// `AnyRay`: of the probes. `throughput`: what light from there can bring. None: no surface was found.
template <class AnyRay, class T>
class ExitSearch {
 public:
  ExitSearch(const World<T>& world, const Dipole<T>& dipole, const DipoleEntry<T>& entry, const Rgb<T>& throughput)
      : world_(world), dipole_(dipole), entry_(entry), throughput_(throughput), basis_(entry.normal) {
    const Rgb<T> brought = throughput * dipole.total_reflectance();
    const T all = brought.x + brought.y + brought.z;
    if (all > 0) odds_ = brought * (1 / all);
  }

  [[nodiscard]] std::optional<DipoleExit<T>> operator()(const DipoleDraws<T>& u, TestCounts& tests) {
    if (odds_ == Rgb<T>(0)) return std::nullopt;
    int channel = 0;
    for (T rest = u.channel; channel < 2 && !(rest < odds_[channel]);) rest -= odds_[channel++];
    while (odds_[channel] == 0) --channel;  // rounding left a little
    const T radius = dipole_.sample_radius(channel, u.place.x);
    const auto [sin, cos] = portable::sin_cos(2 * pi_v<T> * u.place.y);
    among_ = u.among;
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      const Vec3<T> middle =
          entry_.position + radius * (cos * axes_[(k + 1) % axes_.size()] + sin * axes_[(k + 2) % axes_.size()]);
      probe(middle, axes_[k], reach(radius), tests);
    }
    if (drawn_) drawn_->weight *= sum_;
    return drawn_;
  }

 private:
  /// How far a probe looks to both sides. From any place, at least one axis passes by at 0.8 of its distance or more.
  [[nodiscard]] T reach(T radius) const { return radius + dipole_.mean_free_path(); }
  /// With which all probes together find a place, per area of a surface with this normal. `way`: to there.
  [[nodiscard]] T pdf(const Vec3<T>& way, const Vec3<T>& normal) const {
    T sum = 0;
    for (const Vec3<T>& axis : axes_) {
      const T along = dot(way, axis), radius = length(way - along * axis);
      if (std::abs(along) > reach(radius)) continue;
      T of_distance = 0;
      for (int c = 0; c < 3; ++c)
        if (odds_[c] > 0) of_distance += odds_[c] * dipole_.pdf(c, radius);
      sum += of_distance * std::abs(dot(normal, axis));
    }
    return sum;
  }
  void probe(const Vec3<T>& middle, const Vec3<T>& axis, T reach, TestCounts& tests) {
    const Primitives<T>& primitives = world_.accelerator.primitives();
    AnyRay ray{Ray<T>{middle + reach * axis, -axis, {}, entry_.time}};
    for (T left = 2 * reach; left > 0;) {
      const auto hit = world_.accelerator.closest(ray, left, tests);
      if (!hit) return;
      const SurfacePoint<T> point = primitives.surface_at(hit->primitive, ray, Intersection<T>{hit->t, hit->part});
      if (is_of_body(hit->primitive)) find({hit->primitive, hit->part}, point);
      left -= hit->t;
      ray = spawn_ray<AnyRay>(world_, point.position, point.normal, {hit->primitive, hit->part}, -axis, entry_.time);
    }
  }
  [[nodiscard]] bool is_of_body(int primitive) const {
    return &world_.surface(primitive) == &world_.surface(entry_.primitive) &&
           world_.object(primitive) == world_.object(entry_.primitive);
  }
  /// Of this place and those before, one is drawn; the number is then as it was, in 0..1.
  void find(Departure departure, const SurfacePoint<T>& point) {
    const Vec3<T> way = point.position - entry_.position;
    const T distance = length(way), found = pdf(way, point.normal);
    if (!(distance > 0 && found > 0)) return;
    const Rgb<T> weight = dipole_.diffuse_reflectance(distance) * (1 / found);
    const T brings = dot(throughput_, weight);
    if (!(brings > 0)) return;
    sum_ += brings;
    const T share = brings / sum_;
    if (!(among_ < share)) {
      among_ = (among_ - share) / (1 - share);
      return;
    }
    among_ /= share;
    const auto smooth = world_.accelerator.primitives().smooth_normal(departure.primitive, point, entry_.time);
    drawn_ = {&dipole_,
              departure,
              point.position,
              point.normal,
              smooth.value_or(point.normal),
              distance,
              weight * (1 / brings)};
  }

  const World<T>& world_;
  const Dipole<T>& dipole_;
  const DipoleEntry<T>& entry_;
  const Rgb<T>& throughput_;
  Basis<T> basis_;
  std::array<Vec3<T>, 3> axes_{basis_.n, basis_.s, basis_.t};
  Rgb<T> odds_{0};  ///< with which the distance is drawn for each channel
  std::optional<DipoleExit<T>> drawn_;
  T sum_ = 0, among_ = 0;
};

}  // namespace raywalk
