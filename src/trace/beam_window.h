#pragma once
// What is seen from one point, as polygons of a window through which it is seen. The direction to a place (u, v) of the
// window is corner + u right + v down, so that whatever depends on directions linearly is a line in the window: an edge
// of a face, the line in which two planes cross, the edge of a shadow on a plane. A plane is reached at a t whose
// inverse is linear, too, so that where one face begins to hide another one is a line as well.
//
// Windows are cut, never faces: both halves share the places where a line cuts them, and together are what was cut.

#include "math/vec.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace raywalk {

/// The places (u, v) where a u + b v + c is 0; where it is more, they lie inside.
struct WindowLine {
  double a = 0, b = 0, c = 0;
  double slack = 0;  ///< what is as near to 0 lies on the line: rounding may have moved it

  [[nodiscard]] double at(const Vec2d& place) const { return a * place.x + b * place.y + c; }
  /// Of a line that says how near something is, as 1 / distance: towards a horizon it may be farther than a number
  /// says.
  [[nodiscard]] double nearness(const Vec2d& place) const {
    return std::max({at(place), slack, std::numeric_limits<double>::min()});
  }
};

/// A convex polygon of a window; with less than three corners it is empty.
using WindowPiece = std::vector<Vec2d>;

/// On which sides of a line a piece lies, but for places on the line.
struct WindowSides {
  bool inside = false, outside = false;
};
[[nodiscard]] WindowSides sides_of(const WindowPiece& piece, const WindowLine& line);

struct WindowHalves {
  WindowPiece inside, outside;
};
/// A piece that lies all on the line, as thin as rounding, is outside.
[[nodiscard]] WindowHalves halves_of(const WindowPiece& piece, const WindowLine& line);

[[nodiscard]] double area_of(const WindowPiece& piece);
/// Its centroid.
[[nodiscard]] Vec2d middle_of(const WindowPiece& piece);

/// A plane: where the normal, of any length, times x is `offset`.
struct BeamPlane {
  Vec3d normal{0.0};
  double offset = 0;

  /// Positive on the side that the normal points to.
  [[nodiscard]] double above(const Vec3d& point) const { return dot(normal, point) - offset; }
};

/// An eye, or its image in mirrors, and the directions to the places of its window.
struct BeamView {
  Vec3d eye{0.0}, corner{0.0}, right{0.0}, down{0.0};
  double extent = 1;  ///< the largest coordinate of the window

  [[nodiscard]] Vec3d direction(const Vec2d& place) const { return corner + place.x * right + place.y * down; }
  /// Where a vector times the direction is 0; inside it is positive. `scale`: what the vector's components were
  /// computed from, by their size.
  [[nodiscard]] WindowLine line(const Vec3d& vector, double scale) const;
  /// 1 / t of what is seen of a plane: negative behind the eye. No line where the eye lies in the plane.
  [[nodiscard]] WindowLine nearness(const BeamPlane& plane) const;
  /// Where what is seen of `on` lies above a plane; inside it does. The eye does not lie in `on`.
  [[nodiscard]] WindowLine above(const BeamPlane& plane, const BeamPlane& on) const;
  /// In a mirror, through the same window. `normal`: unit length.
  [[nodiscard]] BeamView mirrored(const BeamPlane& mirror) const;
};

}  // namespace raywalk
