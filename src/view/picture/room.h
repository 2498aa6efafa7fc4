#pragma once
// The 3-D picture and its settings.

#include "render/heat.h"
#include "scene/scene.h"
#include "view/fields.h"
#include "view/room.h"

#include <cstdint>
#include <optional>

namespace raywalk {

/// Settings of the 3-D picture, not stored in the scene's file.
struct ImageSettings {
  AcceleratorKind accelerator{};           ///< automatic
  bool single_precision = false;           ///< 24-bit mantissas instead of 53, also for the walk
  int samples = 16;                        ///< final number per pixel, 1..max_image_samples
  std::optional<Integrator> integrator{};  ///< absent: the scene's own
  int walk_samples = 1;                    ///< per walked pixel, 1..max_walk_samples
  Heat heat = Heat::none;
  friend bool operator==(const ImageSettings&, const ImageSettings&) = default;
};
inline constexpr int max_image_samples = 1024, max_walk_samples = 256;

}  // namespace raywalk

namespace raywalk::action {

struct SetImageSettings {
  static constexpr std::string_view word = "image-settings";
  ImageSettings settings;
  static void fields(auto& f, auto& a) {
    auto& s = a.settings;
    f(s.accelerator), f(s.single_precision, float_or_double), f(s.samples), f(s.walk_samples), f(s.heat);
    f(s.integrator);
  }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};

/// The ray tree of the current pixel beside the picture, so that one can click pixel after pixel.
struct ShowTreeBeside {
  static constexpr std::string_view word = "tree-beside";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// The 3-D picture.
struct PictureRoom {
  using Actions = Types<action::SetImageSettings, action::ShowTreeBeside>;
  static constexpr Tab tab{"image", true};
  static void draw_tab(const Ui& ui, const Rect& where, TabContext& context);
  static Commands commands();

  std::optional<Camera> camera;  ///< its own; absent: the scene's
  ImageSettings settings;
  bool tree_beside = true;     ///< in Trace
  std::uint64_t revision = 0;  ///< changes with every change of `camera` and `settings`
};

}  // namespace raywalk
