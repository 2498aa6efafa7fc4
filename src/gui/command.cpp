#include "gui/command.h"

#include <algorithm>
#include <cassert>
#include <map>

namespace raywalk {

namespace {

/// One of its texts: label, short or hint; null if there is none.
const std::string* command_text(const Command& command, std::string_view which, Language language) {
  std::string id = "command." + std::string(command.name) + "." + std::string(which);
  std::replace(id.begin(), id.end(), '-', '_');
  return language.catalogue().find(id);
}

}  // namespace

const std::vector<const Command*>& commands() {
  static const std::vector<const Command*> all = [] {
    std::vector<const Command*> gathered;
    for_each_room(Rooms(), [&]<class Room>() {
      if constexpr (requires { Room::commands(); })
        for (const Command& command : Room::commands()) gathered.push_back(&command);
    });
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
  const Language language = state.appearance.language;
  const std::string* text = in_short ? command_text(command, "short", language) : nullptr;
  if (text == nullptr) text = command_text(command, "label", language);
  return text != nullptr ? *text : std::string(command.name);
}

std::string command_hint(const Command& command, Language language) {
  const std::string* text = command_text(command, "hint", language);
  return text != nullptr ? *text : std::string(command.name);
}

bool enabled(const Command& command, const State& state) {
  return command.enabled == nullptr || command.enabled(state);
}

bool chosen(const Command& command, const State& state) { return command.chosen != nullptr && command.chosen(state); }

void perform(const Command& command, const Ui& ui) {
  if (!enabled(command, ui.state)) return;
  if (command.turn != nullptr)
    command.turn(ui, !chosen(command, ui.state));
  else
    command.run(ui);
}

}  // namespace raywalk
