#pragma once

#include "math/vec.h"

#include <numbers>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <variant>

namespace raywalk {

/// An absent value, such as the object hit by a ray that missed. Not equal to anything, not even itself, and false.
struct Nothing {};

/// The value of an expression. Names (of objects, lights, lines, kinds of rays, endings) are strings.
using Value = std::variant<Nothing, bool, double, std::string, Vec3d>;

/// A value, or why there is none: a sentence without a full stop.
using Outcome = tl::expected<Value, std::string>;
/// Why there is none.
[[nodiscard]] inline tl::unexpected<std::string> wrong(std::string why) { return tl::unexpected(std::move(why)); }

inline constexpr double degree = std::numbers::pi / 180;  ///< in radians; formulas have angles in degrees

/// A readable value. Numbers and the components of vectors have `decimals` decimals, or, if negative, as many as
/// needed, after `decimal_mark`.
[[nodiscard]] std::string text_of(const Value& value, int decimals = -1, char decimal_mark = '.');

/// Whether a condition holds; nothing does not.
[[nodiscard]] inline bool holds(const Value& value) {
  const bool* truth = std::get_if<bool>(&value);
  return truth != nullptr && *truth;
}

}  // namespace raywalk
