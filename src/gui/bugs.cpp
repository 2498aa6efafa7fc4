#include "gui/command.h"
#include "gui/pane_words.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "text/language.h"
#include "view/bugs/bug_panel.h"
#include "view/walk/asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <utility>

namespace raywalk {

namespace {

void list(const Ui& ui, const BugPanel& panel) {
  const Shades shades(ui.state.appearance.theme);
  int* const before = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("chosen"));
  const int now = ui.state.bugs.chosen.value_or(0);
  const bool is_chosen_now = std::exchange(*before, now) != now;
  for (const BugRow& row : panel.rows) {
    std::string text = ui.say("bug.number", {{"number", row.number}});
    if (!row.of.empty()) text += " \u00b7 " + row.of;
    if (row.end == BugEnd::found) text += "  \u2713 " + ui.say("bug.found");
    if (row.end == BugEnd::given_up) text += "  \u00b7 " + ui.say("bug.given_up");
    if (wide_button(ui, fmt::format("bug/{}", row.number), text, row.chosen ? shades.accent : shades.raised,
                    row.chosen ? shades.on_accent : ui.colours.text, true))
      ui.act(action::HuntBug{row.number});
    if (row.chosen && is_chosen_now) ImGui::SetScrollHereY(0.5f);
  }
}

void passages(const Ui& ui, const std::vector<BugPassage>& all) {
  for (const BugPassage& passage : all) {
    if (!passage.heading.empty()) heading(ui, ui.colours.dim_text, passage.heading);
    prose(ui, ui.colours.text, passage.text);
  }
}

void hunt(const Ui& ui, const BugPanel& panel) {
  passages(ui, panel.said);
  // What is new is scrolled into view.
  int* const shown = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("shown"));
  const int now = static_cast<int>(ImGui::GetID((panel.verdict + "\n" + panel.marked).c_str()));
  const bool is_new = std::exchange(*shown, now) != now;
  if (is_new && !panel.verdict.empty() && !panel.can_judge) ImGui::SetScrollHereY(0);
  if (!panel.verdict.empty())
    heading(ui, panel.is_right ? Shades(ui.state.appearance.theme).accent : ui.colours.error,
            (panel.is_right ? "\u2713 " : "\u2717 ") + panel.verdict);
  passages(ui, panel.learnt);
  if (!panel.marked.empty()) heading(ui, panel.can_judge ? ui.colours.text : ui.colours.dim_text, panel.marked);
  if (is_new && panel.can_judge) ImGui::SetScrollHereY(1);
}

}  // namespace

void bug_pane(const Ui& ui, const Rect& where) {
  const BugPanel panel = bug_panel(ui.state);
  const Pane pane(ui, "bugs", where, ui.colours.panel, {ui.px(16), ui.px(12)}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  const float width = ImGui::GetContentRegionAvail().x, height = button_height(ui), gap = ui.px(8);
  const float left = where.x + ui.px(16);
  push_font(ui.fonts.small);
  label(ui.colours.dim_text, shortened(panel.tally, width - 2 * height));
  pop_font();
  ImGui::SetCursorScreenPos({where.right() - ui.px(8) - height, where.y + ui.px(6)});
  if (button(ui, "bugs-close", "", ui.say("bug.leave"), {height, height},
             {.look = Look::flat, .icon = Icon::close, .font = nullptr, .label = false}))
    ui.act(action::ShowBugs{false});
  ImGui::SetCursorScreenPos({left, where.y + ui.px(12) + height});
  push_font(ui.fonts.title);
  paragraph(ui.colours.text, panel.heading);
  pop_font();

  const float foot = (panel.hunting ? 2 : 1) * height + ui.px(panel.hunting ? 26 : 18),
              top = ImGui::GetCursorScreenPos().y;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4{0, 0, 0, 0});
  if (ImGui::BeginChild("bug-words", {width, std::max(where.bottom() - top - foot, 1.0f)}, false)) {
    if (panel.hunting) {
      hunt(ui, panel);
    } else {
      passages(ui, panel.said);
      list(ui, panel);
    }
    close_edges(ui, ui.colours.panel);
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();

  const float y = where.bottom() - foot + ui.px(8), half = (width - gap) / 2;
  ImGui::SetCursorScreenPos({left, y});
  if (!panel.hunting) {
    command_button(ui, command("bug-surprise"), {width, height}, {.look = Look::primary}, ui.say("bug.surprise"));
  } else {
    const bool open = panel.can_give_up;
    command_button(ui, open ? command("bug-mark") : command("bug-mend"), {half, height},
                   {.look = open ? Look::primary : Look::plain},
                   ui.say(panel.can_judge             ? "bug.judge"
                          : open                      ? "bug.mark"
                          : ui.state.walk.bug->mended ? "bug.break_again"
                                                      : "bug.mend"));
    ImGui::SetCursorScreenPos({left + half + gap, y});
    command_button(ui, open ? command("bug-cure") : command("bug-surprise"), {half, height},
                   {.look = open ? Look::plain : Look::primary}, ui.say(open ? "bug.give_up" : "bug.surprise"));
  }

  ImGui::SetCursorScreenPos({left, y + height + gap});
  if (panel.hunting) {
    if (button(ui, "bugs-list", ui.say("bug.all_bugs"), ui.say("bug.all_bugs"), {height, height},
               {.look = Look::plain, .icon = Icon::up, .font = nullptr, .label = false}))
      ui.act(action::LeaveHunt{});
    ImGui::SetCursorScreenPos({left + height + gap, y + height + gap});
    if (button(ui, "bugs-leave", ui.say("bug.leave"), "Esc", {width - height - gap, height},
               {.look = Look::plain, .icon = Icon::none, .font = ui.fonts.small}))
      ui.act(action::ShowBugs{false});
  }
}

bool bug_by_key(const KeyPress& press, const Ui& ui) {
  const State& state = ui.state;
  if (!state.bugs.shown || !chooses_from_list(state) || press.ctrl || press.alt || press.shift) return false;
  if (press.key == "Up" || press.key == "Down") {
    ui.act(action::ChooseBug{press.key == "Up" ? -1 : 1});
  } else if (press.key == "Enter" && state.bugs.chosen) {
    ui.act(action::HuntBug{*state.bugs.chosen});
  } else {
    return false;
  }
  return true;
}

namespace {

// Marks the line that has just run; if one is marked already, judges it.
void mark_line(const Ui& ui) {
  const State& state = ui.state;
  if (state.bugs.hunt && state.bugs.hunt->marked) return ui.act(action::JudgeLine{});
  if (const Event* just_run = state.walk.timeline->just_run(state.walk.position))
    ui.act(action::MarkLine{just_run->line});
}

void hunt_surprise(const Ui& ui) {
  ui.act(action::HuntBug{surprising_bug(ui.state.bugs, std::random_device{}()), true});
}

bool can_mark(const State& state) {
  return asks_for_line(state) && (marked_line(state) || state.walk.position > 0 || state.walk.playing);
}

}  // namespace

Commands BugRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "bugs", .keys = {"Shift+F2"}, .section = Section::learn, .line = "keys.bugs",
       .chosen = [](const State& state) { return state.bugs.shown; }, .turn = turn<action::ShowBugs>},
      {.name = "bug-surprise", .keys = {"Ctrl+F2"}, .line = "keys.bugs", .run = hunt_surprise},
      {.name = "bug-mark", .keys = {{"Enter", When::trace}}, .line = "keys.bugs", .enabled = can_mark,
       .run = mark_line},
      {.name = "bug-cure", .keys = {"Shift+Enter"}, .line = "keys.bugs",
       .enabled = [](const State& state) { return state.bugs.hunt && state.bugs.hunt->end == BugEnd::open; },
       .run = act<action::ShowCure>},
      {.name = "bug-mend", .keys = {"Alt+Enter"}, .line = "keys.bugs",
       .enabled = [](const State& state) { return state.walk.bug && state.walk.bug->known; },
       .chosen = [](const State& state) { return state.walk.bug && state.walk.bug->mended; },
       .turn = turn<action::MendBug>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
