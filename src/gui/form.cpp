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
#include <cstdlib>
#include <cstring>
#include <optional>
#include <type_traits>
#include <vector>

namespace raywalk {

namespace {

/// A number as shown in a field, with a decimal point.
std::string digits_of(double value) { return fmt::format("{:.5g}", value); }

/// The number being typed into an item, or just typed; nothing if it is not a number. A point in it is then shown as
/// the language's decimal separator.
std::optional<double> number_being_typed(ImGuiID item, char mark) {
  ImGuiInputTextState* const state = ImGui::GetInputTextState(item);
  if (state == nullptr) return std::nullopt;
  std::string typed;
  const auto take = [&](auto& letters, int count) {
    for (int i = 0; i < count; ++i) {
      if (letters[i] == '.') letters[i] = static_cast<std::decay_t<decltype(letters[i])>>(mark);
      typed += static_cast<char>(letters[i]);
    }
  };
#if IMGUI_VERSION_NUM < 19120
  take(state->TextW, state->CurLenW);
#else
  take(state->TextA, state->TextLen);
#endif
  const std::vector<double> meant = typed_numbers(typed);
  return meant.empty() ? std::nullopt : std::optional(meant.front());
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

void Form::before_number(const std::string& field) {
  if (memory_.number != field) return;
  for (ImWchar& letter : ImGui::GetIO().InputQueueCharacters)
    if (letter == ',') letter = '.';
}

void Form::after_number(const std::string& field) {
  if (ImGui::TempInputIsActive(ImGui::GetItemID()))
    memory_.number = field;
  else if (memory_.number == field)
    memory_.number.clear();
}

void Form::after_field(const std::string& field, bool refused, double least, double most) {
  if (reddened_) ImGui::PopStyleColor();
  reddened_ = false;
  // The next action, here or in another field, clears the message.
  if (refused) {
    memory_.refused = field;
    memory_.why = ui_.say("notice.refused_number", {{"least", number_text(least, ui_.state.appearance.language)},
                                                    {"most", number_text(most, ui_.state.appearance.language)}});
  } else if (ImGui::IsItemActivated()) {
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
  before_number(id);
  double next = value;
  // ImGui knows only the point. If the language has another separator, numbers are written and read here.
  const char mark = ui_.state.appearance.language.decimal_mark();
  const bool own_mark = mark != '.', was_typed = memory_.number == id, hides = own_mark && !was_typed;
  if (hides) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4{0, 0, 0, 0});
  bool now =
      ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &next, static_cast<float>(step), &least, &most, "%.5g");
  if (hides) ImGui::PopStyleColor();
  const ImGuiID item = ImGui::GetItemID();
  if (own_mark && (was_typed || ImGui::TempInputIsActive(item))) {
    ui_.rest.wake_in(0);  // to show the mark
    // An unchanged number is not rounded to its displayed digits.
    const std::optional<double> read = number_being_typed(item, mark);
    now = read && *read != value && *read != std::strtod(digits_of(value).c_str(), nullptr);
    next = now ? *read : value;
  } else if (hides) {
    write_number(ui_, next, reddened_);
  }
  after_number(id);
  if (ImGui::IsItemActivated()) memory_.before = value;
  // Typing may exceed the limits; this form of the comparison also refuses NaN. Earlier digits took effect already, and
  // are undone.
  const bool good = next >= least && next <= most, back = now && !good && value != memory_.before;
  if (now && good) value = next;
  if (back) value = memory_.before;
  const bool is_change = changed((now && good) || back, id);
  after_field(id, now && !good, least, most);
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
  int next = value;
  const bool now =
      ImGui::InputInt(id.c_str(), &next, 1, 100,
                      ImGuiInputTextFlags_AutoSelectAll | (at_enter ? ImGuiInputTextFlags_EnterReturnsTrue : 0));
  const bool good = next >= least && next <= most;
  ui_.publish(name_);
  if (now && good) value = next;
  const bool is_change = changed(now && good, id);
  after_field(id, now && !good, least, most);
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
  std::array<char, 256> buffer{};
  const std::string& shown = naming ? memory_.typed : value;
  std::strncpy(buffer.data(), shown.c_str(), buffer.size() - 1);
  ImGui::InputText(id.c_str(), buffer.data(), buffer.size());
  ui_.publish(name_);
  if (ImGui::IsItemActive()) {
    memory_.naming = id;
    memory_.typed = buffer.data();
  }
  if (!ImGui::IsItemDeactivated()) return false;
  memory_.naming.clear();
  // Escape has restored the old text by now.
  if (!ImGui::IsItemDeactivatedAfterEdit() || value == buffer.data()) return false;
  value = buffer.data();
  return true;
}

}  // namespace raywalk
