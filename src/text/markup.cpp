#include "text/markup.h"

#include <algorithm>

namespace raywalk {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        // XML has no control characters but these, not even escaped.
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
          result += "\uFFFD";
        else
          result += c;
    }
  }
  return result;
}

std::string escaped_with_powers(std::string_view text, std::string_view open, std::string_view close) {
  constexpr std::string_view parts = "0123456789-/N", minus = "\u2212";
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t power = std::min(text.find('^', begin), text.size());
    result += escaped(text.substr(begin, power - begin));
    begin = std::min(text.find_first_not_of(parts, power + 1), text.size());
    if (power == text.size()) break;
    result += open;
    for (const char c : text.substr(power + 1, begin - power - 1))
      result += c == '-' ? std::string(minus) : std::string(1, c);
    result += close;
  }
  return result;
}

}  // namespace raywalk
