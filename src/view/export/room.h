#pragma once
// Exports of a walk.

#include "view/export/export.h"
#include "view/fields.h"
#include "view/room.h"

#include <optional>
#include <string>

namespace raywalk::action {

struct AskExport {
  static constexpr std::string_view word = "ask-export";
  void apply(State& state) const;
};
struct Export {
  static constexpr std::string_view word = "export";
  std::string path;  ///< its extension selects what
  static void fields(auto& f, auto& a) { f(a.path, FilePath{}); }
  static constexpr Traits traits{.answers_prompt = true};
  void apply(State& state) const;
};
/// The window has written the export, or says why not.
struct FinishExport {
  static constexpr std::string_view word = "finish-export";
  std::string why_not;
  static void fields(auto& f, auto& a) { f(a.why_not); }
  static constexpr Traits traits{.always = true};
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// The walk for those without the program.
struct ExportRoom {
  using Actions = Types<action::AskExport, action::Export, action::FinishExport>;

  std::optional<WindowExport> window;  ///< pending in the window
};

}  // namespace raywalk
