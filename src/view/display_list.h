#pragma once
// A drawing as data: vector graphics in pixels of a viewport, origin in its top left corner, x to the right, y down.
// Drawn in order, first at the bottom. The window, exported slides and tests all read the same list.

#include "math/vec.h"
#include "view/theme.h"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace raywalk {

/// Something of the plan that a person can point at.
enum class TargetKind {
  nothing,
  eye,              ///< drag: moves EYE and what it looks at, so the view keeps its direction
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
  ray,              ///< index: in Timeline::rays()
};

struct Target {
  TargetKind kind = TargetKind::nothing;
  int index = -1;
  int part = -1;
  friend bool operator==(const Target&, const Target&) = default;
  [[nodiscard]] explicit operator bool() const { return kind != TargetKind::nothing; }
};

struct Stroke {
  Colour colour;
  double width = 1;    ///< pixels
  DashPattern dash{};  ///< lengths in pixels, scaled already
  double phase = 0;    ///< how far into the pattern the line starts, in pixels: a clipped ray keeps its dashes in place
};

/// A straight line, with a filled arrowhead if `arrow` is above 0: its length in pixels, its tip at
/// from + arrow_at (to - from), pointing along the line.
struct LineItem {
  Vec2d from, to;
  Stroke stroke;
  double arrow = 0;
  double arrow_at = 1;
};
struct PolylineItem {
  std::vector<Vec2d> points;
  Stroke stroke;
};
/// Any simple polygon, also concave.
struct PolygonItem {
  std::vector<Vec2d> points;
  std::optional<Colour> fill;
  std::optional<Stroke> stroke;
};
struct CircleItem {
  Vec2d centre;
  double radius;
  std::optional<Colour> fill;
  std::optional<Stroke> stroke;
};
/// From angle `begin` to `end`, radians, clockwise on the screen from +x because y runs down.
struct ArcItem {
  Vec2d centre;
  double radius;
  double begin, end;
  Stroke stroke;
};
enum class TextAnchor { start, middle, end };
/// One line of text. `at`: its left end, middle or right end, and the middle of its height.
struct TextItem {
  Vec2d at;
  std::string text;  ///< UTF-8
  double size;       ///< height of a line in pixels
  Colour colour;
  TextAnchor anchor = TextAnchor::start;
};

using Shape2d = std::variant<LineItem, PolylineItem, PolygonItem, CircleItem, ArcItem, TextItem>;

struct DisplayItem {
  Shape2d shape;
  Target target{};  ///< what the item stands for, if it can be pointed at
};

using DisplayList = std::vector<DisplayItem>;

/// The solid pieces of a dashed line, each {from, to}; the line itself when it is solid. Few enough to draw whatever
/// the line's length: more than `most` pieces are given as one solid line.
[[nodiscard]] std::vector<std::array<Vec2d, 2>> dashes(const LineItem& line, int most = 4096);

/// Tip, left and right corner of a line's arrowhead; none when the line has none or is shorter than nothing.
[[nodiscard]] std::optional<std::array<Vec2d, 3>> arrowhead(const LineItem& line);

/// Width in pixels that a text takes at most, by a generous rule of thumb: no font is known here.
[[nodiscard]] double text_width(std::string_view text, double size);

/// Distance in pixels from a point to what the item draws; 0 inside a filled area. Texts are their rectangle.
[[nodiscard]] double distance_to(const DisplayItem& item, const Vec2d& at);

/// True when every number of the list is finite.
[[nodiscard]] bool is_finite(const DisplayList& list);

}  // namespace raywalk
