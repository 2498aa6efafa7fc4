#include "view/action.h"
#include "view/band/band.h"
#include "view/text/text.h"
#include "view/walk/status.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

void action::ShowBand::apply(State& state) const { state.band.shown = shown; }

namespace {

/// Where the cells are.
struct Cells {
  double left, width;  ///< of all
  double top, height;
  int count;
  [[nodiscard]] double begin(int cell) const { return left + width * cell / count; }
};

Cells cells_of(const State& state, double width, double height, double unit) {
  const double margin = 14 * unit, top = 5 * unit, words = 19 * unit;
  return {margin, width - 2 * margin, top, height - 2 * top - words, state.scene().camera.screen.cells};
}

/// Black or white, whichever is farther from this shade.
Colour readable_over(Colour shade) {
  const int grey = 299 * shade.r + 587 * shade.g + 114 * shade.b;
  return grey > 128'000 ? Colour{0, 0, 0} : Colour{255, 255, 255};
}

}  // namespace

int band_cell_at(const State& state, double width, double height, double unit, const Vec2d& at) {
  const Cells cells = cells_of(state, width, height, unit);
  if (!(at.x >= cells.left && at.x < cells.left + cells.width && at.y >= 0 && at.y < height)) return -1;
  return std::clamp(static_cast<int>((at.x - cells.left) / cells.width * cells.count), 0, cells.count - 1);
}

DisplayList band_view(const State& state, double width, double height, double unit, int pointed_at) {
  DisplayList list;
  const Palette& colours = palette(state.appearance.theme);
  const Cells cells = cells_of(state, width, height, unit);
  if (!(cells.width > 0 && cells.height > 0)) return list;
  const std::vector<std::optional<Rgbd>> shades = shades_shown(state);
  const double edge = cells.width / cells.count, letters = 13 * unit;
  const auto box = [&](int cell, double out) {
    const double x0 = cells.begin(cell) - out, x1 = cells.begin(cell + 1) + out;
    const double y0 = cells.top - out, y1 = cells.top + cells.height + out;
    return std::vector<Vec2d>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  };
  // Every cell, or every fifth, tenth ... has its number.
  const double widest = text_width(std::to_string(cells.count - 1), letters) + 4 * unit;
  int every = 1;
  for (int factor = 5; every * edge < widest; factor = factor == 5 ? 2 : 5) every *= factor;
  for (int cell = 0; cell < cells.count; ++cell) {
    const std::optional<Rgbd>& shade = shades[static_cast<std::size_t>(cell)];
    const Colour fill = shade ? display_colour(*shade, state.scene().encoding) : colours.empty_cell;
    PolygonItem quad{box(cell, 0), fill, std::nullopt};
    if (edge >= 3 * unit) quad.stroke = Stroke{colours.ink.with_alpha(70), 0.6 * unit};
    list.push_back({quad, {TargetKind::cell, cell}});
    if (cell % every == 0)
      list.push_back({TextItem{{(cells.begin(cell) + cells.begin(cell + 1)) / 2, cells.top + cells.height / 2},
                               std::to_string(cell),
                               letters,
                               shade ? readable_over(fill) : colours.dim_text,
                               TextAnchor::middle}});
  }
  const int now = state.walk.mode == Mode::move ? (state.live.shown ? live_cell(state) : -1) : current_cell(state);
  const auto mark = [&](int cell, Colour colour, double thick) {
    if (cell < 0 || cell >= cells.count) return;
    list.push_back({PolygonItem{box(cell, 1.5 * unit), std::nullopt, Stroke{colour, thick * unit}}});
  };
  mark(now, colours.next, 3);
  mark(pointed_at, colours.hovered, 2);

  const int told = pointed_at >= 0 ? pointed_at : now;
  const std::string words = told < 0
                                ? std::string(text(state.walk.mode == Mode::move ? "band.in_move" : "band.in_trace",
                                                   state.appearance.language))
                                : cell_text(state, told, shades[static_cast<std::size_t>(told)]);
  list.push_back({TextItem{{cells.left, height - 12 * unit},
                           words,
                           14 * unit,
                           told < 0 ? colours.dim_text : colours.text,
                           TextAnchor::start}});
  return list;
}

}  // namespace raywalk
