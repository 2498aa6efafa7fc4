// The commands and keys of prediction; its banner is in gui/banner.cpp.

#include "gui/command.h"
#include "gui/panes.h"
#include "view/walk/asked.h"

namespace raywalk {

bool guess_by_key(const KeyPress& press, const Ui& ui) {
  const State& state = ui.state;
  const bool up = press.key == "Up";
  if ((!up && press.key != "Down") || press.ctrl || press.alt || state.walk.mode != Mode::trace) return false;
  constexpr double degrees = 5, fine = 1;
  if (aim_origin(state)) {
    ui.act(action::TurnGuess{(up ? 1 : -1) * (press.shift ? fine : degrees)});
  } else if (const auto asked = prediction_asked(state); asked && asked->what == PredictionKind::end) {
    ui.act(action::NextGuess{up ? -1 : 1});
  } else {
    return false;
  }
  return true;
}

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
