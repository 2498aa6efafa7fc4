#pragma once
// Predictions on any walk.

#include "view/drawing/display_list.h"
#include "view/fields.h"

#include <string>

namespace raywalk::action {

struct SetPredictions {
  static constexpr std::string_view word = "predictions";
  bool on;
  static void fields(auto& f, auto& a) { f(a.on, on_or_off); }
  void apply(State& state) const;
};
/// Only if a direction is asked for, by a lesson or here.
struct GuessWay {
  static constexpr std::string_view word = "guess-way";
  Vec2d towards;  ///< the arrow's tip, scene units
  static void fields(auto& f, auto& a) { f(a.towards); }
  void apply(State& state) const;
};
/// Only if asked for.
struct GuessEnd {
  static constexpr std::string_view word = "guess-end";
  Target met;  ///< an object, a light or nothing
  static void fields(auto& f, auto& a) { f(a.met); }
  void apply(State& state) const;
};
struct AskSavePredictions {
  static constexpr std::string_view word = "ask-save-predictions";
  void apply(State& state) const;
};
/// As comma-separated values.
struct SavePredictions {
  static constexpr std::string_view word = "save-predictions";
  std::string path;
  static void fields(auto& f, auto& a) { f(a.path, FilePath{}); }
  static constexpr Traits traits{.answers_prompt = true};
  void apply(State& state) const;
};

using OfPredict = Types<SetPredictions, GuessWay, GuessEnd, AskSavePredictions, SavePredictions>;

}  // namespace raywalk::action
