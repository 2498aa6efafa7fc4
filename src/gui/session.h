#pragma once
// A session: the state, its 3-D image, and persistent data.

#include "gui/gui.h"
#include "gui/platform.h"
#include "gui/row_workers.h"
#include "render/preview.h"
#include "view/action.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// The last chosen appearance; saved in `state_dir`/settings.json.
struct Settings {
  Theme theme = Theme::dark;
  double ui_scale = 1;
  Tab tab = PictureRoom::tab;
  std::string language{};  ///< its code; empty: none saved
  bool tweens = true;
  bool english_code = false;
  std::vector<Tab> exchanged{};
  double code_part = 0;
  bool presenter = false;   ///< lessons are presented
  std::string link_page{};  ///< where links lead to; empty: as LinkRoom has it
  friend bool operator==(const Settings&, const Settings&) = default;
};
[[nodiscard]] Settings settings_of(const State& state);
/// Defaults for what is missing or unreadable: settings are a convenience.
[[nodiscard]] Settings read_settings(const std::string& state_dir);
/// Writes what has changed since `before`, and leaves the rest as it stands: another window may have chosen it. Fails
/// silently for the same reason.
void write_settings(const std::string& state_dir, const Settings& before, const Settings& now);

/// By the first of LC_ALL, LC_MESSAGES and LANG that is set; English if `languages` does not contain it.
[[nodiscard]] Language language_of_environment(const Languages& languages);

/// From `options`, else the last chosen one, else from the environment.
[[nodiscard]] Language language_for(const GuiOptions& options, const Settings& settings);

/// `options.state_dir`, or the user's own folder; empty if there is none.
[[nodiscard]] std::string state_folder(const GuiOptions& options);

/// The initial state for `options`: reads the scene, restores the session, sets mode and position. `stop` cancels it
/// with Stopped, and remains the state's until replaced.
[[nodiscard]] Result<State> start(const GuiOptions& options, const Stop& stop = {});

/// The 3-D image of the state's scene, rendered in time slices, or by workers where there are any.
class LiveImage {
 public:
  explicit LiveImage(Workers& workers = platform::workers()) : workers_(workers) {}

  /// Restarts if the scene has changed. Throws Stopped if cancelled while it builds its accelerator. Returns whether
  /// the picture is black now, for it was one of another document: it would be taken for this one's as long as nothing
  /// of that is there, as while radiosity is solved.
  bool follow(const State& state, const Stop& stop = {});
  /// Works for about `milliseconds` on the scene that it followed last; during a drag only up to the coarse picture.
  /// Returns whether more is to be done.
  bool work(const State& state, double milliseconds, const Stop& stop = {});
  [[nodiscard]] const Preview& preview() const { return preview_; }
  /// Seconds until it is finished at the current pace; 0 if unknown.
  [[nodiscard]] double seconds_left() const;
  /// Nothing is to be done for this state.
  [[nodiscard]] bool rests(const State& state) const;
  /// Nothing can be done before a worker answers.
  [[nodiscard]] bool waits() const { return workers_.waits(); }

 private:
  Preview preview_;
  RowWorkers workers_;
  std::uint64_t revision_ = 0, image_revision_ = 0, document_ = 0;
  double seconds_ = 0;  ///< of work since its start
  std::chrono::steady_clock::time_point begun_at_{};
  bool begun_ = false;
};

/// The actions of a demo file, paced.
class Demo {
 public:
  Demo() = default;
  explicit Demo(std::vector<Action> actions) : actions_(std::move(actions)) {}
  [[nodiscard]] bool over() const { return next_ >= actions_.size(); }
  /// Whether what comes next leaves an open question unanswered, in a demo that ends the program itself: nobody may be
  /// there to answer.
  [[nodiscard]] bool ignores_question() const;
  /// The next action, if it is due after `seconds` more.
  const Action* due(double seconds);

 private:
  static constexpr double pause = 0.25, max_wait = 3600;  // seconds between actions
  std::vector<Action> actions_;
  std::size_t next_ = 0;
  double waited_ = 0;
};

}  // namespace raywalk
