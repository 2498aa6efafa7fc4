#pragma once
// The presenter's notes: drawn anywhere, and in a window of their own, for which gui/desktop and gui/web have a file
// each.

#include "gui/fonts.h"
#include "view/lesson/notes_panel.h"

#include <memory>
#include <string>

namespace raywalk {

class Window;

/// How long a lesson has been going on, as a clock shows it: "3:05".
[[nodiscard]] std::string elapsed_text(double seconds);

/// Draws notes over the whole of ImGui's display, as large as they fit. `clock`: the time of day and since the lesson
/// began. `grown`: how much larger than usual the fonts are. Returns how much larger they would have to be for letters
/// that fit and are sharp, because they are drawn as large as they are.
float draw_notes(const NotesPanel& panel, const Fonts& fonts, Theme theme, const std::string& clock, float grown = 1);

class NotesWindow {
 public:
  /// Keys pressed in it are `main`'s.
  NotesWindow(Window& main, FontFiles fonts);
  ~NotesWindow();
  NotesWindow(const NotesWindow&) = delete;
  NotesWindow& operator=(const NotesWindow&) = delete;

  /// Shows the notes of `state`. False once the user has closed the window.
  [[nodiscard]] bool show(const State& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace raywalk
