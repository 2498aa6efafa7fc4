#pragma once

#include "gui/gallery.h"
#include "gui/ui.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// The choices in a folder: its folders, then its scenes (by extension), both in alphabetical order, without hidden
/// ones.
struct FolderListing {
  bool readable = true;
  std::vector<std::string> folders, files;
};
[[nodiscard]] FolderListing list_folder(const std::string& folder);

/// The dialog that answers DocumentRoom::prompt: a path to open or to save as.
class Browser {
 public:
  /// Draws the dialog while the state asks for a path. `home`: the folder of the shipped scenes, where one begins if
  /// the scene has no file. `pictures`: of the gallery; may be null.
  void draw(const Ui& ui, const std::string& home, GalleryPictures* pictures);

 private:
  void begin(const State& state, const std::string& home);
  void go_to(const std::string& folder);
  void entries(const Ui& ui, float height);
  /// Of what can be opened: the shipped scenes, the lessons, recent files, a folder.
  enum class Page { scenes, lessons, recent, files };
  void pages(const Ui& ui);
  void gallery(const Ui& ui, float height, GalleryPictures* pictures);
  void recent(const Ui& ui, float height);
  /// The kind of an export: as requested, else by the extension.
  [[nodiscard]] ExportKind kind() const;
  /// The typed name, with the extension of the export kind.
  [[nodiscard]] std::string name() const;
  /// A button for each kind, and a description of the chosen one.
  void kinds(const Ui& ui);
  void accept(const Ui& ui);
  void open(const Ui& ui);
  [[nodiscard]] std::string in_folder(const std::string& path) const;

  PathPrompt asking_ = PathPrompt::none;
  std::optional<ExportKind> export_asked_;  ///< independent of the typed extension
  std::string folder_, typed_;
  std::string export_folder_;  ///< of the last export; empty: none yet
  FolderListing listing_;
  Page page_ = Page::scenes;
  std::vector<GalleryCard> cards_;  ///< of the page, once they are read in this language
  std::string cards_for_;
  bool focus_typed_ = false;
};

}  // namespace raywalk
