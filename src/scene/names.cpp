#include "scene/names.h"

#include <algorithm>

namespace raywalk {

std::string shown_name(const std::vector<std::string>& translated, std::string_view name, Language language) {
  if (std::find(translated.begin(), translated.end(), name) == translated.end()) return std::string(name);
  const auto said = [&](std::string_view word) { return language.catalogue().find("name." + std::string(word)); };
  if (const std::string* const whole = said(name)) return *whole;
  const std::size_t last = name.find_last_not_of("0123456789.");
  const std::size_t number = last == std::string_view::npos || name[last] != ' ' ? name.size() : last;
  const std::string* const word = said(name.substr(0, number));
  return word == nullptr ? std::string(name) : *word + std::string(name.substr(number));
}

}  // namespace raywalk
