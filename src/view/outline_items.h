#pragma once
// How the items of an outline are made.

#include "view/action_text.h"
#include "view/outline.h"

#include <cstddef>
#include <string>
#include <utility>

namespace raywalk {

inline OutlineItem& add(OutlineItem& parent, OutlineItem::Role role, std::string key, std::string name) {
  parent.items.push_back({role, std::move(key), std::move(name)});
  return parent.items.back();
}

inline OutlineItem& button(OutlineItem& parent, std::string key, std::string name, const Action& does,
                           bool enabled = true) {
  OutlineItem& item = add(parent, OutlineItem::Role::button, std::move(key), std::move(name));
  item.does = write_action(does);
  item.enabled = enabled;
  return item;
}

inline void field(OutlineItem& parent, OutlineItem::Role role, std::string key, std::string name, std::string does,
                  std::string value) {
  OutlineItem& item = add(parent, role, std::move(key), std::move(name));
  item.does = std::move(does);
  item.value = std::move(value);
}

inline constexpr std::size_t most_outlined = 100;  ///< of the things of a scene, of each kind

// Regions whose dialogs of the window know only ImGui.

/// Where the walk stops.
void outline_breakpoints(const State& state, OutlineItem& region);
/// The keys of what is selected.
void outline_properties(const State& state, OutlineItem& region);
/// What Cost tries next.
void outline_cost_knobs(const State& state, OutlineItem& region);
/// The settings of the 3-D image.
void outline_image_settings(const State& state, OutlineItem& region);

}  // namespace raywalk
