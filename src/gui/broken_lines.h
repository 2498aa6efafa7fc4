#pragma once

#include <imgui.h>

#include <algorithm>
#include <string>

namespace raywalk {

/// `text` broken at words so that each line fits. ImGui itself would break after any full stop, even in numbers.
template <class Fits>
[[nodiscard]] std::string in_lines(const std::string& text, Fits fits) {
  std::string lines, line;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    const std::string word = text.substr(at, end - at);
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && !fits(longer)) {
      lines += line + "\n";
      line = word;
    } else {
      line = longer;
    }
    if (end < text.size() && text[end] == '\n') {
      lines += line + "\n";
      line.clear();
    }
    at = end + 1;
  }
  return lines + line;
}

/// The same at this width, in the current font.
[[nodiscard]] inline std::string broken_lines(const std::string& text, float width) {
  return in_lines(text, [&](const std::string& line) { return ImGui::CalcTextSize(line.c_str()).x <= width; });
}

}  // namespace raywalk
