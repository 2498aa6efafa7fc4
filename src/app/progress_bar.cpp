#include "app/progress_bar.h"

#include "app/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace raywalk {

std::string duration_text(double seconds) {
  constexpr double most = 99 * 3600;
  if (!(seconds < most)) return "over 99 h";
  const int whole = static_cast<int>(std::ceil(std::max(0.0, seconds)));
  const int hours = whole / 3600, minutes = whole / 60 % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                   : fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string progress_line(const Progress& progress, int width) {
  // Rounded down: 100% is shown only when all is done.
  const int percent = static_cast<int>(std::clamp(progress.done, 0.0, 1.0) * 100);
  const std::string words = fmt::format(" {:3}%  {} left", percent, duration_text(progress.seconds_left));
  const int bar = std::min(width - static_cast<int>(words.size()) - 2, 50);
  if (bar < 5) return words.substr(1, static_cast<std::size_t>(std::max(0, width)));
  const int filled = percent * bar / 100;
  std::string line = "[" + std::string(static_cast<std::size_t>(filled), '=');
  if (filled < bar) line += ">" + std::string(static_cast<std::size_t>(bar - filled - 1), ' ');
  return line + "]" + words;
}

ProgressBar::ProgressBar() : width_(terminal_width()) {}

ProgressBar::~ProgressBar() {
  if (!shown_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
}

void ProgressBar::show(const Progress& progress) {
  if (width_ == 0) return;
  shown_ = true;
  // The last column stays free: some terminals wrap when it is written.
  std::fputs(("\r" + progress_line(progress, width_ - 1) + "\x1b[K").c_str(), stderr);
  std::fflush(stderr);
}

void ProgressBar::show(double done, double seconds_left) {
  Progress progress{};
  progress.done = done;
  progress.seconds_left = seconds_left;
  show(progress);
}

}  // namespace raywalk
