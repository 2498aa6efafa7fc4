#pragma once
// Actions of spot the bug. Actions on the scene itself (open, save, new, quit, a lesson) leave the hunt first.

#include "view/fields.h"
#include "view/state.h"

namespace raywalk::action {

struct ShowBugs {
  static constexpr std::string_view word = "bugs";
  bool shown;  ///< hiding them leaves the hunt
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  void apply(State& state) const;
};
struct HuntBug {
  static constexpr std::string_view word = "hunt-bug";
  int number;  ///< from 1, in all_faults
  bool surprise = false;
  static void fields(auto& f, auto& a) { f(a.number), f(a.surprise, Flag{"surprise"}); }
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

using OfBugs = Types<ShowBugs, HuntBug, MarkLine, JudgeLine, ShowCure, MendBug, LeaveHunt>;

}  // namespace raywalk::action
