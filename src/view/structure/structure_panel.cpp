// The texts of the Structure tab.

#include "inspect/search_walk.h"
#include "view/state.h"
#include "view/structure/structure.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

namespace raywalk {

namespace {

std::string_view name_id(AcceleratorKind kind) {
  switch (kind) {
    case AcceleratorKind::bvh:
      return "structure.bvh";
    case AcceleratorKind::grid:
      return "structure.grid";
    case AcceleratorKind::octree:
      return "structure.octree";
    case AcceleratorKind::kdtree:
      return "structure.kdtree";
    case AcceleratorKind::automatic:
    case AcceleratorKind::none:
    case AcceleratorKind::spheres:
    case AcceleratorKind::ellipsoids:
    case AcceleratorKind::boxes:
      break;  // of these only `none` is stepped
  }
  return "structure.none";
}

std::string_view ray_id(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return "structure.ray_primary";
    case RayKind::shadow:
      return "structure.ray_shadow";
    case RayKind::reflect:
      return "structure.ray_reflect";
    case RayKind::refract:
      return "structure.ray_refract";
    case RayKind::photon:
      return "structure.ray_photon";
    case RayKind::beam:
      break;  // nothing is searched for a beam
  }
  return "structure.ray_primary";
}

class PanelWords {
 public:
  explicit PanelWords(const State& state)
      : state_(state), sitting_(state.structure), language_(state.appearance.language) {}

  StructurePanel panel() {
    const bool searching = sitting_.page == StructurePage::search;
    panel_.title = searching && sitting_.searches
                       ? say("structure.title_search", {{"ray", say(ray_id(sitting_.searches->kind))}})
                   : searching ? say("structure.search")
                               : say("structure.title_build", {{"structure", say(name_id(sitting_.kind))}});
    if (!sitting_.walks) {
      panel_.sentence = say("structure.no_ray");
      return std::move(panel_);
    }
    if (sitting_.walks->too_large()) {
      panel_.sentence =
          say("structure.too_large", {{"shapes", sitting_.walks->primitives()}, {"most", SearchWalks::max_primitives}});
      return std::move(panel_);
    }
    if (sitting_.walks->waits()) {
      panel_.sentence = say("structure.being_built", {{"shapes", sitting_.walks->primitives()}});
      return std::move(panel_);
    }
    const int steps = structure_steps(state_);
    if (steps > 0) panel_.counter = say("structure.counter", {{"step", structure_step(state_)}, {"steps", steps}});
    if (searching)
      search();
    else
      build();
    notes(searching);
    return std::move(panel_);
  }

 private:
  [[nodiscard]] std::string say(std::string_view id) const { return std::string(text(id, language_)); }
  [[nodiscard]] std::string say(std::string_view id, const TextArguments& arguments) const {
    return fill(id, language_, arguments);
  }
  [[nodiscard]] std::string shapes(int count) const { return say("structure.shapes", {{"count", count}}); }
  [[nodiscard]] std::string number(double value) const { return number_text(value, language_); }
  [[nodiscard]] bool to_light() const { return sitting_.searches->kind == RayKind::shadow; }

  void search() {
    if (!sitting_.searches) {
      if (sitting_.awaited) {
        panel_.sentence = say("structure.being_searched");
        return;
      }
      if (withholds_end(state_)) {
        panel_.sentence = say("lesson.predict_first");
        return;
      }
      const int ray = state_.walk.timeline->current_ray(state_.walk.position);
      const bool stub = ray >= 0 && !state_.walk.timeline->rays()[static_cast<std::size_t>(ray)].formed;
      panel_.sentence = say(stub ? "structure.stub" : ray >= 0 ? "structure.lost" : "structure.no_ray");
      return;
    }
    const WatchedSearch& chosen = sitting_.searches->in[watched_index(sitting_.kind)];
    if (sitting_.step == 0) {
      panel_.sentence = say("structure.not_begun");
    } else {
      const SearchEvent& event = chosen.events[static_cast<std::size_t>(sitting_.step) - 1];
      panel_.sentence = of(event, chosen);
      panel_.so_far = say("structure.so_far", {{"nodes", event.nodes}, {"tests", event.tests}});
    }
    panel_.columns = {say("structure.column_nodes"), say("structure.column_tests"), say("structure.column_saved")};
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
            ? say("structure.summary_none", {{"tests", brute}})
            : say(saved >= 0 ? "structure.summary" : "structure.summary_more",
                  {{"structure", name}, {"tests", own}, {"brute", brute}, {"difference", saved >= 0 ? saved : -saved}});
  }

  [[nodiscard]] std::string of(const SearchEvent& event, const WatchedSearch& search) const {
    switch (event.kind) {
      case SearchEvent::Kind::entered:
        if (!event.leaf) return say("structure.entered_inner", {{"count", event.items}});
        return say(sitting_.kind == AcceleratorKind::grid ? "structure.entered_cell" : "structure.entered_leaf",
                   {{"shapes", shapes(event.items)}});
      case SearchEvent::Kind::opened:
        return say("structure.opened", {{"shapes", shapes(event.items)}});
      case SearchEvent::Kind::skipped:
        return of_skipped(event, search);
      case SearchEvent::Kind::tested:
        return of_tested(event);
      case SearchEvent::Kind::passed:
        return say("structure.passed", {{"name", sitting_.walks->name(event.primitive, language_)}});
      case SearchEvent::Kind::ended:
        return of_end(event, search);
    }
    return {};
  }

  [[nodiscard]] std::string of_skipped(const SearchEvent& event, const WatchedSearch& /*search*/) const {
    switch (event.skip) {
      case Skip::missed:
        return say(is_off_plan(state_, event.box) ? "structure.skip_off_plan" : "structure.skip_missed");
      case Skip::behind:
        return say("structure.skip_behind");
      case Skip::beyond:
        return to_light() ? say("structure.skip_light")
                          : say("structure.skip_beyond", {{"entry", number(event.t_in)}, {"hit", number(event.t_far)}});
    }
    return {};
  }

  [[nodiscard]] std::string of_tested(const SearchEvent& event) const {
    const TextArguments arguments{{"name", sitting_.walks->name(event.primitive, language_)}, {"t", number(event.t)}};
    std::string sentence;
    switch (event.test) {
      case SearchEvent::Test::missed:
        sentence = say("structure.test_missed", arguments);
        break;
      case SearchEvent::Test::nearest:
        sentence = say(to_light() ? "structure.test_blocks" : "structure.test_nearest", arguments);
        break;
      case SearchEvent::Test::farther:
        sentence = say("structure.test_farther", arguments);
        break;
      case SearchEvent::Test::filters:
        sentence = say("structure.test_filters", arguments);
        break;
    }
    if (event.outside && event.test == SearchEvent::Test::nearest && !to_light())
      sentence += " " + say("structure.test_outside");
    if (event.again) sentence += " " + say("structure.test_again");
    if (event.box.empty() && sitting_.kind != AcceleratorKind::none) sentence += " " + say("structure.test_unbounded");
    return sentence;
  }

  [[nodiscard]] std::string of_end(const SearchEvent& event, const WatchedSearch& search) const {
    std::string sentence;
    switch (event.end) {
      case SearchEnd::all_seen:
        sentence = say("structure.end_all");
        break;
      case SearchEnd::blocked:
        return say("structure.end_blocked");
      case SearchEnd::beyond:
        sentence = say(to_light() ? "structure.end_light" : "structure.end_beyond");
        break;
      case SearchEnd::left:
        sentence = say("structure.end_left");
        break;
    }
    return sentence + " " +
           (search.t ? say("structure.found",
                           {{"name", sitting_.walks->name(search.primitive, language_)}, {"t", number(*search.t)}})
                     : say(to_light() ? "structure.found_no_blocker" : "structure.found_nothing"));
  }

  void build() {
    const WatchedBuild& chosen = sitting_.walks->build(sitting_.kind);
    if (sitting_.kind == AcceleratorKind::none)
      panel_.sentence = say("structure.build_none");
    else if (chosen.steps.empty())
      panel_.sentence = say("structure.build_empty");
    else if (sitting_.build_step == 0)
      panel_.sentence = say("structure.build_begins", {{"shapes", shapes(sitting_.walks->bounded())}});
    else
      panel_.sentence = of(chosen.steps[static_cast<std::size_t>(sitting_.build_step) - 1]);
    panel_.columns = {say("structure.column_nodes"), say("structure.column_listed"), say("structure.column_depth")};
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
        if (step.axis < 0) return capitalised(say("structure.halved", {{"shapes", held}}));
        const std::string axis(1, "xyz"[step.axis]);
        const std::string sides[]{std::to_string(step.parts[0].items), std::to_string(step.parts[1].items)};
        std::string sentence = capitalised(say("structure.split", {{"shapes", held},
                                                                   {"axis", axis},
                                                                   {"place", number(step.plane)},
                                                                   {"one_side", sides[0]},
                                                                   {"other_side", sides[1]}}));
        if (step.leaf_cost > 0)
          sentence += " " + say("structure.split_cost",
                                {{"with", number(step.split_cost)}, {"without", number(step.leaf_cost)}});
        return sentence;
      }
      case BuildStep::Kind::eight:
        return capitalised(say("structure.eight", {{"shapes", held}, {"parts", step.parts.size()}}));
      case BuildStep::Kind::leaf:
        return of_leaf(step, held);
      case BuildStep::Kind::joined:
        return say("structure.joined", {{"boxes", step.items}});
      case BuildStep::Kind::cells:
        return say("structure.cells",
                   {{"shapes", held}, {"nx", step.cells[0]}, {"ny", step.cells[1]}, {"nz", step.cells[2]}});
      case BuildStep::Kind::listed:
        return say("structure.listed",
                   {{"name", sitting_.walks->name(step.primitive, language_)}, {"count", step.items}});
    }
    return {};
  }

  [[nodiscard]] std::string of_leaf(const BuildStep& step, const std::string& held) const {
    switch (step.why) {
      case LeafReason::single:
        return say("structure.leaf_single", {{"shapes", held}});
      case LeafReason::few:
        return say("structure.leaf_few", {{"shapes", held}});
      case LeafReason::split_costs_more:
        return say("structure.leaf_dearer",
                   {{"shapes", held}, {"cut", number(step.split_cost)}, {"leaf", number(step.leaf_cost)}});
      case LeafReason::no_gain:
        return say("structure.leaf_no_gain", {{"shapes", held}});
      case LeafReason::too_deep:
        return say("structure.leaf_deep", {{"shapes", held}});
      case LeafReason::same_place:
        return say("structure.leaf_same", {{"shapes", held}});
      case LeafReason::too_many_listed:
        return say("structure.leaf_full", {{"shapes", held}});
    }
    return {};
  }

  void notes(bool searching) {
    const WatchedBuild& built = sitting_.walks->build(sitting_.kind);
    const int endless = sitting_.walks->unbounded();
    if (sitting_.kind != AcceleratorKind::none && endless > 0)
      panel_.notes.push_back(say("structure.note_unbounded", {{"shapes", endless}}));
    if (!state_.walk.planar && !shows_lines(state_)) panel_.notes.push_back(say("structure.note_above"));
    if (built.nodes.size() > max_boxes_drawn)
      panel_.notes.push_back(say("structure.note_many", {{"most", max_boxes_drawn}}));
    const bool whole = !searching          ? built.complete
                       : sitting_.searches ? sitting_.searches->in[watched_index(sitting_.kind)].complete
                                           : true;
    if (!whole) panel_.notes.push_back(say("structure.note_cut_short", {{"steps", structure_steps(state_)}}));
  }

  const State& state_;
  const StructureRoom& sitting_;
  Language language_;
  StructurePanel panel_;
};

}  // namespace

StructurePanel structure_panel(const State& state) { return PanelWords(state).panel(); }

}  // namespace raywalk
