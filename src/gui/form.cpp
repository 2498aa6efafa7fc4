#include "gui/form.h"

#include "gui/broken_lines.h"
#include "gui/widgets.h"
#include "image/srgb.h"
#include "text/language.h"
#include "view/lesson/typed_number.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace raywalk {

namespace {

/// A number as shown in a field, with a decimal point.
std::string digits_of(double value) { return fmt::format("{:.5g}", value); }

/// What is typed into an item.
std::string text_typed(ImGuiID item) {
  const ImGuiInputTextState* const state = ImGui::GetInputTextState(item);
  if (state == nullptr) return {};
#if IMGUI_VERSION_NUM < 19120
  std::string text;
  // A number is written in ASCII.
  for (int i = 0; i < state->CurLenW; ++i) text += state->TextW[i] < 0x80 ? static_cast<char>(state->TextW[i]) : '?';
  return text;
#else
  return std::string(state->TextA.Data, static_cast<std::size_t>(state->TextLen));
#endif
}

/// Shows the digits with which ImGui begins with the language's decimal separator.
void show_mark(ImGuiID item, char mark) {
  ImGuiInputTextState* const state = ImGui::GetInputTextState(item);
  if (state == nullptr || mark == '.') return;
  const auto replace = [&](auto& letters, int count) {
    for (int i = 0; i < count; ++i)
      if (letters[i] == '.') letters[i] = static_cast<std::decay_t<decltype(letters[i])>>(mark);
  };
#if IMGUI_VERSION_NUM < 19120
  replace(state->TextW, state->CurLenW);
#else
  replace(state->TextA, state->TextLen);
#endif
}

/// The number that a text means; not a number if it means none.
double number_meant(std::string_view typed) {
  const std::vector<double> meant = typed_numbers(typed);
  return meant.empty() ? std::numeric_limits<double>::quiet_NaN() : meant.front();
}

/// Whether ImGui's fields keep every character: some make a replacement character of those beyond U+FFFF, which are
/// four bytes of UTF-8.
bool keeps_letters_of(std::string_view text) {
  constexpr bool all = sizeof(ImWchar) > 2 || IMGUI_VERSION_NUM >= 19120;
  return all || std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0xF0; });
}

/// Draws the number centred in the last item, like ImGui, with the language's decimal separator.
void write_number(const Ui& ui, double value, bool refused) {
  std::string words = digits_of(value);
  std::replace(words.begin(), words.end(), '.', ui.state.appearance.language.decimal_mark());
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 extent = ImGui::CalcTextSize(words.c_str());
  const ImVec2 at{std::max(low.x, (low.x + high.x - extent.x) / 2), (low.y + high.y - extent.y) / 2};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(low, high, true);
  draw.AddText(at, to_imgui(refused ? ui.colours.error : ui.colours.text), words.c_str());
  draw.PopClipRect();
}

float default_label_width(const Ui& ui, float width) { return std::min(ui.px(166), width * 0.42f); }

}  // namespace

Form::Form(const Ui& ui, FormMemory& memory, float width)
    : ui_(ui), memory_(memory), width_(width), label_width_(default_label_width(ui, width)), fields_(ui) {}

void Form::heading(const KeyLabel& of) {
  ImGui::Dummy({1, ui_.px(2)});
  push_font(ui_.fonts.strong);
  label(ui_.colours.text, of.words(ui_.state.appearance.language));
  pop_font();
}

void Form::row(const KeyLabel& of) {
  name_ = "property/" + of.words(ui_.state.appearance.language);
  refused_in_row_ = false;
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  // A longer label takes room from its own fields.
  const float needed = ImGui::CalcTextSize(of.words(ui_.state.appearance.language).c_str()).x + ui_.px(8);
  label_width_ = std::max(default_label_width(ui_, width_), std::min(needed, width_ * 0.6f));
  ImGui::PushClipRect(at, {at.x + label_width_ - ui_.px(6), at.y + ImGui::GetFrameHeight()}, true);
  label(ui_.colours.dim_text, of.words(ui_.state.appearance.language));
  tooltip(ui_, name_ + "/label", of.hint(ui_.state.appearance.language));
  ui_.publish(name_ + "/label");
  if (needed > label_width_ + ui_.px(2)) ui_.publish(name_ + "/label/clipped");
  ImGui::PopClipRect();
  ImGui::SameLine();
  ImGui::SetCursorPosX(left + label_width_);
}

void Form::before_field(const std::string& field, float width) {
  if (focus_) ImGui::SetKeyboardFocusHere();
  focus_ = false;
  ImGui::SetNextItemWidth(std::max(width, ui_.px(24)));
  reddened_ = memory_.refused == field;
  if (reddened_) ImGui::PushStyleColor(ImGuiCol_Text, to_imgui4(ui_.colours.error));
}

void Form::after_number(const std::string& field, bool is_typed, double value) {
  if (is_typed && memory_.number != field) {
    memory_.number = field;
    memory_.before = value;
  } else if (!is_typed && memory_.number == field) {
    memory_.number.clear();
  }
}

void Form::after_field(const std::string& field, std::string_view needs, double least, double most) {
  if (reddened_) ImGui::PopStyleColor();
  reddened_ = false;
  // The next action, here or in another field, clears the message, and so does what is typed on.
  if (!needs.empty()) {
    memory_.refused = field;
    memory_.why = ui_.say(needs, {{"least", number_text(least, ui_.state.appearance.language)},
                                  {"most", number_text(most, ui_.state.appearance.language)}});
  } else if (ImGui::IsItemActivated() || (memory_.number == field && memory_.refused == field)) {
    memory_.refused.clear();
  }
  refused_in_row_ |= memory_.refused == field;
}

void Form::end_row() {
  if (!refused_in_row_) return;
  // Over the rows below, not between them: they must not move under the pointer.
  const float pad = ui_.px(6);
  const std::string words = broken_lines(memory_.why, width_ - 2 * pad);
  const ImVec2 at = ImGui::GetCursorScreenPos(), extent = ImGui::CalcTextSize(words.c_str());
  const Rect where{at.x, at.y, width_, extent.y + 2 * pad};
  ImDrawList& draw = *ImGui::GetForegroundDrawList();
  draw.AddRectFilled(corner(where), opposite(where), to_imgui(ui_.colours.panel), ui_.px(4));
  draw.AddRect(corner(where), opposite(where), to_imgui(ui_.colours.error), ui_.px(4));
  draw.AddText({at.x + pad, at.y + pad}, to_imgui(ui_.colours.error), words.c_str());
  ui_.publish(name_ + "/refused", where);
}

bool Form::changed(bool now, const std::string& field) {
  if (now) {
    continues_ = memory_.edited == field;
    memory_.edited = field;
    memory_.refused.clear();
  }
  if (!ImGui::IsItemActive() && memory_.edited == field) memory_.edited.clear();
  return now;
}

bool Form::drag(const std::string& id, double& value, double step, double least, double most, float width) {
  before_field(id, width);
  // ImGui begins the typing, but knows no other separator than the point, and takes "+1" and "*2" for sums.
  const bool typed = memory_.number == id && ImGui::TempInputIsActive(ImGui::GetID(id.c_str()));
  const char mark = ui_.state.appearance.language.decimal_mark();
  double next = value;
  bool refused = false;
  if (typed) {
    std::array<char, longest_typed + 1> text{};
    ImGui::InputText(id.c_str(), text.data(), text.size());
    next = number_meant(text.data());
    // An unchanged number, also one that Escape brought back, is not rounded to its displayed digits.
    if (next == number_meant(digits_of(memory_.before))) next = memory_.before;
    // This form of the comparison also refuses NaN. Earlier digits took effect already, and are undone.
    refused = next != memory_.before && !(next >= least && next <= most);
    if (refused) next = memory_.before;
  } else {
    const bool hides = mark != '.';
    if (hides) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4{0, 0, 0, 0});
    ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &next, static_cast<float>(step), &least, &most, "%.5g");
    if (hides) ImGui::PopStyleColor();
    refused = next != value && !(next >= least && next <= most);
    if (refused) next = value;
  }
  const ImGuiID item = ImGui::GetItemID();
  const bool is_typed = ImGui::TempInputIsActive(item);
  if (is_typed && !typed) {
    next = value;
    show_mark(item, mark);
    ui_.rest.wake_in(0);  // to show the mark
  } else if (!typed && mark != '.') {
    write_number(ui_, next, reddened_);
  }
  // A double click selects the number; ImGui would select what stands on one side of a comma.
  if (is_typed && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
    ImGuiInputTextState* const state = ImGui::GetInputTextState(item);
    if (state != nullptr) state->SelectAll(), state->SelectedAllMouseLock = true;
  }
  after_number(id, is_typed, value);
  const bool is_change = changed(next != value, id);
  value = next;
  after_field(id, refused ? "notice.refused_number" : "", least, most);
  return is_change;
}

bool Form::number(const KeyLabel& of, double& value, double step, double least, double most) {
  row(of);
  const bool now = drag("##" + name_, value, step, least, most, width_ - label_width_);
  ui_.publish(name_);
  end_row();
  return now;
}

bool Form::whole(const KeyLabel& of, int& value, int least, int most, bool at_enter) {
  row(of);
  const std::string id = "##" + name_;
  before_field(id, width_ - label_width_);
  const bool typed = memory_.number == id;
  if (typed)  // ImGui would drop the minus sign of typesetters
    for (ImWchar& letter : ImGui::GetIO().InputQueueCharacters)
      if (letter == 0x2212) letter = '-';
  int next = value;
  const bool now =
      ImGui::InputInt(id.c_str(), &next, 1, 100,
                      ImGuiInputTextFlags_AutoSelectAll | (at_enter ? ImGuiInputTextFlags_EnterReturnsTrue : 0));
  ui_.publish(name_);
  ImGui::PushID(id.c_str());
  const ImGuiID item = ImGui::GetID("");  // of the text between the buttons; asked for only now (see FormMemory)
  ImGui::PopID();
  const bool is_typed = ImGui::GetActiveID() == item;
  double meant = next;
  // ImGui would take "+1" for one more, and "1.5" for 1.
  if (typed && (now || !at_enter)) meant = number_meant(text_typed(item));
  const bool refused = meant != value && !(meant >= least && meant <= most && meant == std::floor(meant));
  next = !refused ? static_cast<int>(meant) : typed && !at_enter ? static_cast<int>(memory_.before) : value;
  after_number(id, is_typed, value);
  const bool is_change = changed(next != value, id);
  value = next;
  after_field(id, refused ? "notice.refused_whole" : "", least, most);
  end_row();
  return is_change;
}

bool Form::vector(const KeyLabel& of, double* values, int count, double step, double least, double most) {
  row(of);
  const float gap = ui_.px(4);
  const float each = (width_ - label_width_ - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
  bool now = false;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui_.px(4), ImGui::GetStyle().FramePadding.y});
  for (int i = 0; i < count; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    now |= drag("##" + name_ + std::to_string(i), values[i], step, least, most, each);
    ui_.publish(name_ + "/" + std::to_string(i));
  }
  ImGui::PopStyleVar();
  end_row();
  return now;
}

bool Form::colour(const KeyLabel& of, Rgbd& value, double most) {
  row(of);
  const float gap = ui_.px(4), swatch = ImGui::GetFrameHeight();
  const float each = (width_ - label_width_ - swatch - 3 * gap) / 3;
  std::array<double, 3> channels{value.x, value.y, value.z};
  bool now = false;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui_.px(4), ImGui::GetStyle().FramePadding.y});
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    const bool grey = value.x == value.y && value.y == value.z;
    const bool moved = drag("##" + name_ + std::to_string(i), channels[i], 0.005, 0, most, each);
    // Most are grey: then the first number is enough.
    if (moved && grey && i == 0) channels.fill(channels[0]);
    now |= moved;
    ui_.publish(name_ + "/" + std::to_string(i));
  }
  ImGui::PopStyleVar();
  ImGui::SameLine(0, gap);

  // The numbers are linear light; the field and the palette show display colours.
  const std::string popup = name_ + "/palette";
  if (ImGui::ColorButton(("##" + name_).c_str(), to_imgui4(display_colour(value)), ImGuiColorEditFlags_NoTooltip,
                         {swatch, swatch}))
    ImGui::OpenPopup(popup.c_str());
  tooltip(ui_, popup, ui_.say("property.swatch_hint"));
  ui_.publish(name_ + "/swatch");
  if (ImGui::BeginPopup(popup.c_str())) {
    std::array<float, 3> shown{};
    for (std::size_t i = 0; i < 3; ++i) shown[i] = static_cast<float>(srgb_encode(std::clamp(channels[i], 0.0, 1.0)));
    const std::array<float, 3> before = shown;
    const bool picked = ImGui::ColorPicker3("##picker", shown.data(), ImGuiColorEditFlags_NoSidePreview);
    ui_.publish(popup);
    for (std::size_t i = 0; picked && i < 3; ++i) {
      if (shown[i] != before[i]) channels[i] = srgb_decode(static_cast<double>(shown[i]));
    }
    now |= changed(picked, popup);
    ImGui::EndPopup();
  }
  if (now) value = {channels[0], channels[1], channels[2]};
  end_row();
  return now;
}

bool Form::flag(const KeyLabel& of, bool& value) {
  name_ = "property/" + of.words(ui_.state.appearance.language);
  // Its words are a part of it, as everywhere.
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui4(ui_.colours.dim_text));
  const bool now = ImGui::Checkbox((of.words(ui_.state.appearance.language) + "##" + name_).c_str(), &value);
  ImGui::PopStyleColor();
  ui_.publish(name_);
  const bool is_change = changed(now, "##" + name_);
  tooltip(ui_, name_, of.hint(ui_.state.appearance.language));
  return is_change;
}

bool Form::pick(const KeyLabel& of, const std::vector<std::string>& words, int& chosen) {
  row(of);
  ImGui::SetNextItemWidth(width_ - label_width_);
  const auto at = static_cast<std::size_t>(std::clamp(chosen, 0, static_cast<int>(words.size()) - 1));
  const bool open = ImGui::BeginCombo(("##" + name_).c_str(), words[at].c_str());
  ui_.publish(name_);
  if (!open) return false;
  bool now = false;
  const ImVec2 apart = ImGui::GetStyle().ItemSpacing;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {apart.x, std::max(apart.y, ui_.finger - ImGui::GetFontSize())});
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool clicked = ImGui::Selectable(words[i].c_str(), i == at);
    // ImGui takes Space alone.
    const bool entered = ImGui::IsItemFocused() && ImGui::IsKeyPressed(ImGuiKey_Enter, false);
    if (entered) ImGui::CloseCurrentPopup();
    if (clicked || entered) {
      now = i != at;
      chosen = static_cast<int>(i);
    }
    ui_.publish(name_ + "/" + words[i]);
  }
  ImGui::PopStyleVar();
  ImGui::EndCombo();
  continues_ = false;
  return now;
}

bool Form::pick(const KeyLabel& of, const std::vector<std::string_view>& names, int& chosen) {
  std::vector<std::string> words;
  for (const std::string_view name : names)
    words.emplace_back(family_text("choice", name, ui_.state.appearance.language));
  return pick(of, words, chosen);
}

bool Form::text(const KeyLabel& of, std::string& value) {
  row(of);
  const std::string id = "##" + name_;
  before_field(id, width_ - label_width_);
  const bool naming = memory_.naming == id;
  // Has room for whatever is typed or pasted: ImGui would drop all of a paste that does not fit. Who takes the text
  // says what is too long.
  std::string buffer = naming ? memory_.typed : value;
  const auto resize = [](ImGuiInputTextCallbackData* data) {
    auto& text = *static_cast<std::string*>(data->UserData);
    text.resize(static_cast<std::size_t>(data->BufTextLen));
    data->Buf = text.data();
    return 0;
  };
  const bool is_kept = keeps_letters_of(value);
  ImGui::InputText(id.c_str(), buffer.data(), buffer.capacity() + 1,
                   ImGuiInputTextFlags_CallbackResize | (is_kept ? 0 : ImGuiInputTextFlags_ReadOnly), resize, &buffer);
  ui_.publish(name_);
  if (!is_kept) tooltip(ui_, name_, ui_.say("property.letters_hint"));
  if (ImGui::IsItemActive()) {
    memory_.naming = id;
    memory_.typed = buffer.c_str();
  }
  if (!ImGui::IsItemDeactivated()) return false;
  memory_.naming.clear();
  // Escape has restored the old text by now.
  if (!ImGui::IsItemDeactivatedAfterEdit() || value == buffer.c_str()) return false;
  value = buffer.c_str();
  return true;
}

}  // namespace raywalk
