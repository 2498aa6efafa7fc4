// Implements the actions of the Structure tab.

#include "inspect/search_walk.h"
#include "view/action.h"
#include "view/structure/structure.h"
#include "view/walk/asked.h"

#include <algorithm>

namespace raywalk {

bool shows_structure(const State& state) {
  return state.walk.mode == Mode::trace && state.appearance.tab == StructureRoom::tab;
}

int structure_steps(const State& state) {
  const StructureRoom& sitting = state.structure;
  switch (sitting.page) {
    case StructurePage::search:
      return sitting.searches ? static_cast<int>(sitting.searches->in[watched_index(sitting.kind)].events.size()) : 0;
    case StructurePage::build:
      return sitting.walks ? static_cast<int>(sitting.walks->build(sitting.kind).steps.size()) : 0;
  }
  return 0;
}

int structure_step(const State& state) {
  return state.structure.page == StructurePage::search ? state.structure.step : state.structure.build_step;
}

bool is_off_plan(const State& state, const Bounds<double>& box) {
  return state.walk.planar && !state.walk.pixel && !box.empty() && (box.min.z > 0 || box.max.z < 0);
}

namespace {

/// The current ray, if it was formed. None while its end is asked for: its search would reveal the answer.
int ray_in_hand(const State& state) {
  if (withholds_end(state)) return -1;
  const int ray = state.walk.timeline->current_ray(state.walk.position);
  return ray >= 0 && state.walk.timeline->rays()[static_cast<std::size_t>(ray)].formed ? ray : -1;
}

}  // namespace

void StructureRoom::follow(State& state, const Before&) {
  StructureRoom& sitting = state.structure;
  if (!shows_structure(state)) {
    sitting.walks.reset();
    sitting.searches.reset();
    sitting.awaited.reset();
    sitting.step = sitting.build_step = 0;
    return;
  }
  const bool anew = !sitting.walks || sitting.walks->timeline() != state.walk.timeline;
  const int ray = ray_in_hand(state);
  const int before = sitting.awaited ? sitting.awaited->ray : sitting.searches ? sitting.searches->ray : -1;
  if (!anew && before == ray) return;
  // If a search was shown to its end, so is the next one.
  const bool to_end = sitting.awaited ? sitting.awaited->to_end
                                      : sitting.searches && sitting.step > 0 && sitting.step == structure_steps(state);
  sitting.awaited.reset();
  sitting.searches.reset();
  sitting.step = 0;
  if (anew) {
    const Precision precision = state.picture.settings.single_precision ? Precision::float_ : Precision::double_;
    const SceneSeen scene = walked_scene(state);
    show_walks(state, std::make_shared<const SearchWalks>(*scene, state.walk.timeline, precision,
                                                          state.document.worlds.get(), sitting.most_here));
  }
  if (ray < 0) return;
  sitting.awaited = AwaitedSearches{ray, to_end};
  if (!sitting.walks->elsewhere()) show_searches(state, sitting.walks->search(ray));
}

void show_walks(State& state, std::shared_ptr<const SearchWalks> walks) {
  StructureRoom& sitting = state.structure;
  sitting.walks = std::move(walks);
  if (sitting.walks->waits()) return;
  const auto last = static_cast<int>(sitting.walks->build(sitting.kind).steps.size());
  sitting.build_step = std::min(sitting.build_step, last);
}

void show_searches(State& state, std::shared_ptr<const RaySearches> searches) {
  StructureRoom& sitting = state.structure;
  const bool to_end = sitting.awaited && sitting.awaited->to_end;
  sitting.awaited.reset();
  sitting.searches = std::move(searches);
  sitting.step = to_end && sitting.page == StructurePage::search ? structure_steps(state) : 0;
}

void action::ChooseStructure::apply(State& state) const {
  StructureRoom& sitting = state.structure;
  const bool to_end = structure_step(state) > 0 && structure_step(state) == structure_steps(state);
  sitting.kind = watched_accelerators[watched_index(kind)];
  sitting.step = sitting.build_step = 0;
  if (to_end) GoInStructure{structure_steps(state)}.apply(state);
}

void action::ShowStructurePage::apply(State& state) const { state.structure.page = page; }

void action::GoInStructure::apply(State& state) const {
  StructureRoom& sitting = state.structure;
  int& at = sitting.page == StructurePage::search ? sitting.step : sitting.build_step;
  at = std::clamp(step, 0, structure_steps(state));
}

}  // namespace raywalk
