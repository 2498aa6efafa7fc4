#include "scene/schema.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace raywalk::schema {

std::optional<Refusal> Number::refusal(double value) const {
  const double least = 1 / max_magnitude;
  if (!(std::abs(value) <= max_magnitude))
    return Refusal{fmt::format("at most {:g}", max_magnitude), "choose another unit of length"};
  if (value < low || (above_low && value == low) || value > high || (below_high && value == high))
    return Refusal{expected(), std::string(hint)};
  if (low == 0 && above_low && value < least)
    return Refusal{fmt::format("at least {:g}", least), "choose another unit of length"};
  return std::nullopt;
}

std::optional<Vec3d> usable_direction(const Vec3d& given) {
  const Vec3d sizes = absolute(given);
  const double largest = std::fmax(sizes.x, std::fmax(sizes.y, sizes.z));
  if (!(largest > 0)) return std::nullopt;
  if (length(given) >= 1 / max_magnitude) return given;
  const int exponent = std::ilogb(largest);
  return Vec3d(std::scalbn(given.x, -exponent), std::scalbn(given.y, -exponent), std::scalbn(given.z, -exponent));
}

std::string Whole::expected() const { return fmt::format("a whole number from {} to {}", low, high); }

std::string quoted_words(const std::vector<std::string_view>& words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == words.size() ? " or " : ", ", words[i]);
  return list;
}

const std::string& integrator_sentence() {
  static const std::string sentence = [] {
    std::string each, rest;
    for (const IntegratorTraits& traits : raywalk::integrators)
      if (traits.integrator == Integrator::automatic)
        rest = fmt::format(". {}: {}.", traits.name, traits.follows);
      else
        each += fmt::format("{} {} ({})", each.empty() ? ":" : ";", traits.follows, traits.name);
    return "How light is followed" + each + rest;
  }();
  return sentence;
}

std::string OneLine::expected() const { return Name{longest}.expected(); }

std::string Name::expected() const { return fmt::format("one line of text in quotes, 1 to {} bytes long", longest); }

std::string Rows::expected() const {
  return least == 0 ? fmt::format("a list of at most {} {}", most, words)
                    : fmt::format("a list of {} to {} {}", least, most, words);
}

std::string Steps::expected() const { return fmt::format("a list of at most {} steps", most); }

}  // namespace raywalk::schema
