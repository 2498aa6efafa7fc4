#include "scene/warnings.h"

#include "scene/scene.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>

namespace raywalk {

bool is_empty(const Scene& scene) { return scene.objects.empty() && !scene.sky; }

namespace {

/// The position after the closing quote of the quoted text that begins at `at`; a quote in a name is escaped with \.
std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] == '"') return i + 1;
    if (text[i] == '\\') ++i;
  }
  return text.size();
}

/// The warning without what is specific to one object: its position, its name and its numbers.
std::string kind_of(std::string_view warning) {
  constexpr std::string_view digits = "0123456789", number = "0123456789.e+-";
  std::string kind;
  for (std::size_t i = 0; i < warning.size();) {
    if (warning[i] == '"') {
      kind += '"';
      i = end_of_quoted(warning, i);
    } else if (digits.find(warning[i]) != std::string_view::npos) {
      kind += '0';
      i = std::min(warning.find_first_not_of(number, i), warning.size());
    } else {
      kind += warning[i++];
    }
  }
  return kind;
}

}  // namespace

std::vector<std::string> collected(const std::vector<std::string>& warnings) {
  std::vector<std::string> lines;
  std::vector<int> more;
  std::map<std::string, std::size_t> line_of;
  for (const std::string& warning : warnings) {
    const auto [known, is_new] = line_of.emplace(kind_of(warning), lines.size());
    if (is_new) {
      lines.push_back(warning);
      more.push_back(0);
    } else {
      ++more[known->second];
    }
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (more[i] > 0) lines[i] += "; and " + std::to_string(more[i]) + " more like it";
  return lines;
}

}  // namespace raywalk
