// The 3-D picture, its settings, and the legend of its heat map.

#include "gui/choices.h"
#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "gui/window.h"
#include "render/heat.h"
#include "view/lesson/lesson_panel.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raywalk {

namespace {

// The largest centred rectangle with the picture's aspect ratio in `room`; an integer multiple of the picture, so that
// pixels are equal, unless that is much smaller.
Rect fitted(const Rect& room, int width, int height, float density) {
  constexpr float worth = 0.8f;
  const float across = std::max(room.width, 1.0f), down = std::max(room.height, 1.0f);
  float scale = std::min(across / static_cast<float>(width), down / static_cast<float>(height));
  const float whole = std::floor(scale * density);
  if (whole >= 3 || (whole >= 1 && whole > worth * scale * density)) scale = whole / density;
  const float w = std::floor(static_cast<float>(width) * scale), h = std::floor(static_cast<float>(height) * scale);
  return {std::round(room.x + (room.width - w) / 2), std::round(room.y + (room.height - h) / 2), w, h};
}

// Unequal pixels are smoothed.
void draw_texture(const Ui& ui, const Rect& image, const PictureView& picture) {
  const bool is_whole = std::fmod(image.width * ui.fonts.density, static_cast<float>(picture.width)) < 1;
  set_magnification(picture.texture, is_whole ? Magnification::pixels : Magnification::smooth);
  ImGui::GetWindowDrawList()->AddImage((ImTextureID)picture.texture, corner(image), opposite(image));
}

// The row that is the strip: marks at both sides and hairlines above and below it.
void mark_row(const Ui& ui, const Rect& image, float top, float bottom) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 ink = to_imgui(ui.colours.selected);
  const float y = (top + bottom) / 2, r = ui.px(6);
  fill_triangle(draw, {image.x - ui.px(2), y}, {image.x - ui.px(2) - r, y - r}, {image.x - ui.px(2) - r, y + r}, ink);
  fill_triangle(draw, {image.right() + ui.px(2), y}, {image.right() + ui.px(2) + r, y + r},
                {image.right() + ui.px(2) + r, y - r}, ink);
  const ImU32 faint = to_imgui(ui.colours.selected.with_alpha(120));
  draw.AddLine({image.x, top}, {image.right(), top}, faint);
  draw.AddLine({image.x, bottom}, {image.right(), bottom}, faint);
}

void mark_cell(const Ui& ui, const Rect& image, int cell, int cells, float middle) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float edge = image.width / static_cast<float>(cells), half = std::max(edge / 2, ui.px(4));
  const float x = image.x + (static_cast<float>(cell) + 0.5f) * edge;
  const ImVec2 least{x - half, middle - half}, most{x + half, middle + half};
  // White on black, visible on any picture.
  draw.AddRect(least, most, IM_COL32(0, 0, 0, 255), 0, 0, ui.px(3.5f));
  draw.AddRect(least, most, IM_COL32(255, 255, 255, 255), 0, 0, ui.px(1.5f));
}

// Marks the walked pixel, if the picture is the one it was chosen in.
void mark_walked(const Ui& ui, const Rect& image, const PictureView& picture) {
  const std::optional<PixelWalk>& walk = ui.state.walk.pixel;
  if (!walk || walk->camera != ui.state.picture.camera || walk->size.width != picture.width) return;
  const float edge = image.width / static_cast<float>(picture.width), half = std::max(edge / 2, ui.px(4));
  const float x = image.x + (static_cast<float>(walk->column) + 0.5f) * edge;
  const float y = image.y + (static_cast<float>(walk->row) + 0.5f) * edge;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRect({x - half, y - half}, {x + half, y + half}, IM_COL32(0, 0, 0, 255), 0, 0, ui.px(3.5f));
  draw.AddRect({x - half, y - half}, {x + half, y + half}, IM_COL32(255, 255, 255, 255), 0, 0, ui.px(1.5f));
}

std::string seconds_text(double seconds) {
  const int whole = static_cast<int>(std::ceil(std::min(seconds, 359999.0)));
  const std::string rest = (whole % 60 < 10 ? "0" : "") + std::to_string(whole % 60);
  return std::to_string(whole / 60) + ":" + rest;
}

std::string status_of(const Ui& ui, const PictureView& picture, bool has_row) {
  const std::string about = ui.say(ui.state.picture.camera ? "image.turned"
                                   : has_row               ? "image.row_marked"
                                                           : "image.click");
  if (picture.finished) return about;
  const std::string done = percent_text(picture.done, ui.state.appearance.language);
  if (!(picture.seconds_left >= 1)) return done + "  \u00b7  " + about;
  return ui.say("image.progress", {{"percent", done}, {"time", seconds_text(picture.seconds_left)}}) + "  \u00b7  " +
         about;
}

// A bar of colours with numbers, as high as two lines of small letters.
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
  const std::array<std::string, 3> numbers{
      "0", number_text(hottest / 2, ui.state.appearance.language),
      ui.say(most, {{"number", number_text(hottest, ui.state.appearance.language)}})};
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

// The rooms of the picture and of its ray tree, which stands beside it or, where that leaves the picture larger, below
// it and what `legend` is high.
struct PictureRooms {
  Rect picture, tree;
};
PictureRooms with_tree(const Ui& ui, const Rect& room, const PictureView& picture, float legend) {
  constexpr float part = 0.4f;  // for the tree, if the picture leaves less
  const float gap = ui.px(12);
  const auto fit = [&](const Rect& in) { return fitted(in, picture.width, picture.height, ui.fonts.density); };
  const Rect alone = fit(room);
  PictureRooms beside{room, room}, below{room, room};
  beside.tree.width = std::max(room.width - alone.width, part * room.width) - gap;
  beside.picture.width = std::max(room.width - beside.tree.width - gap, 1.0f);
  beside.tree.x = beside.picture.right() + gap;
  below.tree.height = std::max(room.height - alone.height, part * room.height) - gap;
  below.picture.height = std::max(room.height - below.tree.height - gap, 1.0f);
  below.tree.y = below.picture.bottom() + legend + gap;
  return fit(below.picture).width > fit(beside.picture).width ? below : beside;
}

void image_tab(const Ui& ui, const Rect& where, TabContext& context) {
  const PictureView& picture = context.picture;
  const float line = line_height(ui.fonts, *ui.fonts.small), side = ui.px(12);
  const float foot = std::max(line + ui.px(6), std::min(ui.finger, 0.2f * where.height));  // of the buttons
  push_font(ui.fonts.small);
  if (picture.texture == 0) {
    label(ui.colours.dim_text, ui.say("image.waiting"));
    pop_font();
    return;
  }
  if (image_tells_answer(ui.state)) {
    paragraph(ui.colours.dim_text, ui.say("lesson.predict_first"));
    pop_font();
    return;
  }
  const Heat heat = ui.state.picture.settings.heat;
  const float legend = heat == Heat::none ? 0 : 2 * line + ui.px(6);
  Rect room{where.x + side, where.y + ui.px(2), where.width - 2 * side, where.height - foot - ui.px(4) - legend};
  Rect image = fitted(room, picture.width, picture.height, ui.fonts.density);
  // As long as there are no rays, and so no tree, the picture has all the room.
  const bool walks =
      ui.state.walk.mode == Mode::trace && ui.state.walk.timeline->current_pixel(ui.state.walk.position) >= 0;
  if (ui.state.picture.tree_beside && walks) {
    const PictureRooms rooms = with_tree(ui, room, picture, legend);
    room = rooms.picture;
    image = fitted(room, picture.width, picture.height, ui.fonts.density);
    if (const Rect& tree = rooms.tree; tree.width > ui.px(60) && tree.height > ui.px(20)) {
      ImGui::SetCursorScreenPos(corner(tree));
      ui.publish("tree-beside/pane", tree);
      if (const int ray = ray_tree(ui, tree, context.memory.of<CentredOn>().ray); ray >= 0) context.pointed_at = ray;
    }
  }
  const bool has_row = ui.state.walk.planar && !ui.state.picture.camera;
  // What a pixel shows is what its ray is predicted to meet.
  const bool tells_answer = prediction_asked(ui.state).has_value() || mark_tells_answer(ui.state);
  ui.publish("image", image);
  if (image.width >= 8 && image.height >= 8) {
    const int cells = std::max(ui.state.scene().camera.screen.cells, 1);
    draw_texture(ui, image, picture);
    if (has_row) {
      const float row = image.height / static_cast<float>(picture.height);
      const float middle = image.y + static_cast<float>(picture.height / 2) * row + row / 2;
      const float half = std::max(row / 2, 0.5f) + ui.px(1.5f);
      mark_row(ui, image, std::round(middle - half), std::round(middle + half));
      if (const int cell = current_cell(ui.state); cell >= 0 && !tells_answer)
        mark_cell(ui, image, cell, cells, middle);
    }
    if (!tells_answer) mark_walked(ui, image, picture);
    ImGui::SetCursorScreenPos(corner(image));
    ImGui::InvisibleButton(
        "image", size(image),
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    turn_by_mouse(ui, SpaceView::image, image);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (clicked_in_place()) {
      const ImVec2 mouse = ImGui::GetIO().MousePos;
      const auto at = [](float part, int count) {
        return std::clamp(static_cast<int>(part * static_cast<float>(count)), 0, count - 1);
      };
      ui.act(action::WalkPixel{at((mouse.x - image.x) / image.width, picture.width),
                               at((mouse.y - image.y) / image.height, picture.height),
                               {picture.width, picture.height}});
    }
    tooltip(ui, "image", ui.say("image.hint"));
  }
  if (heat != Heat::none)
    heat_legend(ui, {room.x, room.bottom() + ui.px(6), room.width, legend}, heat, picture.hottest);

  // The contents of the picture, and buttons for its settings and the tree.
  const ButtonLook look{.look = Look::choice, .icon = Icon::none, .font = ui.fonts.small, .label = true};
  float button = 0;
  for (const Command* each : {&command("image-settings"), &command("tree-beside")}) {
    const float width = button_width(ui, *each, look);
    button += width;
    ImGui::SetCursorScreenPos({where.right() - button, where.bottom() - foot - ui.px(1)});
    command_button(ui, *each, {width, foot}, look);
  }
  const std::string status = status_of(ui, picture, has_row);
  const float y = where.bottom() - (foot + line) / 2 - ui.px(1);
  ImGui::SetCursorScreenPos({where.x + ui.px(4), y});
  label(ui.colours.dim_text, shortened(status, where.width - button - ui.px(8)));
  pop_font();
}

}  // namespace

void PictureRoom::draw_tab(const Ui& ui, const Rect& where, TabContext& context) { image_tab(ui, where, context); }

void epsilon_row(const Ui& ui, Form& form) {
  const RenderChoices& now = ui.state.scene().render;
  double epsilon = now.epsilon;
  if (form.number("property.epsilon", epsilon, 1e-5, 0, 1e6))
    ui.act(action::SetNumerics{now.numerics, epsilon, form.continues()});
}

/// Where the scene has a use for it.
void light_ways(const Ui& ui, Form& form) {
  const SceneSeen seen = walked_scene(ui.state);
  const Scene& scene = *seen;
  action::SetLightWays next{scene.render.subsurface, scene.render.radiosity.as_ambient};
  bool now = false;
  if (effects_of(scene).used(Effect::scattering))
    now |= pick_among(ui, form, "property.subsurface", values_of<Subsurface>, next.subsurface);
  if (may_take_ambient_from_patches(integrator_of(scene))) now |= form.flag("property.as_ambient", next.as_ambient);
  if (now) ui.act(next);
}

void image_settings(const Ui& ui, FormMemory& memory) {
  const FormPopup popup(ui, "image-settings");
  if (!popup) return;
  const float width = popup.width(ui, 390);
  Form form(ui, memory, width);
  form.heading("image.settings_title");
  const State& state = ui.state;
  ImageSettings next = state.picture.settings;

  Integrator integrator = next.integrator.value_or(state.scene().render.integrator);
  if (pick_among(ui, form, "property.integrator", values_of<Integrator>, integrator)) next.integrator = integrator;
  pick_among(ui, form, "property.accelerator", pickable_accelerators, next.accelerator);
  form.whole("property.samples", next.samples, 1, max_image_samples);
  form.whole("property.walk_samples", next.walk_samples, 1, max_walk_samples);
  pick_among(ui, form, "property.precision", precisions, next.single_precision, precision_word);
  pick_among(ui, form, "property.heat", values_of<Heat>, next.heat);
  if (next != state.picture.settings) ui.act(action::SetImageSettings{next});

  // These belong to the scene: they also affect the walk and the file.
  TraceLimits limits = state.scene().limits;
  bool now = form.whole("property.limits_depth", limits.depth, 1, 50);
  now |= form.number("property.threshold", limits.threshold, 0.0005, 0, 1);
  if (now) ui.act(action::SetLimits{limits, form.continues()});
  Numerics numerics = state.scene().render.numerics;
  if (pick_among(ui, form, "property.numerics", values_of<Numerics>, numerics))
    ui.act(action::SetNumerics{numerics, state.scene().render.epsilon});
  epsilon_row(ui, form);
  light_ways(ui, form);

  ImGui::Dummy({1, ui.px(2)});
  const ButtonLook look{.look = Look::plain, .icon = Icon::none, .font = ui.fonts.small, .label = true};
  const ImVec2 extent{width, ui.high(30)};
  command_button(ui, command("reset-view"), extent, look);
  command_button(ui, command("use-camera"), extent, look);
}

namespace {

void change_heat(const Ui& ui) {
  ImageSettings settings = ui.state.picture.settings;
  settings.heat = next_among(values_of<Heat>, settings.heat);
  ui.act(action::SetImageSettings{settings});
  ui.act(action::SetTab{PictureRoom::tab});
}

}  // namespace

Commands PictureRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-image", .keys = {"I"}, .section = Section::tabs, .line = "keys.tabs",
       .chosen = shows_tab<PictureRoom>, .run = open_tab<PictureRoom>},
      {.name = "use-camera", .keys = {"Shift+U"}, .section = Section::show, .line = "keys.image",
       .enabled = [](const State& state) { return state.picture.camera.has_value(); },
       .run = act<action::UseImageCamera>},
      {.name = "image-settings", .keys = {","}, .section = Section::show, .line = "keys.image",
       .run = wish<WindowWish::image_settings>},
      {.name = "tree-beside", .keys = {"Shift+R"}, .section = Section::show, .line = "keys.image",
       .chosen = [](const State& state) { return state.picture.tree_beside; }, .turn = turn<action::ShowTreeBeside>},
      {.name = "heat", .keys = {"G"}, .section = Section::show, .line = "keys.image", .run = change_heat},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
