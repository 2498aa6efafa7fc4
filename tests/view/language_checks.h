#pragma once
// What must hold between the two languages of any text.

#include "every_text.h"
#include "support/catch.h"

#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk::test {

/// "{0}", "{1}", ... that stand in a text, each as often as it does.
[[nodiscard]] inline std::multiset<std::string> placeholders(std::string_view text) {
  std::multiset<std::string> found;
  for (std::size_t i = 0; i + 2 < text.size(); ++i)
    if (text[i] == '{' && text[i + 2] == '}') found.insert(std::string(text.substr(i, 3)));
  return found;
}

/// Whether digits stand on both sides of a mark.
[[nodiscard]] inline bool has_decimal(std::string_view text, char mark) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i] == mark && digit(text[i - 1]) && digit(text[i + 1])) return true;
  return false;
}

/// Checks every pair. `same_in_both`: names and signs that are not translated.
inline void check_languages(const std::vector<TextPair>& all, const std::set<std::string>& same_in_both) {
  std::set<std::string> seen_same;
  for (const TextPair& pair : all) {
    INFO(pair.where << ": " << pair.english << " | " << pair.portuguese);
    CHECK_FALSE(pair.english.empty());
    CHECK_FALSE(pair.portuguese.empty());
    CHECK(placeholders(pair.english) == placeholders(pair.portuguese));
    CHECK_FALSE(has_decimal(pair.portuguese, '.'));
    CHECK_FALSE(has_decimal(pair.english, ','));
    if (pair.english != pair.portuguese) continue;
    CHECK(same_in_both.count(pair.english) == 1);
    seen_same.insert(pair.english);
  }
  CHECK(seen_same == same_in_both);  // the list names nothing that has been translated
}

}  // namespace raywalk::test
