// The interface on a bench: ImGui without a window, a display or a graphics card, and a hand to click and type.
#pragma once

#include <string>
#include <vector>

#include "gui/interface.h"
#include "gui/live_costs.h"

namespace raywalk::test {

// The classic scene as shipped, in no file.
State classic();
// The same beside the shipped lessons and scenes.
State classic_with_lessons();

class Bench {
 public:
  explicit Bench(State initial = classic(), float width = 1280, float height = 720, const FontFiles& faces = {});
  ~Bench();
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  State state;
  // Everything that the interface asked for since the last forget().
  std::vector<Action> actions;
  // Whether actions change the state; switched off to see what a click asks for and nothing more.
  bool obedient = true;
  // Frames between an event and the next, as the window draws them.
  int settle = 3;

  void frames(int count = 1);
  void resize(float width, float height);
  void forget() { actions.clear(); }

  void move_to(float x, float y);
  void press(int button = 0);
  void release(int button = 0);
  void wheel(float clicks);
  // In the middle of the item of this name; fails the test when there is none.
  void point_at(const std::string& item);
  void click(const std::string& item);
  void double_click(const std::string& item);
  // Dragged by this much, in a few moves.
  void drag(const std::string& item, float dx, float dy);
  // A key as menus write it: "Ctrl+Shift+S".
  void key(const std::string& written);
  // A key of ImGui's own, down or up again; seen with the next frame.
  void hold(ImGuiKey_ key, bool down);
  // The same key, held down.
  void repeat(const std::string& written);
  // Characters into the field that has the keyboard.
  void type(const std::string& text);
  // Enter or Escape, for ImGui's own fields.
  void enter();

  [[nodiscard]] bool has(const std::string& item) const { return interface_.items().contains(item); }
  [[nodiscard]] Rect rect(const std::string& item) const;
  [[nodiscard]] const Interface& interface() const { return interface_; }
  [[nodiscard]] Interface& interface() { return interface_; }
  // Vertices drawn in the last frame.
  [[nodiscard]] int vertices() const;

  // The last action of this kind that was asked for; null when there is none.
  template <class Kind>
  [[nodiscard]] const Kind* last() const {
    for (auto action = actions.rbegin(); action != actions.rend(); ++action) {
      if (const auto* found = action->as<Kind>()) return found;
    }
    return nullptr;
  }

  // ImGui's units per unit at scale 1, and the display's own scale.
  float unit = 1, dpi = 1;

 private:
  void frame();
  // Letters and spacing of the scale, as the window sets them.
  void rescale();
  void take_actions();

  Interface interface_;
  LiveCosts costs_;
  FontFiles faces_;
  Fonts fonts_;
  float fonts_unit_ = 0;  // that `fonts_` are for
  ImGuiContext* context_ = nullptr;
};

}  // namespace raywalk::test
