#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace raywalk {

namespace {

// A menu of the bar; `open` opens it. Returns whether it is open.
template <class Entries>
bool menu(const Ui& ui, std::string_view title, const char* name, bool open, const Entries& entries) {
  const std::string heading(title);
  if (open) ImGui::OpenPopup(heading.c_str());
  // A menu longer than the window scrolls below the bar: covering the bar, it would take the click that opens it.
  const float bar = ImGui::GetWindowHeight(), window = ImGui::GetIO().DisplaySize.y;
  ImGui::SetNextWindowSizeConstraints({0, 0}, {ImGui::GetIO().DisplaySize.x, std::max(window - bar - ui.px(4), 1.0f)});
  const bool is_open = ImGui::BeginMenu(heading.c_str());
  ui.publish(name);
  if (!is_open) return false;
  // So tight that the longest menu fits below the bar of a window of 720 units.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(10), ui.px(6)});
  entries();
  ImGui::PopStyleVar();
  ImGui::EndMenu();
  return true;
}

void recent_menu(const Ui& ui) {
  if (!ImGui::BeginMenu(ui.say("menu.recent").c_str(), !ui.state.recent.empty())) return;
  int number = 0;
  for (const std::string& path : ui.state.recent) {
    ImGui::PushID(number);
    const std::filesystem::path file(path);
    const std::string folder = file.parent_path().string();
    if (ImGui::MenuItem(file.filename().string().c_str(), folder.c_str())) ui.act(action::Open{path});
    ui.publish("menu/recent/" + std::to_string(number++));
    ImGui::PopID();
  }
  ImGui::EndMenu();
}

void file_menu(const Ui& ui) {
  menu_item(ui, Command::new_scene);
  menu_item(ui, Command::open);
  recent_menu(ui);
  ui.publish("menu/recent");
  ImGui::Separator();
  menu_item(ui, Command::save);
  menu_item(ui, Command::save_as);
  menu_item(ui, Command::export_walk);
  menu_item(ui, Command::save_predictions);
  ImGui::Separator();
  menu_item(ui, Command::quit);
}

void edit_menu(const Ui& ui) {
  for (const Command command : {Command::undo, Command::redo}) menu_item(ui, command);
  ImGui::Separator();
  for (const Command command :
       {Command::select_next, Command::select_previous, Command::edit_properties, Command::deselect, Command::remove})
    menu_item(ui, command);
}

/// One line per language, with the name from its file.
void language_items(const Ui& ui) {
  for (const Language language : ui.state.language.others().all()) {
    const std::string name(language.name()), code(language.code());
    if (ImGui::MenuItem(("    " + name).c_str(), nullptr, language == ui.state.language))
      ui.act(action::SetLanguage{code});
    ui.publish("menu/language/" + code);
  }
}

void view_menu(const Ui& ui) {
  for (const Command command : {Command::fit, Command::zoom_in, Command::zoom_out}) menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::lines, Command::ghosts, Command::walk_strip, Command::reset_view,
                                Command::use_camera, Command::image_settings, Command::heat})
    menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::tweens, Command::theme, Command::scale_up, Command::scale_down,
                                Command::scale_reset, Command::language})
    menu_item(ui, command);
  language_items(ui);
  ImGui::Separator();
  for (const Command command : {Command::exchange, Command::full_screen}) menu_item(ui, command);
}

void panels_menu(const Ui& ui) {
  for (const Command command :
       {Command::tab_image, Command::tab_tree, Command::tab_stack, Command::tab_equation, Command::tab_legend})
    menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::tab_cost, Command::cost_next, Command::cost_against, Command::cost_split_left,
                                Command::cost_split_right, Command::cost_page})
    menu_item(ui, command);
  ImGui::Separator();
  for (const Command command :
       {Command::tab_microscope, Command::magnify, Command::diminish, Command::to_numbers, Command::to_scene,
        Command::numerics_robust, Command::numerics_naive, Command::precision_double, Command::precision_float})
    menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::tab_structure, Command::structure_next, Command::structure_back,
                                Command::structure_kind, Command::structure_page})
    menu_item(ui, command);
}

void walk_menu(const Ui& ui) {
  for (const Command command : {Command::step, Command::step_ray, Command::step_pixel}) menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::step_back, Command::step_ray_back, Command::step_pixel_back})
    menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::step_over, Command::step_out, Command::step_back_over, Command::step_back_out})
    menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::run_on, Command::run_back, Command::break_here, Command::breakpoints})
    menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::grain_line, Command::grain_ray, Command::grain_pixel}) menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::play, Command::slower, Command::faster}) menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::first, Command::last, Command::clear}) menu_item(ui, command);
  ImGui::Separator();
  for (const Command command : {Command::predict, Command::lessons, Command::bugs}) menu_item(ui, command);
}

}  // namespace

int bar_pane(const Ui& ui, const Rect& where, int open_menu) {
  int is_open = -1;
  const float text_height = ImGui::GetFontSize();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(10), std::max((where.height - text_height) / 2, 0.0f)});
  const bool visible =
      begin_pane(ui, "bar", where, ui.colours.window,
                 ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const bool has_bar = visible && ImGui::BeginMenuBar();
  ImGui::PopStyleVar(2);
  if (has_bar) {
    // Large letters in a small window leave less space between menus.
    const float apart = where.width < ui.px(760) ? ui.px(7) : ui.px(14);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {apart, ui.px(8)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(10)});
    if (menu(ui, ui.say("menu.file"), "menu-file", open_menu == 0, [&] { file_menu(ui); })) is_open = 0;
    if (menu(ui, ui.say("menu.edit"), "menu-edit", open_menu == 1, [&] { edit_menu(ui); })) is_open = 1;
    if (menu(ui, ui.say("menu.view"), "menu-view", open_menu == 2, [&] { view_menu(ui); })) is_open = 2;
    if (menu(ui, ui.say("menu.walk"), "menu-walk", open_menu == 3, [&] { walk_menu(ui); })) is_open = 3;
    if (menu(ui, ui.say("menu.panels"), "menu-panels", open_menu == 4, [&] { panels_menu(ui); })) is_open = 4;
    ImGui::PopStyleVar(2);

    const float height = where.height - 2 * ui.px(6), y = where.y + ui.px(6);
    ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x + apart, y});
    choice(ui, {Command::mode_move, Command::mode_trace, Command::mode_help}, height, ui.fonts.strong);
    const ButtonLook flat{.look = Look::flat, .icon = Icon::undo, .font = nullptr, .label = false};
    ImGui::SetCursorScreenPos({ImGui::GetItemRectMax().x + apart, y});
    command_button(ui, Command::undo, {height, height}, flat);
    ImGui::SetCursorScreenPos({ImGui::GetItemRectMax().x + ui.px(2), y});
    ButtonLook redo = flat;
    redo.icon = Icon::redo;
    command_button(ui, Command::redo, {height, height}, redo);
    ImGui::SetCursorScreenPos({ImGui::GetItemRectMax().x + ui.px(10), y});
    const ButtonLook small{.look = Look::flat, .icon = Icon::none, .font = ui.fonts.small};
    command_button(ui, Command::language, {height * 1.3f, height}, small, short_label(Command::language, ui.state));

    ImGui::SetCursorScreenPos({ImGui::GetItemRectMax().x + ui.px(6), y});
    if (ImGui::GetCursorScreenPos().x + button_width(ui, Command::lessons, small) < where.right() - ui.px(8))
      command_button(ui, Command::lessons, {0, height}, small);

    // The document's name at the right, if there is room.
    const std::string title = document_title(ui.state);
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    const float x = where.right() - width - ui.px(16);
    if (x > ImGui::GetItemRectMax().x + ui.px(12)) {
      ImGui::GetWindowDrawList()->AddText({x, std::round(where.y + (where.height - text_height) / 2)},
                                          to_imgui(ui.colours.dim_text), title.c_str());
    }
    ImGui::EndMenuBar();
  }
  end_pane();
  return is_open;
}

void palette_pane(const Ui& ui, const Rect& where) {
  if (begin_pane(ui, "palette", where, ui.colours.window, ImGuiWindowFlags_NoScrollbar)) {
    const float height = where.height - 2 * ui.px(6);
    ImGui::SetCursorScreenPos({where.x + ui.px(10), where.y + ui.px(6)});
    constexpr std::array adds{Command::add_solid_sphere, Command::add_transparent_sphere, Command::add_polygon,
                              Command::add_light};
    ButtonLook add{.look = Look::plain, .icon = Icon::plus, .font = nullptr, .label = true};
    ButtonLook remove{.look = Look::flat, .icon = Icon::minus, .font = nullptr, .label = true};
    bool in_short = false;
    const auto word = [&](Command command) {
      return in_short ? short_label(command, ui.state) : command_label(command, ui.state);
    };
    const auto width = [&] {
      float sum = button_width(ui, word(Command::remove), remove) + ui.px(20);
      for (const Command command : adds) sum += button_width(ui, word(command), add) + ImGui::GetStyle().ItemSpacing.x;
      return sum;
    };
    // In a narrow window first the letters shrink, then the words, then the icons go, then the space beside the words.
    if (width() > where.width) add.font = remove.font = ui.fonts.small;
    if (width() > where.width) in_short = true;
    if (width() > where.width) add.icon = remove.icon = Icon::none;
    const float less = std::max(width() - where.width, 0.0f) / static_cast<float>(adds.size() + 1);
    const auto narrowed = [&](Command command, const ButtonLook& look) {
      return ImVec2{std::max(button_width(ui, word(command), look) - less, 1.0f), height};
    };
    for (const Command command : adds) {
      command_button(ui, command, narrowed(command, add), add, word(command));
      ImGui::SameLine();
    }
    command_button(ui, Command::remove, narrowed(Command::remove, remove), remove, word(Command::remove));
  }
  end_pane();
}

}  // namespace raywalk
