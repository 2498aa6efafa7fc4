#include "gui/broken_lines.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text/text.h"
#include "view/walk/status.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace raywalk {

namespace {

// Lengths at scale 1.
constexpr float margin = 14, small = 34, step_width = 106, min_speed_width = 84, max_speed_width = 124,
                default_gap = 20, least_shrink = 0.6f;

constexpr std::array big_buttons{"step", "play", "clear"};

// The assignment to rows. What does not fit beside the big buttons moves down: the grain into the row of the scrub bar,
// and in a very narrow window both grain and speed into their own row. Before that the speed slider and then the big
// buttons shrink. In a low window everything is tighter.
struct Rows {
  explicit Rows(const Ui& ui, float width) {
    constexpr float low = 560;  // units at scale 1
    const bool tight = ImGui::GetIO().DisplaySize.y < ui.px(low);
    // A telephone held upright has room for as little as a low window, but for larger buttons, close to each other.
    constexpr float telephone = 470;  // units at scale 1
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    const bool by_finger = ui.finger > 0;
    compact = whole.y < ui.px(low_window) || by_finger || (is_upright(whole.x, whole.y) && width < ui.px(telephone));
    big = ui.high(compact ? 34 : tight ? 38 : 46);
    gap = ui.px(by_finger ? 3 : tight ? 6 : 9);
    top = ui.px(tight || by_finger ? 5 : 8);
    bottom = ui.px(by_finger ? 3 : tight ? 8 : margin);
    const float space = ImGui::GetStyle().ItemSpacing.x;
    const auto grains = [&](ImFont* font) {
      float sum = ui.px(10);
      for (const Command* each : commands_in(Section::grain))
        sum += button_width(ui, *each, {.look = Look::choice, .icon = Icon::none, .font = font});
      return sum;
    };
    grain = grains(grain_font);
    inner = width - ui.px(2 * margin);
    const float buttons = big + ui.px(3 * step_width), transport = buttons + 3 * space,
                ends = ui.px(2 * small) + 2 * space;
    speed = ends + ui.px(max_speed_width);
    beside = transport + grain + speed + ui.px(28) <= inner;
    const auto in_one_button = [&] {
      one_grain = true;
      grain = 0;
      for (const Command* each : commands_in(Section::grain))
        grain = std::max(grain, button_width(ui, *each, {.look = Look::plain, .font = ui.fonts.small}));
    };
    if (compact) {
      in_one_button();
      beside = true;
      shrink = std::clamp((inner - 3 * space) / buttons, 0.3f, 1.0f);
    } else if (!beside) {
      const float room = inner - least_shrink * buttons - 3 * space - ui.px(default_gap);
      own_row = room < ends + ui.px(min_speed_width);
      // In its own row the slider takes the remaining width, if that is enough.
      const float left = own_row ? inner - grain - ui.px(default_gap) : room;
      speed = left < ends + ui.px(min_speed_width) ? ends - space : std::min(left, speed);
      // Smaller and tighter; but words do not touch.
      const float most = own_row ? inner - speed - ui.px(4) : grain, spare = ui.px(3 * 2 * 8);
      const float small_words = grain > most ? grains(grain_font = ui.fonts.small) : 0;
      if (small_words > most + spare)
        in_one_button();
      else if (small_words > 0)
        grain = std::min(small_words, most);
      shrink = (inner - 3 * space - (own_row ? 0 : speed + ui.px(default_gap))) / buttons;
      shrink = std::clamp(shrink, 0.3f, 1.0f);
    }
    slider = std::max(speed - ends, 0.0f);
    // Of two lines, or where it is narrow of three small ones.
    constexpr float narrow = 480;  // units at scale 1
    sentence =
        inner < ui.px(narrow) ? 3 * line_height(ui.fonts, *ui.fonts.small) : 2 * line_height(ui.fonts, *ui.fonts.text);
    sentence += ui.px(6);
    scrub = ui.high(beside ? 26 : small);
    height = top + sentence + gap + big + gap + (own_row ? ui.px(small) + gap : 0) + scrub + bottom;
  }
  float big, gap, top, bottom, grain, speed, slider, inner, sentence, scrub, height;
  float shrink = 1;
  ImFont* grain_font = nullptr;  ///< null: the usual one
  bool beside, own_row = false;
  bool compact;            ///< without the speed, which has menu entries and keys
  bool one_grain = false;  ///< one button for all lengths of a step
};

// STEP and BACK speed up while held down.
void hold(const Ui& ui, const Command& command) {
  constexpr float patience = 0.4f;  // seconds
  const ImGuiIO& io = ImGui::GetIO();
  bool& holding = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID(command.name.data()), false);
  if (!io.MouseDown[0]) {
    if (std::exchange(holding, false)) ui.act(action::Release{});
    return;
  }
  const Rect& where = ui.items.find(command.name)->second;
  if (holding || !where.contains(io.MouseClickedPos[0].x, io.MouseClickedPos[0].y) || !enabled(command, ui.state) ||
      !where.contains(io.MousePos.x, io.MousePos.y))
    return;
  const float left = patience - io.MouseDownDuration[0];
  if (left > 0) return ui.rest.wake_in(static_cast<double>(left));
  holding = true;
  command.held(ui);
}

void speed_control(const Ui& ui, const Rows& rows) {
  const ButtonLook minus{.look = Look::plain, .icon = Icon::minus, .font = nullptr, .label = false};
  const ButtonLook plus{.look = Look::plain, .icon = Icon::plus, .font = nullptr, .label = false};
  command_button(ui, command("slower"), {ui.px(small), ui.px(small)}, minus);
  ImGui::SameLine();
  if (rows.slider > 0) {
    // The slider is logarithmic.
    const double range = std::log(max_speed / min_speed);
    const double fraction = std::log(ui.state.walk.lines_per_second / min_speed) / range;
    const std::string rate = number_text(ui.state.walk.lines_per_second, ui.state.appearance.language) + "/s";
    const std::string in_full = ui.say("transport.speed") + " " + rate;
    const std::string value = ImGui::CalcTextSize(in_full.c_str()).x + ui.px(8) <= rows.slider ? in_full : rate;
    if (const auto to = slider(ui, "speed", {rows.slider, ui.px(small)}, static_cast<float>(fraction), value)) {
      const double speed = min_speed * std::exp(static_cast<double>(*to) * range);
      // Round numbers: integers from 2 on, quarters below.
      const double neat = speed >= 20  ? std::round(speed / 10) * 10
                          : speed >= 2 ? std::round(speed)
                                       : std::round(speed * 4) / 4;
      if (neat != ui.state.walk.lines_per_second) ui.act(action::SetSpeed{neat});
    }
    tooltip(ui, "speed", ui.say("transport.speed_hint"));
    ImGui::SameLine();
  }
  command_button(ui, command("faster"), {ui.px(small), ui.px(small)}, plus);
}

// The length of a step; pressed, the next one. Returns its right end.
float grain_button(const Ui& ui, const Rows& rows, ImVec2 at) {
  const std::vector<const Command*>& grains = commands_in(Section::grain);
  std::size_t now = 0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    if (chosen(*grains[i], ui.state)) now = i;
  ImGui::SetCursorScreenPos(at);
  if (button(ui, "grain", command_label(*grains[now], ui.state),
             command_hint(*grains[now], ui.state.appearance.language), {rows.grain, rows.scrub},
             {.look = Look::plain, .icon = Icon::none, .font = ui.fonts.small}))
    perform(*grains[(now + 1) % grains.size()], ui);
  return at.x + rows.grain;
}

void scrub_row(const Ui& ui, const Rows& rows, ImVec2 at) {
  const State& state = ui.state;
  push_font(ui.fonts.small);
  // The bar must not change its length during a drag, so the longest status has room from the start.
  const auto widest_of = [&](bool in_short) {
    return ImGui::CalcTextSize(widest_status_line(state, in_short).c_str()).x;
  };
  const float least_bar = rows.compact                  ? rows.grain + ui.px(150)
                          : rows.beside || rows.own_row ? ui.px(260)
                                                        : rows.grain + ui.px(220);
  const bool in_short = widest_of(false) + least_bar > rows.inner;
  const float widest = widest_of(in_short);
  pop_font();
  const std::string status = in_short ? short_status_line(state) : status_line(state);
  const bool with_status = widest + least_bar <= rows.inner;
  const float right = at.x + rows.inner;
  if (rows.compact) at.x = grain_button(ui, rows, at) + ui.px(6);
  if (!rows.beside && !rows.own_row) at.x += rows.grain + ui.px(8);
  const float edge = ui.px(26), high = ui.high(26);
  at.y += (rows.scrub - high) / 2;
  const float length = right - at.x - 2 * (edge + ui.px(8)) - (with_status ? widest + ui.px(10) : 0);

  const ButtonLook first{.look = Look::flat, .icon = Icon::first, .font = nullptr, .label = false};
  ButtonLook last = first;
  last.icon = Icon::last;
  ImGui::SetCursorScreenPos(at);
  command_button(ui, command("first"), {edge, high}, first);
  const float left = at.x + edge + ui.px(8);
  ImGui::SetCursorScreenPos({left, at.y});
  const int steps = std::max(state.walk.timeline->steps(), 1);
  // Ends of pixels: the bar shows how their lengths differ.
  const auto& pixels = state.walk.timeline->pixels();
  if (length / static_cast<float>(pixels.size() + 1) > ui.px(5)) {
    for (const PixelRecord& pixel : pixels) {
      const float x = std::round(left + length * static_cast<float>(pixel.done_at) / static_cast<float>(steps));
      ImGui::GetWindowDrawList()->AddLine({x, at.y + (high - 0.6f * edge) / 2}, {x, at.y + (high + 0.6f * edge) / 2},
                                          to_imgui(Shades(state.appearance.theme).raised_hovered));
    }
  }
  const float fraction = static_cast<float>(state.walk.position) / static_cast<float>(steps);
  if (const auto to = slider(ui, "scrub", {length, high}, fraction, "")) {
    const int position = static_cast<int>(std::lround(static_cast<double>(*to) * steps));
    if (position != state.walk.position) ui.act(action::Jump{position});
  }
  tooltip(ui, "scrub", ui.say("transport.scrub_hint") + "\n" + status_line(state));
  ImGui::SetCursorScreenPos({left + length + ui.px(8), at.y});
  command_button(ui, command("last"), {edge, high}, last);
  if (!with_status) return;
  ImGui::SetCursorScreenPos({right - widest, at.y + (high - line_height(ui.fonts, *ui.fonts.small)) / 2});
  push_font(ui.fonts.small);
  const ImVec2 place = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("status", {widest, line_height(ui.fonts, *ui.fonts.small)}))
    ui.wish(WindowWish::breakpoints);
  const bool lit = ImGui::IsItemHovered();
  ui.publish("status");
  tooltip(ui, "status",
          ui.say("transport.status_hint") + "  (" + command_key(command("breakpoints"), ui.state.appearance.language) +
              ")");
  ImGui::GetWindowDrawList()->AddText(place, to_imgui(lit ? ui.colours.text : ui.colours.dim_text), status.c_str());
  pop_font();
}

}  // namespace

float transport_height(const Ui& ui, float width) { return Rows(ui, width).height; }

void transport_pane(const Ui& ui, const Rect& where) {
  const Pane pane(ui, "transport", where, ui.colours.window, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  const Rows rows(ui, where.width);
  const float left = where.x + ui.px(margin);
  float y = where.y + rows.top;
  ImGui::SetCursorScreenPos({left, y});
  // In a narrow window a long one is smaller, and a very long one smaller still; beyond that it is clipped.
  const std::string said = sentence(ui.state);
  std::string lines = broken_lines(said, rows.inner);
  const bool fits = ImGui::CalcTextSize(lines.c_str()).y <= rows.sentence;
  push_font(fits ? ui.fonts.text : ui.fonts.small);
  if (!fits) lines = broken_lines(said, rows.inner);
  for (float size = 0.95f; ImGui::CalcTextSize(lines.c_str()).y > rows.sentence && size > 0.7f; size -= 0.05f) {
    ImGui::SetWindowFontScale(size);
    lines = broken_lines(said, rows.inner);
  }
  ImGui::PushClipRect({where.x, y}, {where.right(), y + rows.sentence}, true);
  label(ui.colours.text, lines);
  ImGui::PopClipRect();
  ui.publish("sentence");
  ImGui::SetWindowFontScale(1);
  pop_font();
  y += rows.sentence + rows.gap;

  const ImVec2 step{ui.px(step_width) * rows.shrink, rows.big};
  // As large as the words of all three have room for.
  const auto words_fit = [&](ImFont* font) {
    const ButtonLook look{.look = Look::plain, .icon = Icon::none, .font = font};
    return std::all_of(big_buttons.begin(), big_buttons.end(),
                       [&](const char* name) { return button_width(ui, command(name), look) <= step.x + ui.px(12); });
  };
  ImFont* font = rows.shrink >= 0.85f && words_fit(ui.fonts.title) ? ui.fonts.title
                 : words_fit(ui.fonts.strong)                      ? ui.fonts.strong
                                                                   : ui.fonts.small;
  const bool playing = ui.state.walk.playing;
  ImGui::SetCursorScreenPos({left, y});
  command_button(ui, command("step-back"), {rows.big * rows.shrink, step.y},
                 {.look = Look::plain, .icon = Icon::back, .font = nullptr, .label = false});
  ImGui::SameLine();
  command_button(ui, command("step"), step,
                 {.look = playing ? Look::plain : Look::primary, .icon = Icon::none, .font = font});
  ImGui::SameLine();
  hold(ui, command("step-back"));
  hold(ui, command("step"));
  command_button(ui, command("play"), step,
                 {.look = playing ? Look::primary : Look::plain, .icon = Icon::none, .font = font});
  ImGui::SameLine();
  command_button(ui, command("clear"), step, {.look = Look::plain, .icon = Icon::none, .font = font});

  if (rows.compact) {
    scrub_row(ui, rows, {left, y + rows.big + rows.gap});
    return;
  }
  const float second = y + rows.big + rows.gap, third = second + (rows.own_row ? ui.px(small) + rows.gap : 0);
  const float centred = y + (rows.big - ui.px(small)) / 2, speed_x = left + rows.inner - rows.speed;
  const float grain_x = rows.beside ? speed_x - rows.grain - ui.px(4) : left;
  // If there is room, the choice has a label.
  const std::string about = ui.say("transport.grain");
  const float about_x = grain_x - ImGui::CalcTextSize(about.data(), about.data() + about.size()).x - ui.px(10);
  if (about_x > ImGui::GetItemRectMax().x + ui.px(16)) {
    ImGui::SetCursorScreenPos({about_x, centred + (ui.px(small) - ImGui::GetFontSize()) / 2});
    label(ui.colours.dim_text, about);
  }
  ImGui::SetCursorScreenPos({grain_x, rows.beside ? centred : second});
  if (rows.one_grain)
    grain_button(ui, rows, {grain_x, second});
  else
    choice(ui, commands_in(Section::grain), ui.px(small), rows.grain_font, rows.grain);
  ImGui::SetCursorScreenPos({speed_x, rows.own_row ? second : centred});
  speed_control(ui, rows);
  scrub_row(ui, rows, {left, third});
}

}  // namespace raywalk
