#pragma once
// The pencil about a ray of a recording: the system matrix from EYE to each of its rays, and the true rays beside it.

#include "inspect/retraced_ray.h"
#include "trace/pencil.h"

#include <optional>
#include <vector>

namespace raywalk {

/// A ray of the way from EYE, and the pencil about it.
struct PencilStage {
  int ray;                             ///< index in Timeline::rays()
  int object = -1;                     ///< index in Scene::objects of what it meets; -1: nothing
  double time = 0;                     ///< at which moving objects are met
  Vec3d origin, direction;             ///< direction: of unit length
  double length;                       ///< to where it ends; infinite if it meets nothing
  PencilMatrix start;                  ///< from EYE to where it starts, in the plan
  PencilMatrix start_across;           ///< likewise across it, of rays above and below
  double n = 1;                        ///< index of what it goes through
  bool reflected = false;              ///< else refracted, or from EYE
  double curvature = 0;                ///< of the surface that it leaves, in the plan, towards the ray before
  std::optional<double> focus;         ///< how far along it, or behind its start, the pencil folds in the plan
  std::optional<double> focus_across;  ///< likewise across it: elsewhere where what is round is met aslant
};

/// The way of ray `ray` from EYE, first ray first. Empty where it is no ray of a strip that is reflected or refracted
/// in the plan: where it has a width, was drawn at random or leaves the plan. `camera`: that of the recording.
[[nodiscard]] std::vector<PencilStage> pencil_of(const World<double>& world, const RayGenerator<double>& camera,
                                                 const Timeline& timeline, int ray);

/// The true ray that leaves EYE by `angle` to the left of the first stage's, or above it (ConePlane::across): where it
/// starts in each stage, and last where it ends, or would at the last stage's length. Ends early where it meets another
/// object.
[[nodiscard]] std::vector<Vec3d> true_neighbour(const World<double>& world, const std::vector<PencilStage>& stages,
                                                double angle, double last_length,
                                                ConePlane plane = ConePlane::of_incidence);

}  // namespace raywalk
