// The band: SCREEN's cells, large.
#include "view/band/band.h"

#include <algorithm>

#include "fixtures.h"
#include "support/catch.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr double band_wide = 700, band_tall = 58;

DisplayList drawn(const State& state, int pointed_at = -1) {
  return band_view(state, band_wide, band_tall, 1, pointed_at);
}

std::vector<std::string> texts(const DisplayList& list) {
  std::vector<std::string> said;
  for (const DisplayItem& item : list)
    if (const auto* text = std::get_if<TextItem>(&item.shape)) said.push_back(text->text);
  return said;
}

}  // namespace

TEST_CASE("the band has every cell of SCREEN with its number, in the shade that SCREEN shows") {
  State state = classic_state();
  update(state, action::JumpToCell{7});
  const int cells = state.scene().camera.screen.cells;
  const DisplayList list = drawn(state), screen = plan_view(state);
  const std::vector<std::string> said = texts(list);
  for (int cell = 0; cell < cells; ++cell) {
    CHECK(std::count(said.begin(), said.end(), std::to_string(cell)) == 1);
    const auto large = items_of(list, {TargetKind::cell, cell}), small = items_of(screen, {TargetKind::cell, cell});
    REQUIRE(large.size() == 1);
    CHECK(std::get<PolygonItem>(large.front().shape).fill == std::get<PolygonItem>(small.front().shape).fill);
    const auto& points = std::get<PolygonItem>(large.front().shape).points;
    CHECK(band_cell_at(state, band_wide, band_tall, 1, (points[0] + points[2]) / 2.0) == cell);
  }
  CHECK(band_cell_at(state, band_wide, band_tall, 1, {-3, 10}) == -1);
}

TEST_CASE("below the band stand the numbers of the pixel under way, or of the one pointed at") {
  State state = classic_state();
  update(state, action::JumpToCell{7});
  CHECK(texts(drawn(state)).back().find("7") != std::string::npos);
  const std::string done = texts(drawn(state, 3)).back(), open = texts(drawn(state, 12)).back();
  const Rgbd shade = *shades_shown(state)[3];
  CHECK(done.find(colour_text(shade, state.appearance.language)) != std::string::npos);
  CHECK(open.find("12") != std::string::npos);
}

TEST_CASE("with many cells, some have numbers, and none covers another") {
  Scene scene = classic_state().scene();
  scene.camera.screen.cells = 401;
  State state = state_of(scene);
  const DisplayList list = drawn(state);
  double last = -1e9;
  int numbers = 0;
  for (const DisplayItem& item : list)
    if (const auto* text = std::get_if<TextItem>(&item.shape); text != nullptr && text->anchor == TextAnchor::middle) {
      const double half = text_width(text->text, text->size) / 2;
      CHECK(text->at.x - half > last);
      last = text->at.x + half;
      ++numbers;
    }
  CHECK(numbers > 5);
}
