// What the Structure tab says.

#include "timeline/search_walk.h"
#include "view/lesson_panel.h"
#include "view/lesson_text.h"
#include "view/state.h"
#include "view/structure_text.h"
#include "view/text.h"

namespace raywalk {

namespace {

StructureText name_id(AcceleratorKind kind) {
  switch (kind) {
    case AcceleratorKind::bvh:
      return StructureText::bvh;
    case AcceleratorKind::grid:
      return StructureText::grid;
    case AcceleratorKind::octree:
      return StructureText::octree;
    case AcceleratorKind::kdtree:
      return StructureText::kdtree;
    case AcceleratorKind::automatic:
    case AcceleratorKind::none:
    case AcceleratorKind::spheres:
    case AcceleratorKind::ellipsoids:
    case AcceleratorKind::boxes:
      break;  // of these only `none` is stepped
  }
  return StructureText::none;
}

StructureText ray_id(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return StructureText::ray_primary;
    case RayKind::shadow:
      return StructureText::ray_shadow;
    case RayKind::reflect:
      return StructureText::ray_reflect;
    case RayKind::refract:
      return StructureText::ray_refract;
  }
  return StructureText::ray_primary;
}

class Words {
 public:
  explicit Words(const State& state) : state_(state), sitting_(state.structure), language_(state.language) {}

  StructurePanel panel() {
    const bool searching = sitting_.page == StructurePage::search;
    panel_.title = searching && sitting_.searches
                       ? say(StructureText::title_search, {say(ray_id(sitting_.searches->kind))})
                   : searching ? say(StructureText::search)
                               : say(StructureText::title_build, {say(name_id(sitting_.kind))});
    if (!sitting_.walks) {
      panel_.sentence = say(StructureText::no_ray);
      return std::move(panel_);
    }
    if (sitting_.walks->too_large()) {
      panel_.sentence = say(StructureText::too_large, {std::to_string(sitting_.walks->primitives()),
                                                       std::to_string(SearchWalks::most_primitives)});
      return std::move(panel_);
    }
    const int steps = structure_steps(state_);
    if (steps > 0)
      panel_.counter = say(StructureText::counter, {std::to_string(structure_step(state_)), std::to_string(steps)});
    if (searching)
      search();
    else
      build();
    notes(searching);
    return std::move(panel_);
  }

 private:
  [[nodiscard]] std::string say(StructureText id) const { return std::string(text(id, language_)); }
  [[nodiscard]] std::string say(StructureText id, const std::vector<std::string>& arguments) const {
    return fill(id, language_, arguments);
  }
  [[nodiscard]] std::string shapes(int count) const {
    if (count == 0) return say(StructureText::shapes_none);
    if (count == 1) return say(StructureText::shapes_one);
    return say(StructureText::shapes_many, {std::to_string(count)});
  }
  [[nodiscard]] std::string number(double value) const { return number_text(value, language_); }
  [[nodiscard]] static std::string capital(std::string words) {
    if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
    return words;
  }
  [[nodiscard]] bool to_light() const { return sitting_.searches->kind == RayKind::shadow; }

  void search() {
    if (!sitting_.searches) {
      if (question_waits(state_)) {
        panel_.sentence = text(LessonWord::predict_first, language_);
        return;
      }
      const int ray = state_.timeline->current_ray(state_.position);
      const bool stub = ray >= 0 && !state_.timeline->rays()[static_cast<std::size_t>(ray)].formed;
      panel_.sentence = say(stub ? StructureText::stub : ray >= 0 ? StructureText::lost : StructureText::no_ray);
      return;
    }
    const WatchedSearch& chosen = sitting_.searches->in[watched_index(sitting_.kind)];
    if (sitting_.step == 0) {
      panel_.sentence = say(StructureText::not_begun);
    } else {
      const SearchEvent& event = chosen.events[static_cast<std::size_t>(sitting_.step) - 1];
      panel_.sentence = of(event, chosen);
      panel_.so_far = say(StructureText::so_far, {std::to_string(event.nodes), std::to_string(event.tests)});
    }
    panel_.columns = {say(StructureText::column_nodes), say(StructureText::column_tests),
                      say(StructureText::column_saved)};
    const auto tests_in = [&](AcceleratorKind kind) {
      return static_cast<long long>(sitting_.searches->in[watched_index(kind)].counts.primitives);
    };
    const long long brute = tests_in(AcceleratorKind::none);
    for (const AcceleratorKind kind : watched_accelerators) {
      const WatchedSearch& each = sitting_.searches->in[watched_index(kind)];
      panel_.rows.push_back({kind,
                             say(name_id(kind)),
                             {std::to_string(each.counts.nodes), std::to_string(each.counts.primitives),
                              std::to_string(brute - tests_in(kind))}});
    }
    const long long own = tests_in(sitting_.kind), saved = brute - own;
    const std::string name = say(name_id(sitting_.kind));
    panel_.summary =
        sitting_.kind == AcceleratorKind::none
            ? say(StructureText::summary_none, {std::to_string(brute)})
            : say(saved >= 0 ? StructureText::summary : StructureText::summary_more,
                  {name, std::to_string(own), std::to_string(brute), std::to_string(saved >= 0 ? saved : -saved)});
  }

  [[nodiscard]] std::string of(const SearchEvent& event, const WatchedSearch& search) const {
    switch (event.kind) {
      case SearchEvent::Kind::entered:
        if (!event.leaf) return say(StructureText::entered_inner, {std::to_string(event.items)});
        return say(sitting_.kind == AcceleratorKind::grid ? StructureText::entered_cell : StructureText::entered_leaf,
                   {shapes(event.items)});
      case SearchEvent::Kind::opened:
        return say(StructureText::opened, {shapes(event.items)});
      case SearchEvent::Kind::skipped:
        return of_skipped(event, search);
      case SearchEvent::Kind::tested:
        return of_tested(event);
      case SearchEvent::Kind::passed:
        return say(StructureText::passed, {sitting_.walks->name(event.primitive)});
      case SearchEvent::Kind::ended:
        return of_end(event, search);
    }
    return {};
  }

  [[nodiscard]] std::string of_skipped(const SearchEvent& event, const WatchedSearch& /*search*/) const {
    switch (event.skip) {
      case Skip::missed:
        return say(is_off_plan(state_, event.box) ? StructureText::skip_off_plan : StructureText::skip_missed);
      case Skip::behind:
        return say(StructureText::skip_behind);
      case Skip::beyond:
        return to_light() ? say(StructureText::skip_light)
                          : say(StructureText::skip_beyond, {number(event.t_in), number(event.reach)});
    }
    return {};
  }

  [[nodiscard]] std::string of_tested(const SearchEvent& event) const {
    const std::vector<std::string> arguments{sitting_.walks->name(event.primitive), number(event.t)};
    std::string sentence;
    switch (event.test) {
      case SearchEvent::Test::missed:
        sentence = say(StructureText::test_missed, arguments);
        break;
      case SearchEvent::Test::nearest:
        sentence = say(to_light() ? StructureText::test_blocks : StructureText::test_nearest, arguments);
        break;
      case SearchEvent::Test::farther:
        sentence = say(StructureText::test_farther, arguments);
        break;
      case SearchEvent::Test::filters:
        sentence = say(StructureText::test_filters, arguments);
        break;
    }
    if (event.outside && event.test == SearchEvent::Test::nearest && !to_light())
      sentence += " " + say(StructureText::test_outside);
    if (event.again) sentence += " " + say(StructureText::test_again);
    if (event.box.empty() && sitting_.kind != AcceleratorKind::none)
      sentence += " " + say(StructureText::test_unbounded);
    return sentence;
  }

  [[nodiscard]] std::string of_end(const SearchEvent& event, const WatchedSearch& search) const {
    std::string sentence;
    switch (event.end) {
      case SearchEnd::all_seen:
        sentence = say(StructureText::end_all);
        break;
      case SearchEnd::blocked:
        return say(StructureText::end_blocked);
      case SearchEnd::beyond:
        sentence = say(to_light() ? StructureText::end_light : StructureText::end_beyond);
        break;
      case SearchEnd::left:
        sentence = say(StructureText::end_left);
        break;
    }
    return sentence + " " +
           (search.t ? say(StructureText::found, {sitting_.walks->name(search.primitive), number(*search.t)})
                     : say(StructureText::found_nothing));
  }

  void build() {
    const WatchedBuild& chosen = sitting_.walks->build(sitting_.kind);
    if (sitting_.kind == AcceleratorKind::none)
      panel_.sentence = say(StructureText::build_none);
    else if (chosen.steps.empty())
      panel_.sentence = say(StructureText::build_empty);
    else if (sitting_.build_step == 0)
      panel_.sentence = say(StructureText::build_begins, {shapes(sitting_.walks->bounded())});
    else
      panel_.sentence = of(chosen.steps[static_cast<std::size_t>(sitting_.build_step) - 1]);
    panel_.columns = {say(StructureText::column_nodes), say(StructureText::column_listed),
                      say(StructureText::column_depth)};
    for (const AcceleratorKind kind : watched_accelerators) {
      const AcceleratorStatistics& built = sitting_.walks->build(kind).statistics;
      panel_.rows.push_back(
          {kind,
           say(name_id(kind)),
           {std::to_string(built.nodes), std::to_string(built.references), std::to_string(built.depth)}});
    }
  }

  [[nodiscard]] std::string of(const BuildStep& step) const {
    const std::string held = shapes(step.items);
    switch (step.kind) {
      case BuildStep::Kind::split: {
        if (step.axis < 0) return capital(say(StructureText::halved, {held}));
        const std::string axis(1, "xyz"[step.axis]);
        const std::string sides[]{std::to_string(step.parts[0].items), std::to_string(step.parts[1].items)};
        std::string sentence = capital(say(StructureText::split, {held, axis, number(step.plane), sides[0], sides[1]}));
        if (step.leaf_cost > 0)
          sentence += " " + say(StructureText::split_cost, {number(step.split_cost), number(step.leaf_cost)});
        return sentence;
      }
      case BuildStep::Kind::eight:
        return capital(say(StructureText::eight, {held, std::to_string(step.parts.size())}));
      case BuildStep::Kind::leaf:
        return of_leaf(step, held);
      case BuildStep::Kind::joined:
        return say(StructureText::joined, {std::to_string(step.items)});
      case BuildStep::Kind::cells:
        return say(StructureText::cells,
                   {held, std::to_string(step.cells[0]), std::to_string(step.cells[1]), std::to_string(step.cells[2])});
      case BuildStep::Kind::listed:
        return say(step.items == 1 ? StructureText::listed_once : StructureText::listed,
                   {sitting_.walks->name(step.primitive), std::to_string(step.items)});
    }
    return {};
  }

  [[nodiscard]] std::string of_leaf(const BuildStep& step, const std::string& held) const {
    switch (step.why) {
      case LeafReason::single:
        return say(StructureText::leaf_single, {held});
      case LeafReason::few:
        return say(StructureText::leaf_few, {held});
      case LeafReason::dearer:
        return say(StructureText::leaf_dearer, {held, number(step.split_cost), number(step.leaf_cost)});
      case LeafReason::no_gain:
        return say(StructureText::leaf_no_gain, {held});
      case LeafReason::too_deep:
        return say(StructureText::leaf_deep, {held});
      case LeafReason::same_place:
        return say(StructureText::leaf_same, {held});
    }
    return {};
  }

  void notes(bool searching) {
    const WatchedBuild& built = sitting_.walks->build(sitting_.kind);
    const int endless = sitting_.walks->unbounded();
    if (sitting_.kind != AcceleratorKind::none && endless > 0)
      panel_.notes.push_back(say(StructureText::note_unbounded, {std::to_string(endless)}));
    if (!state_.planar && !shows_lines(state_)) panel_.notes.push_back(say(StructureText::note_above));
    if (built.nodes.size() > most_boxes_drawn)
      panel_.notes.push_back(say(StructureText::note_many, {std::to_string(most_boxes_drawn)}));
    const bool whole = !searching          ? built.complete
                       : sitting_.searches ? sitting_.searches->in[watched_index(sitting_.kind)].complete
                                           : true;
    if (!whole) panel_.notes.push_back(say(StructureText::note_cut_short, {std::to_string(structure_steps(state_))}));
  }

  const State& state_;
  const StructureSitting& sitting_;
  Language language_;
  StructurePanel panel_;
};

}  // namespace

StructurePanel structure_panel(const State& state) { return Words(state).panel(); }

}  // namespace raywalk
