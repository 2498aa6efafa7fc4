#include "view/drawing/theme.h"

#include "image/srgb.h"

#include <cmath>

namespace raywalk {

Colour display_colour(const Rgbd& linear, Encoding encoding) {
  if (std::isnan(linear.x) || std::isnan(linear.y) || std::isnan(linear.z)) return {255, 0, 255};
  const Rgb<float> c(linear);
  return {to_byte(c.x, encoding), to_byte(c.y, encoding), to_byte(c.z, encoding)};
}

Colour mix(Colour a, Colour b, double t) {
  const auto between = [t](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + t * (to - from)));
  };
  return {between(a.r, b.r), between(a.g, b.g), between(a.b, b.b), between(a.a, b.a)};
}

namespace {

constexpr Palette dark_palette{
    .window = {24, 27, 33},
    .plan = {17, 20, 26},
    .panel = {30, 34, 42},
    .text = {232, 234, 238},
    .dim_text = {156, 163, 175},
    .grid = {36, 41, 51},
    .ink = {200, 205, 214},
    .empty_cell = {46, 52, 64},
    .light = {255, 231, 150},
    .normal = {235, 235, 235},
    .handle = {240, 242, 246},
    .selected = {255, 255, 255},
    .hovered = {124, 200, 255},
    .just_run = {30, 84, 140},
    .next = {124, 200, 255},
    .error = {255, 138, 120},
};

constexpr Palette projector_palette{
    .window = {240, 240, 240},
    .plan = {255, 255, 255},
    .panel = {250, 250, 250},
    .text = {10, 10, 10},
    .dim_text = {84, 84, 84},
    .grid = {228, 230, 234},
    .ink = {40, 40, 40},
    .empty_cell = {214, 218, 224},
    .light = {196, 116, 0},
    .normal = {60, 60, 60},
    .handle = {20, 20, 20},
    .selected = {0, 0, 0},
    .hovered = {0, 100, 190},
    .just_run = {255, 214, 102},
    .next = {0, 100, 190},
    .error = {176, 20, 0},
};

constexpr DashPattern solid{};
constexpr DashPattern short_dash{{4, 4}, 2};
constexpr DashPattern long_dash{{14, 5}, 2};
constexpr DashPattern dash_dot{{11, 4, 2, 4}, 4};
constexpr DashPattern dots{{2, 4}, 2};

// Okabe and Ito's yellow, reddish purple, orange and sky blue on dark; on white their bluish green instead of the
// yellow, and the darker of each pair: a darker purple, vermillion and blue.
constexpr RayStyle dark_primary{{240, 228, 66}, solid}, dark_shadow{{204, 121, 167}, short_dash},
    dark_reflect{{230, 159, 0}, long_dash}, dark_refract{{86, 180, 233}, dash_dot}, dark_photon{{255, 231, 150}, dots},
    dark_beam{{0, 186, 138}, solid};
constexpr RayStyle light_primary{{0, 128, 92}, solid}, light_shadow{{150, 60, 120}, short_dash},
    light_reflect{{213, 94, 0}, long_dash}, light_refract{{0, 114, 178}, dash_dot}, light_photon{{196, 116, 0}, dots},
    light_beam{{0, 128, 92}, solid};

}  // namespace

const Palette& palette(Theme theme) {
  switch (theme) {
    case Theme::dark:
      return dark_palette;
    case Theme::projector:
      return projector_palette;
  }
  return dark_palette;
}

const RayStyle& ray_style(Theme theme, RayKind kind) {
  const bool dark = theme == Theme::dark;
  switch (kind) {
    case RayKind::primary:
      return dark ? dark_primary : light_primary;
    case RayKind::shadow:
      return dark ? dark_shadow : light_shadow;
    case RayKind::reflect:
      return dark ? dark_reflect : light_reflect;
    case RayKind::refract:
      return dark ? dark_refract : light_refract;
    case RayKind::photon:
      return dark ? dark_photon : light_photon;
    case RayKind::beam:
      return dark ? dark_beam : light_beam;
  }
  return dark_primary;
}

double theme_scale(Theme theme) {
  switch (theme) {
    case Theme::dark:
      return 1;
    case Theme::projector:
      return 1.25;
  }
  return 1;
}

}  // namespace raywalk
