#pragma once
// What an observer is told: one event for each executed line of pseudocode, with the numbers that the line computed.
// All numbers are passed in double, whatever scalar the tracer uses.

#include "math/vec.h"
#include "math/words.h"
#include "trace/optics.h"
#include "trace/pencil.h"
#include "trace/pseudocode.h"
#include "trace/rough_dielectric.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

/// `photon`: what leaves a light, or a surface where a photon was. `beam`: all rays of a pixel, or a part of them.
enum class RayKind { primary, shadow, reflect, refract, photon, beam };
template <>
inline constexpr Word<RayKind> words_of<RayKind>[] = {{RayKind::primary, "primary"}, {RayKind::shadow, "shadow"},
                                                      {RayKind::reflect, "reflect"}, {RayKind::refract, "refract"},
                                                      {RayKind::photon, "photon"},   {RayKind::beam, "beam"}};
inline constexpr int ray_kind_count = 6;

/// Why a ray ended, or why it was not formed. A formed ray ends in one of the first four or the last.
enum class Ending {
  hit,                        ///< met a surface, which was shaded
  missed,                     ///< left the scene: background
  blocked,                    ///< shadow ray: something occludes the light
  reached_light,              ///< shadow ray: nothing occludes it
  depth,                      ///< not formed: its SHADE would be deeper than the limit
  threshold,                  ///< not formed: its throughput would be below the threshold
  total_internal_reflection,  ///< not formed: no refracted direction exists
  path_length,                ///< not formed: the path is as long as the path tracer allows
  facing_away,                ///< not formed: the light is behind the surface
  outside_cone,               ///< not formed: outside the cone of the spot
  wrong_side,                 ///< not formed: the facet drawn of a rough surface sends it to the surface's other side
  scattered,                  ///< a medium scattered it before it met anything
};
template <>
inline constexpr Word<Ending> words_of<Ending>[] = {{Ending::hit, "hit"},
                                                    {Ending::missed, "missed"},
                                                    {Ending::blocked, "blocked"},
                                                    {Ending::reached_light, "reached_light"},
                                                    {Ending::depth, "depth"},
                                                    {Ending::threshold, "threshold"},
                                                    {Ending::total_internal_reflection, "total_internal_reflection"},
                                                    {Ending::path_length, "path_length"},
                                                    {Ending::facing_away, "facing_away"},
                                                    {Ending::outside_cone, "outside_cone"},
                                                    {Ending::wrong_side, "wrong_side"},
                                                    {Ending::scattered, "scattered"}};
inline constexpr int ending_count = 12;

/// The quadratic a t^2 + b t + c of a sphere (roots NaN when there are none).
struct QuadraticNumbers {
  double a, b, c, discriminant, t0, t1;
};
/// t = numerator / denominator of a plane or of a prism's face.
struct PlaneNumbers {
  double numerator, denominator;
};
/// Where in the sky a ray went that hit nothing.
struct SkyNumbers {
  double elevation, azimuth;  ///< in degrees: above the horizon; from the sky's middle, counter-clockwise from above
  double pdf;                 ///< per steradian, with which paths that sample the sky aim there
  Rgbd radiance;
};
/// Where light comes out of a body by the dipole (trace/dipole.h).
struct DipoleNumbers {
  double distance;   ///< from where it went in
  Rgbd reflectance;  ///< R_d of this distance, per area
  Rgbd total;        ///< of all distances
};
using IntersectionNumbers = std::variant<std::monostate, QuadraticNumbers, PlaneNumbers, SkyNumbers, DipoleNumbers>;

/// Snell's law at a surface: n1 sin(in) = n2 sin(out).
struct SnellNumbers {
  double n1, n2;           ///< indices of refraction on the ray's side and beyond
  double cos_in, cos_out;  ///< cosines to the normal, >= 0
  double fresnel;          ///< unpolarised reflectance; 1 under total internal reflection
};
template <class T>
[[nodiscard]] SnellNumbers snell_numbers(const Refraction<T>& at) {
  return {static_cast<double>(at.n1), static_cast<double>(at.n2), static_cast<double>(at.cos_in),
          static_cast<double>(at.cos_out), static_cast<double>(at.fresnel())};
}
/// At the small facet of rough glass that turns one direction into the other, if there is one. `at`: at the surface as
/// a whole.
template <class T>
[[nodiscard]] std::optional<SnellNumbers> snell_at_facet(const RoughDielectric<T>& glass, const Refraction<T>& at,
                                                         const Vec3<T>& incident, const Vec3<T>& direction) {
  const auto facet = glass.bends_by(glass.side_of(at.n1), incident, direction);
  return facet ? std::optional(snell_numbers(*facet)) : std::nullopt;
}

/// In place of the index of a light.
inline constexpr int light_of_sky = -2;

/// for_each_pixel: a sample of a pixel begins.
struct PixelBegun {
  int column, row, sample;
};

/// form_*_ray. `throughput`: the factor, per channel, by which the light along this ray contributes to the pixel.
struct RayFormed {
  int ray;     ///< number of the ray in this recording, from 0
  int parent;  ///< ray at whose hit it was formed; -1 for a primary ray
  RayKind kind;
  Vec3d origin, direction;  ///< a shadow ray's direction to a point light reaches it at t = 1; else unit length
  Rgbd throughput;
  int light = -1;                       ///< shadow rays, photons: index of the light; -1 an emitting object, or
                                        ///< light_of_sky
  bool light_at_end = false;            ///< shadow rays: origin + direction is the light itself
  std::optional<SnellNumbers> snell{};  ///< refract rays
  int light_sample = 0;                 ///< shadow rays: which of the points of a light with an extent
  double radius = 0, end_radius = 0;    ///< shadow cones: where they start, and at the light
};

/// form_*_ray when a limit, or a light behind the surface, prevents it. `direction`: where it would have gone.
struct RayNotFormed {
  int parent;
  RayKind kind;
  Ending why;
  Vec3d origin, direction;
  Rgbd throughput;
  int light = -1;
  int light_sample = 0;
};

/// The normals that a hit is shaded with, of unit length.
struct HitNormals {
  Vec3d shading{0.0};  ///< on the side that the ray came from, unless the material's is fixed; 0: no surface is shaded
  std::optional<Vec3d> geometric{};  ///< the surface's own, on that side, where it is another one: of a normal that is
                                     ///< interpolated, bent or fixed
};
template <class T>
[[nodiscard]] HitNormals hit_normals(const Vec3<T>& shading, const Vec3<T>& geometric) {
  HitNormals normals{Vec3d(shading)};
  if (shading != geometric) normals.geometric = Vec3d(geometric);
  return normals;
}

/// find_*: how a ray ended. The point and all members after it are set when something was hit.
struct Found {
  int ray;
  Ending ending;
  double t = 0;
  int object = -1;  ///< index in Scene::objects: what was hit, or the nearest blocker of a shadow ray
  int part = 0;
  Vec3d point{0.0}, normal{0.0};  ///< normal: unit length, outward; interpolated or bent where the surface's is
  Rgbd transmittance{1.0};        ///< shadow rays: the transmittance of the filtering objects
  IntersectionNumbers numbers{};
  int triangle = -1;     ///< of a mesh: which one, from 0
  std::string member{};  ///< of an instance: the name of what was hit in its group
  HitNormals shaded{};
};

/// if_*.
struct Decided {
  bool holds;
  Rgbd weight{0.0};                     ///< kr' or kt'; unused in MAIN ALGORITHM
  std::optional<Ending> why{};          ///< total_internal_reflection when that is why nothing is transmitted
  std::optional<SnellNumbers> snell{};  ///< with `why`: Snell's law, which has no solution
};

/// shade_*: SHADE is called for `ray`. When the ray missed, it returns `background` at once.
struct ShadeCalled {
  int ray;
  bool missed;
  int depth;  ///< DEPTH of the SHADE that is called
  Rgbd background{0.0};
};

/// The contribution of one light; of an area light, all its samples together.
struct LightTerm {
  int light;
  Rgbd diffuse{0.0}, specular{0.0};  ///< 0 when blocked or behind the surface
};

/// compute_rtnshade: total = passed (ambient + emission + lights + reflect + refract).
struct ShadeComputed {
  Rgbd ambient, emission;
  std::vector<LightTerm> lights;
  Rgbd reflect, refract;  ///< kr' I(reflect) and kt' I(refract)
  Rgbd total;
  Rgbd transmittance{1.0};           ///< the transmittance of the absorbing object that the ray passed through
  std::optional<Rgbd> irradiance{};  ///< of light between surfaces: kd / pi times it is in the place of ambient light
};

/// put_final_shade.
struct PixelPut {
  int column, row, sample;
  Rgbd shade;
};

// Path tracing and photon mapping only, from here on.

/// How a surface scatters. Mirror and transparent lobes are sharp, or cones where the material is glossy or
/// translucent.
enum class Lobe {
  diffuse,
  highlight,
  mirror,
  transparent,
  phase,  ///< of no surface: the phase function of a medium
};
template <>
inline constexpr Word<Lobe> words_of<Lobe>[] = {{Lobe::diffuse, "diffuse"},
                                                {Lobe::highlight, "highlight"},
                                                {Lobe::mirror, "mirror"},
                                                {Lobe::transparent, "transparent"},
                                                {Lobe::phase, "phase"}};
inline constexpr int lobe_count = 4;  ///< of surfaces: all before `phase`

/// add_background: the path has left the scene. Pdfs as of EmissionAdded.
struct BackgroundAdded {
  int ray;
  Rgbd background;
  double direction_pdf, light_pdf, weight;
  Rgbd added;  ///< to the pixel
};

/// add_emission: the emission of the surface hit. The pdfs are those with which this direction was sampled at the
/// previous vertex (0: it was the only one possible) and with which light sampling would have chosen it there (0: it
/// could not).
struct EmissionAdded {
  int ray;
  Rgbd emission;
  double direction_pdf, light_pdf, weight;
  Rgbd added;  ///< to the pixel
};

/// add_light: the contribution of a light. Pdfs as above; both 0 for a light that no ray can hit.
struct LightAdded {
  int light;   ///< index in Scene::lights; -1 for an object that emits, or light_of_sky
  int object;  ///< index in Scene::objects of that; else -1
  double direction_pdf, light_pdf, weight;
  Rgbd added;
};

/// choose_direction. `throughput`: the throughput along the direction chosen.
struct DirectionChosen {
  bool absorbed;  ///< no direction: the surface absorbs everything
  Lobe lobe = Lobe::diffuse;
  Vec3d direction{0.0};
  double pdf = 0;  ///< by solid angle; 0 for the one direction of a sharp lobe
  Rgbd throughput{0.0};
};

/// if_path_survives. Russian roulette: goes on with probability `survival`, and then counts 1 / survival times.
struct SurvivalDecided {
  bool survives;
  double survival = 1;
  std::optional<Ending> why{};  ///< why not: path_length or threshold (roulette); none when absorbed
};

// Photon mapping only, from here on.

/// for_each_photon: a photon begins, or all others that are not recorded.
struct PhotonBegun {
  int photon, count;  ///< number, from 0, of as many
  int others = 0;     ///< not 0: as many photons, from this one on, went their ways together
};

/// The way of a photon up to where it is.
enum class PhotonHistory {
  direct,    ///< from the light: what shadow rays find
  caustic,   ///< from the light by mirrors, glass or highlights only
  indirect,  ///< a diffuse surface scattered it
};
template <>
inline constexpr Word<PhotonHistory> words_of<PhotonHistory>[] = {
    {PhotonHistory::direct, "direct"}, {PhotonHistory::caustic, "caustic"}, {PhotonHistory::indirect, "indirect"}};

/// store_photon.
struct PhotonStored {
  int ray;
  Vec3d position, normal;  ///< normal: of the side that it arrived at
  Rgbd power;
  PhotonHistory history;
  bool kept;  ///< false: shadow rays bring this light, so that it is not used
};

/// What a search in a photon map found. Radius 0: the map is empty.
struct PhotonCircle {
  double radius = 0;
  int count = 0;  ///< of the photons inside
  Rgbd power{0.0};
  Rgbd irradiance{0.0};   ///< power over the circle's area; in a flat world over its diameter
  bool at_limit = false;  ///< it may not be larger: it did not grow to the last photon that was wanted
};
/// find_nearest_photons.
struct PhotonsFound {
  int ray;
  Vec3d position, normal;
  PhotonCircle caustic, other;
  bool flat;
  std::optional<Rgbd> answered;  ///< of a rough matt surface: what it sends on, times pi; else kd times the irradiance
};

/// add_light_of_photons.
struct PhotonsAdded {
  int ray;
  Rgbd irradiance;  ///< of both searches
  Rgbd albedo;      ///< kd
  bool flat;
  Rgbd added;  ///< to the pixel
};

// Radiosity only, from here on.

/// The light of a patch. Radiosities and irradiances: powers per area, in a flat world per length.
struct PatchLight {
  Rgbd irradiance{0.0};  ///< what has arrived so far
  Rgbd unshot{0.0};      ///< the radiosity that it has not sent on yet
};

/// cut_patches, light_patches. `unshot`: the power of all patches together.
struct PatchesMade {
  int count;
  bool flat;
  Rgbd unshot{0.0};
  std::shared_ptr<const std::vector<PatchLight>> lights{};  ///< of light_patches: of each patch
};

/// while_unshot_light.
struct UnshotLight {
  bool holds;
  int shots;         ///< so far
  double share;      ///< of the first light: what is still unshot
  double tolerance;  ///< below which the rest is let be
};

/// take_patch.
struct PatchTaken {
  int patch, object;
  Rgbd radiosity;  ///< unshot
  double share;    ///< of all unshot light: what this patch has
};

/// shoot_light. `lights`: where the shot, or all that were left, is not walked; what the patches have then.
struct PatchShot {
  int patch, object;
  int others = 0;    ///< not 0: as many shots, from this one on, went together
  double share = 0;  ///< of the first light: what is unshot after these
  std::shared_ptr<const std::vector<PatchLight>> lights{};
};

/// for_each_patch, in front of the one that shoots.
struct PatchInFront {
  int patch, object;
};

/// compute_form_factor: how much of what `from` sends arrives at `to`.
struct FormFactorFound {
  int from, to, object;
  Vec2d from_a{0.0}, from_b{0.0}, to_a{0.0}, to_b{0.0};  ///< in a flat world, what of both sees the other
  double crossed = 0, uncrossed = 0, length = 0;         ///< of the strings; of `from`
  double factor = 0;                                     ///< as if nothing stood between
  double visible = 1;                                    ///< the share that nothing keeps away
};

/// add_what_arrives.
struct LightArrived {
  int patch, object;
  Rgbd arrived;      ///< irradiance
  Rgbd reflectance;  ///< kd
  PatchLight light;  ///< of the patch, with it
};

/// forget_unshot_light.
struct PatchEmptied {
  int patch, object;
  PatchLight light;
  double share;  ///< of the first light: what is still unshot
};

/// look_up_light.
struct LightLookedUp {
  int ray;
  int patch;  ///< where it is; -1: the ray met no patch
  bool flat;
  Rgbd irradiance, albedo, emission, shade;
};

// Beam and cone tracing only, from here on. Places in the pixel's width go from 0 to 1.

/// The rays between two places, as they are drawn: from where they start to where they end; as many of each. A beam
/// that meets nothing ends far outside.
struct BeamArea {
  std::vector<Vec3d> starts, ends;
  std::vector<Vec3d> corner_starts{},
      corner_ends{};  ///< in space: the rays through the corners of a beam's window, on a cone's rim
};

/// form_beam, form_mirrored_beam, form_refracted_beam, form_cone and its like.
struct BeamFormed {
  int ray;     ///< number of the beam, among the rays of this recording
  int parent;  ///< the part that was mirrored or refracted; -1 for a pixel's beam
  Vec3d apex;  ///< from where its rays come, or seem to: EYE, or its mirror image
  double begin, end;
  BeamArea area;
  Rgbd throughput;
  double radius = 0, spread = 0;        ///< cones: where they start, and how fast that grows (trace/ray_cone.h)
  std::optional<SnellNumbers> snell{};  ///< of a refracted beam, in the middle of its part
  double off = 0;  ///< then: the angle in radians that the rays at its ends are off Snell's law, the larger one
};

/// A part of a beam. `object`: index in Scene::objects, what all of it sees; -1: nothing.
struct BeamPiece {
  int ray;  ///< number of the part
  int object;
  double begin, end;
  double coverage;  ///< of the pixel: the width between these two places, to the last bit. Of a cone: its share of it
  BeamArea area;
  Vec3d origin, point, normal;  ///< of the ray in its middle; `point`, `normal` and `shaded`: if it sees something
  HitNormals shaded{};
};
/// cut_beam, cut_mirrored_beam, find_cover and its like.
struct BeamCut {
  int ray;
  std::vector<BeamPiece> pieces;
};

/// for_each_part, for_each_cover.
struct PartBegun {
  int ray, number, count;  ///< the part, and its number, from 0, of as many
  double coverage;
  bool sees_nothing;
};

/// shade_middle: what lights and the surface itself bring. A part that sees nothing: the background.
struct PartShaded {
  int ray;
  Rgbd ambient, emission;
  std::vector<LightTerm> lights;
  Rgbd total;
};

/// add_part, add_share.
struct PartAdded {
  int ray;
  Rgbd local, reflect, refract;  ///< local: of shade_middle; kr' I(reflect) and kt' I(refract)
  Rgbd shade;                    ///< of the part
  double share;                  ///< of the beam
  Rgbd mean;                     ///< of the beam, up to the end of this part
  bool last;
  double off = 0;  ///< by how much the shades near the border of a part differ from its one, at most
};

// Pencil tracing only.

/// transfer_pencil, reflect_pencil, refract_pencil: what the matrix from EYE has become.
struct PencilChanged {
  int ray;                               ///< the axis, or the one that leaves the surface
  std::optional<PencilSystem> system{};  ///< none where the axis does not leave as the surface itself sends it
  double along = 0;                      ///< transfer_pencil: the distance
  double curvature = 0, cos_in = 1;  ///< else: of the surface in the plane of incidence, towards the ray; of the angle
  std::optional<SnellNumbers> snell{};  ///< refract_pencil
};
/// In the plan: what the matrix was multiplied by.
[[nodiscard]] inline PencilMatrix step_of(const PencilChanged& changed, Line line) {
  if (line == Line::transfer_pencil) return pencil_transfer(changed.along);
  if (!changed.snell) return pencil_mirror(ConePlane::of_incidence, changed.curvature, changed.cos_in);
  const SnellNumbers& snell = *changed.snell;
  return pencil_refraction(ConePlane::of_incidence, changed.curvature, snell.n1, snell.n2, snell.cos_in, snell.cos_out);
}

using EventDetail = std::variant<PixelBegun, RayFormed, RayNotFormed, Found, Decided, ShadeCalled, ShadeComputed,
                                 PixelPut, BackgroundAdded, EmissionAdded, LightAdded, DirectionChosen, SurvivalDecided,
                                 PhotonBegun, PhotonStored, PhotonsFound, PhotonsAdded, PatchesMade, UnshotLight,
                                 PatchTaken, PatchShot, PatchInFront, FormFactorFound, LightArrived, PatchEmptied,
                                 LightLookedUp, BeamFormed, BeamCut, PartBegun, PartShaded, PartAdded, PencilChanged>;

struct Event {
  Line line;
  /// DEPTH of the SHADE that executes the line; in FOLLOW PATH, FOLLOW PHOTON and GATHER LIGHT the number of rays so
  /// far, the current one included; 0 in the procedure that calls these.
  int depth;
  EventDetail detail;
};

}  // namespace raywalk
