#pragma once
// The Cost panel: what settings of the picture cost.

#include "study/workbench.h"
#include "view/fields.h"
#include "view/room.h"

#include <optional>
#include <vector>

namespace raywalk {

enum class CostPicture {
  split,       ///< two pictures side by side, separated by a movable line
  difference,  ///< their difference, from dark to light
};
template <>
inline constexpr Word<CostPicture> words_of<CostPicture>[] = {{CostPicture::split, "split"},
                                                              {CostPicture::difference, "difference"}};

enum class CostPage {
  tries,    ///< settings compared with each other
  effects,  ///< what each effect of the scene adds
};
template <>
inline constexpr Word<CostPage> words_of<CostPage>[] = {{CostPage::tries, "tries"}, {CostPage::effects, "effects"}};

}  // namespace raywalk

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
  int index;             ///< in CostRoom::tried
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

}  // namespace raywalk::action

namespace raywalk {

/// What settings of the picture cost, and what they gain. For this session only; not stored in the scene's file.
struct CostRoom {
  using Actions = Types<action::SetCostKnobs, action::TryCost, action::ForgetCosts, action::ChooseCost,
                        action::ShowCosts, action::ShowCostPage>;
  static constexpr Tab tab{"cost", true, true};
  static void draw_tab(const Ui& ui, const Rect& where, TabContext& context);
  static Commands commands();

  static constexpr int max_tries = 64, max_samples = 4096, max_grid = 16, max_depth = 50;

  CostPage page = CostPage::tries;
  std::optional<study::Setup> knobs{};  ///< absent: the scene's own
  std::vector<study::Setup> tried{};    ///< without duplicates, at most `max_tries`
  int chosen = -1;                      ///< in `tried`: the picture on the left; -1: none yet
  int against = -1;                     ///< in `tried`: the picture on the right; -1: the reference
  CostPicture picture = CostPicture::split;
  study::CostAxis axis = study::CostAxis::rays;
  double split = 0.5;  ///< of the picture's width, 0..1
  friend bool operator==(const CostRoom&, const CostRoom&) = default;
};

}  // namespace raywalk
