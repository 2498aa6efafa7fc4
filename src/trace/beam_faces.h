#pragma once
// Flat convex faces as beams see them: which of them, and in whose shadow (of a scene: trace/beam_scene.h).

#include "accel/query.h"
#include "accel/wide_tree.h"
#include "math/stop.h"
#include "trace/beam_window.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace raywalk {

struct BeamFace {
  std::vector<Vec3d> outline;  ///< counter-clockwise about the normal; empty where it has no end
  BeamPlane plane;             ///< its normal has unit length
  int primitive = 0, part = 0, object = 0;
  bool is_flat = true;  ///< it is the surface itself, and not a piece that stands for a round one
};

/// Where faces may be met: above all of some planes.
struct BeamRegion {
  std::vector<BeamPlane> sides;
  Vec3d eye{0.0}, axis{0.0};  ///< nearer ones, along the axis, come first
};

class BeamFaces {
 public:
  /// `stop` may cancel it, which then throws Stopped.
  explicit BeamFaces(std::vector<BeamFace> faces, const Stop& stop = {});

  [[nodiscard]] int size() const { return static_cast<int>(faces_.size()); }
  [[nodiscard]] const BeamFace& operator[](int i) const { return faces_[static_cast<std::size_t>(i)]; }
  /// Farther from an eye than every corner.
  [[nodiscard]] double far_from(const Vec3d& eye) const;

  /// Calls use(face) with those that may lie in a region: all that do, and some that narrowly do not. It returns how
  /// far along the axis others may still matter. `stop` is checked before each.
  template <class Use>
  void visit(const BeamRegion& region, const Stop& stop, const Use& use) const;

 private:
  struct Waiting {
    TreeChild child;
    double near;
  };
  /// How near the box begins along the region's axis; nothing where it lies outside.
  [[nodiscard]] static std::optional<double> nearest_of(const BeamRegion& region, const Bounds<float>& box);

  std::vector<BeamFace> faces_;
  std::vector<int> endless_;
  WideTree tree_;
};

template <class Use>
void BeamFaces::visit(const BeamRegion& region, const Stop& stop, const Use& use) const {
  double far = infinity<double>;
  const auto meet = [&](int face) {
    stop.check();
    far = use(face);
  };
  for (const int face : endless_) meet(face);
  if (tree_.empty()) return;
  std::array<Waiting, (tree_width - 1) * WideTree::most_levels + tree_width> stack;
  std::size_t waiting = 1;
  stack[0] = {TreeChild::node(0), -infinity<double>};
  while (waiting > 0) {
    const Waiting at = stack[--waiting];
    if (at.near > far) continue;
    if (at.child.is_leaf()) {
      const std::int32_t* faces = tree_.listed(at.child.index());
      for (std::uint32_t i = 0; i < at.child.count(); ++i) meet(faces[i]);
      continue;
    }
    const WideNode& node = tree_.nodes()[at.child.index()];
    const std::size_t first = waiting;
    for (unsigned lane = 0; lane < node.count; ++lane) {
      const std::optional<double> near = nearest_of(region, node.box(lane));
      if (!near) continue;
      std::size_t place = waiting++;
      for (; place > first && stack[place - 1].near < *near; --place) stack[place] = stack[place - 1];
      stack[place] = {node.children[lane], *near};
    }
  }
}

/// A part of a window, and the face that is seen in it; -1 where that is none.
struct SeenFace {
  WindowPiece window;
  int face = -1;
  WindowLine nearness{};  ///< of the face
};

/// What is seen through a window: its parts, which are the window together. Of faces in the same place the one of the
/// lower primitive is seen. `beyond`: what lies below that plane is not there. `stop` may cancel this, and the next
/// two, which then throw Stopped: of one pixel they may have thousands of faces to look at.
///
/// E. Catmull, "An analytic visible surface algorithm for independent pixel processing", SIGGRAPH 1984, with the
/// polygons of K. Weiler and P. Atherton, "Hidden surface removal using polygon area sorting", SIGGRAPH 1977: each face
/// takes from those before it where it is nearer, in any order.
[[nodiscard]] std::vector<SeenFace> faces_seen(const BeamFaces& faces, const BeamView& view, const WindowPiece& window,
                                               const BeamPlane* beyond = nullptr, const Stop& stop = {});

/// Where light comes from: a point, or a direction of unit length towards it.
struct BeamLight {
  Vec3d place{0.0};
  bool is_distant = false;
};

/// A part of a window, and whether something stops light on its way there, or only weakens it.
struct LitPiece {
  WindowPiece window;
  bool stopped = false, weakened = false;
};

/// Where on a face, seen in a part of a window, the shadows of others lie: its parts. `role(primitive)`: what each does
/// to light. A round body casts no shadow on itself: there its own normals say where light ends.
template <class Role>
[[nodiscard]] std::vector<LitPiece> shadows_on(const BeamFaces& faces, const BeamView& view, const SeenFace& seen,
                                               const BeamLight& light, const Role& role, const Stop& stop = {});

/// What of a light is seen that is a window itself: the view's corner, right and down are its corner and sides, less
/// the eye.
template <class Role>
[[nodiscard]] std::vector<LitPiece> open_light(const BeamFaces& faces, const BeamView& view, const WindowPiece& window,
                                               const BeamFace& from, bool from_inside, const Role& role,
                                               const Stop& stop = {});

namespace detail {

/// Calls use(from, to) with the ends of each side.
template <class Use>
void for_each_side(const BeamFace& face, const Use& use) {
  for (std::size_t i = 0; i < face.outline.size(); ++i)
    use(face.outline[i], face.outline[i + 1 == face.outline.size() ? 0 : i + 1]);
}

/// Keeps of `pieces` what is inside of all lines, as one that `use` changes; the rest as it was.
template <class Piece, class Use>
void take(std::vector<Piece>& pieces, std::size_t which, const std::vector<WindowLine>& lines, const Use& use) {
  for (const WindowLine& line : lines)
    if (!sides_of(pieces[which].window, line).inside) return;
  WindowPiece inside = pieces[which].window;
  std::vector<WindowPiece> outside;
  for (const WindowLine& line : lines) {
    WindowHalves halves = halves_of(inside, line);
    if (halves.inside.empty()) return;
    if (!halves.outside.empty()) outside.push_back(std::move(halves.outside));
    inside = std::move(halves.inside);
  }
  for (WindowPiece& window : outside) {
    Piece rest = pieces[which];
    rest.window = std::move(window);
    pieces.push_back(std::move(rest));
  }
  pieces[which].window = std::move(inside);
  use(pieces[which]);
}

/// Whether light on its way to the first may meet the second. A round body, which is convex, hides none from its own
/// outside, and what stands for it must not, for it is shaded as what is round.
[[nodiscard]] inline bool is_hidden_by(const BeamFace& face, bool from_inside, const BeamFace& other) {
  return &face != &other && (other.is_flat || from_inside || face.primitive != other.primitive);
}
inline void darken(LitPiece& piece, ShadowRole does) {
  if (does != ShadowRole::ignored) (does == ShadowRole::filters ? piece.weakened : piece.stopped) = true;
}
/// What lies inside of all lines is in the shadow of what does this to light.
inline void darken(std::vector<LitPiece>& pieces, const std::vector<WindowLine>& lines, ShadowRole does) {
  if (lines.empty() || does == ShadowRole::ignored) return;
  for (std::size_t i = 0, before = pieces.size(); i < before; ++i)
    if (!pieces[i].stopped && !(pieces[i].weakened && does == ShadowRole::filters))
      take(pieces, i, lines, [&](LitPiece& piece) { darken(piece, does); });
}

/// The edges of a face, seen from an eye that does not lie in its plane.
void add_edges(std::vector<WindowLine>& lines, const BeamView& view, const BeamFace& face);
/// What a light cannot see of a plane for a face, seen in a window.
void add_shadow(std::vector<WindowLine>& lines, const BeamView& view, const BeamPlane& on, const BeamLight& light,
                const BeamFace& face);
/// Between the places of a window on a plane and a light.
[[nodiscard]] BeamRegion region_to(const BeamLight& light, const BeamView& view, const SeenFace& seen,
                                   const BeamPlane& on);
/// Seen through a window.
[[nodiscard]] BeamRegion region_of(const BeamView& view, const WindowPiece& window);
/// Whether an eye lies in the plane of a face, as far as rounding tells.
[[nodiscard]] bool is_edge_on(const Vec3d& eye, const BeamPlane& plane);

}  // namespace detail

template <class Role>
std::vector<LitPiece> shadows_on(const BeamFaces& faces, const BeamView& view, const SeenFace& seen,
                                 const BeamLight& light, const Role& role, const Stop& stop) {
  const BeamFace& receiver = faces[seen.face];
  const bool from_inside = receiver.plane.above(view.eye) < 0;
  std::vector<LitPiece> pieces{{seen.window}};
  const BeamPlane& on = receiver.plane;
  // What is round may still be shaded as if it faced a light that lies behind the face that stands for it.
  if (from_inside && !receiver.is_flat && (light.is_distant ? dot(on.normal, light.place) : on.above(light.place)) > 0)
    detail::darken(pieces[0], role(receiver.primitive));
  std::vector<WindowLine> lines;
  faces.visit(detail::region_to(light, view, seen, on), stop, [&](int id) {
    if (!detail::is_hidden_by(receiver, from_inside, faces[id])) return infinity<double>;
    lines.clear();
    detail::add_shadow(lines, view, on, light, faces[id]);
    detail::darken(pieces, lines, role(faces[id].primitive));
    return infinity<double>;
  });
  return pieces;
}

template <class Role>
std::vector<LitPiece> open_light(const BeamFaces& faces, const BeamView& view, const WindowPiece& window,
                                 const BeamFace& from, bool from_inside, const Role& role, const Stop& stop) {
  std::vector<LitPiece> pieces{{window}};
  std::vector<WindowLine> lines;
  if (from_inside && !from.is_flat) detail::darken(pieces, {view.line(from.plane.normal, 1)}, role(from.primitive));
  faces.visit(detail::region_of(view, window), stop, [&](int id) {
    const BeamFace& face = faces[id];
    if (!detail::is_hidden_by(from, from_inside, face) || detail::is_edge_on(view.eye, face.plane))
      return infinity<double>;
    // A place of what is round lies outside of the faces about it that stand for it.
    if (!face.is_flat && face.primitive == from.primitive && face.plane.above(view.eye) > 0) return infinity<double>;
    lines.clear();
    lines.push_back(view.nearness(face.plane));
    lines.back().c -= 1;  // before the light, which is at t = 1
    detail::add_edges(lines, view, face);
    detail::darken(pieces, lines, role(face.primitive));
    return infinity<double>;
  });
  return pieces;
}

}  // namespace raywalk
