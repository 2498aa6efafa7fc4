#pragma once
// Edits of the scene, undo, and files.

#include "view/fields.h"
#include "view/state.h"

#include <string>

namespace raywalk {

namespace action {
enum class ObjectKind { solid_sphere, transparent_sphere, polygon, light };
enum class Answer { save, discard, recover, cancel };
}  // namespace action
template <>
inline constexpr Word<action::ObjectKind> words_of<action::ObjectKind>[] = {
    {action::ObjectKind::solid_sphere, "solid-sphere"},
    {action::ObjectKind::transparent_sphere, "transparent-sphere"},
    {action::ObjectKind::polygon, "polygon"},
    {action::ObjectKind::light, "light"}};
template <>
inline constexpr Word<action::Answer> words_of<action::Answer>[] = {{action::Answer::save, "save"},
                                                                    {action::Answer::discard, "discard"},
                                                                    {action::Answer::recover, "recover"},
                                                                    {action::Answer::cancel, "cancel"}};

namespace action {

// Edits. Each is one undo entry; with `continues` it joins the previous entry, if that was the same edit of the same
// thing (a dragged slider). An edit that would make the scene invalid is refused with a notice that says why.

struct AddObject {
  static constexpr std::string_view word = "add";
  ObjectKind kind;
  static void fields(auto& f, auto& a) { f(a.kind); }
  void apply(State& state) const;
};
/// An object, a light, or a corner.
struct RemoveSelected {
  static constexpr std::string_view word = "remove";
  void apply(State& state) const;
};
struct InsertCorner {
  static constexpr std::string_view word = "insert-corner";
  int object;
  int edge;
  Vec2d at;  ///< scene units
  static void fields(auto& f, auto& a) { f(a.object), f(a.edge), f(a.at); }
  void apply(State& state) const;
};
struct RemoveCorner {
  static constexpr std::string_view word = "remove-corner";
  int object;
  int corner;
  static void fields(auto& f, auto& a) { f(a.object), f(a.corner); }
  void apply(State& state) const;
};
/// An object or a light.
struct Rename {
  static constexpr std::string_view word = "rename";
  Target target;
  std::string name;
  static void fields(auto& f, auto& a) { f(a.target), f(a.name); }
  void apply(State& state) const;
};
struct SetMaterial {
  int object;
  Material material;
  bool continues = false;
  static void fields(auto& f, auto& a) { f(a.object), f(a.material, Unwritten{}), f(a.continues, Unwritten{}); }
  void apply(State& state) const;
};
struct SetShape {
  int object;
  ObjectShape shape;
  bool continues = false;
  static void fields(auto& f, auto& a) { f(a.object), f(a.shape, Unwritten{}), f(a.continues, Unwritten{}); }
  void apply(State& state) const;
};
struct SetLight {
  int light;
  Light value;
  bool continues = false;
  static void fields(auto& f, auto& a) { f(a.light), f(a.value, Unwritten{}), f(a.continues, Unwritten{}); }
  void apply(State& state) const;
};
struct SetCamera {
  Camera camera;
  bool continues = false;
  static void fields(auto& f, auto& a) { f(a.camera, Unwritten{}), f(a.continues, Unwritten{}); }
  void apply(State& state) const;
};
struct SetLimits {
  TraceLimits limits;
  bool continues = false;
  static void fields(auto& f, auto& a) { f(a.limits, Unwritten{}), f(a.continues, Unwritten{}); }
  void apply(State& state) const;
};
/// Of the scene: affects walk, picture and file.
struct SetNumerics {
  static constexpr std::string_view word = "numerics";
  Numerics numerics;
  double epsilon;
  bool continues = false;
  static void fields(auto& f, auto& a) { f(a.numerics), f(a.epsilon, Number::any), f(a.continues, Unwritten{}); }
  void apply(State& state) const;
};
struct SetSurroundings {
  Rgbd background, ambient;
  bool continues = false;
  static void fields(auto& f, auto& a) {
    f(a.background, Unwritten{}), f(a.ambient, Unwritten{}), f(a.continues, Unwritten{});
  }
  void apply(State& state) const;
};
struct Undo {
  static constexpr std::string_view word = "undo";
  void apply(State& state) const;
};
struct Redo {
  static constexpr std::string_view word = "redo";
  void apply(State& state) const;
};

// Files.

struct New {
  static constexpr std::string_view word = "new";
  static constexpr Traits traits{.of_own_scene = true};
  void apply(State& state) const;
};
struct Open {
  static constexpr std::string_view word = "open";
  std::string path;
  static void fields(auto& f, auto& a) { f(a.path, FilePath{}); }
  static constexpr Traits traits{.answers_prompt = true, .of_own_scene = true};
  void apply(State& state) const;
};
/// Asks for a path if there is none.
struct Save {
  static constexpr std::string_view word = "save";
  static constexpr Traits traits{.of_own_scene = true};
  void apply(State& state) const;
};
struct SaveAs {
  static constexpr std::string_view word = "save-as";
  std::string path;
  static void fields(auto& f, auto& a) { f(a.path, FilePath{}); }
  static constexpr Traits traits{.answers_prompt = true, .of_own_scene = true};
  void apply(State& state) const;
};
struct AskOpen {
  static constexpr std::string_view word = "ask-open";
  static constexpr Traits traits{.of_own_scene = true};
  void apply(State& state) const;
};
struct AskSaveAs {
  static constexpr std::string_view word = "ask-save-as";
  static constexpr Traits traits{.of_own_scene = true};
  void apply(State& state) const;
};
struct CancelPrompt {
  static constexpr std::string_view word = "cancel-prompt";
  static constexpr Traits traits{.answers_prompt = true};
  void apply(State& state) const;
};
struct AnswerQuestion {
  static constexpr std::string_view word = "answer";
  Answer answer;
  static void fields(auto& f, auto& a) { f(a.answer); }
  static constexpr Traits traits{.answers_question = true};
  void apply(State& state) const;
};
struct Quit {
  static constexpr std::string_view word = "quit";
  static constexpr Traits traits{.answers_prompt = true, .postpones_recovery = true, .of_own_scene = true};
  void apply(State& state) const;
};

using OfDocument = Types<AddObject, RemoveSelected, InsertCorner, RemoveCorner, Rename, SetMaterial, SetShape, SetLight,
                         SetCamera, SetLimits, SetNumerics, SetSurroundings, Undo, Redo, New, Open, Save, SaveAs,
                         AskOpen, AskSaveAs, CancelPrompt, AnswerQuestion, Quit>;

}  // namespace action
}  // namespace raywalk
