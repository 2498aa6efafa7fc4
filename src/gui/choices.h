#pragma once
// One of a few values: for pick fields and for commands that switch to the next.

#include "gui/form.h"
#include "text/language.h"
#include "view/text/choice_text.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace raywalk {

/// The index of `value` in `choices`; 0 if absent.
template <class Choices, class Value>
[[nodiscard]] std::size_t index_among(const Choices& choices, const Value& value) {
  const auto at = std::find(choices.begin(), choices.end(), value);
  return at == choices.end() ? 0 : static_cast<std::size_t>(at - choices.begin());
}

/// The one after `now`, cyclically.
template <class Choices, class Value>
[[nodiscard]] Value next_among(const Choices& choices, const Value& now) {
  return choices[(index_among(choices, now) + 1) % choices.size()];
}

/// A field for one of `choices`, named by `id_of`: by default each is the id of its own text. Returns whether `value`
/// was changed.
template <class Choices, class Value, class IdOf = std::identity>
bool pick_among(const Ui& ui, Form& form, const KeyLabel& label, const Choices& choices, Value& value,
                const IdOf& id_of = {}) {
  std::vector<std::string> names;
  for (const auto& choice : choices) names.emplace_back(text(id_of(choice), ui.state.appearance.language));
  int index = static_cast<int>(index_among(choices, value));
  if (!form.pick(label, names, index)) return false;
  value = choices[static_cast<std::size_t>(index)];
  return true;
}

}  // namespace raywalk
