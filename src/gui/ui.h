#pragma once
// The context of every pane: the state to show, and the sink of user actions.

#include "gui/fonts.h"
#include "gui/layout.h"
#include "view/action.h"
#include "view/text/text.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raywalk {

/// A request that concerns the window and not the state.
enum class WindowWish {
  full_screen,
  menu,                   ///< opens the first menu, or the one after the open one
  properties,             ///< focuses the first field of the properties
  image_settings,         ///< opens the settings of the 3-D picture
  cost_knobs,             ///< opens the knobs of the Cost panel
  breakpoints,            ///< opens the breakpoints and the go-to field
  lesson_number,          ///< a lesson's field for a number gets the keyboard, and the digit that was pressed
  missing_lesson_number,  ///< the same field gets the keyboard, and says that nothing was typed
  line_up,                ///< these scroll the help text
  line_down,
  page_up,
  page_down,
  top,
  bottom,
};

/// A tooltip to be shown at the end of the frame, when it is known what stands beside its item.
struct Tip {
  Rect item;
  std::string text;
};

/// What the pointer rests on, for delayed tooltips.
class Rest {
 public:
  /// Called in every frame for the item under the pointer: whether it has been there long enough. Not once it was
  /// `pressed`: who clicks on it, perhaps again and again, knows it.
  bool rested_on(std::string_view name, double now, bool pressed) {
    if (name_ != name) {
      name_ = name;
      since_ = now;
      pressed_ = false;
    }
    pressed_ = pressed_ || pressed;
    asked_ = true;
    now_ = now;
    return !hushed_ && !pressed_ && now - since_ >= patience;
  }
  /// A key was pressed: who types looks elsewhere, until the pointer moves.
  void hush() { hushed_ = true; }
  void pointer_moved() { hushed_ = false; }
  [[nodiscard]] bool hushed() const { return hushed_; }
  void show(Tip tip) { tip_ = std::move(tip); }
  [[nodiscard]] std::optional<Tip> take_tip() { return std::exchange(tip_, std::nullopt); }
  /// Requests another frame after at most this many seconds.
  void wake_in(double seconds) { wake_ = wake_ < 0 ? seconds : std::min(wake_, seconds); }
  /// At the end of a frame. Returns the seconds until the next frame; negative: none.
  double end_frame() {
    if (!asked_) name_.clear();
    if (std::exchange(asked_, false) && !pressed_ && now_ - since_ < patience) wake_in(patience - (now_ - since_));
    return std::exchange(wake_, -1);
  }

 private:
  static constexpr double patience = 0.6;  // seconds
  std::string name_;
  double since_ = 0, now_ = 0;
  bool asked_ = false, pressed_ = false, hushed_ = false;
  std::optional<Tip> tip_;
  double wake_ = -1;
};

struct Ui {
  const State& state;
  const Fonts& fonts;
  const Palette& colours;
  float unit = 1;  ///< ImGui's units per unit at scale 1, for the interface around the plan
  float dpi = 1;   ///< ImGui's units per pixel of `view`, which scales its drawings itself
  std::vector<Action>& actions;
  std::vector<WindowWish>& wishes;
  /// Rectangles drawn in this frame, by name: used by tests.
  std::map<std::string, Rect, std::less<>>& items;
  Rest& rest;
  float finger = 0;  ///< the least height of what is pressed, in ImGui's units; 0: as its words need

  /// A text in the language of the interface, with its arguments.
  [[nodiscard]] std::string say(std::string_view id, const TextArguments& arguments = {}) const {
    return fill(id, state.appearance.language, arguments);
  }
  /// In its own file: moving actions takes two seconds to compile.
  void act(Action action) const;
  void wish(WindowWish what) const { wishes.push_back(what); }
  [[nodiscard]] float px(float units) const { return units * unit; }
  /// The padding of a window that is as large as its contents: whole, for ImGui drops what its size has beyond whole
  /// units, and a window that lacks that part scrolls.
  [[nodiscard]] ImVec2 padding(float x, float y) const { return {std::round(px(x)), std::round(px(y))}; }
  /// A height of what is pressed: so many units, and where a finger presses as many as that needs.
  [[nodiscard]] float high(float units) const { return std::max(px(units), finger); }
  /// What a finger presses, so high, shows less than that above and below: neighbours then need no gap.
  [[nodiscard]] float unseen(float height) const { return finger > 0 && height > finger - 1 ? px(3) : 0; }
  /// Notes the rectangle of ImGui's last item.
  void publish(std::string_view name) const;
  void publish(std::string_view name, const Rect& where) const;
};

[[nodiscard]] inline ImU32 to_imgui(Colour c) { return IM_COL32(c.r, c.g, c.b, c.a); }
[[nodiscard]] inline ImVec4 to_imgui4(Colour c) { return ImGui::ColorConvertU32ToFloat4(to_imgui(c)); }
[[nodiscard]] inline ImVec2 corner(const Rect& r) { return {r.x, r.y}; }
[[nodiscard]] inline ImVec2 opposite(const Rect& r) { return {r.right(), r.bottom()}; }
[[nodiscard]] inline ImVec2 size(const Rect& r) { return {r.width, r.height}; }

/// A pane, as long as it exists: a child window that covers `where`, with a background. False if invisible.
class Pane {
 public:
  Pane(const Ui& ui, const char* name, const Rect& where, Colour ground, ImVec2 padding = {0, 0},
       ImGuiWindowFlags flags = 0);
  ~Pane() { ImGui::EndChild(); }
  Pane(const Pane&) = delete;
  Pane& operator=(const Pane&) = delete;
  explicit operator bool() const { return visible_; }

 private:
  bool visible_;
};

/// While it exists, ImGui's fields, and what is as high as they are, suit a finger where one presses: they are a little
/// higher, and the gaps between them belong to them.
class FingerFields {
 public:
  explicit FingerFields(const Ui& ui);
  ~FingerFields();
  FingerFields(const FingerFields&) = delete;
  FingerFields& operator=(const FingerFields&) = delete;

 private:
  int pushed_ = 0;
  ImVec2 reach_;  ///< beyond an item's edges, before
};

/// In a dialog, a framed list of this height that scrolls, as wide as there is room, of lines as high as a finger
/// needs. False while nothing of it is seen.
class ScrolledList {
 public:
  ScrolledList(const Ui& ui, const char* name, float height, float padding);
  ~ScrolledList();
  ScrolledList(const ScrolledList&) = delete;
  ScrolledList& operator=(const ScrolledList&) = delete;
  explicit operator bool() const { return visible_; }

 private:
  bool visible_;
};

/// A popup with a form, as long as it exists: named NAME-popup, in small letters. False unless it is open.
class FormPopup {
 public:
  FormPopup(const Ui& ui, const char* name);
  ~FormPopup();
  FormPopup(const FormPopup&) = delete;
  FormPopup& operator=(const FormPopup&) = delete;
  explicit operator bool() const { return open_; }
  /// Of a form in it: so many units, where the window is as wide.
  [[nodiscard]] static float width(const Ui& ui, float units);

 private:
  bool open_;
};

/// Small arrowheads in the middle of the upper and lower edge of `where`: that there is more above or below.
void mark_more(const Ui& ui, const Rect& where, bool above, bool below);
/// In a window over `where`, the height nearest to `edge`, upwards (way -1) or downwards (way 1), that cuts nothing of
/// what was drawn: between two lines of text, or above a button. Nothing if that is farther than `most`. What fills the
/// whole height of the window, its ground, is always cut.
[[nodiscard]] std::optional<float> uncut_edge(const ImDrawList& drawn, const Rect& where, float edge, float way,
                                              float most);
/// At the end of a scrolling region, where more is above or below: shows whole lines only, and marks that there are
/// more. Large pictures fade into the background instead. Returns where whole lines are seen.
Rect close_edges(const Ui& ui, Colour ground);

}  // namespace raywalk
