#pragma once
// What the parts of the plan are painted with. Included by the files of this folder that draw, and by nobody else.

#include "view/plan_geometry.h"
#include "view/plan_view.h"

#include <array>
#include <optional>

namespace raywalk::detail {

/// An axis-parallel rectangle in pixels.
struct Box {
  Vec2d min, max;
  [[nodiscard]] double overlap(const Box& other) const;  ///< area in common
};

class Painter {
 public:
  Painter(const State& the_state, const Viewport& the_viewport)
      : state(the_state), viewport(the_viewport), sizes(the_state), colours(palette(the_state.theme)) {}

  const State& state;
  const Viewport& viewport;
  const Sizes sizes;
  const Palette& colours;
  DisplayList list;
  std::vector<Box> kept_free;  ///< where labels do not go

  [[nodiscard]] const Scene& scene() const { return state.scene(); }
  [[nodiscard]] Vec2d pixels(const Vec2d& point) const { return to_pixels(state.camera, viewport, point); }
  [[nodiscard]] double pixels(double scene_units) const { return scene_units * state.camera.pixels_per_unit; }
  [[nodiscard]] Box pane() const { return {Vec2d(0.0), {viewport.width, viewport.height}}; }
  [[nodiscard]] Stroke stroke(Colour colour, double width = 1) const { return {colour, width * sizes.line}; }
  [[nodiscard]] DashPattern scaled(DashPattern dash) const;
  /// Outline of something that can be selected and pointed at.
  [[nodiscard]] Stroke outline(const Target& target, Colour colour, double width = 1) const;

  void add(Shape2d shape, const Target& target = {}) { list.push_back({std::move(shape), target}); }
  /// A line that keeps its dashes in place when what lies outside the pane is cut off, with its arrowhead on what is
  /// left; nothing if nothing is.
  void add_clipped(LineItem line, const Target& target = {});
  /// A text on a ground of its own that labels keep free; `at`: its middle.
  void note(const Vec2d& at, const std::string& text);
  /// The same at the first of these places where it lies in the pane and covers nothing that is kept free; else at the
  /// very first. There is one at least.
  void note(const std::vector<Vec2d>& places, const std::string& text);
  /// Where the way between two points leaves the pane, with a margin; `to` when it does not.
  [[nodiscard]] Vec2d seen_end(const Vec2d& from, const Vec2d& to) const;
  /// The middle of what is seen of the way between two points, of which each may lie far outside.
  [[nodiscard]] Vec2d seen_middle(Vec2d from, Vec2d to) const;
  void keep_free(const Vec2d& at, double radius) { kept_free.push_back({at - radius, at + radius}); }

 private:
  /// The part of the way between two points that is seen, with a margin: from and to, 0..1.
  [[nodiscard]] std::optional<std::array<double, 2>> seen_stretch(const Vec2d& from, const Vec2d& to) const;
};

// objects_view.cpp
void draw_grid(Painter& painter);
void draw_objects(Painter& painter);
/// The colour that stands for a material in the plan; its alpha says how solid it is.
[[nodiscard]] Colour body_colour(const Scene& scene, const Material& material);

// symbols_view.cpp
void draw_screen(Painter& painter);
void draw_eye(Painter& painter);
void draw_lights(Painter& painter);

// rays_view.cpp: how rays look, in the plan and in space
/// How a ray stands out: what the line just run speaks of, its pixel's others, and those of pixels before.
enum class Prominence { earlier, of_pixel, current };
struct RayLook {
  Prominence prominence;
  bool hovered;
};
[[nodiscard]] Stroke ray_stroke(const Painter& painter, const RayRecord& ray, const RayLook& look);
/// A ray on the screen: where it starts and is drawn to, and its unit direction there.
struct RayWay {
  Vec2d from, to, along;
  bool open = false;  ///< it goes on to an end that is not known yet
};
/// `known`: whether its end is known. Nothing for a ray straight up or down, which is a point of the plan.
[[nodiscard]] std::optional<RayWay> ray_way(const Painter& painter, const RayRecord& ray, bool known);
[[nodiscard]] double ray_arrow(const Painter& painter, const RayLook& look);
/// A cross where a shadow ray is stopped.
void draw_blocked(Painter& painter, const Vec2d& at, const Vec2d& along, const Stroke& ray);
/// A ray that was not formed: a short piece of it, ended by a bar.
void draw_stub(Painter& painter, const Vec2d& from, const Vec2d& along, const Stroke& stroke, const Target& target);
void draw_rays(Painter& painter);

// ghosts_view.cpp
void draw_ghosts(Painter& painter);

// structure_view.cpp
/// The boxes of the accelerator that is stepped, and what its search has tested.
void draw_structure(Painter& painter);
/// The boxes' edges in space.
struct StructureEdge {
  Vec3d from, to;
  Stroke stroke;
};
[[nodiscard]] std::vector<StructureEdge> structure_edges(const Painter& painter);

// samples_view.cpp
void draw_samples(Painter& painter);

// handles_view.cpp
void draw_handles(Painter& painter);

// equation_view.cpp
void draw_hit_notes(Painter& painter);

// lesson_view.cpp
void draw_guess(Painter& painter);

// bug_view.cpp
/// Beside the rays of the pixel those that it has without the bug, or with it where it is mended, once it is known.
void draw_other_rays(Painter& painter);

// labels_view.cpp
void draw_labels(Painter& painter);

}  // namespace raywalk::detail
