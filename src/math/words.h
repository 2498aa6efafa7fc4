#pragma once
// The words of an enumeration in files, options and reports, once, beside it: `words_of<Sampler>`.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace raywalk {

template <class E>
using Word = std::pair<E, std::string_view>;

/// Specialised beside the enumeration, as an array of Word<E>.
template <class E>
inline constexpr bool words_of = false;

template <class E>
concept Worded = requires { std::span<const Word<E>>(words_of<E>); };

/// The values that have a word, in its order.
template <Worded E>
inline constexpr auto values_of = [] {
  std::array<E, std::size(words_of<E>)> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = words_of<E>[i].first;
  return values;
}();

/// Their words.
template <Worded E>
inline constexpr auto word_array = [] {
  std::array<std::string_view, std::size(words_of<E>)> words{};
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = words_of<E>[i].second;
  return words;
}();
template <Worded E>
[[nodiscard]] std::vector<std::string_view> all_words() {
  return {word_array<E>.begin(), word_array<E>.end()};
}

/// The place of a value among them; none if it has no word.
template <Worded E>
[[nodiscard]] constexpr std::optional<std::size_t> index_of(const E& value) {
  for (std::size_t i = 0; i < std::size(words_of<E>); ++i)
    if (words_of<E>[i].first == value) return i;
  return std::nullopt;
}

/// The word of a value; empty if it has none.
template <Worded E>
[[nodiscard]] constexpr std::string_view name_of(const E& value) {
  const std::optional<std::size_t> index = index_of(value);
  return index ? word_array<E>[*index] : std::string_view();
}
/// The value of this word.
template <Worded E>
[[nodiscard]] constexpr std::optional<E> named(std::string_view name) {
  for (const auto& [each, word] : words_of<E>)
    if (word == name) return each;
  return std::nullopt;
}

}  // namespace raywalk
