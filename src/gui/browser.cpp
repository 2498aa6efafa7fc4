#include "gui/browser.h"

#include "gui/broken_lines.h"
#include "gui/dialogs.h"
#include "gui/platform.h"
#include "gui/widgets.h"
#include "text/file_path.h"
#include "view/document/document.h"
#include "view/export/export.h"
#include "view/link/link.h"
#include "view/opening.h"
#include "view/text/text.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <span>
#include <system_error>

namespace raywalk {

namespace {

namespace fs = std::filesystem;

std::string title_of(PathPrompt asking, const Ui& ui) {
  switch (asking) {
    case PathPrompt::none:
      return {};
    case PathPrompt::start:
      return ui.say("command.new.label");
    case PathPrompt::open:
      return ui.say("command.open.label");
    case PathPrompt::save_as:
      return ui.say("command.save_as.label");
    case PathPrompt::save_predictions:
      return command_label(command("save-predictions"), ui.state);
    case PathPrompt::export_walk:
      return command_label(command("export"), ui.state);
  }
  return {};
}

// Whether a scene is to be read, and none to be written.
bool opens(PathPrompt asking) { return asking == PathPrompt::open || asking == PathPrompt::start; }

}  // namespace

FolderListing list_folder(const std::string& folder) {
  constexpr std::size_t most = 5000;
  FolderListing listing;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  listing.readable = !error;
  while (!error && entry != fs::directory_iterator() && listing.folders.size() + listing.files.size() < most) {
    const std::string name = entry->path().filename().string();
    std::error_code unknown;
    if (!name.starts_with(".")) {
      if (entry->is_directory(unknown)) {
        listing.folders.push_back(name);
      } else if (has_scene_ending(name)) {
        listing.files.push_back(name);
      }
    }
    entry.increment(error);
  }
  std::sort(listing.folders.begin(), listing.folders.end());
  std::sort(listing.files.begin(), listing.files.end());
  return listing;
}

void Browser::begin(const State& state, const std::string& home) {
  const fs::path current(state.document.path);
  // The user's files go beside the user's scene, not among the shipped scenes, which are in `home`.
  const std::string folder = current.parent_path().string();
  std::error_code failed;
  const bool own = !state.document.path.empty() && (opens(asking_) || !fs::equivalent(folder, home, failed));
  const bool exports = asking_ == PathPrompt::export_walk;
  const std::string first = exports && !export_folder_.empty() ? export_folder_
                            : own                              ? folder
                            : opens(asking_)                   ? home
                                                               : std::string();
  go_to(absolute_path(first.empty() ? "." : first));
  typed_ = fs::path(offered_path(state)).filename().string();
  export_asked_.reset();
  // By its button, so that it stays one whatever is typed.
  if (export_kind_of(typed_) == ExportKind::script) export_asked_ = ExportKind::script;
  focus_typed_ = asking_ != PathPrompt::start;
  page_ = Page::scenes;
  cards_.clear();
  cards_for_.clear();
}

void Browser::go_to(const std::string& folder) {
  folder_ = folder;
  listing_ = list_folder(folder);
}

ExportKind Browser::kind() const {
  return export_asked_ ? *export_asked_ : export_kind_of(typed_).value_or(ExportKind::slides);
}

std::string Browser::name() const {
  if (asking_ == PathPrompt::save_predictions && !fs::path(typed_).has_extension()) return typed_ + ".csv";
  return asking_ != PathPrompt::export_walk || export_kind_of(typed_) == kind() ? typed_ : with_ending(typed_, kind());
}

std::string Browser::in_folder(const std::string& path) const {
  return fs::path(path).is_absolute() ? path : (fs::path(folder_) / path).string();
}

void Browser::open(const Ui& ui) {
  std::error_code none;
  const bool is_file = fs::exists(in_folder(typed_), none);
  const std::string meant = is_file ? typed_ : path_meant(typed_, platform::home_folder());
  if (meant.empty()) return;
  // A shipped scene by its name, and a link, as on the command line.
  const std::string path = in_folder(meant), shipped = shipped_path(ui.state, meant);
  const bool exists = fs::exists(path, none);
  std::string named = path;
  if (!exists && !fs::path(meant).has_parent_path() && fs::exists(shipped, none)) named = shipped;
  if (!exists && means_link(meant)) named = meant;
  for (const Action& action : opening_of(ui.state, named)) ui.act(action);
}

void Browser::accept(const Ui& ui) {
  if (typed_.empty()) return;
  focus_typed_ = true;  // if it fails, another name follows
  if (opens(asking_)) return open(ui);
  typed_ = path_meant(typed_, platform::home_folder());
  if (typed_.empty()) return;
  typed_ = name();
  const std::string path = in_folder(typed_);
  if (asking_ == PathPrompt::save_as) ui.act(action::SaveAs{path});
  if (asking_ == PathPrompt::save_predictions) ui.act(action::SavePredictions{path});
  if (asking_ == PathPrompt::export_walk) {
    export_folder_ = fs::path(path).parent_path().string();
    ui.act(action::Export{path});
  }
}

void Browser::entries(const Ui& ui, float height) {
  const ScrolledList list(ui, "files", height, ui.px(8));
  if (!list) return;
  std::string into;
  for (const std::string& name : listing_.folders) {
    if (ImGui::Selectable((name + "/").c_str())) into = name;
    ui.publish("browser/" + name + "/");
  }
  for (const std::string& name : listing_.files) {
    if (ImGui::Selectable(name.c_str(), name == typed_, ImGuiSelectableFlags_AllowDoubleClick)) {
      typed_ = name;
      if (ImGui::IsMouseDoubleClicked(0)) accept(ui);
    }
    ui.publish("browser/" + name);
  }
  if (!listing_.readable) paragraph(ui.colours.error, ui.say("files.folder_unreadable"));
  if (listing_.readable && listing_.files.empty() && opens(asking_))
    paragraph(ui.colours.dim_text, ui.say("files.no_scene_here"));
  if (!into.empty()) go_to((fs::path(folder_) / into).string());
}

void Browser::kinds(const Ui& ui) {
  struct Words {
    std::string_view label, hint;
  };
  const auto words = [](ExportKind kind) -> Words {
    switch (kind) {
      case ExportKind::slides:
        return {"export.slides", "export.slides_hint"};
      case ExportKind::picture:
        return {"export.picture", "export.picture_hint"};
      case ExportKind::animation:
        return {"export.animation", "export.animation_hint"};
      case ExportKind::plan:
        return {"export.plan", "export.plan_hint"};
      case ExportKind::transcript:
        return {"export.transcript", "export.transcript_hint"};
      case ExportKind::steps:
        return {"export.steps", "export.steps_hint"};
      case ExportKind::script:
        return {"export.script", "export.script_hint"};
    }
    return {};
  };
  const ExportKind chosen = kind();
  // A lesson's script is last: it is available only with a lesson.
  const std::size_t shown = kinds_of_export.size() - (ui.state.lessons.open ? 0 : 1);
  const float gap = ui.px(6), count = static_cast<float>(shown);
  const ButtonLook look{.look = Look::choice, .icon = Icon::none, .font = ui.fonts.small};
  // Each by its words, and all together as wide as the dialog.
  float spare = ImGui::GetContentRegionAvail().x - (count - 1) * gap;
  for (const ExportEnding& each : std::span(kinds_of_export).first(shown))
    spare -= button_width(ui, ui.say(words(each.kind).label), look);
  for (const ExportEnding& each : std::span(kinds_of_export).first(shown)) {
    const Words of = words(each.kind);
    if (&each != &kinds_of_export.front()) ImGui::SameLine(0, gap);
    if (button(ui, "export" + std::string(each.ending), ui.say(of.label), ui.say(of.hint),
               {button_width(ui, ui.say(of.label), look) + spare / count, ImGui::GetFrameHeight()}, look,
               chosen == each.kind))
      export_asked_ = each.kind, typed_ = name();
  }
  const std::string file = fs::path(name()).filename().string();
  if (typed_.empty() || typed_ == name()) {
    paragraph(ui.colours.dim_text, ui.say(words(chosen).hint));
    ui.publish("export-hint");
  } else {
    label(ui.colours.text, ui.say("export.will_be", {{"file", file}}));
    ui.publish("export-as");
  }
}

void Browser::pages(const Ui& ui) {
  const auto choice = [&](Page page, const char* name, std::string_view label, bool first = false) {
    const float width = button_width(ui, ui.say(label), {.look = Look::choice});
    if (!first) ImGui::SameLine();
    if (!first && ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
    if (!button(ui, name, ui.say(label), "", {width, ImGui::GetFrameHeight()}, {.look = Look::choice}, page_ == page))
      return;
    page_ = page;
    cards_for_.clear();
    focus_typed_ = page == Page::files;
    if (page == Page::lessons) ui.act(action::ListLessons{});
  };
  choice(Page::scenes, "gallery-scenes", "files.scenes", true);
  choice(Page::lessons, "gallery-lessons", "lesson.lessons");
  choice(Page::recent, "gallery-recent", "files.recent");
  choice(Page::files, "gallery-files", "files.folder");
}

void Browser::gallery(const Ui& ui, float height, GalleryPictures* pictures) {
  const State& state = ui.state;
  const bool scenes = page_ == Page::scenes;
  // Lessons are listed one frame after they were asked for.
  const std::string wanted = std::string(state.appearance.language.code()) + (scenes ? "/scenes" : "/lessons") +
                             std::to_string(scenes ? 0 : state.lessons.list.size());
  if (cards_for_ != wanted) {
    cards_ = scenes ? scene_cards(state) : lesson_cards(state);
    cards_for_ = wanted;
  }
  const GalleryCard* chosen = draw_cards(ui, cards_, height, pictures);
  if (chosen == nullptr || chosen->locked) return;
  if (!chosen->path.empty()) return ui.act(action::Open{chosen->path});
  if (chosen->lesson.empty()) return ui.act(action::New{});
  ui.act(action::CancelPrompt{});
  ui.act(action::OpenLesson{chosen->lesson});
}

void Browser::recent(const Ui& ui, float height) {
  const ScrolledList list(ui, "recent", height, ui.px(8));
  if (!list) return;
  int number = 0;
  for (const std::string& path : ui.state.document.recent) {
    // The name, and behind it the folder.
    const std::string name = fs::path(path).filename().string(), folder = fs::path(path).parent_path().string();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x, behind = ImGui::CalcTextSize(name.c_str()).x + ui.px(14);
    if (ImGui::Selectable(("##" + path).c_str())) ui.act(action::Open{path});
    ui.publish("recent/" + std::to_string(number++));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText(at, to_imgui(ui.colours.text), shortened(name, room).c_str());
    if (behind < room)
      draw.AddText({at.x + behind, at.y}, to_imgui(ui.colours.dim_text), shortened(folder, room - behind).c_str());
  }
  if (number == 0) paragraph(ui.colours.dim_text, ui.say("files.no_recent"));
}

void Browser::draw(const Ui& ui, const std::string& home, GalleryPictures* pictures) {
  // While a question is open the dialog waits, and then returns unchanged.
  const PathPrompt wanted = ui.state.document.prompt;
  if (wanted != asking_) {
    asking_ = wanted;
    if (asking_ != PathPrompt::none) begin(ui.state, home);
  }
  if (asking_ == PathPrompt::none || ui.state.document.question) return;
  const bool saves = !opens(asking_);
  const std::string title = title_of(asking_, ui);
  const ImVec2 whole = ImGui::GetMainViewport()->Size;
  // The gallery needs room for pictures, and takes more of a large window.
  const float wide = saves ? ui.px(640) : std::max(ui.px(900), 0.7f * whole.x);
  const float high = saves ? ui.px(470) : std::max(ui.px(620), 0.8f * whole.y);
  const ImVec2 extent{std::min(wide, whole.x), std::min(high, whole.y)};
  ImGui::SetNextWindowSize(extent);
  ImGui::SetNextWindowPos({whole.x / 2, whole.y / 2}, 0, {0.5f, 0.5f});
  const std::string id = title + "###browser";
  if (!ImGui::IsPopupOpen(id.c_str())) ImGui::OpenPopup(id.c_str());
  if (!ImGui::BeginPopupModal(id.c_str(), nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) return;
  std::optional<FingerFields> fields(ui);
  const float line = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemSpacing.y;
  if (!saves) pages(ui);
  const bool lists = saves || page_ == Page::files;
  if (lists && button(ui, "browser-up", ui.say("files.folder_up"), ui.say("files.folder_up_hint"), {0, line},
                      {.look = Look::plain, .icon = Icon::up}))
    go_to(fs::path(folder_).parent_path().string());
  if (lists) {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    label(ui.colours.dim_text, shortened(folder_, ImGui::GetContentRegionAvail().x));
  }
  const bool complains = ui.state.document.notice && ui.state.document.notice->kind == Notice::Kind::error;
  // A long message scrolls: it never takes the room of the name and the buttons.
  constexpr float most_lines = 4;
  const std::string complaint =
      complains ? broken_lines(ui.state.document.notice->text, ImGui::GetContentRegionAvail().x - ui.px(16)) : "";
  const float message =
      complains ? std::min(ImGui::CalcTextSize(complaint.c_str()).y, most_lines * ImGui::GetTextLineHeight()) + ui.px(4)
                : 0;
  const bool exports = asking_ == PathPrompt::export_walk;
  const float room = std::max(
      ImGui::GetContentRegionAvail().y - (exports ? 4 : 2) * (line + gap) - message - (complains ? gap : 0), ui.px(40));
  if (lists) {
    entries(ui, room);
  } else if (page_ == Page::recent) {
    recent(ui, room);
  } else {
    gallery(ui, room, pictures);
  }
  if (exports) kinds(ui);
  if (complains) {
    if (ImGui::BeginChild("complaint", {0, message})) label(ui.colours.error, complaint);
    ImGui::EndChild();
    ui.publish("browser-complaint");
  }

  if (std::exchange(focus_typed_, false)) ImGui::SetKeyboardFocusHere();
  std::array<char, 4096 + max_link> buffer{};
  std::strncpy(buffer.data(), typed_.c_str(), buffer.size() - 1);
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputTextWithHint("##path", ui.say(saves ? "dialog.path" : "dialog.path_or_link").c_str(), buffer.data(),
                               buffer.size(), ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  typed_ = buffer.data();
  ui.publish("browser-path");
  const ImVec2 large{ui.px(130), line};
  if (asks_for_files(ui.state)) {
    if (button(ui, "browser-device", ui.say("files.from_device"), ui.say("files.from_device_hint"), {0, line}, {})) {
      platform::choose_files();
      ui.act(action::CancelPrompt{});
    }
    ImGui::SameLine();
  }
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - 2 * large.x - ImGui::GetStyle().ItemSpacing.x -
                       ImGui::GetStyle().WindowPadding.x);
  const bool cancelled = button(ui, "browser-cancel", ui.say("answer.cancel"), "", large, {});
  ImGui::SameLine();
  const bool accepted = button(ui, "browser-accept", ui.say(saves ? "command.save.label" : "command.open.label"), "",
                               large, {.look = Look::primary}, false, !typed_.empty());
  if (accepted || entered) accept(ui);
  if (cancelled) ui.act(action::CancelPrompt{});
  fields.reset();
  ImGui::EndPopup();
}

}  // namespace raywalk
