// The commands of the walk.

#include "view/walk/walk.h"
#include "gui/command.h"

namespace raywalk {

namespace {

bool goes_on(const State& state) { return state.walk.position < state.walk.timeline->steps(); }
bool goes_back(const State& state) { return state.walk.position > 0 || state.walk.playing; }

/// By pixels, a walk of the picture's goes on with the next one.
template <bool forward>
bool goes_by_pixels(const State& state) {
  return (forward ? goes_on(state) : goes_back(state)) || neighbour(state, forward).has_value();
}
template <bool forward>
bool goes(const State& state) {
  return state.walk.grain == Grain::pixel ? goes_by_pixels<forward>(state)
         : forward                        ? goes_on(state)
                                          : goes_back(state);
}

template <Grain grain>
bool goes_by(const State& state) {
  return state.walk.grain == grain;
}
template <Mode mode>
bool is_in(const State& state) {
  return state.walk.mode == mode;
}

std::string play_label(const State& state, bool) {
  return fill(state.walk.playing ? "transport.pause" : "command.play.label", state.appearance.language);
}

bool breaks_here(const State& state) {
  const Event* const next = state.walk.timeline->next(state.walk.position);
  return next != nullptr && state.walk.breakpoints.is_before(next->line);
}

void break_here(const Ui& ui) {
  ui.act(action::ToggleBreakpoint{ui.state.walk.timeline->next(ui.state.walk.position)->line});
}

}  // namespace

Commands WalkRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "step", .keys = {"Space", {"Right", When::trace}, {"Page Down", When::trace}}, .section = Section::step,
       .line = "keys.steps", .enabled = goes<true>, .run = act<action::Step, true>, .held = act<action::Hold, true>},
      {.name = "step-back", .keys = {{"Left", When::trace}, {"Page Up", When::trace}}, .section = Section::back,
       .line = "keys.steps", .enabled = goes<false>, .run = act<action::Step, false>, .held = act<action::Hold, false>},
      {.name = "step-ray", .keys = {{"Shift+Right", When::trace}, "Shift+Space"}, .section = Section::step,
       .line = "keys.rays", .enabled = goes_on, .run = act<action::Step, true, Grain::ray>},
      {.name = "step-ray-back", .keys = {{"Shift+Left", When::trace}}, .section = Section::back, .line = "keys.rays",
       .enabled = goes_back, .run = act<action::Step, false, Grain::ray>},
      {.name = "step-pixel", .keys = {{"Ctrl+Right", When::trace}, "Ctrl+Space"}, .section = Section::step,
       .line = "keys.pixels", .enabled = goes_by_pixels<true>, .run = act<action::Step, true, Grain::pixel>},
      {.name = "step-pixel-back", .keys = {{"Ctrl+Left", When::trace}}, .section = Section::back, .line = "keys.pixels",
       .enabled = goes_by_pixels<false>, .run = act<action::Step, false, Grain::pixel>},
      {.name = "step-over", .keys = {{"Down", When::trace}}, .section = Section::over, .line = "keys.over",
       .enabled = goes_on, .run = act<action::Step, true, Grain::over>},
      {.name = "step-back-over", .keys = {{"Shift+Down", When::trace}}, .section = Section::over, .line = "keys.over",
       .enabled = goes_back, .run = act<action::Step, false, Grain::over>},
      {.name = "step-out", .keys = {{"Up", When::trace}}, .section = Section::over, .line = "keys.out",
       .enabled = goes_on, .run = act<action::Step, true, Grain::out>},
      {.name = "step-back-out", .keys = {{"Shift+Up", When::trace}}, .section = Section::over, .line = "keys.out",
       .enabled = goes_back, .run = act<action::Step, false, Grain::out>},
      {.name = "first", .keys = {"Home"}, .section = Section::ends, .line = "keys.ends", .enabled = goes_back,
       .run = act<action::Jump, 0>},
      {.name = "last", .keys = {"End"}, .section = Section::ends, .line = "keys.ends", .enabled = goes_on,
       .run = [](const Ui& ui) { ui.act(action::Jump{ui.state.walk.timeline->steps()}); }},
      {.name = "play", .keys = {"A"}, .section = Section::play, .line = "keys.auto_clear",
       .enabled = [](const State& state) { return goes_on(state) || state.walk.playing; },
       .chosen = [](const State& state) { return state.walk.playing; }, .label = play_label,
       .run = act<action::PlayPause>},
      {.name = "clear", .keys = {"C"}, .section = Section::ends, .line = "keys.auto_clear", .enabled = goes_back,
       .run = act<action::Clear>},
      {.name = "slower", .keys = {"-"}, .section = Section::play, .line = "keys.speed",
       .enabled = [](const State& state) { return state.walk.lines_per_second > min_speed; },
       .run = [](const Ui& ui) { ui.act(action::SetSpeed{ui.state.walk.lines_per_second / 2}); }},
      {.name = "faster", .keys = {"+"}, .section = Section::play, .line = "keys.speed",
       .enabled = [](const State& state) { return state.walk.lines_per_second < max_speed; },
       .run = [](const Ui& ui) { ui.act(action::SetSpeed{ui.state.walk.lines_per_second * 2}); }},
      {.name = "grain-line", .keys = {{"1", When::not_move}}, .section = Section::grain, .line = "keys.grain",
       .chosen = goes_by<Grain::line>, .run = act<action::SetGrain, Grain::line>},
      {.name = "grain-ray", .keys = {{"2", When::not_move}}, .section = Section::grain, .line = "keys.grain",
       .chosen = goes_by<Grain::ray>, .run = act<action::SetGrain, Grain::ray>},
      {.name = "grain-pixel", .keys = {{"3", When::not_move}}, .section = Section::grain, .line = "keys.grain",
       .chosen = goes_by<Grain::pixel>, .run = act<action::SetGrain, Grain::pixel>},
      {.name = "run-on", .keys = {"W"}, .section = Section::run, .line = "keys.run", .enabled = goes_on,
       .run = act<action::RunOn, true>},
      {.name = "run-back", .keys = {"Shift+W"}, .section = Section::run, .line = "keys.run", .enabled = goes_back,
       .run = act<action::RunOn, false>},
      {.name = "break-here", .keys = {"Ctrl+B"}, .section = Section::run, .line = "keys.breaks", .enabled = goes_on,
       .chosen = breaks_here, .run = break_here},
      {.name = "breakpoints", .keys = {"B", "J"}, .section = Section::run, .line = "keys.breaks",
       .chosen = [](const State& state) { return breakpoints_here(state).any(); }, .run = wish<WindowWish::breakpoints>},
      {.name = "mode-move", .keys = {"M"}, .section = Section::modes, .line = "keys.modes", .chosen = is_in<Mode::move>,
       .run = act<action::SetMode, Mode::move>},
      {.name = "mode-trace", .keys = {"T"}, .section = Section::modes, .line = "keys.modes",
       .chosen = is_in<Mode::trace>, .run = act<action::SetMode, Mode::trace>},
      {.name = "mode-help", .keys = {"F1", "H"}, .section = Section::modes, .line = "keys.modes",
       .chosen = is_in<Mode::help>, .run = act<action::SetMode, Mode::help>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
