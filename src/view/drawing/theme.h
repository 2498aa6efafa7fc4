#pragma once
// Colours and line styles. Rays differ in three ways at once (colour, dash pattern, width of the current one), so that
// colour alone never matters; the colours are those of M. Okabe and K. Ito, "Color Universal Design" (2008), whose
// yellow is invisible on white and is replaced in the light theme.

#include "math/vec.h"
#include "math/words.h"
#include "scene/scene.h"
#include "trace/event.h"

#include <array>
#include <cstdint>

namespace raywalk {

/// A display colour: sRGB, not premultiplied.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend bool operator==(const Colour&, const Colour&) = default;

  [[nodiscard]] constexpr Colour with_alpha(int alpha) const { return {r, g, b, static_cast<std::uint8_t>(alpha)}; }
};

/// Linear light for display: clamped, encoded like a scene's pictures, else in sRGB; NaN is magenta.
[[nodiscard]] Colour display_colour(const Rgbd& linear, Encoding encoding = Encoding::srgb);
/// a + t (b - a) in sRGB; t in 0..1.
[[nodiscard]] Colour mix(Colour a, Colour b, double t);

enum class Theme {
  dark,
  projector,  ///< light and large, for lit rooms and distant viewers
};
template <>
inline constexpr Word<Theme> words_of<Theme>[] = {{Theme::dark, "dark"}, {Theme::projector, "projector"}};

/// Alternating lengths of dashes and gaps, in pixels before scaling; count 0: solid.
struct DashPattern {
  std::array<double, 4> lengths{};
  int count = 0;
  friend bool operator==(const DashPattern&, const DashPattern&) = default;
};

struct RayStyle {
  Colour colour;
  DashPattern dash;  ///< primary solid, shadow short dashes, reflect long dashes, refract dash and dot
};

struct Palette {
  Colour window;          ///< behind everything
  Colour plan;            ///< background of the plan
  Colour panel;           ///< background of code, tree and stack
  Colour text, dim_text;  ///< on any of the three
  Colour grid;            ///< faint lines of the plan
  Colour ink;             ///< outlines of EYE, SCREEN and objects
  Colour empty_cell;      ///< a cell of SCREEN without its final shade
  Colour light;           ///< sun symbols
  Colour normal;          ///< normals at hits
  Colour handle;          ///< what can be dragged
  Colour selected, hovered;
  Colour just_run;  ///< background of the line that has just run, behind `text`
  Colour next;      ///< outline of the line that runs next
  Colour error;     ///< notices that report a failure
};

[[nodiscard]] const Palette& palette(Theme theme);
[[nodiscard]] const RayStyle& ray_style(Theme theme, RayKind kind);

/// Scale of the theme's lines and letters relative to the dark theme.
[[nodiscard]] double theme_scale(Theme theme);

}  // namespace raywalk
