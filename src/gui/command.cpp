#include "gui/command.h"

#include <algorithm>
#include <cassert>
#include <map>

namespace raywalk {

namespace {

/// One of its texts: label, short or hint.
std::string_view command_text(const Command& command, std::string_view which, Language language) {
  return family_text("command", std::string(command.name) + "." + std::string(which), language);
}

}  // namespace

const std::vector<const Command*>& commands() {
  static const std::vector<const Command*> all = [] {
    std::vector<const Command*> gathered;
    const auto gather = [&](auto... rows_of) {
      for (const rows::Rows some : {rows_of()...})
        for (const Command& command : some) gathered.push_back(&command);
    };
    gather(rows::walk, rows::breakpoints, rows::bar, rows::lessons, rows::bugs, rows::plan, rows::lines);
    for_each_room(Rooms(), [&]<class Room>() {
      if constexpr (rooms::WithTab<Room>) gather(rows::of_tab<Room>);
    });
    gather(rows::palette, rows::properties, rows::document, rows::predict, rows::appearance);
    return gathered;
  }();
  return all;
}

const std::vector<const Command*>& commands_in(Section section) {
  static const std::map<Section, std::vector<const Command*>> by_section = [] {
    std::map<Section, std::vector<const Command*>> sorted;
    for (const Command* each : commands()) sorted[each->section].push_back(each);
    sorted[Section::quit];  // empty in a page
    return sorted;
  }();
  return by_section.at(section);
}

const Command& command(std::string_view name) {
  const auto found =
      std::find_if(commands().begin(), commands().end(), [&](const Command* each) { return each->name == name; });
  assert(found != commands().end());
  return **found;
}

std::string command_label(const Command& command, const State& state, bool in_short) {
  if (command.label != nullptr) return command.label(state, in_short);
  std::string id = "command." + std::string(command.name) + ".short";
  std::replace(id.begin(), id.end(), '-', '_');
  const std::string* const brief = in_short ? state.appearance.language.catalogue().find(id) : nullptr;
  return brief != nullptr ? *brief : std::string(command_text(command, "label", state.appearance.language));
}

std::string command_hint(const Command& command, Language language) {
  return std::string(command_text(command, "hint", language));
}

bool enabled(const Command& command, const State& state) {
  return command.enabled == nullptr || command.enabled(state);
}

bool chosen(const Command& command, const State& state) { return command.chosen != nullptr && command.chosen(state); }

void perform(const Command& command, const Ui& ui) {
  if (enabled(command, ui.state)) command.run(ui);
}

}  // namespace raywalk
