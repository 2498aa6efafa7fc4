#pragma once
// Where photons start: on what shines in a scene, each source chosen in proportion to its power.
//
// A light is what its illumination says: at distance r a surface that faces it receives the irradiance pi L / a(r), a
// being its attenuation (kd L / a(r) is what SHADE makes of that). It sends photons as if a(r) were r^2, and the first
// surface that they meet receives them weighted by r^2 / a(r), so exactly that. From there on no light is lost or won.
//
// Few photons of a lamp would meet a glass ball in the distance. So half of them are aimed at what mirrors or bends
// light (Jensen's projection map), and count for as much less as they are more: the direction comes from a mixture of
// two densities, and the power is divided by their mean.
//
// In a flat world everything is endless along z, and light travels in the plane: angles in place of solid angles,
// lengths in place of areas, r in place of r^2, 2 in place of pi.

#include "math/random.h"
#include "trace/emitters.h"
#include "trace/event.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace raywalk {

/// A photon as it leaves its source.
template <class T>
struct EmittedPhoton {
  Vec3<T> origin, direction;                       ///< direction: unit length
  Rgb<T> power;                                    ///< of all photons of its pass together, were they all like this one
  Departure departure{};                           ///< of an emitting object
  const typename World<T>::Light* lamp = nullptr;  ///< that weakens by its own law; null: by none
  int light = -1;                                  ///< as in RayFormed
};

/// A point on an emitting object, as seen from a surface.
template <class T>
struct EmitterPoint {
  Vec3<T> point, normal;  ///< normal: unit length, outward
  Departure departure;
  T pdf;  ///< per area, or length
};

/// Everything that sends photons: lights, emitting objects, the sky or a background that is not black.
template <class T>
class PhotonLights {
 public:
  PhotonLights(const World<T>& world, const Emitters<T>& emitters, bool flat);

  /// Nothing shines.
  [[nodiscard]] bool empty() const { return cdf_.empty(); }
  /// The random numbers of one photon's start.
  static constexpr int draws = 9;
  /// `u`: `draws` numbers in [0, 1).
  [[nodiscard]] EmittedPhoton<T> emit(const T (&u)[draws]) const;
  /// The factor of a lamp's own law on what its photon brings to this distance, by mirrors and through clear glass too.
  [[nodiscard]] T weight_at(const typename World<T>::Light& lamp, T distance) const {
    return (flat_ ? distance : distance * distance) / lamp.attenuation(distance);
  }

  /// In a flat world: a point of an area light.
  [[nodiscard]] Vec3<T> point_in_plane(const typename World<T>::Light& lamp, const Vec2<T>& unit) const;
  /// In a flat world: a point on an emitting object, uniform in power. None where nothing emits.
  [[nodiscard]] std::optional<EmitterPoint<T>> sample_emitter(T pick, T along) const;
  [[nodiscard]] bool has_emitters() const { return flat_ ? !cuts_.empty() : !emitters_.empty(); }

  /// The ball that holds everything bounded: photons from far away start at its edge.
  [[nodiscard]] const Vec3d& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }

  /// The radiance of what a ray meets that leaves the scene.
  [[nodiscard]] Rgb<T> environment(const Vec3<T>& direction) const;
  /// Whether it shines; where nothing is bounded it sends no photons.
  [[nodiscard]] bool has_environment() const { return environment_shines_; }

 private:
  enum class Source { lamp, emitters, environment };
  struct Entry {
    Source source;
    std::size_t lamp;
    double probability;
  };
  /// The cut of an emitting object by the plane: a circle about `from`, or the points from + t along, 0 <= t <= 1.
  struct Cut {
    Departure departure;
    Vec3d from, along;
    double radius;  ///< 0: no circle
    double length, probability;
  };
  /// A ball about something that mirrors or bends light.
  struct Target {
    Vec3d centre;
    double radius;
  };
  /// The part of all directions that a target is seen in, as a cone about an axis; width: 1 - cos of its half angle.
  struct Cone {
    Vec3d axis;
    double width;
  };
  [[nodiscard]] std::optional<Cone> cone_of(const Target& target, const Vec3d& from) const;
  /// Per solid angle, or angle, with which directions are aimed at targets.
  [[nodiscard]] double aimed_pdf(const Vec3d& from, const Vec3d& direction) const;
  [[nodiscard]] Vec3d in_cone(const Cone& cone, const Vec2d& unit) const;
  [[nodiscard]] double cone_pdf(const Cone& cone) const;
  [[nodiscard]] static bool is_within(const Cone& cone, const Vec3d& direction);
  /// A direction from here: by `base`, or aimed. `base_pdf(direction)`: the density of `base`. Returns it with the
  /// density of the mixture.
  struct Way {
    Vec3d direction;
    double pdf;
  };
  template <class Base, class BasePdf>
  [[nodiscard]] Way way_from(const Vec3d& from, const T (&u)[draws], Base base, BasePdf base_pdf) const;
  void add_targets();
  void add(Source source, std::size_t lamp, double power);
  void add_cuts();
  [[nodiscard]] double power_of(const typename World<T>::Light& lamp) const;
  [[nodiscard]] EmittedPhoton<T> from_lamp(const typename World<T>::Light& lamp, const T (&u)[draws]) const;
  [[nodiscard]] EmittedPhoton<T> from_emitter(const T (&u)[draws]) const;
  [[nodiscard]] EmittedPhoton<T> from_environment(const T (&u)[draws]) const;
  [[nodiscard]] Vec3d far_origin(const Vec3d& direction, const Vec2d& unit) const;
  [[nodiscard]] Vec3d any_direction(const Vec2d& unit) const;
  /// The integral of the cosine over all directions above a surface, and of 1 over all directions.
  [[nodiscard]] double cosines() const;
  [[nodiscard]] double directions() const;

  const World<T>& world_;
  const Emitters<T>& emitters_;
  bool flat_;
  Vec3d centre_{0.0};
  double radius_ = 0;
  bool environment_shines_ = false;
  std::vector<Entry> entries_;
  std::vector<double> cdf_;
  std::vector<Target> targets_;
  std::vector<Cut> cuts_;
  std::vector<double> cuts_cdf_;
};

extern template class PhotonLights<float>;
extern template class PhotonLights<double>;

}  // namespace raywalk
