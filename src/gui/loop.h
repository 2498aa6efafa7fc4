#pragma once

#include "gui/attention.h"
#include "gui/gui.h"
#include "gui/session.h"
#include "gui/window.h"
#include "view/cost/cost.h"

#include <chrono>
#include <memory>
#include <string_view>

namespace raywalk {

/// Shows a state in the window and follows its events, one turn at a time: whoever runs it decides when the next
/// begins.
class Loop {
 public:
  /// `begun`: when the program began, for its report.
  Loop(GuiOptions options, State state, Window& window, Attention& attention, Demo demo,
       std::chrono::steady_clock::time_point begun);
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// Waits for an event or for what is due, where waiting is possible, and does it. False once the window is closed or,
  /// for a screenshot, idle.
  [[nodiscard]] bool turn();
  /// Seconds until the next turn is needed without an event; negative: it is not.
  [[nodiscard]] double patience() const;
  /// As if the user had done it.
  void act(const Action& action);
  /// Does what a button or a field of outline_with_commands stands for; fails where outlined_action does.
  Result<void> act_by_outline(std::string_view does, std::string_view typed);
  /// Writes an autosave of unsaved work that has none yet: nobody may come back to what is left now.
  void autosave_now();
  /// The graphics card has lost all that was drawn with.
  void draw_again();
  [[nodiscard]] const State& state() const;
  /// What Cost has found so far; as long as the loop does nothing.
  [[nodiscard]] CostFindings costs() const;
  /// Whether a button is there, in units, that repeats while it is held down.
  [[nodiscard]] bool holds_at(float x, float y) const;
  /// Whether what is typed goes into a lesson's field for a number.
  [[nodiscard]] bool types_number() const;
  /// After the last turn. Fails where run_gui says.
  [[nodiscard]] Result<void> end();

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace raywalk
