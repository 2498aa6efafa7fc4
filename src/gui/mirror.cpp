#include "gui/mirror.h"

#include "gui/command.h"
#include "gui/dialogs.h"
#include "gui/panes.h"
#include "view/action_text.h"
#include "view/document/document.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace raywalk {

namespace {

using Role = OutlineItem::Role;

/// A command that opens a dialog leads to the region of its name, which is folded until it is asked for.
void add_commands(OutlineItem& region, const Outline& all, const State& state, Section section) {
  for (const Command* each : commands_in(section)) {
    OutlineItem button{Role::button, "command-" + std::string(each->name), command_label(*each, state)};
    button.does = "command " + std::string(each->name);
    button.hint = command_hint(*each, state.appearance.language);
    button.enabled = enabled(*each, state);
    const auto stands_for = [&](const OutlineItem& item) { return item.folded && item.key == each->name; };
    if (std::any_of(all.begin(), all.end(), stands_for)) button.leads_to = each->name;
    if (each->chosen != nullptr) button.chosen = chosen(*each, state);
    region.items.push_back(std::move(button));
  }
}

void add_languages(OutlineItem& region, const State& state) {
  for (const Language language : state.appearance.language.others().all()) {
    const std::string code(language.code());
    OutlineItem button{Role::button, "language-" + code, std::string(language.name())};
    button.does = write_action(action::SetLanguage{code});
    button.chosen = language == state.appearance.language;
    region.items.push_back(std::move(button));
  }
}

void add_file_chooser(OutlineItem& region, const State& state) {
  OutlineItem button{Role::button, "device", fill("files.from_device", state.appearance.language)};
  button.does = choosing_files;
  button.hint = fill("files.from_device_hint", state.appearance.language);
  region.items.push_back(std::move(button));
}

nlohmann::ordered_json json_of(const Outline& items) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const OutlineItem& item : items) {
    nlohmann::ordered_json json{{"role", name_of(item.role)}, {"key", item.key}, {"name", item.name}};
    if (!item.does.empty()) json["does"] = item.does;
    if (!item.hint.empty()) json["hint"] = item.hint;
    if (item.role == Role::number || item.role == Role::words || item.role == Role::path) json["value"] = item.value;
    if (!item.enabled) json["enabled"] = false;
    if (!item.leads_to.empty()) json["to"] = item.leads_to;
    if (item.chosen) json["chosen"] = *item.chosen;
    if (item.current) json["current"] = true;
    if (item.folded) json["folded"] = true;
    if (!item.items.empty()) json["items"] = json_of(item.items);
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

Outline outline_with_commands(const State& state, const CostFindings* costs) {
  Outline outlined = outline(state, costs);
  if (waits_for_answer(state)) {
    if (asks_for_files(state)) add_file_chooser(outlined.back(), state);
    return outlined;
  }
  const auto region = [&](std::string_view key) -> OutlineItem& {
    return *std::find_if(outlined.begin(), outlined.end(), [&](const OutlineItem& item) { return item.key == key; });
  };
  add_commands(region("walk"), outlined, state, Section::modes);
  add_commands(region("plan"), outlined, state, Section::add);
  for (int i = 0; i < menu_count; ++i) {
    const MenuContents menu = menu_contents(i);
    const bool walks = std::find(menu.sections.begin(), menu.sections.end(), Section::step) != menu.sections.end();
    OutlineItem own{Role::region, "menu-" + std::to_string(i), fill(menu.title, state.appearance.language)};
    own.folded = true;
    for (const Section section : menu.sections) {
      add_commands(walks ? region("walk") : own, outlined, state, section);
      if (section == Section::style) add_languages(own, state);
    }
    if (i == menu_count - 1) add_commands(own, outlined, state, Section::none);
    if (!own.items.empty()) outlined.push_back(std::move(own));
  }
  return outlined;
}

std::string outline_json(const State& state, const CostFindings* costs) {
  // Paths need not be UTF-8.
  return json_of(outline_with_commands(state, costs))
      .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace raywalk
