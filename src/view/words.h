#pragma once
// The words of an enumeration in demo files, once, beside it: `words_of<Mode>`.

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
concept Worded = std::is_enum_v<E> && requires { std::span<const Word<E>>(words_of<E>); };

}  // namespace raywalk
