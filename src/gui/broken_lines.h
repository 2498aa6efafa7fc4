#pragma once

#include <imgui.h>

#include <algorithm>
#include <string>

namespace raywalk {

/// `text` wrapped at words to this width, in the current font. ImGui itself would break after any full stop, even in
/// numbers.
[[nodiscard]] inline std::string broken_lines(const std::string& text, float width) {
  std::string lines, line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    at = end + 1;
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && ImGui::CalcTextSize(longer.c_str()).x > width) {
      lines += line + "\n";
      line = word;
    } else {
      line = longer;
    }
  }
  return lines + line;
}

}  // namespace raywalk
