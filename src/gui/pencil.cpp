#include "gui/command.h"
#include "view/state.h"

namespace raywalk {

Commands PencilRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "pencils", .keys = {"Shift+B"}, .section = Section::show,
       .chosen = [](const State& state) { return state.pencil.shown; }, .turn = turn<action::ShowPencils>},
      {.name = "neighbours", .keys = {"Shift+Y"}, .section = Section::show,
       .chosen = [](const State& state) { return state.pencil.neighbours; }, .turn = turn<action::ShowNeighbours>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
