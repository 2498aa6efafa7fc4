// The commands of prediction; its banner is in gui/banner.cpp.

#include "gui/command.h"

namespace raywalk {

Commands PredictRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "predict", .keys = {"Ctrl+P"}, .section = Section::learn, .line = "keys.predict",
       .chosen = [](const State& state) { return state.predictions.on; }, .turn = turn<action::SetPredictions>},
      {.name = "save-predictions", .keys = {"Ctrl+Shift+P"}, .section = Section::save, .line = "keys.predict",
       .run = act<action::AskSavePredictions>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
