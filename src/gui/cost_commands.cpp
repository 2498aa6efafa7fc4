#include "gui/cost_commands.h"

#include "gui/choices.h"

#include <array>

namespace raywalk {

namespace {

constexpr std::array kinds{CostPicture::split, CostPicture::difference};
constexpr std::array axes{study::CostAxis::rays, study::CostAxis::tests, study::CostAxis::seconds};
constexpr double split_step = 0.05;  // of the picture's width

}  // namespace

void perform_cost(Command command, const Ui& ui) {
  const CostState& cost = ui.state.cost;
  const int tries = static_cast<int>(cost.tried.size());
  switch (command) {
    case Command::cost_knobs:
      return ui.wish(WindowWish::cost_knobs);
    case Command::cost_try:
    case Command::cost_ladder:
      ui.act(action::SetTab{Tab::cost});
      ui.act(action::ShowCostPage{CostPage::tries});
      return ui.act(action::TryCost{command == Command::cost_ladder});
    case Command::cost_forget:
      return ui.act(action::ForgetCosts{});
    case Command::cost_next:
      return ui.act(action::ChooseCost{(cost.chosen + 1) % tries});
    case Command::cost_against:
      return ui.act(action::ChooseCost{cost.against + 1 < tries ? cost.against + 1 : -1, true});
    case Command::cost_kind:
      return ui.act(action::ShowCosts{next_among(kinds, cost.picture), cost.axis, cost.split});
    case Command::cost_axis:
      return ui.act(action::ShowCosts{cost.picture, next_among(axes, cost.axis), cost.split});
    case Command::cost_split_left:
      return ui.act(action::ShowCosts{cost.picture, cost.axis, cost.split - split_step});
    case Command::cost_split_right:
      return ui.act(action::ShowCosts{cost.picture, cost.axis, cost.split + split_step});
    case Command::cost_page:
      if (ui.state.tab != Tab::cost) {
        ui.act(action::SetTab{Tab::cost});
        return ui.act(action::ShowCostPage{CostPage::effects});
      }
      return ui.act(action::ShowCostPage{cost.page == CostPage::tries ? CostPage::effects : CostPage::tries});
    default:
      return;
  }
}

std::optional<std::string_view> cost_label(Command command, const State& state) {
  if (command == Command::cost_kind)
    return state.cost.picture == CostPicture::split ? "cost.shows_split" : "cost.shows_difference";
  if (command == Command::cost_page)
    return state.tab == Tab::cost && state.cost.page == CostPage::effects ? "cost.page_tries" : "cost.page_effects";
  if (command != Command::cost_axis) return std::nullopt;
  switch (state.cost.axis) {
    case study::CostAxis::rays:
      return "cost.axis_rays";
    case study::CostAxis::tests:
      return "cost.axis_tests";
    case study::CostAxis::seconds:
      return "cost.axis_seconds";
  }
  return std::nullopt;
}

}  // namespace raywalk
