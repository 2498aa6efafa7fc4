#pragma once

#include "math/vec.h"

#include <numbers>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <variant>

namespace raywalk {

/// What there is none of: the object that a ray met which met nothing. Equal to nothing, not even to itself, and false.
struct Nothing {};

/// What an expression of a lesson comes to. Names (of objects, lights, lines, kinds of rays, endings) are strings.
using Value = std::variant<Nothing, bool, double, std::string, Vec3d>;

/// A value, or why there is none: one sentence without a full stop.
using Outcome = tl::expected<Value, std::string>;
/// Why there is none.
[[nodiscard]] inline tl::unexpected<std::string> wrong(std::string why) { return tl::unexpected(std::move(why)); }

inline constexpr double degree = std::numbers::pi / 180;  ///< in radians; formulas have angles in degrees

/// A value as a person reads it. Numbers and each component of a vector with `decimals` of them, or, below 0, as many
/// as tell it; with `decimal_mark` before them.
[[nodiscard]] std::string text_of(const Value& value, int decimals = -1, char decimal_mark = '.');

/// Whether a condition holds; nothing does not.
[[nodiscard]] inline bool holds(const Value& value) {
  const bool* truth = std::get_if<bool>(&value);
  return truth != nullptr && *truth;
}

}  // namespace raywalk
