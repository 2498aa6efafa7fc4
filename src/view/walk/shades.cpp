#include "view/walk/walk.h"

namespace raywalk {

std::vector<std::optional<Rgbd>> shades_shown(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const int position = position_shown(state);
  std::vector<std::optional<Rgbd>> shades(static_cast<std::size_t>(state.scene().camera.screen.cells));
  for (std::size_t i = 0; timeline.of_strip() && i < timeline.pixels().size(); ++i) {
    const PixelRecord& pixel = timeline.pixels()[i];
    if (!timeline.pixel_done(static_cast<int>(i), position)) continue;
    if (pixel.column >= 0 && pixel.column < static_cast<int>(shades.size()))
      shades[static_cast<std::size_t>(pixel.column)] = pixel.mean;
  }
  return shades;
}

}  // namespace raywalk
