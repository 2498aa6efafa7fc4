#pragma once
// What an observer of the path tracer is told: one event for each executed line, as trace/event.h has it for the
// tracer.

#include "trace/event.h"
#include "trace/path_pseudocode.h"

namespace raywalk {

/// How a surface scatters. Mirror and transparent lobes are sharp, or cones where the material is glossy or
/// translucent.
enum class Lobe { diffuse, highlight, mirror, transparent };
inline constexpr int lobe_count = 4;
[[nodiscard]] std::string_view lobe_name(Lobe lobe);  ///< "diffuse"

/// add_background: the path has left the scene.
struct BackgroundAdded {
  int ray;
  Rgbd added;
};

/// add_emission: what the surface met gives off. The densities are those with which this direction was chosen where the
/// ray left (0: it was the only one possible) and with which a light sample there would have chosen it (0: it could
/// not).
struct EmissionAdded {
  int ray;
  Rgbd emission;
  double direction_density, light_density, weight;
  Rgbd added;  ///< to the pixel
};

/// add_light: what a light brings. Densities as above; both 0 for a light that no ray can meet.
struct LightAdded {
  int light;   ///< index in Scene::lights; -1 for an object that emits
  int object;  ///< index in Scene::objects of that; else -1
  double direction_density, light_density, weight;
  Rgbd added;
};

/// choose_direction. `share`: what is left of the ray's share of the pixel along the direction chosen.
struct DirectionChosen {
  bool absorbed;  ///< none: the surface swallows what comes
  Lobe lobe = Lobe::diffuse;
  Vec3d direction{0.0};
  double density = 0;  ///< by solid angle; 0 for the one direction of a sharp lobe
  Rgbd share{0.0};
};

/// if_path_survives. Russian roulette: goes on with probability `survival`, and then counts 1 / survival times.
struct SurvivalDecided {
  bool survives;
  double survival = 1;
  std::optional<Ending> why{};  ///< why not: path_length or threshold (roulette); none when absorbed
};

using PathEventDetail = std::variant<PixelBegun, RayFormed, RayNotFormed, Found, Decided, BackgroundAdded,
                                     EmissionAdded, LightAdded, DirectionChosen, SurvivalDecided, PixelPut>;

struct PathEvent {
  PathLine line;
  int length;  ///< rays of the path so far, this one included; 0 outside FOLLOW PATH
  PathEventDetail detail;
};

/// Is told every event of a path, in order.
class PathObserver {
 public:
  static constexpr bool watches = true;
  virtual ~PathObserver() = default;
  virtual void record(PathEvent&& event) = 0;
};

}  // namespace raywalk
