#include "gui/broken_lines.h"
#include "gui/command.h"
#include "gui/pane_words.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "text/language.h"
#include "view/lesson/lesson_panel.h"
#include "view/lesson/typed_number.h"
#include "view/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace raywalk {

namespace {

// `is_new`: just come to, so that the lesson to go on with is scrolled into view.
void list(const Ui& ui, const LessonPanel& panel, bool is_new) {
  const Shades shades(ui.state.appearance.theme);
  int* const before = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("chosen"));
  const int now = ui.state.lessons.chosen ? *ui.state.lessons.chosen + 1 : 0;
  const bool is_chosen_now = std::exchange(*before, now) != now && now != 0;
  int number = 0;
  for (const LessonRow& row : panel.rows) {
    std::string title = fmt::format("{}  {}", ++number, row.title);
    if (row.done > 0) title += row.done == row.steps ? "  \u2713" : fmt::format("  {}/{}", row.done, row.steps);
    const Colour ink = row.next ? shades.on_accent : row.locked ? ui.colours.dim_text : ui.colours.text;
    // Where *Finish* was clicked twice a lesson may lie by now.
    if (wide_button(ui, "lesson/" + row.name, title, row.next ? shades.accent : shades.raised, ink, true) &&
        !(ImGui::IsMouseReleased(0) && ImGui::GetIO().MouseClickedLastCount[0] > 1))
      ui.act(action::OpenLesson{row.name});
    if ((is_new || is_chosen_now) && row.next) ImGui::SetScrollHereY(0.35f);
    if (row.locked) tooltip(ui, "lesson/" + row.name, ui.say("lesson.locked"));
  }
  ImGui::Dummy({1, ui.px(6)});
  command_button(ui, command("bugs"), {ImGui::GetContentRegionAvail().x, button_height(ui)}, {}, ui.say("bug.title"));
}

// The class's votes for a choice, at its right: counted while the answer is not known. A bar along the lower edge of
// the choice compares them.
void show_of_hands(const Ui& ui, const LessonPanel& panel, std::size_t i, const Rect& choice, float width) {
  int most = 1;
  for (const LessonChoice& each : panel.choices) most = std::max(most, each.hands);
  const int index = static_cast<int>(i), hands = panel.choices[i].hands;
  const std::string key = std::to_string(i + 1), number = std::to_string(hands);
  const ImVec2 extent{button_height(ui), button_height(ui)};
  const float y = choice.y + (choice.height - extent.y) / 2, left = choice.right() + ui.px(4), right = left + width;
  if (!ui.state.lessons.revealed) {
    ImGui::SetCursorScreenPos({left, y});
    if (button(ui, "hand-less/" + key, ui.say("lesson.hand_less"), ui.say("keys.name_shift") + "+" + key, extent,
               {.look = Look::plain, .icon = Icon::minus, .font = nullptr, .label = false}, false, hands > 0))
      ui.act(action::ShowHands{index, -1});
    ImGui::SetCursorScreenPos({right - extent.x, y});
    if (button(ui, "hand-more/" + key, ui.say("lesson.hand_more"), key, extent,
               {.look = Look::plain, .icon = Icon::plus, .font = nullptr, .label = false}))
      ui.act(action::ShowHands{index, 1});
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float middle = (left + right) / 2 - ImGui::CalcTextSize(number.c_str()).x / 2;
  draw.AddText({middle, choice.y + (choice.height - ImGui::GetFontSize()) / 2}, to_imgui(ui.colours.text),
               number.c_str());
  const float length = choice.width * static_cast<float>(hands) / static_cast<float>(most), thick = ui.px(4);
  if (hands > 0)
    draw.AddRectFilled({choice.x, choice.bottom() - thick}, {choice.x + length, choice.bottom()},
                       to_imgui(Shades(ui.state.appearance.theme).accent_hovered), thick / 2);
}

// Returns where the one that is guessed begins, in the pane's content.
std::optional<float> choices(const Ui& ui, const LessonPanel& panel) {
  const Shades shades(ui.state.appearance.theme);
  const bool revealed = ui.state.lessons.revealed;
  const bool counts = ui.state.lessons.presenter && (!revealed || !panel.hands.empty());
  const float hands = counts ? 2 * button_height(ui) + ui.px(30) : 0;
  std::optional<float> guessed;
  for (std::size_t i = 0; i < panel.choices.size(); ++i) {
    const LessonChoice& choice = panel.choices[i];
    if (choice.guessed) guessed = ImGui::GetCursorPosY();
    const bool filled = choice.guessed;
    // The right choice has a sign, not only a colour.
    const std::string sign = !revealed ? "" : choice.right ? "\u2713 " : choice.guessed ? "\u2717 " : "";
    const std::string text = fmt::format("{}{}  {}", sign, i + 1, choice.text);
    const float width = ImGui::GetContentRegionAvail().x - (counts ? hands + ui.px(4) : 0);
    if (wide_button(ui, fmt::format("guess/{}", i + 1), text, filled ? shades.accent : shades.raised,
                    filled ? shades.on_accent : ui.colours.text, !revealed, width))
      ui.act(action::GuessChoice{static_cast<int>(i)});
    if (!counts) continue;
    const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax(), next = ImGui::GetCursorScreenPos();
    show_of_hands(ui, panel, i, {least.x, least.y, most.x - least.x, most.y - least.y}, hands);
    ImGui::SetCursorScreenPos(next);
  }
  return guessed;
}

// How lessons are shown: to a student, or by a presenter, who may hide or export the notes.
void options(const Ui& ui, float width, bool open) {
  const LessonRoom& sitting = ui.state.lessons;
  const bool presents = sitting.presenter && open;
  const float gap = ui.px(8), count = presents ? 3 : 2;
  // Sized by their words, and together as wide as the pane.
  const auto needs = [&](std::string_view label) {
    return button_width(ui, ui.say(label), {Look::plain, Icon::none, ui.fonts.small});
  };
  const float needed =
      needs("lesson.presenter") + (presents ? needs("lesson.notes") + needs("lesson.script") : needs("lesson.unlock"));
  const auto extent = [&](std::string_view label) {
    return ImVec2{(width - (count - 1) * gap) * needs(label) / needed, button_height(ui)};
  };
  action::SetLessonOptions next{sitting.presenter, sitting.unlocked, !sitting.notes};
  const auto toggle = [&](const char* name, std::string_view label, std::string_view hint, bool& value, bool is_on) {
    const ButtonLook look{is_on ? Look::choice : Look::plain, Icon::none, ui.fonts.small};
    if (!button(ui, name, ui.say(label), ui.say(hint), extent(label), look, is_on)) return;
    value = !value;
    ui.act(next);
  };
  toggle("lesson-presenter", "lesson.presenter", "lesson.presenter_hint", next.presenter, sitting.presenter);
  ImGui::SameLine(0, gap);
  if (!presents) {
    toggle("lesson-unlock", "lesson.unlock", "lesson.unlock_hint", next.unlocked, sitting.unlocked);
    return;
  }
  toggle("lesson-notes", "lesson.notes", "lesson.notes_hint", next.without_notes, sitting.notes);
  ImGui::SameLine(0, gap);
  if (button(ui, "lesson-script", ui.say("lesson.script"), ui.say("lesson.script_hint"), extent("lesson.script"),
             {.look = Look::plain, .icon = Icon::none, .font = ui.fonts.small}))
    ui.act(action::AskExport{});
}

// The current step, a close button, and the topic.
void head(const Ui& ui, const LessonPanel& panel, const Rect& where, bool open) {
  const float width = ImGui::GetContentRegionAvail().x, height = button_height(ui);
  const std::string about = open ? fmt::format("{}/{} \u00b7 {}", panel.step, panel.steps, panel.lesson) : panel.score;
  push_font(ui.fonts.small);
  const std::string shown = shortened(about, width - 2 * height);
  label(ui.colours.dim_text, shown);
  const float about_height = ImGui::GetTextLineHeightWithSpacing();
  pop_font();
  ui.publish("lesson-about");
  if (shown != about) tooltip(ui, "lesson-about", about);
  ImGui::SetCursorScreenPos({where.right() - ui.px(8) - height, where.y + ui.px(6)});
  if (button(ui, "lesson-close", "", open ? ui.say("lesson.close") : "", {height, height},
             {.look = Look::flat, .icon = Icon::close, .font = nullptr, .label = false})) {
    if (open) ui.act(action::LeaveLesson{});
    ui.act(action::ShowLessons{false});
  }
  // Below the button, unless a finger has made that higher than the line beside it.
  const bool beside = ui.finger > 0;
  ImGui::SetCursorScreenPos({where.x + ui.px(16), where.y + ui.px(12) + (beside ? about_height : height)});
  push_font(ui.fonts.title);
  label(ui.colours.text,
        broken_lines(open ? panel.heading : ui.say("lesson.lessons"), beside ? width - height : width));
  pop_font();
  if (!panel.told_in.empty()) paragraph(ui.colours.dim_text, panel.told_in);
}

/// Scrolls so that what stands from `begin` to `end` is whole, else its beginning; `before`: with so much above it
/// where there is room for that; `from`: rather with what begins there than with its end. Heights in the pane's
/// content.
void scroll_to(float begin, float end, float before, float margin, float from) {
  const float room = ImGui::GetWindowHeight();
  ImGui::SetScrollY(std::min(std::min(begin, from) - margin, std::max(begin - before, end + margin - room)));
}

struct AnswerEnds {
  float verdict = 0;  ///< of whether it is right
  float all = 0;      ///< of what has to be read: with the change to make, if both are lower than the room for them
};

AnswerEnds answer(const Ui& ui, const LessonPanel& panel, float room) {
  const float begin = ImGui::GetCursorPosY();
  if (!panel.verdict.empty())
    heading(ui, panel.is_right ? Shades(ui.state.appearance.theme).accent : ui.colours.error,
            (panel.is_right ? "\u2713 " : "\u2717 ") + panel.verdict);
  ui.publish("lesson-verdict");
  AnswerEnds ends{ImGui::GetCursorPosY()};
  if (!panel.hands.empty()) heading(ui, ui.colours.text, panel.hands);
  if (!panel.verdict.empty() || !panel.unanswered.empty()) {
    push_font(ui.fonts.small);
    paragraph(ui.colours.dim_text, panel.verdict.empty() ? panel.unanswered : panel.score);
    pop_font();
  }
  if (!panel.reveal.empty()) prose(ui, ui.colours.text, panel.reveal);
  ends.all = ImGui::GetCursorPosY();
  if (panel.change.empty()) return ends;
  heading(ui, ui.colours.text, ui.say("lesson.change"));
  prose(ui, ui.colours.text, panel.change);
  if (ImGui::GetCursorPosY() - begin < room) ends.all = ImGui::GetCursorPosY();
  return ends;
}

void notes(const Ui& ui, const LessonPanel& panel) {
  const auto part = [&](const std::string& title, const std::string& words) {
    if (words.empty()) return;
    heading(ui, ui.colours.dim_text, title);
    prose(ui, ui.colours.dim_text, words);
  };
  part(ui.say("lesson.presenter") + " \u00b7 " + panel.time, panel.presenter);
  part(ui.say("lesson.teacher"), panel.teacher);
  if (!panel.notes.empty()) prose(ui, ui.colours.dim_text, panel.notes);
  part(ui.say("lesson.sources"), panel.sources);
}

// To the list, back, and on: first to the answer, if one is asked for.
void steps(const Ui& ui, const LessonPanel& panel, ImVec2 at, float width) {
  const float height = button_height(ui), gap = ui.px(8), half = (width - height - 2 * gap) / 2;
  ImGui::SetCursorScreenPos(at);
  if (button(ui, "lesson-list", ui.say("lesson.all_lessons"), ui.say("lesson.all_lessons"), {height, height},
             {.look = Look::plain, .icon = Icon::up, .font = nullptr, .label = false}))
    ui.act(action::LeaveLesson{});
  ImGui::SameLine(0, gap);
  if (button(ui, "lesson-back", ui.say("lesson.back"), "", {half, height}, {}, false, panel.can_go_back))
    ui.act(action::GoToLessonStep{panel.step - 2});
  ImGui::SameLine(0, gap);
  if (panel.asks != Asks::nothing && !ui.state.lessons.revealed) {
    if (button(ui, "lesson-reveal", ui.say("lesson.reveal"), "", {half, height}, {.look = Look::primary}, false,
               panel.can_reveal))
      ui.act(action::RevealLesson{});
  } else if (button(ui, "lesson-next", ui.say(panel.is_last ? "lesson.finish" : "lesson.next"), "", {half, height},
                    {.look = Look::primary}, false, panel.can_go_on)) {
    ui.act(action::GoToLessonStep{panel.step});
  }
}

bool offers_cure(const Ui& ui, const LessonPanel& panel) {
  return panel.asks == Asks::line && ui.state.lessons.revealed && ui.state.walk.bug.has_value();
}

void cure(const Ui& ui, ImVec2 extent) {
  command_button(ui, command("bug-mend"), extent, {},
                 ui.say(ui.state.walk.bug->mended ? "bug.break_again" : "bug.mend"));
}

// A number has no letters but those of "2x" and "1e-7": others are slips of the hand, or commands.
bool is_slip(ImWchar letter) {
  const bool is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
  return is_letter && letter != 'e' && letter != 'E' && letter != 'x';
}

// Digits that were typed before the field had the keyboard stay: ImGui selects them, so that the next would replace
// them.
int without_letters(ImGuiInputTextCallbackData* typed) {
  if (typed->EventFlag == ImGuiInputTextFlags_CallbackCharFilter) return is_slip(typed->EventChar) ? 1 : 0;
  if (!*static_cast<const bool*>(typed->UserData)) return 0;
  typed->CursorPos = typed->BufTextLen;
  typed->ClearSelection();
  return 0;
}

// Whether a number is asked for and nobody has typed one. Enter then shows no answer, for it ends what is typed, and is
// soon pressed by mistake: an answer that was seen cannot be predicted any more. Presenters go on by that key.
bool is_missing_number(const State& state, const LessonPanel& panel) {
  return panel.asks == Asks::number && !state.lessons.revealed && !state.lessons.presenter &&
         !state.lessons.guess.number;
}

// What is typed in this frame, up to so many characters; nobody else gets it.
std::string take_typed(std::size_t most) {
  std::string taken;
  ImVector<ImWchar>& typed = ImGui::GetIO().InputQueueCharacters;
  for (const ImWchar letter : typed)
    if (letter > ' ' && letter < 0x7f && !is_slip(letter) && taken.size() < most) taken += static_cast<char>(letter);
  typed.resize(0);
  return taken;
}

}  // namespace

void LessonPane::ask_for_number(bool missed) {
  wanted_ = until_typed;
  missed_ = missed;
}

void LessonPane::number(const Ui& ui, const LessonPanel& panel, bool is_new, bool takes_keys) {
  const bool revealed = ui.state.lessons.revealed;
  const auto guess_typed = [&] {
    ui.act(
        action::GuessNumber{typed_guess(ui.state.lessons, number_).value_or(std::numeric_limits<double>::quiet_NaN())});
  };
  if ((is_new && takes_keys && !revealed) || wanted_ == until_typed) ImGui::SetKeyboardFocusHere();
  // While nobody types here the guess decides: it may be of another visit, or typed elsewhere.
  const std::optional<double>& guess = ui.state.lessons.guess.number;
  if (!types_ && typed_guess(ui.state.lessons, number_) != guess)
    number_ = guess ? typeset_number(fmt::format("{:.10g}", *guess), ui.state.appearance.language) : "";
  char typed[32] = {};
  // ImGui gives a field the keyboard a frame later than asked: until then what is typed is lost to it.
  bool begins = wanted_ > 0 && !types_;
  if (begins) {
    const std::string begun = take_typed(sizeof typed - 1 - std::min(number_.size(), sizeof typed - 1));
    number_ += begun;
    if (!begun.empty()) guess_typed();
  }
  number_.copy(typed, sizeof typed - 1);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.5f);
  const bool entered =
      ImGui::InputText("##number", typed, sizeof typed,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCharFilter |
                           ImGuiInputTextFlags_CallbackAlways | (revealed ? ImGuiInputTextFlags_ReadOnly : 0),
                       without_letters, &begins);
  types_ = ImGui::IsItemActive();
  wanted_ = types_ ? 0 : std::max(wanted_ - 1, 0);
  ui.publish("lesson-number");
  if (number_ != typed) {
    number_ = typed;
    guess_typed();
  }
  // Who typed something wants it judged, also where the answer may be shown without.
  const bool is_unread = !number_.empty() && !typed_guess(ui.state.lessons, number_);
  const bool is_missing = number_.empty() && is_missing_number(ui.state, panel);
  const bool reveals = panel.can_reveal && !is_unread && !is_missing;
  if (entered && reveals) ui.act(action::RevealLesson{});
  // Keys typed next still go to this field, not to the walk.
  if (entered && !reveals) ImGui::SetKeyboardFocusHere(-1);
  missed_ = is_missing && (missed_ || entered);
  if (!panel.unit.empty()) {
    ImGui::SameLine();
    label(ui.colours.text, panel.unit);
  }
  if (is_unread && !revealed) paragraph(ui.colours.error, ui.say("lesson.not_a_number"));
  if (missed_) {
    paragraph(ui.colours.error, ui.say("lesson.nothing_typed"));
    ui.publish("lesson-nothing-typed");
  }
}

std::optional<float> LessonPane::question(const Ui& ui, const LessonPanel& panel, bool is_new, bool is_low) {
  const LessonRoom& sitting = ui.state.lessons;
  const ImVec2 wide{ImGui::GetContentRegionAvail().x, button_height(ui)};
  heading(ui, Shades(ui.state.appearance.theme).accent, ui.say("lesson.predict"));
  prose(ui, ui.colours.text, panel.question);
  std::optional<float> guessed = choices(ui, panel);
  if (!sitting.revealed) {
    push_font(ui.fonts.small);
    if (panel.asks == Asks::choice && sitting.presenter) paragraph(ui.colours.dim_text, ui.say("lesson.hands_hint"));
    if (panel.asks == Asks::arrow && !panel.astray)
      paragraph(ui.colours.dim_text, "\u2192 " + ui.say("lesson.drag_arrow"));
    if (panel.asks == Asks::number) paragraph(ui.colours.dim_text, ui.say("lesson.type_number"));
    if (panel.asks == Asks::line) paragraph(sitting.guess.line ? ui.colours.text : ui.colours.dim_text, panel.marked);
    pop_font();
  }
  if (offers_cure(ui, panel) && !is_low) cure(ui, wide);
  if (panel.astray &&
      button(ui, "lesson-question", ui.say("lesson.back_to_question"), "", wide, {.look = Look::primary}))
    ui.act(action::GoToLessonStep{panel.step - 1});
  // Nothing was typed, and nothing can be any more: an empty field would ask for it.
  // In a low pane the keyboard's field would scroll away what is asked.
  if (panel.asks == Asks::number && panel.unanswered.empty()) {
    guessed = ImGui::GetCursorPosY();
    number(ui, panel, is_new, !is_low);
  }
  return guessed;
}

void LessonPane::draw(const Ui& ui, const Rect& where) {
  const LessonPanel panel = lesson_panel(ui.state);
  const LessonRoom& sitting = ui.state.lessons;
  const Pane pane(ui, "lesson", where, ui.colours.panel, {ui.px(16), ui.px(12)},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (!pane) return;
  const std::string shown_for = panel.lesson + "/" + std::to_string(panel.step) +
                                (sitting.revealed ? "!"
                                 : panel.astray   ? "?"
                                                  : "");
  const bool is_new = shown_for_ != shown_for;
  if (is_new && !sitting.revealed) number_.clear();
  if (is_new) {
    wanted_ = 0;
    missed_ = false;
  }
  shown_for_ = shown_for;
  // A scroll bar that appears makes lines shorter, and more of them.
  settling_ = is_new ? 3 : std::max(settling_ - 1, 0);
  const bool open = sitting.at() != nullptr;
  const float width = ImGui::GetContentRegionAvail().x, height = button_height(ui), left = where.x + ui.px(16);
  const bool alone = ui.state.focus.on && has_question(ui.state);  // the question, and what leads to it above
  if (!alone || where.height > ui.px(360)) head(ui, panel, where, open);

  // A telephone has no room for what a teacher chooses once; the list of lessons has it, too.
  const bool has_options = !alone && (!open || where.height > ui.px(360));
  const float options_height = has_options ? height + ui.px(8) : 0;
  const float foot = (open ? height + ui.px(ui.finger > 0 ? 12 : 18) : ui.px(10)) + options_height;
  const float room = std::max(where.bottom() - ImGui::GetCursorScreenPos().y - foot, 1.0f);
  const bool is_low = room <= ui.px(240);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4{0, 0, 0, 0});
  if (ImGui::BeginChild("lesson-words", {width, room}, false)) {
    if (is_new) ImGui::SetScrollY(0);
    if (open) {
      if (!panel.summary.empty() && !alone) prose(ui, ui.colours.dim_text, panel.summary);
      if (!alone || !is_low) prose(ui, ui.colours.text, panel.text);
      const float asked = ImGui::GetCursorPosY(), margin = ui.px(12);  // below the mark
      std::optional<float> guessed;
      if (panel.asks != Asks::nothing) guessed = question(ui, panel, is_new, is_low);
      // The first hand that goes up wants the choices in sight.
      const int hands = std::accumulate(sitting.hands.begin(), sitting.hands.end(), 0);
      if (hands > 0 && hands_ == 0 && !sitting.revealed) scroll_to(asked, ImGui::GetCursorPosY(), asked, margin, asked);
      hands_ = hands;
      if (alone && is_new && !is_low && !sitting.revealed) ImGui::SetScrollHereY(1);
      const float begin = ImGui::GetCursorPosY();
      const AnswerEnds ends = answer(ui, panel, room - 2 * margin);
      // A new answer comes into view, with its context where there is room for both: at least with the guess that it
      // judges. Else it is at the top of a low pane, and nothing of the last choice, which would be cut and so be
      // blank.
      const float more = ImGui::GetTextLineHeightWithSpacing();  // so that its reason is seen to begin
      const bool both = guessed && ends.verdict + more - *guessed + 2 * margin <= room;
      if (settling_ > 0 && sitting.revealed)
        scroll_to(begin, ends.all, is_low ? margin : 0.35f * room, margin, both ? *guessed : begin);
      // Where the question has scrolled away, below what speaks of it.
      if (offers_cure(ui, panel) && is_low) cure(ui, {ImGui::GetContentRegionAvail().x, height});
      if (!alone) notes(ui, panel);
    } else {
      list(ui, panel, is_new);
    }
    ui.publish("lesson-lines", close_edges(ui, ui.colours.panel));
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();

  if (open) steps(ui, panel, {left, where.bottom() - foot + ui.px(ui.finger > 0 ? 6 : 8)}, width);
  if (!has_options) return;
  ImGui::SetCursorScreenPos({left, where.bottom() - ui.px(10) - height});
  options(ui, width, open);
}

bool lesson_by_key(const KeyPress& press, const Ui& ui) {
  const State& state = ui.state;
  // A presenter goes on by the same keys after "Now change something".
  const bool listens = state.walk.mode == Mode::trace || chooses_from_list(state) ||
                       (state.walk.mode == Mode::move && state.lessons.presenter && state.lessons.at() != nullptr);
  if (!state.lessons.shown || !listens || press.ctrl || press.alt) return false;
  const LessonPanel panel = lesson_panel(state);
  const int digit = press.key.size() == 1 ? press.key[0] - '1' : -1;
  const bool picks = panel.asks == Asks::choice && !state.lessons.revealed && digit >= 0 &&
                     digit < static_cast<int>(panel.choices.size());
  if (picks && state.lessons.presenter) {
    ui.act(action::ShowHands{digit, press.shift ? -1 : 1});
    return true;
  }
  if (press.shift) return false;
  if (picks) {
    ui.act(action::GuessChoice{digit});
    return true;
  }
  // Digits beside the field of a number that is asked for are meant for it.
  const bool is_digit = press.key.size() == 1 && press.key[0] >= '0' && press.key[0] <= '9';
  if (is_digit && panel.asks == Asks::number && !state.lessons.revealed && !panel.astray) {
    ui.wish(WindowWish::lesson_number);
    return true;
  }
  // A digit too many, or a class's hand too late, is a slip, and must not change what a step is.
  if (panel.asks == Asks::choice && state.lessons.presenter && digit >= 0 && digit < 9) return true;
  if (panel.asks == Asks::choice && !state.lessons.revealed && !panel.astray && digit >= 0 && digit < 9) return true;
  if (panel.asks == Asks::choice && !state.lessons.revealed && !panel.astray &&
      (press.key == "Up" || press.key == "Down")) {
    const int last = static_cast<int>(panel.choices.size()) - 1, by = press.key == "Up" ? -1 : 1;
    const std::optional<int>& now = state.lessons.guess.choice;
    ui.act(action::GuessChoice{now ? std::clamp(*now + by, 0, last) : by > 0 ? 0 : last});
    return true;
  }
  if (state.lessons.at() == nullptr && (press.key == "Up" || press.key == "Down")) {
    ui.act(action::ChooseLesson{press.key == "Up" ? -1 : 1});
    return true;
  }
  if (press.key != "Enter") return false;
  const auto next = std::find_if(panel.rows.begin(), panel.rows.end(), [](const LessonRow& row) { return row.next; });
  if (state.lessons.at() == nullptr && next != panel.rows.end()) {
    ui.act(action::OpenLesson{next->name});
  } else if (is_missing_number(state, panel)) {
    ui.wish(WindowWish::missing_lesson_number);
  } else if (panel.can_reveal) {
    ui.act(action::RevealLesson{});
  } else if (panel.can_go_on) {
    ui.act(action::GoToLessonStep{panel.step});
  } else {
    return false;
  }
  return true;
}

Commands LessonRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "lessons", .keys = {"F2"}, .section = Section::learn,
       .chosen = [](const State& state) { return state.lessons.shown; }, .turn = turn<action::ShowLessons>},
      {.name = "notes-window", .keys = {"Alt+N"}, .section = Section::learn,
       .chosen = [](const State& state) { return state.lessons.notes_window; }, .turn = turn<action::ShowNotesWindow>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
