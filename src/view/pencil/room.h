#pragma once
// Pencils in the plan: the rays beside each ray of the pixel at work, by their system matrix (trace/pencil.h).

#include "inspect/pencil_walk.h"
#include "view/fields.h"
#include "view/room.h"

#include <memory>
#include <vector>

namespace raywalk::action {

/// The pencils of the pixel's rays.
struct ShowPencils {
  static constexpr std::string_view word = "pencils";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  void apply(State& state) const;
};
/// The true rays beside them, and how far off a pencil is.
struct ShowNeighbours {
  static constexpr std::string_view word = "neighbours";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// The pencil about a ray of the pixel, as it is drawn.
struct Pencil {
  int ray;                                  ///< index in Timeline::rays()
  std::vector<PencilStage> stages;          ///< its way from EYE
  std::vector<std::vector<Vec3d>> truly{};  ///< of each drawn ray, while they are shown: its true way
  int parted = 0;                           ///< of these, what meets something else than the pencil's ray, or nothing
  double error = 0;                         ///< the farthest that one of the others is from the pencil where it ends
};

struct PencilRoom {
  using Actions = Types<action::ShowPencils, action::ShowNeighbours>;
  static constexpr Layer layer = Layer::over_rays;
  static void draw_in_plan(Painter& painter);
  static void follow(State& state, const Before& before);
  static Commands commands();

  bool shown = false;       ///< also over rays: pencils that are walked are there in any case
  bool neighbours = false;  ///< and the true rays, too
  // Of the walk at a position.
  std::shared_ptr<const Timeline> of{};
  int position = -1;
  bool with_neighbours = false;
  double half_angle = 0;  ///< between the pixel's middle and its edge, as EYE sees it
  std::vector<Pencil> pencils{};
};

/// Rays that are drawn of a pencil, by their share of its half angle.
inline constexpr double pencil_rays[] = {-1, -2.0 / 3, -1.0 / 3, 1.0 / 3, 2.0 / 3, 1};

}  // namespace raywalk
