#pragma once
// Spot the bug. Actions on the scene itself (open, save, new, quit, a lesson) leave the hunt first.

#include "timeline/timeline.h"
#include "trace/fault.h"
#include "view/fields.h"
#include "view/room.h"

#include <array>
#include <memory>
#include <optional>

namespace raywalk {

enum class BugEnd { open, found, given_up };

/// The hunt for one bug. Its scene replaces the user's own for the time being.
struct BugHunt {
  int number = 1;                   ///< in values_of<Fault>, from 1
  bool surprise = false;            ///< the number is not shown
  int pixel = 0;                    ///< the first of SCREEN in which the bug is visible
  int first_pixel = 0;              ///< the same as index in the walk's pixels: rays of earlier pixels are hidden
  bool from_start = false;          ///< the bug is in what runs before the pixels: the walk begins there
  std::optional<Line> marked{};     ///< suspected, and not judged yet
  std::optional<Line> acquitted{};  ///< the last one judged innocent
  BugEnd end = BugEnd::open;
  std::shared_ptr<const State> before{};  ///< the previous state, to return to

  /// Whether no line was marked and nothing was told.
  [[nodiscard]] bool is_new() const { return !marked && !acquitted && end == BugEnd::open; }
};

}  // namespace raywalk

namespace raywalk::action {

struct ShowBugs {
  static constexpr std::string_view word = "bugs";
  bool shown;  ///< hiding them leaves the hunt
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  void apply(State& state) const;
};
struct HuntBug {
  static constexpr std::string_view word = "hunt-bug";
  int number;  ///< from 1, in values_of<Fault>
  bool surprise = false;
  static void fields(auto& f, auto& a) { f(a.number), f(a.surprise, Flag{"surprise"}); }
  void apply(State& state) const;
};
/// In the list by keys: the one so many below the one chosen before.
struct ChooseBug {
  static constexpr std::string_view word = "choose-bug";
  int by;
  static void fields(auto& f, auto& a) { f(a.by); }
  void apply(State& state) const;
};
/// As the one at fault.
struct MarkLine {
  static constexpr std::string_view word = "mark-line";
  Line line;
  static void fields(auto& f, auto& a) { f(a.line); }
  void apply(State& state) const;
};
/// Judges the marked line.
struct JudgeLine {
  static constexpr std::string_view word = "judge-line";
  void apply(State& state) const;
};
/// Gives up.
struct ShowCure {
  static constexpr std::string_view word = "show-cure";
  void apply(State& state) const;
};
/// Once it is known.
struct MendBug {
  static constexpr std::string_view word = "mend-bug";
  bool mended;
  static void fields(auto& f, auto& a) { f(a.mended, on_or_off); }
  void apply(State& state) const;
};
/// Restores the previous state.
struct LeaveHunt {
  static constexpr std::string_view word = "leave-hunt";
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// Spot the bug: the hunts of this session.
struct BugRoom {
  using Actions = Types<action::ShowBugs, action::HuntBug, action::ChooseBug, action::MarkLine, action::JudgeLine,
                        action::ShowCure, action::MendBug, action::LeaveHunt>;
  static Commands commands();
  static constexpr Layer layer = Layer::over_rays;
  static void draw_in_plan(Painter& painter);

  bool shown = false;
  std::optional<int> chosen{};  ///< of the list, by keys: its number
  std::optional<BugHunt> hunt{};
  std::array<BugEnd, values_of<Fault>.size()> ends{};  ///< of each bug: the best result
};

}  // namespace raywalk
