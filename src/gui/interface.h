#pragma once
// The whole interface in one frame of ImGui: it needs an ImGui context and a state, but no window.

#include "gui/browser.h"
#include "gui/panes.h"
#include "gui/window.h"

#include <map>
#include <string>
#include <vector>

namespace raywalk {

class Interface {
 public:
  /// `home`: folder in which the file dialog begins for a scene that is in no file.
  explicit Interface(std::string home) : home_(std::move(home)) {}

  /// Draws `state` between ImGui::NewFrame and Render. `unit` and `dpi` as in Ui.
  void draw(const State& state, const Fonts& fonts, float unit, float dpi, const Picture& picture);
  /// What a key press asks for; keys that a text field or an open menu wants are left to it.
  void press(const State& state, const Fonts& fonts, float unit, float dpi, const KeyPress& key);

  /// What was asked for since the last call, in order.
  [[nodiscard]] std::vector<Action> take_actions() { return std::exchange(actions_, {}); }
  /// Of the wishes, those that only the window can grant.
  [[nodiscard]] bool take_full_screen() { return std::exchange(full_screen_, false); }
  /// Where things stood in the last frame, by name, in units.
  [[nodiscard]] const std::map<std::string, Rect, std::less<>>& items() const { return items_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  /// Seconds until another frame is needed although nothing happens (a tooltip is due); negative: none.
  [[nodiscard]] double next_frame_in() const { return next_frame_in_; }

 private:
  [[nodiscard]] Ui ui(const State& state, const Fonts& fonts, float unit, float dpi);
  void grant(const Ui& ui);

  std::string home_;
  std::vector<Action> actions_;
  std::vector<WindowWish> wishes_;
  std::map<std::string, Rect, std::less<>> items_;
  Rest rest_;
  Layout layout_;
  PropertiesPane properties_;
  TabsPane tabs_;
  LessonPane lesson_;
  BreakpointsPopup breakpoints_;
  Browser browser_;
  bool full_screen_ = false, focus_properties_ = false, open_settings_ = false, open_knobs_ = false,
       open_breakpoints_ = false;
  int wanted_menu_ = -1, shown_menu_ = -1;  ///< of the bar, by number; -1: none
  /// An arrow to the side in an open menu: when that closes, and opens no menu inside, its neighbour opens.
  struct Aside {
    int neighbour = -1, frames = 0;
  } aside_;
  bool exchanged_ = false;  ///< the tabs stand where the plan was, and the plan in their corner
  float scroll_help_ = 0;
  double next_frame_in_ = -1;
};

}  // namespace raywalk
