// The settings of the 3-D picture, and the legend of its heat map.

#include "gui/choices.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "gui/words.h"
#include "render/heat.h"
#include "view/text.h"

#include <algorithm>
#include <array>

namespace raywalk {

namespace {

constexpr std::array integrators{Integrator::automatic, Integrator::cast, Integrator::whitted, Integrator::distributed,
                                 Integrator::path};

std::string_view heat_name(Heat heat) {
  switch (heat) {
    case Heat::none:
      return words::heat_none;
    case Heat::rays:
      return words::heat_rays;
    case Heat::tests:
      return words::heat_tests;
    case Heat::time:
      return words::heat_time;
    case Heat::noise:
      return words::heat_noise;
  }
  return "";
}

}  // namespace

void epsilon_row(const Ui& ui, Form& form) {
  const RenderChoices& now = ui.state.scene().render;
  double epsilon = now.epsilon;
  if (form.number(std::string(words::epsilon), epsilon, 1e-5, 0, 1e6))
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
  form.heading(words::image_settings);
  const State& state = ui.state;
  ImageSettings next = state.image;

  Integrator integrator = next.integrator.value_or(state.scene().render.integrator);
  if (pick_among(form, std::string(words::integrator), integrators, integrator_name, integrator))
    next.integrator = integrator;
  pick_among(form, std::string(words::accelerator), pickable_accelerators, accelerator_name, next.accelerator);
  form.whole(std::string(words::samples), next.samples, 1, most_image_samples);
  form.whole(std::string(words::walk_samples), next.walk_samples, 1, most_walk_samples);
  pick_among(form, std::string(words::precision), precisions, precision_word, next.single_precision);
  pick_among(form, std::string(words::heat), all_heats, heat_name, next.heat);
  if (next != state.image) ui.act(action::SetImageSettings{next});

  // These belong to the scene: the walk and the file have them too.
  TraceLimits limits = state.scene().limits;
  bool now = form.whole(TextId::depth_limit, limits.depth, 1, 50);
  now |= form.number(TextId::threshold, limits.threshold, 0.0005, 0, 1);
  if (now) ui.act(action::SetLimits{limits, form.continues()});
  Numerics numerics = state.scene().render.numerics;
  if (pick_among(form, std::string(words::numerics), all_numerics, numerics_name, numerics))
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
  const auto most = [&] {
    switch (heat) {
      case Heat::none:
        return TextId::heat_rays;
      case Heat::rays:
        return TextId::heat_rays;
      case Heat::tests:
        return TextId::heat_tests;
      case Heat::time:
        return TextId::heat_time;
      case Heat::noise:
        return TextId::heat_noise;
    }
    return TextId::heat_rays;
  }();
  const std::array<std::string, 3> numbers{"0", number_text(hottest / 2), fill(most, {number_text(hottest)})};
  const float bar = ui.px(9), y = where.y;
  // The longest number stands to the right of the bar, the others below their colours.
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
