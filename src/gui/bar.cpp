// The bar along the top, with the menus.

#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text/text.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

// The heading of a menu is ImGui's last item until the menu is shown, and again once that is done.

void recent_menu(const Ui& ui) {
  if (ImGui::BeginMenu(ui.say("menu.recent").c_str(), !ui.state.document.recent.empty())) {
    int number = 0;
    for (const std::string& path : ui.state.document.recent) {
      ImGui::PushID(number);
      const std::filesystem::path file(path);
      const std::string folder = file.parent_path().string();
      if (ImGui::MenuItem(file.filename().string().c_str(), folder.c_str())) ui.act(action::Open{path});
      ui.publish("menu/recent/" + std::to_string(number++));
      ImGui::PopID();
    }
    ImGui::EndMenu();
  }
  ui.publish("menu/recent");
}

/// Which rays are drawn, in Trace and in Move.
void rays_menu(const Ui& ui) {
  if (ImGui::BeginMenu(ui.say("menu.rays").c_str())) {
    for (const Command* each : commands_in(Section::rays)) menu_item(ui, *each);
    ImGui::Separator();
    label(ui.colours.dim_text, ui.say("legend.earlier"));
    for (const Command* each : commands_in(Section::earlier)) menu_item(ui, *each);
    ImGui::EndMenu();
  }
  ui.publish("menu/rays");
}

/// One line per language, with the name from its file.
void language_items(const Ui& ui) {
  for (const Language language : ui.state.appearance.language.others().all()) {
    const std::string name(language.name()), code(language.code());
    if (ImGui::MenuItem(("    " + name).c_str(), nullptr, language == ui.state.appearance.language))
      ui.act(action::SetLanguage{code});
    ui.publish("menu/language/" + code);
  }
}

struct MenuPart {
  Section section;
  void (*more)(const Ui&) = nullptr;  ///< what follows its commands
  std::vector<Section> inner{};       ///< whose commands are in what follows
};

struct Menu {
  std::string_view title;  ///< the id of its text
  const char* name;        ///< of its item, for tests
  std::vector<MenuPart> parts;
};

const std::array<Menu, menu_count> menus{{
    {"menu.file", "menu-file", {{Section::open, recent_menu}, {Section::save}, {Section::quit}}},
    {"menu.edit", "menu-edit", {{Section::undo}, {Section::select}, {Section::ink}}},
    {"menu.view",
     "menu-view",
     {{Section::zoom},
      {Section::show, rays_menu, {Section::rays, Section::earlier}},
      {Section::style, language_items},
      {Section::window}}},
    {"menu.walk",
     "menu-walk",
     {{Section::step},
      {Section::back},
      {Section::over},
      {Section::run},
      {Section::grain},
      {Section::play},
      {Section::ends},
      {Section::learn}}},
    {"menu.panels",
     "menu-panels",
     {{Section::tabs},
      {Section::cost},
      {Section::microscope},
      {Section::numerics},
      {Section::precision},
      {Section::structure}}},
}};

// What stands in an open menu that begins `below` the upper edge of the window.
void menu_entries(const Ui& ui, const Menu& menu, float below) {
  const float window = ImGui::GetIO().DisplaySize.y;
  // As tight as it must be to fit below the bar of the window; wider for fingers, where there is room.
  std::size_t rows = 0;
  for (const MenuPart& part : menu.parts) {
    rows += commands_in(part.section).size();
    if (part.more != nullptr)
      rows += part.more == language_items ? ui.state.appearance.language.others().all().size() : 1;
  }
  const float line = ImGui::GetTextLineHeight(), entries = static_cast<float>(rows),
              lines = static_cast<float>(menu.parts.size());
  float gap = (window - below - ui.px(24) - entries * line - lines) / (entries + lines);
  if (!ui.state.appearance.touch)
    gap = std::clamp(gap, ui.px(1), ui.px(6));
  else  // what a finger would miss scrolls rather
    gap = line + gap < ui.px(28) ? ui.px(finger_height) - line : std::min(gap, ui.px(finger_height) - line);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(10), gap});
  bool first = true;
  for (const MenuPart& part : menu.parts) {
    if (part.more == nullptr && commands_in(part.section).empty()) continue;
    if (!std::exchange(first, false)) ImGui::Separator();
    for (const Command* each : commands_in(part.section)) menu_item(ui, *each);
    if (part.more != nullptr) part.more(ui);
  }
  ImGui::PopStyleVar();
}

// A menu of the bar; `open` opens it. Returns whether it is open.
bool show_menu(const Ui& ui, const Menu& menu, bool open) {
  const std::string heading = ui.say(menu.title);
  if (open) ImGui::OpenPopup(heading.c_str());
  // A menu longer than the window scrolls below the bar: covering the bar, it would take the click that opens it.
  const float bar = ImGui::GetWindowHeight();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowSizeConstraints({0, 0}, {window.x, std::max(window.y - bar - ui.px(4), 1.0f)});
  const bool is_open = ImGui::BeginMenu(heading.c_str());
  if (is_open) {
    menu_entries(ui, menu, bar);
    ImGui::EndMenu();
  }
  ui.publish(menu.name);
  return is_open;
}

// Of the button for the language.
float language_width(const Ui& ui) { return ui.px(44); }

// Modes, undo, lessons and language, from `x` on, as far as there is room; returns where they end.
float bar_buttons(const Ui& ui, const Rect& row, float x, float apart) {
  const float margin = ui.px(ui.finger > 0 ? 1 : 6), height = row.height - 2 * margin, y = row.y + margin;
  const float edge = std::min(height, ui.px(32));  // the width of what has no words
  const ButtonLook small{.look = Look::flat, .icon = Icon::none, .font = ui.fonts.small};
  const float lessons = button_width(ui, command("lessons"), small);
  // Where there is little room the modes have less beside their words.
  const float others = apart + 2 * edge + ui.px(2) + ui.px(6) + lessons;
  const float spare = 2 * ui.px(7);  // what a word can lose beside it
  float tight = 0;
  for (const Command* each : commands_in(Section::modes))
    tight += button_width(ui, *each, {.look = Look::choice, .icon = Icon::none, .font = ui.fonts.strong}) - spare;
  const float room = row.right() - x - others, language = ui.px(10) + language_width(ui);
  ImGui::SetCursorScreenPos({x, y});
  choice(ui, commands_in(Section::modes), height, ui.fonts.strong,
         std::max(tight <= room - language ? room - language : room, ui.px(120)));
  const ButtonLook flat{.look = Look::flat, .icon = Icon::undo, .font = nullptr, .label = false};
  ImGui::SetCursorScreenPos({ImGui::GetItemRectMax().x + apart, y});
  command_button(ui, command("undo"), {edge, height}, flat);
  ImGui::SetCursorScreenPos({ImGui::GetItemRectMax().x + ui.px(2), y});
  ButtonLook redo = flat;
  redo.icon = Icon::redo;
  command_button(ui, command("redo"), {edge, height}, redo);
  const auto add = [&](const Command& each, float width, const ButtonLook& look, const std::string& label, float gap) {
    const float left = ImGui::GetItemRectMax().x + gap;
    if (left + width > row.right() + 0.5f) return;
    ImGui::SetCursorScreenPos({left, y});
    command_button(ui, each, {width, height}, look, label);
  };
  // The language also has a menu entry.
  const float free = row.right() + 0.5f - ImGui::GetItemRectMax().x - ui.px(10) - ui.px(6) - lessons;
  ButtonLook world = small;
  world.icon = Icon::globe;
  world.label = language_width(ui) <= free;  // else the globe alone
  if (const float own = world.label ? language_width(ui) : edge; own <= free)
    add(command("language"), own, world, command_label(command("language"), ui.state, true), ui.px(10));
  const float left = row.right() - ImGui::GetItemRectMax().x;
  add(command("lessons"), std::min(lessons, std::max(left, ui.px(40))), small, {},
      std::min(ui.px(6), std::max(left - lessons, 0.0f)));
  return ImGui::GetItemRectMax().x;
}

}  // namespace

MenuContents menu_contents(int menu) {
  const Menu& of = menus[static_cast<std::size_t>(menu)];
  MenuContents contents{of.title, {}};
  for (const MenuPart& part : of.parts) {
    contents.sections.push_back(part.section);
    contents.sections.insert(contents.sections.end(), part.inner.begin(), part.inner.end());
  }
  return contents;
}

float bar_width(const Ui& ui) {
  const float apart = ui.px(7), height = ui.px(32);
  float sum = 0;
  for (const Menu& each : menus) sum += ImGui::CalcTextSize(ui.say(each.title).c_str()).x + 2 * apart;
  for (const Command* each : commands_in(Section::modes))
    sum += button_width(ui, *each, {.look = Look::choice, .icon = Icon::none, .font = ui.fonts.strong});
  const float lessons =
      button_width(ui, command("lessons"), {.look = Look::flat, .icon = Icon::none, .font = ui.fonts.small});
  return sum + 2 * apart + 2 * height + language_width(ui) + lessons + ui.px(2 + 10 + 6);
}

int bar_pane(const Ui& ui, const Rect& where, int open_menu) {
  int is_open = -1;
  const float text_height = ImGui::GetFontSize();
  // In one column the buttons are below the menus.
  const bool two_lines = where.height > ui.px(60);
  const Rect menu{where.x, where.y, where.width, two_lines ? where.height / 2 : where.height};
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(10), std::max((menu.height - text_height) / 2, 0.0f)});
  const Pane pane(ui, "bar", where, ui.colours.window, {0, 0},
                  ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const bool has_bar = pane && ImGui::BeginMenuBar();
  ImGui::PopStyleVar();
  if (!has_bar) return -1;
  // Large letters in a small window leave less space between menus.
  const float apart = where.width < ui.px(800) ? ui.px(7) : ui.px(14);
  // What is between lines is part of a menu's heading.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {apart, std::max(ui.px(8), ui.finger - text_height)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.padding(10, 10));
  for (std::size_t i = 0; i < menus.size(); ++i)
    if (show_menu(ui, menus[i], open_menu == static_cast<int>(i))) is_open = static_cast<int>(i);
  ImGui::PopStyleVar(2);
  float end = ImGui::GetCursorScreenPos().x;
  if (!two_lines) end = bar_buttons(ui, where, end + apart, apart);
  // The document's name at the right, as much of it as there is room for.
  const std::string title = document_title(ui.state);
  const float room = where.right() - ui.px(16) - end - ui.px(12);
  if (const std::string shown = shortened(title, room); room > ui.px(60) && !shown.empty()) {
    const float width = ImGui::CalcTextSize(shown.c_str()).x;
    const ImVec2 at{where.right() - ui.px(16) - width, std::round(menu.y + (menu.height - text_height) / 2)};
    ImGui::GetWindowDrawList()->AddText(at, to_imgui(ui.colours.dim_text), shown.c_str());
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({width, text_height});
    ui.publish("document-title");
    if (shown != title) tooltip(ui, "document-title", title);
  }
  ImGui::EndMenuBar();
  if (two_lines)
    bar_buttons(ui, {where.x, menu.bottom(), where.width, where.height - menu.height}, where.x + ui.px(10), apart);
  return is_open;
}

}  // namespace raywalk
