#include "text/toml_text.h"

#include "text/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace raywalk::toml_text {

namespace {

/// Bytes of the UTF-8 character at `at` (Unicode 15, table 3-7: no surrogates, nothing overlong); 0 when there is none.
std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0;
  };
  const auto is_in = [&](std::size_t i, unsigned low, unsigned high) { return low <= byte(i) && byte(i) <= high; };
  const auto tails = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i)
      if (!is_in(i, 0x80, 0xbf)) return false;
    return true;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead <= 0xdf) return tails(1, 2) ? 2 : 0;
  if (lead >= 0xe0 && lead <= 0xef) {
    const bool second = is_in(1, lead == 0xe0 ? 0xa0 : 0x80, lead == 0xed ? 0x9f : 0xbf);
    return second && tails(2, 3) ? 3 : 0;
  }
  if (lead >= 0xf0 && lead <= 0xf4) {
    const bool second = is_in(1, lead == 0xf0 ? 0x90 : 0x80, lead == 0xf4 ? 0x8f : 0xbf);
    return second && tails(2, 4) ? 4 : 0;
  }
  return 0;
}

/// The character at `at`, such as "U+00E9", as it may be invisible.
std::string described(std::string_view text, std::size_t at) {
  const std::size_t length = utf8_length(text, at);
  const auto lead = static_cast<unsigned>(static_cast<unsigned char>(text[at]));
  unsigned code = length == 1 ? lead : lead & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) code = code << 6 | (static_cast<unsigned char>(text[at + i]) & 0x3fU);
  return fmt::format("U+{:04X}", code);
}

/// The place of `at`: lines and characters from 1.
Error error_at(std::string_view text, std::size_t at, const std::string& file, std::string message, std::string hint) {
  int line = 1, column = 1;
  for (std::size_t i = 0; i < at; ++i) {
    if (text[i] == '\n') {
      ++line;
      column = 1;
    } else if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) {
      ++column;
    }
  }
  return {file, line, column, std::move(message), std::move(hint)};
}

/// Calls `visit` with the position of every character outside strings and comments until it returns true; returns that
/// position, or the text's end. A quote within a word does not open a string.
template <class Visit>
std::size_t first_outside(std::string_view text, Visit visit) {
  constexpr std::string_view before_string = " \t\r\n=[{,.";
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if ((c == '"' || c == '\'') && (at == 0 || before_string.find(text[at - 1]) != std::string_view::npos))
      at = after_string(text, at) - 1;
    else if (c == '#')
      at = std::min(text.find('\n', at), text.size()) - 1;
    else if (visit(c))
      return at;
  }
  return text.size();
}

/// The first key with more dotted names than any sensible key has.
std::size_t too_deep_key(std::string_view text) {
  constexpr int max_dots = 64;
  return first_outside(text, [dots = 0](char c) mutable {
    if (c == '\n' || c == '=' || c == ',' || c == '{') dots = 0;
    return c == '.' && ++dots > max_dots;
  });
}

/// The first character that TOML allows only in strings and comments. (toml++ 3.3.0 has undefined behaviour on it, in
/// its test for blanks.)
std::size_t stray_character(std::string_view text) {
  const std::size_t skipped = text.starts_with(utf8_mark) ? utf8_mark.size() : 0;
  return skipped + first_outside(text.substr(skipped), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
}

}  // namespace

std::size_t after_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool escapes = quote == '"';
  const std::string three(3, quote);
  if (text.substr(at, 3) == three) {
    for (std::size_t i = at + 3; i < text.size(); ++i) {
      if (escapes && text[i] == '\\') {
        ++i;
      } else if (text.substr(i, 3) == three) {
        i += 3;
        // Up to two more quotes belong to the string's content.
        for (int extra = 0; extra < 2 && i < text.size() && text[i] == quote; ++extra) ++i;
        return i;
      }
    }
    return text.size();
  }
  for (std::size_t i = at + 1; i < text.size() && text[i] != '\n'; ++i) {
    if (escapes && text[i] == '\\')
      ++i;
    else if (text[i] == quote)
      return i + 1;
  }
  return std::min(text.find('\n', at), text.size());
}

Result<void> check(std::string_view text, const std::string& file, std::string_view what) {
  const auto refuse = [&](std::size_t at, std::string message, std::string hint) {
    return tl::unexpected(error_at(text, at, file, std::move(message), std::move(hint)));
  };
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return refuse(0, fmt::format("the file is empty (expected {} in TOML)", what),
                  "copy one that comes with Raywalk, such as scenes/classic.toml, and change it");
  if (const auto other = why_not_utf8(text, file)) return tl::unexpected(*other);
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    return refuse(zero, fmt::format("this is a binary file (expected {} in TOML, which is text)", what),
                  "is this the right file?");
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0)
      return refuse(at,
                    fmt::format("byte 0x{:02x} is not UTF-8 (expected a scene in TOML, which is UTF-8 text)",
                                static_cast<unsigned>(static_cast<unsigned char>(text[at]))),
                    "save the file again with the encoding UTF-8, or check that it is the right file");
    at += length;
  }
  if (const std::size_t deep = too_deep_key(text); deep < text.size())
    return refuse(deep, "keys are nested too deeply (expected at most 64 levels)",
                  "no scene needs more than three levels, as in object.material.checker");
  if (const std::size_t stray = stray_character(text); stray < text.size())
    return refuse(stray,
                  fmt::format("the character {} stands outside of quotes (expected plain letters, digits and signs)",
                              described(text, stray)),
                  "put quotes around a text; a blank that came with a copied text may be a special one: type it anew");
  return {};
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned>(static_cast<unsigned char>(c));
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (c == '\t') {
      result += "\\t";
    } else if (code < 0x20 || code == 0x7f) {
      result += fmt::format("\\u{:04x}", code);
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string number(double value) {
  // An integer 0 has no sign in TOML.
  if (value == 0 && std::signbit(value)) return "-0.0";
  return fmt::format("{}", value);
}

std::optional<double> read_number(std::string_view word) {
  constexpr std::size_t longest = 400;
  if (word.empty() || word.size() > longest || word.find_first_not_of("+-.0123456789eE") != std::string_view::npos ||
      word.find_first_of("0123456789") == std::string_view::npos)
    return std::nullopt;
  const std::string text(word);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace raywalk::toml_text
