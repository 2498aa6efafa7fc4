#pragma once
// What a beam of light rays from an eye meets in the plan: P. Heckbert and P. Hanrahan, "Beam Tracing Polygonal
// Objects", SIGGRAPH 1984, in two dimensions, where K. Weiler and P. Atherton's clipping of what is farther away by
// what is nearer is a division of the pixel's width.
//
// A mirror that is straight shows the plan reflected, so that a mirrored beam is a beam of the same rays from the same
// eye, through the mirror, into a reflected plan: it is unfolded, and a place in the pixel is a place in every beam
// that comes of it.
//
// Where something begins or ends to be seen is the root of a linear or quadratic equation, whose coefficients are
// computed exactly. A root is rounded once, to a multiple of 2^-104 of the pixel's width; what is seen between two
// neighbouring ones is decided there to about 100 bits, and what is nearer than that is one place. Every part begins
// where the one before it ends, so that widths, taken exactly, add up to exactly 1.

#include "math/expansion.h"
#include "math/stop.h"
#include "trace/outlines.h"

#include <optional>
#include <vector>

namespace raywalk {

/// A place in the width of a pixel, 0..1: the sum of a multiple of 2^-52 and a smaller one of 2^-104.
struct Place {
  double high = 0, low = 0;
  [[nodiscard]] double value() const { return high + low; }
  friend bool operator==(const Place&, const Place&) = default;
};
/// The width between two places, rounded once.
[[nodiscard]] inline double operator-(const Place& to, const Place& from) {
  return (to.high - from.high) + (to.low - from.low);  // both differences are exact
}
[[nodiscard]] inline bool operator<(const Place& a, const Place& b) { return b - a > 0; }
[[nodiscard]] Place middle(const Place& a, const Place& b);

/// The rays of a pixel: from the eye in the directions between these two, which are not opposite to each other. The one
/// at a place x is begin + x (end - begin).
struct PixelFan {
  Vec2d begin, end;
  [[nodiscard]] Vec2d at(const Place& place) const { return begin + place.value() * (end - begin); }
};

/// What a beam sees between two places: one outline, or nothing.
struct BeamPart {
  Place begin, end;
  int outline = -1;  ///< index in the plan's outlines; -1: nothing
  [[nodiscard]] double width() const { return end - begin; }
  [[nodiscard]] Place middle() const { return raywalk::middle(begin, end); }
};

/// A light without extent, in the plan.
struct PlanLight {
  Vec2d place;  ///< or, of a distant light, the direction to it
  bool is_distant = false;
};

namespace detail {
struct ExactPoint {
  Expansion x, y;
};
/// The points X of a straight outline have normal . X = offset.
struct ExactLine {
  ExactPoint normal;
  Expansion offset;
};
}  // namespace detail

/// The outlines of a plan as an eye sees them, directly or by flat mirrors.
class UnfoldedPlan {
 public:
  /// `outlines` outlive this.
  UnfoldedPlan(const std::vector<Outline>& outlines, const Vec2d& eye);
  /// As it is seen beyond a straight outline that mirrors.
  [[nodiscard]] UnfoldedPlan mirrored(int outline) const;
  /// The same outlines as an eye sees them through a straight one: what lies beyond it, unreflected. By glass that
  /// bends its rays this is another eye than they come from.
  [[nodiscard]] UnfoldedPlan beyond(int outline, const Vec2d& eye) const;
  /// Whether a straight outline of another object lies upon this straight one, in part.
  [[nodiscard]] bool has_another_upon(int outline) const;

  /// What the rays between two places see, in parts that follow each other; each with another outline than its
  /// neighbours, or, of a circle, its other side. `stop` may cancel it, which then throws Stopped.
  [[nodiscard]] std::vector<BeamPart> cut(const PixelFan& fan, const Place& begin = {0, 0}, const Place& end = {1, 0},
                                          const Stop& stop = {}) const;

  /// Where a straight outline, which the rays between these places see, passes from light into shadow or back; in
  /// order. A superset: outlines that other outlines hide from the light are not left out, nor those behind.
  [[nodiscard]] std::vector<Place> shadow_edges(const PixelFan& fan, const BeamPart& part, const PlanLight& light,
                                                const Stop& stop = {}) const;
  /// Where the rays of a part pass points of its outline, or the point opposite; in order. Those of a part that are
  /// behind the eye or on a circle's other side are not left out.
  [[nodiscard]] std::vector<Place> places_of(const PixelFan& fan, const BeamPart& part,
                                             const std::vector<Vec2d>& points) const;

  // Rounded, in the plan itself.

  /// Where this ray starts: the eye, or the last mirror or glass.
  [[nodiscard]] Vec2d start(const Vec2d& direction) const;
  /// Its direction there, as long as it is at the eye.
  [[nodiscard]] Vec2d leaving(const Vec2d& direction) const;
  /// Where it meets what a part sees.
  [[nodiscard]] Vec2d end(const PixelFan& fan, const BeamPart& part, const Place& place) const;
  /// From where the beam seems to come: the eye, mirrored.
  [[nodiscard]] Vec2d virtual_eye() const;

 private:
  /// An outline relative to the eye, unfolded, times a positive number that is common to all.
  struct Seen {
    bool straight, endless;
    detail::ExactPoint from, to;  ///< of a side
    detail::ExactPoint normal;    ///< of a side or a wall: its points X have normal . X = offset
    Expansion offset;
    detail::ExactPoint centre;  ///< of a circle
    Expansion square;           ///< of its radius
    Vec2d low, high;            ///< a box around it, in the plan itself
  };
  /// A mirror, and what makes its reflection exact: points are multiplied by `size`, which is the square of the normal
  /// times a power of two. It keeps `scale_` in [1, 2), however long the mirror is and however many there are: what is
  /// computed with are its powers up to the twelfth.
  struct Mirror {
    int outline;
    detail::ExactLine line;
    Expansion size;
    double twice;  ///< 2, times that power of two
  };
  /// How far along a direction, in multiples of it: to a relative error of about 2^-96.
  using Distance = DoubleDouble;

  [[nodiscard]] Seen seen(const Outline& outline) const;
  /// Relative to the eye, as the mirrors show it, times `scale`, which this sets.
  [[nodiscard]] detail::ExactPoint unfolded(const Vec2d& point, bool is_direction, Expansion& scale) const;
  [[nodiscard]] std::vector<Place> breaks(const PixelFan& fan, const Stop& stop) const;
  [[nodiscard]] std::optional<Distance> distance(const Seen& outline, const detail::ExactPoint& direction,
                                                 const std::optional<Distance>& beyond, bool* far_side) const;
  struct Nearest {
    int outline = -1;
    bool far_side = false;  ///< of a circle
  };
  [[nodiscard]] Nearest nearest(const detail::ExactPoint& direction) const;
  [[nodiscard]] Vec2d folded(Vec2d point, bool is_direction) const;

  const std::vector<Outline>* outlines_;
  Vec2d eye_;
  std::vector<Mirror> mirrors_;  ///< from the eye on
  double scale_ = 1;             ///< the common number, rounded
  std::vector<Seen> seen_;
  std::optional<Seen> mirror_;  ///< the last one, as it is seen in those before; or a face of glass
  int mirror_outline_ = -1;     ///< its outline
};

}  // namespace raywalk
