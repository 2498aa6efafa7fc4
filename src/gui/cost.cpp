// What accuracy costs in this scene: knobs, error against cost, and two pictures side by side.

#include "view/cost/cost.h"
#include "gui/broken_lines.h"
#include "gui/choices.h"
#include "gui/command.h"
#include "gui/live_costs.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "text/language.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raywalk {

namespace {

/// Tooltips of the marks; a click chooses, with Shift or the right button it compares.
void draw_plot(const Ui& ui, const Rect& where, const CostFindings& findings) {
  const float scale = ui.dpi;
  const CostPlot plot = cost_plot(ui.state, findings, static_cast<double>(where.width / scale),
                                  static_cast<double>(where.height / scale), static_cast<double>(ui.unit / scale));
  paint(*ImGui::GetWindowDrawList(), plot.list, where, scale, ui.fonts);
  ImGui::SetCursorScreenPos(corner(where));
  ImGui::InvisibleButton("cost-plot", size(where),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  ui.publish("cost-plot", where);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Vec2d at{static_cast<double>((mouse.x - where.x) / scale), static_cast<double>((mouse.y - where.y) / scale)};
  const double reach = static_cast<double>(ui.px(14) / scale);
  const CostPlot::Mark* nearest = nullptr;
  for (const CostPlot::Mark& mark : plot.marks) {
    ui.publish("cost-mark-" + std::to_string(mark.attempt), {where.x + static_cast<float>(mark.at.x) * scale,
                                                             where.y + static_cast<float>(mark.at.y) * scale, 0, 0});
    if (length(mark.at - at) <= reach && (nearest == nullptr || length(mark.at - at) < length(nearest->at - at)))
      nearest = &mark;
  }
  if (nearest == nullptr || !ImGui::IsItemHovered()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  tooltip(ui, "cost-mark-" + std::to_string(nearest->attempt), attempt_text(ui.state, findings, nearest->attempt),
          TipOf::point);
  if (ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1))
    ui.act(action::ChooseCost{nearest->attempt, ImGui::IsMouseClicked(1) || ImGui::GetIO().KeyShift});
}

void draw_picture(const Ui& ui, const Rect& room, const PictureView& picture) {
  const ImageSize extent = picture.costs->size();
  if (picture.cost_texture == 0 || extent.width == 0) return;
  const CostRoom& cost = ui.state.cost;
  const std::string right = cost.against < 0 ? ui.say("cost.reference_name") : "B";
  const std::string difference = broken_lines(
      ui.say("cost.difference",
             {{"other", right}, {"largest", number_text(picture.costs->largest(), ui.state.appearance.language)}}),
      room.width);
  const bool differs = cost.picture == CostPicture::difference;
  const float legend = ImGui::CalcTextSize(differs ? difference.c_str() : "A").y + ui.px(4);
  const float scale = std::min(room.width / static_cast<float>(extent.width),
                               (room.height - legend) / static_cast<float>(extent.height));
  if (scale <= 0) return;
  const Rect image{std::round(room.x), std::round(room.y), std::round(scale * static_cast<float>(extent.width)),
                   std::round(scale * static_cast<float>(extent.height))};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddImage((ImTextureID)picture.cost_texture, corner(image), opposite(image));
  ui.publish("cost-picture", image);
  const ImU32 ink = to_imgui(ui.colours.text);
  const float y = image.bottom() + ui.px(3);
  if (differs) {
    draw.AddText({image.x, y}, ink, difference.c_str());
  } else {
    const float border = image.x + static_cast<float>(cost.split) * image.width;
    draw.AddLine({border, image.y}, {border, image.bottom()}, IM_COL32(0, 0, 0, 255), ui.px(3));
    draw.AddLine({border, image.y}, {border, image.bottom()}, IM_COL32(255, 255, 255, 255), ui.px(1.5f));
    draw.AddCircleFilled({border, (image.y + image.bottom()) / 2}, ui.px(7), IM_COL32(0, 0, 0, 255));
    draw.AddCircleFilled({border, (image.y + image.bottom()) / 2}, ui.px(5.5f), IM_COL32(255, 255, 255, 255));
    draw.AddText({image.x, y}, ink, "A");
    draw.AddText({image.right() - ImGui::CalcTextSize(right.c_str()).x, y}, ink, right.c_str());
  }
  ImGui::SetCursorScreenPos(corner(image));
  ImGui::InvisibleButton("cost-picture", size(image));
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive() && cost.picture == CostPicture::split) {
    const double at = static_cast<double>((ImGui::GetIO().MousePos.x - image.x) / image.width);
    if (std::clamp(at, 0.0, 1.0) != cost.split) ui.act(action::ShowCosts{cost.picture, cost.axis, at});
  }
}

void draw_effects(const Ui& ui, const Rect& where, float top, const LiveCosts& costs) {
  const float line = line_height(ui.fonts, *ui.fonts.small), scale = ui.dpi;
  const std::string whole = survey_text(costs.survey(), costs.surveyed(), ui.state.appearance.language);
  ImGui::PushTextWrapPos(0);
  const float text_height = ImGui::CalcTextSize(whole.c_str(), nullptr, false, where.width).y + ui.px(6);
  ImGui::PopTextWrapPos();
  const Rect bars{where.x, top, where.width, where.bottom() - top - std::max(text_height, line)};
  if (bars.height > 8) {
    const DisplayList list =
        effect_bars(ui.state, costs.survey(), static_cast<double>(bars.width / scale),
                    static_cast<double>(bars.height / scale), static_cast<double>(ui.unit / scale));
    paint(*ImGui::GetWindowDrawList(), list, bars, scale, ui.fonts);
    ui.publish("cost-effects", bars);
  }
  ImGui::SetCursorScreenPos({where.x, bars.bottom() + ui.px(6)});
  paragraph(ui.colours.dim_text, whole);
}

}  // namespace

void cost_knobs_popup(const Ui& ui, FormMemory& memory) {
  const FormPopup popup(ui, "cost-knobs");
  if (!popup) return;
  const float width = popup.width(ui, 390);
  Form form(ui, memory, width);
  form.heading("cost.knobs");
  const study::Setup now = cost_knobs(ui.state);
  study::Setup next = now;
  form.whole("property.samples", next.samples, 1, CostRoom::max_samples);
  pick_among(ui, form, "property.sampler", values_of<Sampler>, next.sampler);
  form.whole("property.light_grid", next.light_grid, 0, CostRoom::max_grid);
  form.whole("property.limits_depth", next.depth, 1, CostRoom::max_depth);
  form.number("property.threshold", next.threshold, 0.0005, 0, 1);
  form.number("property.tolerance", next.tolerance, 0.0005, 0, 1);
  pick_among(ui, form, "property.precision", precisions, next.single_precision, precision_word);
  pick_among(ui, form, "property.numerics", values_of<Numerics>, next.numerics);
  if (next.numerics == Numerics::naive) form.number("property.epsilon", next.epsilon, 1e-6, 0, 1);
  pick_among(ui, form, "property.accelerator", pickable_accelerators, next.accelerator);
  if (!(next == now)) ui.act(action::SetCostKnobs{next});
  ImGui::Dummy({1, ui.px(2)});
  const ButtonLook look{.look = Look::primary, .icon = Icon::none, .font = ui.fonts.small, .label = true};
  command_button(ui, command("cost-try"), {width, ui.high(30)}, look);
}

namespace {

void cost_tab(const Ui& ui, const Rect& where, const PictureView& picture) {
  if (picture.costs == nullptr) return;
  push_font(ui.fonts.small);
  const CostFindings findings = findings_of(picture.costs->bench());

  ButtonRow row(ui, where, ui.high(28));
  row.add(command("cost-page"));
  if (ui.state.cost.page == CostPage::effects) {
    draw_effects(ui, where, row.bottom() + ui.px(8), *picture.costs);
    return pop_font();
  }
  row.add(command("cost-knobs"),
          setup_text(cost_knobs(ui.state), study::setup_of(ui.state.scene()), ui.state.appearance.language));
  row.add(command("cost-try"));
  row.add(command("cost-ladder"));
  row.add(command("cost-axis"));
  row.add(command("cost-kind"));
  row.add(command("cost-forget"));

  const std::string chosen = broken_lines("A: " + attempt_text(ui.state, findings, ui.state.cost.chosen), where.width);
  const std::string other =
      broken_lines(ui.state.cost.against < 0 ? reference_text(findings, ui.state.appearance.language)
                                             : "B: " + attempt_text(ui.state, findings, ui.state.cost.against),
                   where.width);
  const auto height_of = [](const std::string& words) { return ImGui::CalcTextSize(words.c_str()).y; };
  const float text_height = height_of(chosen) + height_of(other) + ui.px(6), gap = ui.px(8);
  Rect body{where.x, row.bottom() + gap, where.width, where.bottom() - row.bottom() - text_height - 2 * gap};
  if (ui.state.cost.tried.empty()) {
    ImGui::SetCursorScreenPos({where.x, body.y});
    paragraph(ui.colours.dim_text, ui.say("cost.empty"));
    return pop_font();
  }
  // Side by side, or one above the other if that gives both more room.
  const bool beside = body.width > 1.2f * body.height;
  Rect plot = body, image = body;
  if (beside) {
    plot.width = std::floor(body.width * 0.54f);
    image.x = plot.right() + gap;
    image.width = body.right() - image.x;
  } else {
    plot.height = std::floor(body.height * 0.55f);
    image.y = plot.bottom() + gap;
    image.height = body.bottom() - image.y;
  }
  if (plot.width > 8 && plot.height > 8) draw_plot(ui, plot, findings);
  if (image.width > 8 && image.height > 8) draw_picture(ui, image, picture);

  const float y = where.bottom() - text_height;
  ImGui::SetCursorScreenPos({where.x, y});
  label(ui.colours.text, chosen);
  ImGui::SetCursorScreenPos({where.x, y + height_of(chosen)});
  label(ui.colours.dim_text, other);
  pop_font();
}

}  // namespace

void CostRoom::draw_tab(const Ui& ui, const Rect& where, TabContext& context) { cost_tab(ui, where, context.picture); }

namespace {

constexpr std::array cost_pictures{CostPicture::split, CostPicture::difference};
constexpr std::array cost_axes{study::CostAxis::rays, study::CostAxis::tests, study::CostAxis::seconds};
constexpr double split_step = 0.05;  // of the picture's width

bool has_tries(const State& state) {
  return state.appearance.tab == CostRoom::tab && state.cost.page == CostPage::tries && !state.cost.tried.empty();
}

bool shows_effects(const State& state) {
  return state.appearance.tab == CostRoom::tab && state.cost.page == CostPage::effects;
}

void try_cost(const Ui& ui, bool ladder) {
  ui.act(action::SetTab{CostRoom::tab});
  ui.act(action::ShowCostPage{CostPage::tries});
  ui.act(action::TryCost{ladder});
}

void move_split(const Ui& ui, double by) {
  const CostRoom& cost = ui.state.cost;
  ui.act(action::ShowCosts{cost.picture, cost.axis, cost.split + by});
}

std::string axis_label(const State& state, bool) {
  switch (state.cost.axis) {
    case study::CostAxis::rays:
      return fill("cost.axis_rays", state.appearance.language);
    case study::CostAxis::tests:
      return fill("cost.axis_tests", state.appearance.language);
    case study::CostAxis::seconds:
      return fill("cost.axis_seconds", state.appearance.language);
  }
  return {};
}

void choose_next(const Ui& ui) {
  const CostRoom& cost = ui.state.cost;
  ui.act(action::ChooseCost{(cost.chosen + 1) % static_cast<int>(cost.tried.size())});
}

void compare_with_next(const Ui& ui) {
  const int next = ui.state.cost.against + 1;
  ui.act(action::ChooseCost{next < static_cast<int>(ui.state.cost.tried.size()) ? next : -1, true});
}

std::string kind_label(const State& state, bool) {
  return fill(state.cost.picture == CostPicture::split ? "cost.shows_split" : "cost.shows_difference",
              state.appearance.language);
}

void change_kind(const Ui& ui) {
  const CostRoom& cost = ui.state.cost;
  ui.act(action::ShowCosts{next_among(cost_pictures, cost.picture), cost.axis, cost.split});
}

void change_axis(const Ui& ui) {
  const CostRoom& cost = ui.state.cost;
  ui.act(action::ShowCosts{cost.picture, next_among(cost_axes, cost.axis), cost.split});
}

std::string page_label(const State& state, bool) {
  return fill(shows_effects(state) ? "cost.page_tries" : "cost.page_effects", state.appearance.language);
}

void turn_page(const Ui& ui) {
  ui.act(action::SetTab{CostRoom::tab});
  ui.act(action::ShowCostPage{shows_effects(ui.state) ? CostPage::tries : CostPage::effects});
}

}  // namespace

Commands CostRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-cost", .keys = {"F3"}, .section = Section::tabs, .line = "keys.cost", .chosen = shows_tab<CostRoom>,
       .run = open_tab<CostRoom>},
      {.name = "cost-knobs", .keys = {"Shift+F3"}, .line = "keys.cost", .run = wish<WindowWish::cost_knobs>},
      {.name = "cost-try", .keys = {"F4"}, .line = "keys.cost", .run = [](const Ui& ui) { try_cost(ui, false); }},
      {.name = "cost-ladder", .keys = {"Shift+F4"}, .line = "keys.cost",
       .run = [](const Ui& ui) { try_cost(ui, true); }},
      {.name = "cost-forget", .keys = {"Ctrl+F4"}, .line = "keys.cost", .enabled = has_tries,
       .run = act<action::ForgetCosts>},
      {.name = "cost-next", .keys = {"F5"}, .section = Section::cost, .line = "keys.cost_views", .enabled = has_tries,
       .run = choose_next},
      {.name = "cost-against", .keys = {"Shift+F5"}, .section = Section::cost, .line = "keys.cost_views",
       .enabled = has_tries, .run = compare_with_next},
      {.name = "cost-kind", .keys = {"F6"}, .line = "keys.cost_views", .enabled = has_tries, .label = kind_label,
       .run = change_kind},
      {.name = "cost-axis", .keys = {"F7"}, .line = "keys.cost_views", .enabled = has_tries, .label = axis_label,
       .run = change_axis},
      {.name = "cost-split-left", .keys = {"Shift+F8"}, .section = Section::cost, .line = "keys.cost_views",
       .enabled = has_tries, .run = [](const Ui& ui) { move_split(ui, -split_step); }},
      {.name = "cost-split-right", .keys = {"F8"}, .section = Section::cost, .line = "keys.cost_views",
       .enabled = has_tries, .run = [](const Ui& ui) { move_split(ui, split_step); }},
      {.name = "cost-page", .keys = {"F9"}, .section = Section::cost, .label = page_label, .run = turn_page},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
