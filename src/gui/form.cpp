#include "gui/form.h"

#include "gui/widgets.h"
#include "gui/words.h"
#include "io/srgb.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace raywalk {

Form::Form(const Ui& ui, FormMemory& memory, float width)
    : ui_(ui), memory_(memory), width_(width), label_width_(std::min(ui.px(124), width * 0.42f)) {}

void Form::heading(std::string_view text) {
  ImGui::Dummy({1, ui_.px(2)});
  push_font(ui_.fonts.strong);
  label(ui_.colours.text, text);
  pop_font();
}

void Form::row(std::string_view text) {
  name_ = "property/" + std::string(text);
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(at, {at.x + label_width_ - ui_.px(6), at.y + ImGui::GetFrameHeight()}, true);
  label(ui_.colours.dim_text, text);
  ImGui::PopClipRect();
  ImGui::SameLine();
  ImGui::SetCursorPosX(left + label_width_);
}

void Form::before_field(float width) {
  if (focus_) ImGui::SetKeyboardFocusHere();
  focus_ = false;
  ImGui::SetNextItemWidth(std::max(width, ui_.px(24)));
}

bool Form::changed(bool now, const std::string& field) {
  const unsigned id = ImGui::GetID(field.c_str());
  if (now) {
    continues_ = memory_.edited == id;
    memory_.edited = id;
  }
  if (!ImGui::IsItemActive() && memory_.edited == id) memory_.edited = 0;
  return now;
}

bool Form::drag(const std::string& id, double& value, double step, double least, double most) {
  double next = value;
  const bool now =
      ImGui::DragScalar(id.c_str(), ImGuiDataType_Double, &next, static_cast<float>(step), &least, &most, "%.5g");
  // Typing may leave the limits; comparing this way round also refuses what is not a number.
  const bool good = next >= least && next <= most;
  if (now && good) value = next;
  return changed(now && good, id);
}

bool Form::number(std::string_view text, double& value, double step, double least, double most) {
  row(text);
  before_field(width_ - label_width_);
  const bool now = drag("##" + name_, value, step, least, most);
  ui_.publish(name_);
  return now;
}

bool Form::whole(std::string_view text, int& value, int least, int most) {
  row(text);
  before_field(width_ - label_width_);
  int next = value;
  const bool now = ImGui::InputInt(("##" + name_).c_str(), &next) && next >= least && next <= most;
  ui_.publish(name_);
  if (now) value = next;
  return changed(now, "##" + name_);
}

bool Form::vector(std::string_view text, double* values, int count, double step) {
  row(text);
  constexpr double far = 1e6;
  const float gap = ui_.px(4);
  const float each = (width_ - label_width_ - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
  bool now = false;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui_.px(4), ImGui::GetStyle().FramePadding.y});
  for (int i = 0; i < count; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    before_field(each);
    now |= drag("##" + name_ + std::to_string(i), values[i], step, -far, far);
    ui_.publish(name_ + "/" + std::to_string(i));
  }
  ImGui::PopStyleVar();
  return now;
}

bool Form::colour(std::string_view text, Rgbd& value, double most) {
  row(text);
  const float gap = ui_.px(4), swatch = ImGui::GetFrameHeight();
  const float each = (width_ - label_width_ - swatch - 3 * gap) / 3;
  std::array<double, 3> channels{value.x, value.y, value.z};
  bool now = false;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui_.px(4), ImGui::GetStyle().FramePadding.y});
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    before_field(each);
    now |= drag("##" + name_ + std::to_string(i), channels[i], 0.005, 0, most);
    ui_.publish(name_ + "/" + std::to_string(i));
  }
  ImGui::PopStyleVar();
  ImGui::SameLine(0, gap);

  // The numbers are linear light; the field and the palette show what a display makes of it.
  const std::string popup = name_ + "/palette";
  if (ImGui::ColorButton(("##" + name_).c_str(), to_imgui4(display_colour(value)), ImGuiColorEditFlags_NoTooltip,
                         {swatch, swatch}))
    ImGui::OpenPopup(popup.c_str());
  tooltip(ui_, popup, std::string(words::swatch_hint));
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
  return now;
}

bool Form::flag(std::string_view text, bool& value) {
  name_ = "property/" + std::string(text);
  before_field(0);
  const bool now = ImGui::Checkbox(("##" + name_).c_str(), &value);
  ui_.publish(name_);
  const bool is_change = changed(now, "##" + name_);
  ImGui::SameLine();
  label(ui_.colours.dim_text, text);
  return is_change;
}

bool Form::text(std::string_view text, std::string& value) {
  row(text);
  before_field(width_ - label_width_);
  const std::string id = "##" + name_;
  const bool naming = memory_.naming == ImGui::GetID(id.c_str());
  std::array<char, 256> buffer{};
  const std::string& shown = naming ? memory_.typed : value;
  std::strncpy(buffer.data(), shown.c_str(), buffer.size() - 1);
  ImGui::InputText(id.c_str(), buffer.data(), buffer.size());
  ui_.publish(name_);
  if (ImGui::IsItemActive()) {
    memory_.naming = ImGui::GetID(id.c_str());
    memory_.typed = buffer.data();
  }
  if (!ImGui::IsItemDeactivated()) return false;
  memory_.naming = 0;
  // Escape has put the old text back by now.
  if (!ImGui::IsItemDeactivatedAfterEdit() || value == buffer.data()) return false;
  value = buffer.data();
  return true;
}

}  // namespace raywalk
