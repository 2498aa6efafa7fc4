#pragma once
// What values the keys of the scene format take: which numbers, which words. The keys themselves: io/scene_keys.h.

#include "scene/scene.h"

#include <array>
#include <string_view>
#include <utility>

namespace raywalk::scene_keys {

enum class Presence { required, optional };
using enum Presence;

/// Which numbers a key takes. Every number is finite and at most `most_magnitude`, so that squares and products of a
/// few of them do not overflow; a number that must be above 0 is at least 1 / most_magnitude.
struct NumberRule {
  std::string_view expected;  ///< completes "expected ..."
  double low = 0, high = 0;
  bool above_low = false;   ///< low itself is refused
  bool below_high = false;  ///< high itself is refused
  std::string_view hint{};
};
inline constexpr double most_magnitude = 1e15;

inline constexpr NumberRule coordinate{
    .expected = "a number",
    .low = -most_magnitude,
    .high = most_magnitude,
    .hint = "in scene units: x to the right, y up, z towards the reader",
};
inline constexpr NumberRule any_priority{
    .expected = "a number",
    .low = -most_magnitude,
    .high = most_magnitude,
    .hint = "where transparent bodies overlap, the one with the highest counts; 0 when left out",
};
inline constexpr NumberRule above_zero{
    .expected = "a number above 0",
    .high = most_magnitude,
    .above_low = true,
    .hint = "such as 1 or 0.5",
};
inline constexpr NumberRule lengths_above_zero{
    .expected = "one number above 0, or [x, y, z] of them",
    .high = most_magnitude,
    .above_low = true,
    .hint = "such as 1 or [1, 2, 0.5]",
};
inline constexpr NumberRule not_negative{
    .expected = "a number that is 0 or more",
    .high = most_magnitude,
    .hint = "such as 0 or 0.5",
};
/// Light that is given off, and the share of it that a surface sends on. Both are far above what any scene needs, and
/// so low that a few surfaces in turn do not make more of them than the float of a picture's file holds, 3e38.
inline constexpr NumberRule light_amount{
    .expected = "a number from 0 to 1e12",
    .high = 1e12,
    .hint = "one number is a grey, [red, green, blue] a colour; light is never negative",
};
inline constexpr NumberRule reflectance{
    .expected = "a number from 0 to 1000",
    .high = 1000,
    .hint = "the share of the light that goes on, usually from 0 to 1",
};
inline constexpr NumberRule view_angle{
    .expected = "an angle in degrees above 0 and below 180",
    .high = 180,
    .above_low = true,
    .below_high = true,
    .hint = "45 is a usual angle of view, 90 a very wide one",
};

inline constexpr NumberRule cone_angle{
    .expected = "a full angle in degrees above 0 and at most 180",
    .high = 180,
    .above_low = true,
    .hint = "30 is a narrow spot, 90 a wide one",
};
inline constexpr NumberRule inner_cone_angle{
    .expected = "a full angle in degrees from 0 to 180",
    .high = 180,
    .hint = "up to half of it from the axis the light is at its full strength",
};
inline constexpr NumberRule lobe_angle{
    .expected = "half an angle in degrees from 0 to 90",
    .high = 90,
    .hint = "0 is sharp, 5 a brushed metal, 20 very rough",
};

struct WholeRule {
  int low = 1, high = 1;
};
inline constexpr WholeRule cell_count{1, 10001}, pixel_count{1, 32768}, depth_count{1, 1000}, sample_count{1, 1 << 20},
    light_grid_count{1, 256}, path_length_count{1, 1000};

/// The names of a choice's values in a scene file.
template <class Value>
struct Names;
template <>
struct Names<FovAxis> {
  static constexpr std::array<std::pair<FovAxis, std::string_view>, 2> all{{{FovAxis::x, "x"}, {FovAxis::y, "y"}}};
};
template <>
struct Names<ShadowKind> {
  static constexpr std::array<std::pair<ShadowKind, std::string_view>, 2> all{
      {{ShadowKind::opaque, "opaque"}, {ShadowKind::filtered, "filtered"}}};
};

template <>
struct Names<Integrator> {
  static constexpr std::array<std::pair<Integrator, std::string_view>, integrator_count> all{
      {{Integrator::automatic, integrator_name(Integrator::automatic)},
       {Integrator::cast, integrator_name(Integrator::cast)},
       {Integrator::whitted, integrator_name(Integrator::whitted)},
       {Integrator::distributed, integrator_name(Integrator::distributed)},
       {Integrator::path, integrator_name(Integrator::path)}}};
};
template <>
struct Names<Numerics> {
  static constexpr std::array<std::pair<Numerics, std::string_view>, 2> all{
      {{Numerics::robust, numerics_name(Numerics::robust)}, {Numerics::naive, numerics_name(Numerics::naive)}}};
};
template <>
struct Names<Sampler> {
  static constexpr std::array<std::pair<Sampler, std::string_view>, sampler_count> all{
      {{Sampler::random, "random"}, {Sampler::jittered, "jittered"}, {Sampler::sobol, "sobol"}}};
};
template <>
struct Names<ShadingNormal> {
  static constexpr std::array<std::pair<ShadingNormal, std::string_view>, 2> all{
      {{ShadingNormal::facing, "facing"}, {ShadingNormal::fixed, "fixed"}}};
};
template <>
struct Names<Encoding> {
  static constexpr std::array<std::pair<Encoding, std::string_view>, 2> all{
      {{Encoding::srgb, "srgb"}, {Encoding::truncated, "truncated"}}};
};

/// What a variant's alternatives are called under `type`.
constexpr std::string_view type_name(const PointLight& /*light*/) { return "point"; }
constexpr std::string_view type_name(const DirectionalLight& /*light*/) { return "directional"; }
constexpr std::string_view type_name(const SpotLight& /*light*/) { return "spot"; }
constexpr std::string_view type_name(const SphereLight& /*light*/) { return "sphere"; }
constexpr std::string_view type_name(const RectangleLight& /*light*/) { return "rectangle"; }
template <class S>
constexpr auto type_name(const S& shape) -> decltype(shape_name(shape)) {
  return shape_name(shape);
}

}  // namespace raywalk::scene_keys
