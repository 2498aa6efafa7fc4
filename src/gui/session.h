#pragma once
// One sitting: the state, the 3-D image that follows it, and what is kept between sittings.

#include "gui/gui.h"
#include "render/preview.h"
#include "view/action.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// The look that was last chosen; kept in `state_dir`/settings.json.
struct Settings {
  Theme theme = Theme::dark;
  double ui_scale = 1;
  Tab tab = Tab::image;
  std::string language{};  ///< its code; empty: none was kept
  bool tweens = true;
  friend bool operator==(const Settings&, const Settings&) = default;
};
[[nodiscard]] Settings settings_of(const State& state);
/// Defaults for what is missing or unreadable: settings are a convenience.
[[nodiscard]] Settings read_settings(const std::string& state_dir);
/// Fails silently for the same reason.
void write_settings(const std::string& state_dir, const Settings& settings);

/// Of the first of LC_ALL, LC_MESSAGES and LANG that is set; English where `languages` do not hold it.
[[nodiscard]] Language language_of_environment(const Languages& languages);

/// What `options` say, else what was chosen last, else that of the environment.
[[nodiscard]] Language language_for(const GuiOptions& options, const Settings& settings);

/// `options.state_dir`, or the user's own folder; empty when there is none.
[[nodiscard]] std::string state_folder(const GuiOptions& options);

/// The state that `options` ask for: the scene is read, the session restored, mode and position set.
/// `stop` may end it: it throws Stopped then, and is the state's until another is set.
[[nodiscard]] Result<State> start(const GuiOptions& options, const Stop& stop = {});

/// The 3-D image of the state's scene, worked on in slices of time.
class LiveImage {
 public:
  /// Starts afresh when the scene has changed. Throws Stopped when asked to while it builds its structure.
  void follow(const State& state, const Stop& stop = {});
  /// Works for about `milliseconds` on the scene that it followed last; while that is being dragged it goes no further
  /// than the coarse picture. Whether more is to be done.
  bool work(const State& state, double milliseconds, const Stop& stop = {});
  [[nodiscard]] const Preview& preview() const { return preview_; }
  /// Seconds until it is finished at the pace so far; 0 while there is none.
  [[nodiscard]] double seconds_left() const;
  /// Nothing is to be done for this state.
  [[nodiscard]] bool rests(const State& state) const;

 private:
  Preview preview_;
  std::uint64_t revision_ = 0, image_revision_ = 0;
  double seconds_ = 0;  ///< worked since it was begun
  bool begun_ = false;
};

/// The actions of a demo file, handed out at a walking pace.
class Demo {
 public:
  Demo() = default;
  explicit Demo(std::vector<Action> actions) : actions_(std::move(actions)) {}
  [[nodiscard]] bool over() const { return next_ >= actions_.size(); }
  /// The next action when it is due after `seconds` more.
  const Action* due(double seconds);

 private:
  static constexpr double pause = 0.25, most_wait = 3600;  // seconds between actions
  std::vector<Action> actions_;
  std::size_t next_ = 0;
  double waited_ = 0;
};

}  // namespace raywalk
