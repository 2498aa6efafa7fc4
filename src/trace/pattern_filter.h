#pragma once
// What a pattern of a surface, its checker or image, is over the footprint of a ray.

#include "trace/bsdf.h"
#include "trace/checker_filter.h"
#include "trace/ray_differential.h"
#include "trace/ray_generator.h"
#include "trace/texture.h"
#include "trace/texture_pyramid.h"
#include "trace/world.h"

namespace raywalk {

/// The factor of checker and texture on a surface's colours at a hit, each filtered as its material asks for it, of a
/// surface that filters something. `neighbours`: how far their hits are away.
template <class T>
[[nodiscard, gnu::noinline]] Rgb<T> filtered_pattern(const World<T>& world, const HitDifferential<T>& neighbours,
                                                     const Hit<T>& hit, const SurfacePoint<T>& point, T time) {
  const typename World<T>::Surface& surface = world.surface(hit.primitive);
  const PatternFilter& filter = world.pattern_filter(surface);
  const auto [uv, reach] =
      place_in_pattern(neighbours, world.accelerator.primitives(), hit.primitive, point, hit.part, time);
  Rgb<T> colour{1};
  if (surface.checker) {
    const auto& [even, odd, size] = *surface.checker;
    const T share =
        filter.checker == CheckerFilter::closed ? even_share(uv, size, reach) : static_cast<T>(even_square(uv, size));
    colour = share * even + (1 - share) * odd;
  }
  if (!surface.texture) return colour;
  const auto& [pixels, width, height, wraps] = *surface.texture;
  const auto in_copies = [&](const Vec2<T>& lengths) { return Vec2<T>(lengths.x / width, lengths.y / height); };
  const Footprint<T> copies{in_copies(reach.x), in_copies(reach.y)};
  switch (filter.texture) {
    case TextureFilter::none:
      return colour * surface.texture->at(uv);
    case TextureFilter::trilinear:
      return colour * filter.pyramid->trilinear(uv.x / width, uv.y / height, copies, wraps);
    case TextureFilter::ewa:
      return colour * filter.pyramid->ewa(uv.x / width, uv.y / height, copies, wraps);
  }
  return colour;
}

/// The differential of the one ray that a procedure follows at a time, from the eye, or of what it met last. Does
/// nothing where the world filters nothing.
template <class T>
class FollowedDifferential {
 public:
  FollowedDifferential(const World<T>& world, const RayGenerator<T>& camera)
      : world_(world), camera_(camera), active_(world.filters()) {}

  [[nodiscard]] bool filters(const typename World<T>::Surface& surface) const {
    return active_ && world_.filters(surface);
  }
  void begin(const Vec3<T>& direction) {
    if (active_) ray_ = camera_.differential(direction);
  }
  /// At a hit, which is shaded with this normal.
  void arrive(const Vec3<T>& direction, const Hit<T>& hit, const SurfacePoint<T>& point, T time,
              const Vec3<T>& shading_normal) {
    if (!active_) return;
    ray_ = transfer(ray_, direction, hit.t, point.normal);
    normal_ = normal_differential(hit_differential(ray_), world_.accelerator.primitives(), hit.primitive, point,
                                  hit.part, time, shading_normal);
  }
  /// Where a medium scatters the ray.
  void arrive_inside(T distance) {
    ray_.x.dP += distance * ray_.x.dD;
    ray_.y.dP += distance * ray_.y.dD;
  }
  [[nodiscard]] Rgb<T> pattern(const Hit<T>& hit, const SurfacePoint<T>& point, T time) const {
    return filtered_pattern(world_, hit_differential(ray_), hit, point, time);
  }
  /// On from the hit. `refraction`: only used by what is transmitted.
  template <class AnyBsdf>
  void leave(const AnyBsdf& at, const Refraction<T>& refraction, const BsdfSample<T>& choice) {
    if (!active_) return;
    if (choice.lobe == Lobe::mirror) ray_ = reflect(ray_, at.incident, at.shading_normal, normal_);
    if (choice.lobe == Lobe::transparent && !refraction.total())
      ray_ = refract(ray_, at.incident, at.shading_normal, normal_, refraction);
    if (choice.pdf > 0) ray_ = scattered(ray_, choice.direction, choice.pdf, camera_.spacing());
  }

 private:
  const World<T>& world_;
  const RayGenerator<T>& camera_;
  bool active_;
  RayDifferential<T> ray_;
  NormalDifferential<T> normal_;
};

/// Where nothing is filtered, or what is followed does not come from the eye.
template <class T>
struct NoDifferential {
  NoDifferential() = default;
  NoDifferential(const World<T>& /*world*/, const RayGenerator<T>& /*camera*/) {}
  [[nodiscard]] static constexpr bool filters(const typename World<T>::Surface& /*surface*/) { return false; }
  void begin(const Vec3<T>& /*direction*/) {}
  void arrive(const Vec3<T>& /*direction*/, const Hit<T>& /*hit*/, const SurfacePoint<T>& /*point*/, T /*time*/,
              const Vec3<T>& /*shading_normal*/) {}
  void arrive_inside(T /*distance*/) {}
  [[nodiscard]] Rgb<T> pattern(const Hit<T>& /*hit*/, const SurfacePoint<T>& /*point*/, T /*time*/) const {
    return Rgb<T>(1);
  }
  template <class AnyBsdf>
  void leave(const AnyBsdf& /*at*/, const Refraction<T>& /*refraction*/, const BsdfSample<T>& /*choice*/) {}
};

}  // namespace raywalk
