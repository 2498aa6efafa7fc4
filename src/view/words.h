#pragma once
// The words of an enumeration in demo files, once, beside it: `words_of<Mode>`.

#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

namespace raywalk {

template <class E>
using Word = std::pair<E, std::string_view>;

/// Specialised beside the enumeration, as an array of Word<E>.
template <class E>
inline constexpr bool words_of = false;

template <class E>
concept Worded = requires { std::span<const Word<E>>(words_of<E>); };

/// The word of a value; empty if it has none.
template <Worded E>
[[nodiscard]] constexpr std::string_view name_of(const E& value) {
  for (const auto& [each, word] : words_of<E>)
    if (each == value) return word;
  return {};
}
/// The value of this word.
template <Worded E>
[[nodiscard]] constexpr std::optional<E> named(std::string_view name) {
  for (const auto& [each, word] : words_of<E>)
    if (word == name) return each;
  return std::nullopt;
}

}  // namespace raywalk
