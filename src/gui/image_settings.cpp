// The settings of the 3-D picture, and the legend of its heat map.

#include "gui/choices.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "render/heat.h"
#include "view/text.h"

#include <algorithm>
#include <array>

namespace raywalk {

namespace {

constexpr std::array integrators{Integrator::automatic, Integrator::cast, Integrator::whitted, Integrator::distributed,
                                 Integrator::path};

std::string_view heat_word(Heat heat) {
  switch (heat) {
    case Heat::none:
      return "heat.none";
    case Heat::rays:
      return "heat.rays";
    case Heat::tests:
      return "heat.tests";
    case Heat::time:
      return "heat.time";
    case Heat::noise:
      return "heat.noise";
  }
  return "heat.none";
}

}  // namespace

void epsilon_row(const Ui& ui, Form& form) {
  const RenderChoices& now = ui.state.scene().render;
  double epsilon = now.epsilon;
  if (form.number("property.epsilon", epsilon, 1e-5, 0, 1e6))
    ui.act(action::SetNumerics{now.numerics, epsilon, form.continues()});
}

void image_settings(const Ui& ui, FormMemory& memory) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(14), ui.px(12)});
  const bool open = ImGui::BeginPopup("image-settings");
  ImGui::PopStyleVar();
  if (!open) return;
  ui.publish("image-settings-popup",
             {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y, ImGui::GetWindowWidth(), ImGui::GetWindowHeight()});
  push_font(ui.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(6)});
  Form form(ui, memory, ui.px(390));
  form.heading("image.settings_title");
  const State& state = ui.state;
  ImageSettings next = state.image;

  Integrator integrator = next.integrator.value_or(state.scene().render.integrator);
  if (pick_among(ui, form, "property.integrator", integrators, integrator)) next.integrator = integrator;
  pick_among(ui, form, "property.accelerator", pickable_accelerators, next.accelerator);
  form.whole("property.samples", next.samples, 1, max_image_samples);
  form.whole("property.walk_samples", next.walk_samples, 1, max_walk_samples);
  pick_among(ui, form, "property.precision", precisions, next.single_precision, precision_word);
  pick_among(ui, form, "property.heat", all_heats, next.heat, heat_word);
  if (next != state.image) ui.act(action::SetImageSettings{next});

  // These belong to the scene: they also affect the walk and the file.
  TraceLimits limits = state.scene().limits;
  bool now = form.whole("property.limits_depth", limits.depth, 1, 50);
  now |= form.number("property.threshold", limits.threshold, 0.0005, 0, 1);
  if (now) ui.act(action::SetLimits{limits, form.continues()});
  Numerics numerics = state.scene().render.numerics;
  if (pick_among(ui, form, "property.numerics", all_numerics, numerics))
    ui.act(action::SetNumerics{numerics, state.scene().render.epsilon});
  epsilon_row(ui, form);

  ImGui::Dummy({1, ui.px(2)});
  const ButtonLook look{.look = Look::plain, .icon = Icon::none, .font = ui.fonts.small, .label = true};
  const ImVec2 extent{ui.px(390), ui.px(30)};
  command_button(ui, Command::reset_view, extent, look);
  command_button(ui, Command::use_camera, extent, look);
  ImGui::PopStyleVar();
  pop_font();
  ImGui::EndPopup();
}

void heat_legend(const Ui& ui, const Rect& where, Heat heat, double hottest) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto most = [&]() -> std::string_view {
    switch (heat) {
      case Heat::none:
        return "heat.scale_rays";
      case Heat::rays:
        return "heat.scale_rays";
      case Heat::tests:
        return "heat.scale_tests";
      case Heat::time:
        return "heat.scale_time";
      case Heat::noise:
        return "heat.scale_noise";
    }
    return "heat.scale_rays";
  }();
  const std::array<std::string, 3> numbers{"0", number_text(hottest / 2, ui.state.language),
                                           ui.say(most, {{"number", number_text(hottest, ui.state.language)}})};
  const float bar = ui.px(9), y = where.y;
  // The last number is to the right of the bar, the others below their colours.
  const float last = ImGui::CalcTextSize(numbers[2].c_str()).x;
  const float left = where.x + ImGui::CalcTextSize(numbers[0].c_str()).x + ui.px(8);
  const float right = std::max(where.right() - last - ui.px(10), left + ui.px(20));
  constexpr int pieces = 64;
  for (int i = 0; i < pieces; ++i) {
    const auto c = heat_colour((i + 0.5) / pieces);
    const float from = left + (right - left) * static_cast<float>(i) / pieces;
    const float to = left + (right - left) * static_cast<float>(i + 1) / pieces;
    draw.AddRectFilled({from, y}, {to + 0.5f, y + bar}, IM_COL32(c[0], c[1], c[2], 255));
  }
  const ImU32 ink = to_imgui(ui.colours.dim_text);
  const float middle_of_bar = y + (bar - ImGui::GetFontSize()) / 2;
  draw.AddText({where.x, middle_of_bar}, ink, numbers[0].c_str());
  draw.AddText({right + ui.px(8), middle_of_bar}, ink, numbers[2].c_str());
  const float middle = (left + right) / 2;
  draw.AddLine({middle, y + bar}, {middle, y + bar + ui.px(4)}, ink);
  draw.AddText({middle - ImGui::CalcTextSize(numbers[1].c_str()).x / 2, y + bar + ui.px(4)}, ink, numbers[1].c_str());
  ui.publish("heat-legend", {where.x, y, where.width, bar});
}

}  // namespace raywalk
