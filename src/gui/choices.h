#pragma once
// One of a few: for fields that pick and for commands that go on to the next.

#include "accel/accelerator.h"
#include "gui/form.h"
#include "text/language.h"
#include "view/choice_text.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
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

/// A field for one of `choices`, called as `id_of` says: by default each is the id of its own text. Whether another one
/// than `value` was picked, which then is it.
template <class Choices, class Value, class IdOf = std::identity>
bool pick_among(const Ui& ui, Form& form, const FormLabel& label, const Choices& choices, Value& value,
                const IdOf& id_of = {}) {
  std::vector<std::string> names;
  for (const auto& choice : choices) names.emplace_back(text(id_of(choice), ui.state.language));
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
[[nodiscard]] constexpr std::string_view precision_word(bool single) {
  return single ? "precision.float" : "precision.double";
}

}  // namespace raywalk
