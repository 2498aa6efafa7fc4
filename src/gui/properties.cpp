#include "view/document/properties.h"
#include "gui/command.h"
#include "gui/form.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text/shown.h"
#include "view/text/text.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

/// Properties as the fields of a form.
class FormRows final : public PropertyRows {
 public:
  explicit FormRows(Form& form) : form_(form) {}

  bool number(const Key& key, double& value, const schema::Number& kind) override {
    return std::isfinite(value) && form_.number(label(key), value, step_of(kind, value), least(kind), most(kind));
  }
  bool whole(const Key& key, int& value, const schema::Whole& kind) override {
    return form_.whole(label(key), value, kind.low, kind.high);
  }
  bool flag(const Key& key, bool& value) override { return form_.flag(label(key), value); }
  bool choice(const Key& key, std::size_t& chosen, const std::vector<std::string_view>& words) override {
    int index = static_cast<int>(chosen);
    if (!form_.pick(label(key), words, index)) return false;
    chosen = static_cast<std::size_t>(index);
    return true;
  }
  bool numbers(const Key& key, std::span<double> values, const schema::Tuple& kind) override {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return form_.vector(label(key), values.data(), static_cast<int>(values.size()), step_of(kind.number, largest),
                        least(kind.number), most(kind.number));
  }
  bool colour(const Key& key, Rgbd& value, const schema::Colour& kind) override {
    return form_.colour(label(key), value, kind.number.high);
  }
  bool file(const Key& key, std::string& value) override { return form_.text(label(key), value); }
  bool name(std::string& value) override { return form_.text("property.name", value); }
  void heading(std::string_view id) override { form_.heading(id); }
  // A field shows by itself what it does not take.
  void broken(std::string_view /*message*/, std::string_view /*hint*/) override {}

 private:
  static KeyLabel label(const Key& key) { return {KeyLabel(key.table, key.name, key.sentence), key.row}; }
  /// Of dragging by a pixel.
  static double step_of(const schema::Number& kind, double value) {
    return kind.unit == schema::degrees ? 0.2 : std::max(0.005, std::abs(value) / 200);
  }
  static double least(const schema::Number& kind) {
    return kind.above_low ? kind.low + 1 / schema::max_magnitude : kind.low;
  }
  static double most(const schema::Number& kind) {
    return kind.below_high ? std::nextafter(kind.high, kind.low) : kind.high;
  }

  Form& form_;
};

/// Acts, as a part of the edit before if the form says so.
void act(const Ui& ui, PropertyEdit edit, bool continues) {
  std::visit(
      [&](auto& each) {
        if constexpr (requires { each.continues; }) each.continues = continues;
        ui.act(std::move(each));
      },
      edit);
}

}  // namespace

void PropertiesPane::draw(const Ui& ui, const Rect& where, bool focus) {
  const Pane pane(ui, "properties", where, ui.colours.panel, {ui.px(14), ui.px(10)});
  if (!pane) return;
  const Target target = ui.state.plan.selected;
  const float width = ImGui::GetContentRegionAvail().x, edge = ui.high(28);
  push_font(ui.fonts.title);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(at, {at.x + width - edge - ui.px(8), at.y + edge}, true);
  if (ui.finger > 0) ImGui::SetCursorScreenPos({at.x, at.y + (edge - ImGui::GetFontSize()) / 2});
  label(ui.colours.text, properties_title(ui.state));
  ImGui::PopClipRect();
  pop_font();
  ImGui::SetCursorScreenPos({at.x + width - edge, at.y});
  command_button(ui, command("deselect"), {edge, edge},
                 {.look = Look::flat, .icon = Icon::close, .font = nullptr, .label = false});

  push_font(ui.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(5)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(6), ui.px(4)});
  // Fields of different things need different ids.
  ImGui::PushID(static_cast<int>(target.kind));
  ImGui::PushID(target.index);
  if (std::exchange(shown_, target) != target) {
    memory_ = {};
    ImGui::SetScrollY(0);
  }
  Form form(ui, memory_, width);
  // First the pane, a frame later its field: newer versions of ImGui search only the focused window.
  if (std::exchange(focus_field_, false)) form.focus_next();
  if (focus) ImGui::SetWindowFocus();
  focus_field_ |= focus;
  FormRows rows(form);
  if (auto edit = property_rows(ui.state, target, rows)) act(ui, std::move(*edit), form.continues());
  ImGui::PopID();
  ImGui::PopID();
  ImGui::PopStyleVar(2);
  pop_font();
  close_edges(ui, ui.colours.panel);
}

}  // namespace raywalk
