// The command of live rays.

#include "gui/command.h"

#include <string>

namespace raywalk {

namespace {

std::string live_label(const State& state, bool) {
  const std::string_view now = state.live.rays == LiveRays::off     ? "live.off"
                               : state.live.rays == LiveRays::pixel ? "live.pixel"
                                                                    : "live.strip";
  return fill("command.live.label", state.appearance.language) + ": " + fill(now, state.appearance.language);
}

LiveRays after(LiveRays rays) {
  return rays == LiveRays::off ? LiveRays::pixel : rays == LiveRays::pixel ? LiveRays::strip : LiveRays::off;
}

}  // namespace

Commands LiveRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "live", .keys = {"Shift+M"}, .section = Section::rays, .label = live_label,
       .run = [](const Ui& ui) { ui.act(action::SetLiveRays{after(ui.state.live.rays)}); }},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
