#pragma once
// A drawing as data: vector graphics in pixels of a viewport, origin in its top left corner, x to the right, y down.
// Later items are on top. The window, exported slides and tests all use the same list.

#include "math/vec.h"
#include "math/words.h"
#include "view/drawing/theme.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace raywalk {

/// Something in the plan that can be pointed at.
enum class TargetKind {
  nothing,
  eye,              ///< drag: moves EYE and its look-at point, so the view keeps its direction
  view_direction,   ///< handle ahead of EYE: turns the view
  screen_height,    ///< part 0: the end of cell 0, 1: the other end
  screen_distance,  ///< the middle of SCREEN
  cell,             ///< index: column of the strip
  object,           ///< index: in Scene::objects
  radius,           ///< a sphere's handle; index: object
  corner,           ///< a polygon's corner; index: object, part: corner
  edge,             ///< a polygon's side from corner `part` to the next; index: object
  rotation,         ///< a polygon's handle; index: object
  light,            ///< index: in Scene::lights
  light_radius,     ///< the handle of a light with a radius; index: light
  ray,              ///< index: in Timeline::rays()
};
template <>
inline constexpr Word<TargetKind> words_of<TargetKind>[] = {
    {TargetKind::nothing, "nothing"},
    {TargetKind::eye, "eye"},
    {TargetKind::view_direction, "view-direction"},
    {TargetKind::screen_height, "screen-height"},
    {TargetKind::screen_distance, "screen-distance"},
    {TargetKind::cell, "cell"},
    {TargetKind::object, "object"},
    {TargetKind::radius, "radius"},
    {TargetKind::corner, "corner"},
    {TargetKind::edge, "edge"},
    {TargetKind::rotation, "rotation"},
    {TargetKind::light, "light"},
    {TargetKind::light_radius, "light-radius"},
    {TargetKind::ray, "ray"},
};

struct Target {
  TargetKind kind = TargetKind::nothing;
  int index = -1;
  int part = -1;
  static void fields(auto& f, auto& t) { f(t.kind), f(t.index), f(t.part); }
  friend bool operator==(const Target&, const Target&) = default;
  [[nodiscard]] explicit operator bool() const { return kind != TargetKind::nothing; }
};

struct Stroke {
  Colour colour;
  double width = 1;    ///< pixels
  DashPattern dash{};  ///< lengths in pixels, after scaling
  double phase = 0;    ///< offset into the pattern, in pixels: keeps the dashes of a clipped ray in place
  friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// A straight line, with a filled arrowhead if `arrow` is above 0: its length in pixels, its tip at
/// from + arrow_at (to - from), pointing along the line.
struct LineItem {
  Vec2d from, to;
  Stroke stroke;
  double arrow = 0;
  double arrow_at = 1;
  friend bool operator==(const LineItem&, const LineItem&) = default;
};
struct PolylineItem {
  std::vector<Vec2d> points;
  Stroke stroke;
  friend bool operator==(const PolylineItem&, const PolylineItem&) = default;
};
/// A simple polygon, possibly concave.
struct PolygonItem {
  std::vector<Vec2d> points;
  std::optional<Colour> fill;
  std::optional<Stroke> stroke;
  friend bool operator==(const PolygonItem&, const PolygonItem&) = default;
};
struct CircleItem {
  Vec2d centre;
  double radius;
  std::optional<Colour> fill;
  std::optional<Stroke> stroke;
  friend bool operator==(const CircleItem&, const CircleItem&) = default;
};
/// From angle `begin` to `end`, radians, clockwise on the screen from +x because y runs down.
struct ArcItem {
  Vec2d centre;
  double radius;
  double begin, end;
  Stroke stroke;
  friend bool operator==(const ArcItem&, const ArcItem&) = default;
};
enum class TextAnchor { start, middle, end };
/// One line of text. `at`: its left end, middle or right end, and the middle of its height.
struct TextItem {
  Vec2d at;
  std::string text;  ///< UTF-8
  double size;       ///< height of a line in pixels
  Colour colour;
  TextAnchor anchor = TextAnchor::start;
  std::optional<Colour> halo{};  ///< around each letter, so that it is read across what lies below
  friend bool operator==(const TextItem&, const TextItem&) = default;
};

using Shape2d = std::variant<LineItem, PolylineItem, PolygonItem, CircleItem, ArcItem, TextItem>;

struct DisplayItem {
  Shape2d shape;
  Target target{};  ///< what the item represents, if it can be pointed at
};

using DisplayList = std::vector<DisplayItem>;

/// The solid pieces of a dashed line, each {from, to}; the line itself if it is solid. More than `most` pieces are
/// returned as one solid line, so that long lines stay cheap.
[[nodiscard]] std::vector<std::array<Vec2d, 2>> dashes(const LineItem& line, int most = 4096);

/// Tip, left and right corner of a line's arrowhead; none if the line has none or no length.
[[nodiscard]] std::optional<std::array<Vec2d, 3>> arrowhead(const LineItem& line);

/// Upper bound of the width of a text in pixels, by a generous rule of thumb: the font is not known here.
[[nodiscard]] double text_width(std::string_view text, double size);

/// Distance in pixels from a point to what the item draws; 0 inside a filled area. Texts count as rectangles.
[[nodiscard]] double distance_to(const DisplayItem& item, const Vec2d& at);

/// Whether that distance is 0. Of a filled polygon this takes far less time than how far away it is.
[[nodiscard]] bool covers(const DisplayItem& item, const Vec2d& at);

/// Whether a point lies in the area that an outline of at least one corner encloses (by the even-odd rule), or on it.
[[nodiscard]] bool inside(const std::vector<Vec2d>& polygon, const Vec2d& at);

/// True when every number of the list is finite.
[[nodiscard]] bool is_finite(const DisplayList& list);

}  // namespace raywalk
