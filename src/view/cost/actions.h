#pragma once
// Actions of the Cost panel.

#include "view/cost/cost.h"
#include "view/fields.h"

namespace raywalk::action {

struct SetCostKnobs {
  static constexpr std::string_view word = "cost-knobs";
  study::Setup knobs;  ///< clamped to their limits
  static void fields(auto& f, auto& a) { f(a.knobs); }
  void apply(State& state) const;
};
/// The current knobs. If tried already, they are chosen.
struct TryCost {
  static constexpr std::string_view word = "cost-try";
  bool ladder = false;  ///< also with 1, 4, 16, 64 samples
  static void fields(auto& f, auto& a) { f(a.ladder, Flag{"ladder"}); }
  void apply(State& state) const;
};
struct ForgetCosts {
  static constexpr std::string_view word = "cost-forget";
  void apply(State& state) const;
};
struct ChooseCost {
  static constexpr std::string_view word = "cost-choose";
  int index;             ///< in CostState::tried
  bool against = false;  ///< then -1 is the reference
  static void fields(auto& f, auto& a) { f(a.index), f(a.against, Flag{"against"}); }
  void apply(State& state) const;
};
struct ShowCosts {
  static constexpr std::string_view word = "cost-show";
  CostPicture picture;
  study::CostAxis axis;
  double split;  ///< clamped to 0..1
  static void fields(auto& f, auto& a) { f(a.picture), f(a.axis), f(a.split); }
  void apply(State& state) const;
};
struct ShowCostPage {
  static constexpr std::string_view word = "cost-page";
  CostPage page;
  static void fields(auto& f, auto& a) { f(a.page); }
  void apply(State& state) const;
};

using OfCost = Types<SetCostKnobs, TryCost, ForgetCosts, ChooseCost, ShowCosts, ShowCostPage>;

}  // namespace raywalk::action
