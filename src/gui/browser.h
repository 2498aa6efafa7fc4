#pragma once

#include "gui/ui.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// What of a folder a person can choose from: its folders, then its scenes (by their endings), both in the order of the
/// alphabet; hidden ones are left out.
struct FolderListing {
  bool readable = true;
  std::vector<std::string> folders, files;
};
[[nodiscard]] FolderListing list_folder(const std::string& folder);

/// The dialog that answers State::prompt: a path to open or to save as.
class Browser {
 public:
  /// Draws the dialog while the state asks for a path. `home`: folder to begin in when the scene has none.
  void draw(const Ui& ui, const std::string& home);

 private:
  void begin(const State& state, const std::string& home);
  void go_to(const std::string& folder);
  void entries(const Ui& ui, float height);
  /// What an export is to be: as was asked for, else as the name's ending says.
  [[nodiscard]] ExportKind kind() const;
  /// What was typed, with the ending of an export's kind.
  [[nodiscard]] std::string name() const;
  /// A button for each kind, and what comes of the one that is chosen.
  void kinds(const Ui& ui);
  void accept(const Ui& ui);

  PathPrompt asking_ = PathPrompt::none;
  std::optional<ExportKind> export_asked_;  ///< stays, whatever ending is typed
  std::string folder_, typed_;
  FolderListing listing_;
  bool focus_typed_ = false;
};

}  // namespace raywalk
