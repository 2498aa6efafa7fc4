#pragma once

#include "render/render.h"

#include <string>

namespace raywalk {

/// "0:07", "12:30", "3:00:05"; above 99 hours "over 99 h".
[[nodiscard]] std::string duration_text(double seconds);

/// A line of at most `width` characters: "[=======>        ]  43%  0:12 left".
[[nodiscard]] std::string progress_line(const Progress& progress, int width);

/// Redraws the line in place on standard error; does nothing if that is not a terminal.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();  ///< wipes the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void show(const Progress& progress);
  void show(double done, double seconds_left);

 private:
  int width_;
  bool shown_ = false;
};

}  // namespace raywalk
