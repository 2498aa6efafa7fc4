#pragma once
// The words of a transform's steps and the numbers that follow each. Internal to `io`.

#include "scene/transform_step.h"

#include <array>
#include <string_view>
#include <vector>

namespace raywalk::detail {

struct TransformWord {
  std::string_view word;
  std::size_t numbers;
  std::string_view arguments;  ///< as a person writes them
  std::string_view meaning;
};

/// In the order of TransformStep's alternatives.
inline constexpr std::array<TransformWord, 6> transform_words{{
    {"translate", 3, "x, y, z", "moves by x, y, z"},
    {"rotate", 4, "x, y, z, degrees", "turns about the axis x, y, z through the origin, by the right-hand rule"},
    {"scale", 3, "x, y, z", "stretches along each axis; -1 mirrors"},
    {"mirror", 3, "x, y, z", "mirrors in the plane through the origin whose normal is x, y, z"},
    {"shear", 6, "xy, xz, yx, yz, zx, zy", "x grows by xy times y and xz times z, and so on"},
    {"matrix", 12, "twelve numbers", "three rows of four: the factors of x, y and z, and what is added"},
}};
static_assert(transform_words.size() == std::variant_size_v<decltype(TransformStep::kind)>);

/// `index` is a word's place in transform_words, `numbers` as many as it takes.
[[nodiscard]] TransformStep step_from(std::size_t index, const std::vector<double>& numbers);
[[nodiscard]] std::vector<double> numbers_of(const TransformStep& step);

}  // namespace raywalk::detail
