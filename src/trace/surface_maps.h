#pragma once
// What maps and a mask make of a surface at a point: its parameters, its small facets and its normal.

#include "accel/primitives.h"
#include "scene/material.h"
#include "trace/microfacets.h"
#include "trace/optics.h"
#include "trace/rough_dielectric.h"

#include <memory>
#include <vector>

namespace raywalk {

/// The numbers of a material that shading asks for.
template <class T>
struct SurfaceValues {
  Rgb<T> ambient, diffuse, specular, reflection, transmission, emission;
  T shininess;
  /// 1 - cos of the half angle of the lobes about the mirrored and the refracted direction; 0: sharp.
  T gloss = 0, translucency = 0;
};

/// The same at a point of a mapped surface.
template <class T>
struct MappedValues : SurfaceValues<T> {
  T roughness = 0;          ///< alpha of small facets; 0: smooth
  T diffuse_roughness = 0;  ///< r of a matt surface; 0: Lambert's
};

/// The facets of a point whose roughness lies between two that there are tables of: a mixture of both. Each of the two
/// keeps energy and can be sampled, so that the mixture does and can.
template <class T>
struct MappedFacets {
  const Microsurface<T>* mirror = nullptr;    ///< null: neither of metal nor rough
  const Microsurface<T>* rougher = nullptr;   ///< null: `mirror` alone
  const RoughDielectric<T>* glass = nullptr;  ///< the same of rough glass
  const RoughDielectric<T>* rougher_glass = nullptr;
  T share = 0;  ///< of the rougher ones, in 0..1
};

/// Of one surface of a world; without maps, it has none.
template <class T>
class SurfaceMaps {
 public:
  SurfaceMaps() = default;
  /// `first`, `second`: of the material and of that of its mask, as the integrator takes them. `has_lobes`: whether it
  /// has gloss and translucency; `bends`: whether it shades by normals of maps.
  SurfaceMaps(const Material& material, const SurfaceValues<T>& first, const SurfaceValues<T>& second, bool has_lobes,
              bool bends);
  /// Rough glass between its index and others; to be called once, where it transmits as a dielectric.
  void prepare_glass(T ior, const std::vector<T>& others);

  [[nodiscard]] bool any() const { return !layers_.empty(); }
  [[nodiscard]] bool bends() const { return normal_map_.pixels || bump_map_.pixels; }
  [[nodiscard]] bool maps_emission() const { return maps_emission_; }

  /// What is mixed at a point, so that a pattern can colour the first material before `mixed`.
  struct Mixture {
    MappedValues<T> first, second;
    T share = 0;  ///< of the second, in 0..1
  };
  /// `uv`: of the shape.
  [[nodiscard]] Mixture at(const Vec2<T>& uv) const;
  /// a + t (b - a) of each number: as they are where the share is 0 or 1.
  [[nodiscard]] static MappedValues<T> mixed(const Mixture& mixture);

  /// `through`: where the surface transmits; else null.
  [[nodiscard]] MappedFacets<T> facets(const MappedValues<T>& at, const Refraction<T>* through) const;
  /// Null: Lambert's.
  [[nodiscard]] const RoughDiffuse<T>* matt(const MappedValues<T>& at) const;

  /// The outward unit `normal` of a point, geometric or interpolated, as the maps bend it: by the normal map in the
  /// frame of the derivatives of the position by u and v, then by the bump map to N - grad h (M. Mikkelsen, "Surface
  /// Gradient-Based Bump Mapping Framework", JCGT 9(3), 2020; the same as Blinn's). As it is where u and v do not
  /// span the surface.
  [[nodiscard]] Vec3<T> bent(const Primitives<T>& primitives, int primitive, const SurfacePoint<T>& point, int part,
                             T time, const Vec3<T>& normal) const;

 private:
  struct Image {
    std::shared_ptr<const raywalk::Image> pixels{};
    T width = 1, height = 1;
    int channel = 0;
    ImageWraps wraps{};
    Vec2<T> first{0};  ///< where the first copy begins, in copies
    Image() = default;
    explicit Image(const MapImage& from, MapChannel from_channel = MapChannel::red);
    [[nodiscard]] Rgb<T> colour(const Vec2<T>& uv) const;
    [[nodiscard]] T number(const Vec2<T>& uv) const { return colour(uv)[channel]; }
  };
  struct Map : Image {
    MappedParameter of;
  };
  /// One of the two materials.
  struct Layer {
    MappedValues<T> own;
    double gloss, translucency;  ///< half angles in degrees; 0 where the integrator has no lobes
    std::vector<Map> maps;
    [[nodiscard]] MappedValues<T> at(const Vec2<T>& uv) const;
  };
  [[nodiscard]] static Layer layer_of(const Material& material, const SurfaceValues<T>& values, bool has_lobes);
  void prepare_roughness(const Material& material);

  std::vector<Layer> layers_;  ///< one, or with a mask two
  Image mask_;
  T squares_ = 0;  ///< > 0: the mask is a checker of them
  Image normal_map_, bump_map_;
  T strength_ = 0, relief_ = 0;
  bool maps_emission_ = false;
  /// Roughnesses that there are tables of, ascending, > 0; with what they make of the surface.
  std::vector<T> levels_;
  std::vector<Microsurface<T>> mirrors_;
  std::vector<std::vector<std::shared_ptr<const RoughDielectric<T>>>> glasses_;
  std::vector<Microsurface<T>> smooth_;  ///< where it is of metal: one mirror
  std::vector<RoughDiffuse<T>> matts_;   ///< of the materials, then at even steps from 0 to 1
};

extern template class SurfaceMaps<float>;
extern template class SurfaceMaps<double>;

}  // namespace raywalk
