#pragma once
// Ink over the plan: freehand, arrows, words, a ruler and a protractor. What is drawn lies in the units of the scene,
// so that zooming and moving the plan leave it in place. It belongs to the document (io/scene_file.h), is undone as
// edits are, and goes into the file on request.

#include "scene/ink.h"
#include "view/fields.h"
#include "view/plan/room.h"
#include "view/room.h"

#include <optional>
#include <string>

namespace raywalk {

enum class InkTool { pen, arrow, text, ruler, protractor, eraser };
template <>
inline constexpr Word<InkTool> words_of<InkTool>[] = {
    {InkTool::pen, "pen"},     {InkTool::arrow, "arrow"},           {InkTool::text, "text"},
    {InkTool::ruler, "ruler"}, {InkTool::protractor, "protractor"}, {InkTool::eraser, "eraser"}};

}  // namespace raywalk

namespace raywalk::action {

/// Whether the pointer draws, in place of what it does in the plan. What is drawn stays in sight.
struct SetInk {
  static constexpr std::string_view word = "ink";
  bool on;
  static void fields(auto& f, auto& a) { f(a.on, on_or_off); }
  void apply(State& state) const;
};
/// What the pointer draws.
struct ChooseInkTool {
  static constexpr std::string_view word = "ink-tool";
  InkTool tool;
  static void fields(auto& f, auto& a) { f(a.tool); }
  void apply(State& state) const;
};
struct ChooseInkColour {
  static constexpr std::string_view word = "ink-colour";
  InkColour colour;
  static void fields(auto& f, auto& a) { f(a.colour); }
  void apply(State& state) const;
};
/// What is being written, once a place for it is pressed.
struct TypeInk {
  static constexpr std::string_view word = "ink-type";
  std::string text;
  static void fields(auto& f, auto& a) { f(a.text); }
  void apply(State& state) const;
};
/// Puts down what is being written.
struct FinishInk {
  static constexpr std::string_view word = "ink-finish";
  void apply(State& state) const;
};
/// Drops what is begun; with nothing begun, the pointer draws no more.
struct LeaveInk {
  static constexpr std::string_view word = "ink-leave";
  void apply(State& state) const;
};
/// Removes all ink.
struct ClearInk {
  static constexpr std::string_view word = "ink-clear";
  void apply(State& state) const;
};
/// Whether the ink is saved with the scene.
struct KeepInk {
  static constexpr std::string_view word = "ink-keep";
  bool kept;
  static void fields(auto& f, auto& a) { f(a.kept, on_or_off); }
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// Drawing over the plan.
struct InkRoom {
  using Actions = Types<action::SetInk, action::ChooseInkTool, action::ChooseInkColour, action::TypeInk,
                        action::FinishInk, action::LeaveInk, action::ClearInk, action::KeepInk>;
  static Commands commands();
  static constexpr Layer layer = Layer::on_top;
  static void draw_in_plan(Painter& painter);

  // The pointer while it draws: places in scene units. Measuring tools take two or three places: pressed one after the
  // other, or drawn from one to the next.
  static void press(State& state, const Vec2d& at, const action::Modifiers& modifiers);
  static void lead(State& state, const Vec2d& at, const action::Modifiers& modifiers);
  static void lift(State& state, bool moved);
  static void drop(State& state);  ///< takes the drag back

  /// A mark that is not finished.
  struct Begun {
    InkMark mark;
    int placed = 1;     ///< of an arrow's, a ruler's or a protractor's places: those that stay; the next follows
    bool fresh = true;  ///< the press that began it still lasts
  };

  bool on = false;
  InkTool tool = InkTool::pen;
  InkColour colour = InkColour::red;
  std::optional<Begun> begun;
  Vec2d led{0.0};       ///< where the eraser was last
  bool erased = false;  ///< since it was pressed
};

/// Whether the pointer draws: the plan is shown, and ink is on.
[[nodiscard]] bool inks(const State& state);
/// The text that is being written; null if there is none.
[[nodiscard]] const InkText* text_begun(const State& state);

}  // namespace raywalk
