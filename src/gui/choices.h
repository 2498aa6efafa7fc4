#pragma once
// One of a few: for fields that pick and for commands that go on to the next.

#include "accel/accelerator.h"
#include "gui/form.h"
#include "gui/words.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// Where `value` stands among `choices`; 0 for one that is not there.
template <class Choices, class Value>
[[nodiscard]] std::size_t index_among(const Choices& choices, const Value& value) {
  const auto at = std::find(choices.begin(), choices.end(), value);
  return at == choices.end() ? 0 : static_cast<std::size_t>(at - choices.begin());
}

/// The one after `now`, after the last the first.
template <class Choices, class Value>
[[nodiscard]] Value next_among(const Choices& choices, const Value& now) {
  return choices[(index_among(choices, now) + 1) % choices.size()];
}

/// A field for one of `choices`, called as `name` says. Whether another one than `value` was picked, which then is it.
template <class Choices, class NameOf, class Value>
bool pick_among(Form& form, const FormLabel& label, const Choices& choices, const NameOf& name, Value& value) {
  std::vector<std::string> names;
  for (const auto& choice : choices) names.emplace_back(name(choice));
  int index = static_cast<int>(index_among(choices, value));
  if (!form.pick(label, names, index)) return false;
  value = choices[static_cast<std::size_t>(index)];
  return true;
}

/// The accelerators that a person is asked to choose from.
inline constexpr std::array pickable_accelerators{AcceleratorKind::automatic, AcceleratorKind::none,
                                                  AcceleratorKind::bvh,       AcceleratorKind::grid,
                                                  AcceleratorKind::octree,    AcceleratorKind::kdtree};

/// Whether numbers have 24 bits.
inline constexpr std::array precisions{false, true};
[[nodiscard]] constexpr std::string_view precision_word(bool single) { return single ? words::single : words::double_; }

}  // namespace raywalk
