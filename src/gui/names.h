#pragma once
// Names of choices in options, settings and reports.

#include "view/state.h"

#include <initializer_list>
#include <optional>
#include <string_view>

namespace raywalk {

[[nodiscard]] std::string_view name_of(Mode mode);
[[nodiscard]] std::string_view name_of(Grain grain);
[[nodiscard]] std::string_view name_of(Tab tab);
[[nodiscard]] std::string_view name_of(Theme theme);
[[nodiscard]] std::string_view name_of(Question::Kind kind);
[[nodiscard]] std::string_view name_of(PathPrompt prompt);  ///< empty for none

inline constexpr std::initializer_list<Mode> all_modes{Mode::move, Mode::trace, Mode::help};
inline constexpr std::initializer_list<Tab> all_tabs{Tab::image,    Tab::tree, Tab::stack,      Tab::legend,
                                                     Tab::equation, Tab::cost, Tab::microscope, Tab::structure};
inline constexpr std::initializer_list<Theme> all_themes{Theme::dark, Theme::projector};

/// The one of `choices` that has this name.
template <class Choice>
[[nodiscard]] std::optional<Choice> named(std::initializer_list<Choice> choices, std::string_view name) {
  for (const Choice choice : choices) {
    if (name_of(choice) == name) return choice;
  }
  return std::nullopt;
}

}  // namespace raywalk
