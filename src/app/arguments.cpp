#include "app/arguments.h"

#include "scene/schema_kinds.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace raywalk {

namespace {

template <class Number>
std::optional<Number> digits(std::string_view text) {
  Number number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.starts_with('-') || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<int> parse_whole(std::string_view text, int low, int high) {
  const auto number = digits<int>(text);
  return number && *number >= low && *number <= high ? number : std::nullopt;
}

std::optional<std::uint64_t> parse_seed(std::string_view text) { return digits<std::uint64_t>(text); }

std::optional<double> parse_amount(const std::string& text) {
  if (text.empty() || std::isspace(static_cast<unsigned char>(text.front())) != 0) return std::nullopt;
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size() || !(number >= 0) || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::optional<double> parse_share(const std::string& text) {
  const auto number = parse_amount(text);
  return number && *number <= 1 ? number : std::nullopt;
}

std::optional<Share> parse_part(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto of = parse_whole(std::string_view(text).substr(slash + 1), 1, max_parts);
  if (!of) return std::nullopt;
  const auto part = parse_whole(std::string_view(text).substr(0, slash), 1, *of);
  if (!part) return std::nullopt;
  return Share{*part, *of};
}

std::optional<ImageSize> parse_size(const std::string& text) {
  const std::size_t by = text.find_first_of("xX");
  if (by == std::string::npos) return std::nullopt;
  constexpr auto range = schema::pixel_count;
  const auto width = parse_whole(std::string_view(text).substr(0, by), range.low, range.high);
  const auto height = parse_whole(std::string_view(text).substr(by + 1), range.low, range.high);
  if (!width || !height) return std::nullopt;
  return ImageSize{*width, *height};
}

std::optional<PixelChoice> parse_pixel(const std::string& text) {
  constexpr int most = schema::pixel_count.high - 1;
  const std::size_t comma = text.find(',');
  const auto first = parse_whole(std::string_view(text).substr(0, comma), 0, most);
  if (!first) return std::nullopt;
  if (comma == std::string::npos) return Cell{*first};
  const auto row = parse_whole(std::string_view(text).substr(comma + 1), 0, most);
  if (!row) return std::nullopt;
  return ImagePixel{*first, *row};
}

}  // namespace raywalk
