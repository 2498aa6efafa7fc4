#pragma once
// The whole interface: needs an ImGui context and a state, but no window.

#include "gui/browser.h"
#include "gui/panes.h"
#include "gui/window.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace raywalk {

class Interface {
 public:
  /// `home`: the initial folder of the file dialog for a scene without a file.
  explicit Interface(std::string home) : home_(std::move(home)) {}

  /// Draws `state` between ImGui::NewFrame and Render. `unit` and `dpi` as in Ui.
  void draw(const State& state, const Fonts& fonts, float unit, float dpi, const PictureView& picture);
  /// Handles a key press; keys for a text field or an open menu are left to it. What no field uses, such as Ctrl+S,
  /// ends the typing first.
  void press(const State& state, const Fonts& fonts, float unit, float dpi, const KeyPress& key);
  /// Acts once what is being typed into a field has been taken over: a few frames later; at once if nothing is.
  void act_after_typing(const Action& action);
  /// Runs a command, if it is enabled.
  void run(const State& state, const Fonts& fonts, float unit, float dpi, const Command& command);

  /// The actions since the last call, in order.
  [[nodiscard]] std::vector<Action> take_actions() { return std::exchange(actions_, {}); }
  /// Requests that only the window can fulfil.
  [[nodiscard]] bool take_full_screen() { return std::exchange(full_screen_, false); }
  /// The rectangles of the last frame, by name, in units.
  [[nodiscard]] const std::map<std::string, Rect, std::less<>>& items() const { return items_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }
  /// Whether what is typed goes into a lesson's field for a number.
  [[nodiscard]] bool types_number() const { return lesson_.types(); }
  /// Seconds until the next frame is needed without input (for a tooltip); negative: none.
  [[nodiscard]] double next_frame_in() const { return next_frame_in_; }

 private:
  [[nodiscard]] Ui ui(const State& state, const Fonts& fonts, float unit, float dpi);
  void grant(const Ui& ui);
  void after_typing(std::function<void(const Ui& ui)> what);

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
  InkField ink_field_;
  Browser browser_;
  bool full_screen_ = false, focus_properties_ = false, open_settings_ = false, open_knobs_ = false,
       open_breakpoints_ = false;
  int wanted_menu_ = -1, shown_menu_ = -1;  ///< of the bar, by number; -1: none
  /// A horizontal arrow key in an open menu: if it closes the menu, and opens no submenu, the neighbour opens.
  struct Aside {
    int neighbour = -1, frames = 0;
  } aside_;
  std::vector<std::function<void(const Ui& ui)>> after_typing_;
  int left_in_ = 0;  ///< frames until the field is left, and these are done
  float scroll_help_ = 0;
  double next_frame_in_ = -1;
};

}  // namespace raywalk
