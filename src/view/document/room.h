#pragma once
// The scene and its file: edits, undo, questions.

#include "io/scene_file.h"
#include "math/stop.h"
#include "render/world_cache.h"
#include "text/file_hold.h"
#include "view/drawing/display_list.h"
#include "view/fields.h"
#include "view/room.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace raywalk {

/// A short message, until the next one.
struct Notice {
  enum class Kind { info, error };
  Kind kind = Kind::info;
  std::string text;
  bool lasts = false;  ///< tells of what goes on failing: not over with the next edit
};

/// What is done once unsaved work is settled, or a file may be overwritten.
struct Intent {
  std::string_view question{};  ///< the id of the text that asks first
  void (*carry_out)(State& state, const std::string& path_or_lesson) = nullptr;
};

/// A path that the window must ask for: where to start (with a scene that is shipped, or a new one), to open, to write.
/// Answered by the action of that name, or by CancelPrompt.
enum class PathPrompt { none, start, open, save_as, save_predictions, export_walk };
template <>
inline constexpr Word<PathPrompt> words_of<PathPrompt>[] = {{PathPrompt::start, "new"},
                                                            {PathPrompt::open, "open"},
                                                            {PathPrompt::save_as, "save_as"},
                                                            {PathPrompt::save_predictions, "save_predictions"},
                                                            {PathPrompt::export_walk, "export"}};

struct Question {
  enum class Kind {
    unsaved,      ///< answers: save, discard, cancel
    predictions,  ///< were made and not saved; the same answers
    recover,      ///< an autosave was found at the start; answers: recover, discard, cancel (asks at the next start)
    overwrite,    ///< the file to be written exists, or others have changed it; answers: save, cancel
  };
  Kind kind = Kind::unsaved;
  Intent intent{};         ///< continues with this after save or discard
  std::string path{};      ///< of the intent, or of the file that the autosave belongs to (may be empty)
  std::string autosave{};  ///< recover: the autosave
  std::shared_ptr<const FileHold> hold{};  ///< recover: of it, so that no other window asks about it too
  std::string when{};                      ///< recover: when it was written: "2026-11-21T14:05"
  std::string why_not{};                   ///< recover: why it could not be, once that was tried
};
template <>
inline constexpr Word<Question::Kind> words_of<Question::Kind>[] = {{Question::Kind::unsaved, "unsaved"},
                                                                    {Question::Kind::predictions, "predictions"},
                                                                    {Question::Kind::recover, "recover"},
                                                                    {Question::Kind::overwrite, "overwrite"}};

/// An undo entry's edit: edits that continue each other have equal marks.
struct EditMark {
  std::size_t edit = 0;  ///< index in Action
  int index = -1;
  friend bool operator==(const EditMark&, const EditMark&) = default;
};

/// What an edit replaced: the scene, or the ink over it.
using Undone = std::variant<Scene, Ink>;
/// Last in, first out.
using History = std::vector<std::shared_ptr<const Undone>>;

inline constexpr std::size_t undo_entries = 256;
inline constexpr std::size_t undo_bytes = 64 << 20;  ///< of undo and redo together, roughly
inline constexpr double autosave_every = 5;          ///< seconds

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
/// A key of an object, a light, or of camera and scene, and its value (view/document/properties.h): "material.diffuse
/// 0.5".
struct SetKey {
  static constexpr std::string_view word = "set";
  Target target;
  std::string setting;
  static void fields(auto& f, auto& a) { f(a.target), f(a.setting); }
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
  static constexpr std::string_view word = "limits";
  TraceLimits limits;
  bool continues = false;
  static void fields(auto& f, auto& a) {
    f(a.limits.depth), f(a.limits.threshold, Number::any), f(a.continues, Unwritten{});
  }
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
/// The same: how light gets through bodies that scatter it, and whether patches give ambient light.
struct SetLightWays {
  static constexpr std::string_view word = "light-ways";
  Subsurface subsurface;
  bool as_ambient;
  static constexpr bool continues = false;  ///< is chosen, not dragged
  static void fields(auto& f, auto& a) { f(a.subsurface), f(a.as_ambient, on_or_off); }
  void apply(State& state) const;
};
struct SetSurroundings {
  Rgbd background, ambient;
  std::optional<Sky> sky;
  bool continues = false;
  static void fields(auto& f, auto& a) {
    f(a.background, Unwritten{}), f(a.ambient, Unwritten{}), f(a.sky, Unwritten{}), f(a.continues, Unwritten{});
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
  static constexpr Traits traits{.answers_prompt = true, .of_own_scene = true};
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
/// What was saved did not reach the user's file after all, as a browser finds out later: it is unsaved work again.
struct NotSaved {
  std::string path, why;  ///< an empty reason: it was refused
  static constexpr Traits traits{.keeps_drag = true, .always = true};
  void apply(State& state) const;
};
/// What to start with: the gallery.
struct AskNew {
  static constexpr std::string_view word = "ask-new";
  static constexpr Traits traits{.of_own_scene = true};
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

}  // namespace action
/// The scene, its file, what can be undone, and what the user is asked or told about it.
struct DocumentRoom {
  using Actions =
      Types<action::AddObject, action::RemoveSelected, action::InsertCorner, action::RemoveCorner, action::Rename,
            action::SetKey, action::SetMaterial, action::SetShape, action::SetLight, action::SetCamera,
            action::SetLimits, action::SetNumerics, action::SetLightWays, action::SetSurroundings, action::Undo,
            action::Redo, action::New, action::Open, action::Save, action::SaveAs, action::NotSaved, action::AskNew,
            action::AskOpen, action::AskSaveAs, action::CancelPrompt, action::AnswerQuestion, action::Quit>;
  static Commands commands();

  SceneDocument contents;
  std::uint64_t number = 0;    ///< of the document, among those that were shown
  std::string path;            ///< absolute; empty: never saved
  std::optional<Scene> saved;  ///< the scene as the file holds it; absent: as contents.scene
  Ink saved_ink{};             ///< the ink that the file holds
  bool dirty = false;          ///< contents differ from saved_scene or saved_ink
  std::uint64_t revision = 0;  ///< incremented with every change of contents.scene, to restart the 3-D image
  History undo, redo;          ///< bounded (undo_entries, undo_bytes)
  std::shared_ptr<WorldCache>
      worlds;   ///< of contents.scene; replaced with each change of it, so that copies may share it
  Stop stop{};  ///< cancels a long update: it throws Stopped, and the state is then invalid
  std::optional<EditMark> last_edit;
  History replaced_redo;            ///< what could be redone before last_edit, which others may join and take back
  std::vector<std::string> recent;  ///< paths, most recent first
  std::vector<std::string> keeps;   ///< files of the command line that must not be replaced, such as a demo
  /// Folder for the autosave and the list of recent files; empty: neither is kept.
  std::string state_dir;
  /// This session's autosave: a name in state_dir that no other has; empty until it is written.
  std::string autosave_file = "autosave.toml";
  std::shared_ptr<const FileHold> autosave_hold;  ///< of that file: this session still runs
  double autosave_in = 0;                         ///< seconds until the next autosave may be written
  std::uint64_t autosaved_revision = 0;
  std::string autosave_failure;    ///< why the last one was not written; empty: it was
  bool failure_dismissed = false;  ///< whoever was told of that needs to hear it no more

  std::optional<Question> question;
  PathPrompt prompt = PathPrompt::none;
  std::optional<Intent> after_save;  ///< continues with this once SaveAs has succeeded
  std::string after_save_path;       ///< of the intent
  std::optional<Notice> notice;
  bool quit = false;  ///< the window closes now
};

}  // namespace raywalk
