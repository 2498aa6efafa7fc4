#pragma once
// Painting of the plan. Included only by the files of this folder that draw.

#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

/// An axis-parallel rectangle in pixels.
struct PixelRect {
  Vec2d min, max;
  [[nodiscard]] bool holds(const Vec2d& at) const {
    return at.x >= min.x && at.x <= max.x && at.y >= min.y && at.y <= max.y;
  }
  [[nodiscard]] double overlap(const PixelRect& other) const;          ///< area in common
  [[nodiscard]] bool meets(const Vec2d& from, const Vec2d& to) const;  ///< a segment
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Whether two segments cross.
[[nodiscard]] bool cross_each_other(const std::array<Vec2d, 2>& a, const std::array<Vec2d, 2>& b);

/// The width of a text in the window's font, slightly overestimated. text_width() is up to 50% more, for other fonts,
/// which would keep names off bodies that they fit on.
[[nodiscard]] double width_of(const std::string& text, double size);

class Painter {
 public:
  Painter(const State& the_state, const Viewport& the_viewport)
      : state(the_state), viewport(the_viewport), sizes(the_state), colours(palette(the_state.appearance.theme)) {}

  const State& state;
  const Viewport& viewport;
  const Sizes sizes;
  const Palette& colours;
  DisplayList list;
  std::vector<PixelRect> kept_free;             ///< not used by labels
  std::vector<PixelRect> unnamed;               ///< not used by names, but their leaders may cross it
  std::vector<std::array<Vec2d, 2>> prominent;  ///< rays of the current pixel, normals, sides of beams at work, arcs
  std::vector<std::array<Vec2d, 2>> leaders;    ///< from notes to what they are of, and normals of angles: not crossed
  std::vector<Vec2d> frame;                     ///< closed, if the plan has one: drawings stay inside of it

  [[nodiscard]] const Scene& scene() const { return state.scene(); }
  [[nodiscard]] Vec2d pixels(const Vec2d& point) const { return to_pixels(state.plan.camera, viewport, point); }
  [[nodiscard]] double pixels(double scene_units) const { return scene_units * state.plan.camera.pixels_per_unit; }
  [[nodiscard]] PixelRect pane() const { return {Vec2d(0.0), {viewport.width, viewport.height}}; }
  [[nodiscard]] Stroke stroke(Colour colour, double width = 1) const { return {colour, width * sizes.line}; }
  /// Of letters that rays may cross.
  [[nodiscard]] Colour halo() const { return colours.plan.with_alpha(200); }
  [[nodiscard]] DashPattern scaled(DashPattern dash) const;
  /// Outline of something that can be selected and pointed at.
  [[nodiscard]] Stroke outline(const Target& target, Colour colour, double width = 1) const;

  void add(Shape2d shape, const Target& target = {}) { list.push_back({std::move(shape), target}); }
  /// A line clipped to the pane, with its dashes in place and its arrowhead on the visible part, if any.
  void add_clipped(LineItem line, const Target& target = {});
  /// A text on its own background, which labels avoid; `at`: its middle.
  void note(const Vec2d& at, const std::string& text);
  /// The same at the first of these places that is in the pane, not kept free and, if possible, on no ray of the pixel
  /// and on no outline of a body. None if there is no such place: it must be said elsewhere too. Returns whether it is
  /// there.
  bool note(const std::vector<Vec2d>& places, const std::string& text);
  /// The same, but on no outline of a body at all.
  bool note_off_bodies(const std::vector<Vec2d>& places, const std::string& text);
  /// The same beside a point, as near as possible and farther away with a line to it, which runs over nothing that is
  /// kept free, nor over another such line, and rather over no ray and no body. `away`: preferably in this direction,
  /// of unit length. Returns whether it is there.
  /// `around`: what is kept free around the point itself, which the line may enter from its side.
  bool note_beside(const Vec2d& of, const Vec2d& away, const std::string& text,
                   const std::optional<PixelRect>& around = {});
  /// The same close to the visible part of a segment, preferably above its middle, and on no part of it; else beside
  /// its middle. `above`: false: preferably below.
  bool note_along(const Vec2d& from, const Vec2d& to, const std::string& text, bool above = true);
  /// How far it is from a point, in a direction of unit length, to the edge of the pane or to the frame; 0 from
  /// outside.
  [[nodiscard]] double room_along(const Vec2d& from, const Vec2d& along) const;
  /// Where the segment between two points leaves the pane, with a margin; `to` if it does not.
  [[nodiscard]] Vec2d seen_end(const Vec2d& from, const Vec2d& to) const;
  /// The middle of the visible part of a segment, whose ends may be far outside.
  [[nodiscard]] Vec2d seen_middle(Vec2d from, Vec2d to) const;
  /// Whether a box covers something that is kept free.
  [[nodiscard]] bool covers_kept(const PixelRect& box) const;
  void keep_free(const Vec2d& at, double radius) { kept_free.push_back({at - radius, at + radius}); }

 private:
  /// The same, where each place costs this much `more` than the lines that it lies on, of which a ray costs 6; if
  /// infinitely much, it is none. `off_bodies`: nor is one on the outline of a body.
  bool note(const std::vector<Vec2d>& places, const std::string& text, const std::function<double(const Vec2d&)>& more,
            bool off_bodies = false);
  /// The same at one of `first`; else as `note_beside`.
  bool note_near(const Vec2d& of, const Vec2d& away, const std::string& text, const std::vector<Vec2d>& first,
                 const std::optional<PixelRect>& around);
  /// How much of a line is inside bodies, in pixels: where it runs through one it seems to lead to it.
  [[nodiscard]] double inside_bodies(const Vec2d& from, const Vec2d& to) const;
  /// The visible part of a segment, with a margin: from and to, 0..1.
  [[nodiscard]] std::optional<std::array<double, 2>> seen_stretch(const Vec2d& from, const Vec2d& to,
                                                                  double margin) const;
};

// objects_view.cpp
void draw_grid(Painter& painter);
void draw_objects(Painter& painter);
/// The colour of a material in the plan; its alpha is its opacity.
[[nodiscard]] Colour body_colour(const Scene& scene, const Material& material);

// symbols_view.cpp
void draw_screen(Painter& painter);
void draw_eye(Painter& painter);
void draw_lights(Painter& painter);

// rays_view.cpp: how rays look, in the plan and in space
/// A ray's prominence: the current ray, others of its pixel, and those of earlier pixels, which fade once they are
/// many.
enum class Prominence { faded, earlier, of_pixel, current };
struct RayLook {
  Prominence prominence;
  bool hovered;
};
[[nodiscard]] Stroke ray_stroke(const Painter& painter, const RayRecord& ray, const RayLook& look);
/// A ray on the screen: its start, its drawn end, and its unit direction.
struct RayWay {
  Vec2d from, to, along;
  bool open = false;  ///< its end is not known yet
};
/// `known`: whether its end is known. Nothing for a vertical ray, which is a point in the plan.
[[nodiscard]] std::optional<RayWay> ray_way(const Painter& painter, const RayRecord& ray, bool known);
[[nodiscard]] double ray_arrow(const Painter& painter, const RayLook& look);
/// A cross where a shadow ray is blocked.
void draw_blocked(Painter& painter, const Vec2d& at, const Vec2d& along, const Stroke& ray);
/// A ray that was not formed: a short piece that ends in a bar.
void draw_stub(Painter& painter, const Vec2d& from, const Vec2d& along, const Stroke& stroke, const Target& target);
/// Which rays of the walk are drawn.
struct RaysShown {
  int position = 0;     ///< those formed by then
  int pixel = -1;       ///< whose rays are prominent
  int current = -1;     ///< the ray that is most so
  int first_pixel = 0;  ///< none of the pixels before it
  Earlier others = Earlier::shown;
  bool pointed_at = true;  ///< whether the pointer finds them; else it finds what lies below
};
[[nodiscard]] RaysShown rays_shown(const State& state);
/// Absent: the ray is not drawn.
[[nodiscard]] std::optional<Prominence> prominence_of(const State& state, const RaysShown& shown, int ray);
void draw_rays(Painter& painter, const RaysShown& shown);

// beams_view.cpp
/// Of a walk of beams: each as an area, or its parts once it is cut.
void draw_beams(Painter& painter, const RaysShown& shown);

/// That the walk runs in a flat world.
void draw_flat_note(Painter& painter, std::string_view id);

// ghosts_view.cpp
void draw_ghosts(Painter& painter);

// structure_view.cpp
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

// labels_view.cpp
void draw_labels(Painter& painter);

}  // namespace raywalk
