#pragma once
// The views in space: the 3-D picture and the scene as lines.

#include "scene/scene.h"
#include "view/fields.h"
#include "view/room.h"

#include <optional>

namespace raywalk {

/// The views that can be turned by hand.
enum class SpaceView {
  image,  ///< the 3-D picture
  lines,  ///< the scene as lines in space, instead of the plan
};
template <>
inline constexpr Word<SpaceView> words_of<SpaceView>[] = {{SpaceView::image, "image"}, {SpaceView::lines, "lines"}};

}  // namespace raywalk

namespace raywalk::action {

/// Walks this pixel of the picture, as currently seen: to its end, with its tree; if it is on the strip: goes there.
struct WalkPixel {
  static constexpr std::string_view word = "walk-pixel";
  int column = 0, row = 0;
  ImageSize size{};  ///< of the picture
  static void fields(auto& f, auto& a) { f(a.column), f(a.row), f(a.size); }
  void apply(State& state) const;
};
/// Back to SCREEN.
struct WalkStrip {
  static constexpr std::string_view word = "walk-strip";
  void apply(State& state) const;
};
struct Orbit {
  static constexpr std::string_view word = "orbit";
  SpaceView view;
  Vec2d angles;  ///< radians: see orbited
  static void fields(auto& f, auto& a) { f(a.view), f(a.angles); }
  void apply(State& state) const;
};
struct Shift {
  static constexpr std::string_view word = "shift";
  SpaceView view;
  Vec2d parts;  ///< of the view's width, to the right and down
  static void fields(auto& f, auto& a) { f(a.view), f(a.parts); }
  void apply(State& state) const;
};
struct Approach {
  static constexpr std::string_view word = "approach";
  SpaceView view;
  double factor;
  static void fields(auto& f, auto& a) { f(a.view), f(a.factor, Number::positive); }
  void apply(State& state) const;
};
struct ResetView {
  static constexpr std::string_view word = "reset-view";
  SpaceView view;
  static void fields(auto& f, auto& a) { f(a.view); }
  void apply(State& state) const;
};
/// The picture's camera becomes the scene's; one undo entry.
struct UseImageCamera {
  static constexpr std::string_view word = "use-camera";
  void apply(State& state) const;
};
struct ShowLines {
  static constexpr std::string_view word = "lines";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// The scene as lines in space.
struct SpaceRoom {
  using Actions = Types<action::WalkPixel, action::WalkStrip, action::Orbit, action::Shift, action::Approach,
                        action::ResetView, action::UseImageCamera, action::ShowLines>;
  static Commands commands();
  static constexpr Layer layer = Layer::over_rays;
  static void draw_in_plan(Painter& painter);

  std::optional<Camera> lines_camera;        ///< absent: shows the whole scene
  std::optional<bool> lines_wanted;          ///< chosen by hand; absent: lines if the plan cannot show the walk
  SpaceView turned_last = SpaceView::image;  ///< or selected last: what the keys turn
};

}  // namespace raywalk
