#pragma once
// Ink: what a person has drawn over the plan. It lies beside the scene, in its units; no ray meets it.

#include "math/vec.h"
#include "math/words.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

struct PenStroke {
  std::vector<Vec2d> points;  ///< at least one
  friend bool operator==(const PenStroke&, const PenStroke&) = default;
};
struct InkArrow {
  Vec2d from{0.0}, to{1.0, 0.0};
  friend bool operator==(const InkArrow&, const InkArrow&) = default;
};
struct InkText {
  Vec2d at{0.0};  ///< its left end, and the middle of its height
  std::string text = "?";
  friend bool operator==(const InkText&, const InkText&) = default;
};
/// Says its length.
struct Ruler {
  Vec2d from{0.0}, to{1.0, 0.0};
  friend bool operator==(const Ruler&, const Ruler&) = default;
};
/// Says the angle at `vertex` between the ways to `from` and to `to`, the smaller of the two.
struct Protractor {
  Vec2d vertex{0.0}, from{1.0, 0.0}, to{0.0, 1.0};
  friend bool operator==(const Protractor&, const Protractor&) = default;
};

/// The value of `type`.
constexpr std::string_view shape_name(const PenStroke& /*mark*/) { return "pen"; }
constexpr std::string_view shape_name(const InkArrow& /*mark*/) { return "arrow"; }
constexpr std::string_view shape_name(const InkText& /*mark*/) { return "text"; }
constexpr std::string_view shape_name(const Ruler& /*mark*/) { return "ruler"; }
constexpr std::string_view shape_name(const Protractor& /*mark*/) { return "protractor"; }

/// `plain` is dark on light and light on dark.
enum class InkColour { plain, red, blue, green, yellow };
template <>
inline constexpr Word<InkColour> words_of<InkColour>[] = {{InkColour::plain, "plain"},
                                                          {InkColour::red, "red"},
                                                          {InkColour::blue, "blue"},
                                                          {InkColour::green, "green"},
                                                          {InkColour::yellow, "yellow"}};

struct InkMark {
  std::variant<PenStroke, InkArrow, InkText, Ruler, Protractor> shape;
  InkColour colour = InkColour::red;
  friend bool operator==(const InkMark&, const InkMark&) = default;
};
/// In the order of drawing.
using Ink = std::vector<InkMark>;

inline constexpr std::size_t most_pen_points = 10'000, longest_ink_text = 200;

}  // namespace raywalk
