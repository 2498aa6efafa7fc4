#include "fixtures.h"
#include "view/legend/legend.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/stack/stack_panel.h"
#include "view/text/text.h"
#include "view/tree/tree_panel.h"
#include "view/walk/code_panel.h"
#include "view/walk/status.h"

#include <algorithm>
#include <set>

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// How many rays the path has whose line has just run.
int rays_of_path(const State& state) {
  int rays = 0;
  for (int i = state.walk.position - 1; i >= 0; --i) {
    const auto* formed = std::get_if<RayFormed>(&state.walk.timeline->event(i).detail);
    if (formed == nullptr || formed->kind == RayKind::shadow) continue;
    ++rays;
    if (formed->kind == RayKind::primary) break;
  }
  return rays;
}

}  // namespace

TEST_CASE("the code panel highlights the timeline's line at every position") {
  for (State state : {classic_state(), busy_state()}) {
    for (int position = 0; position <= state.walk.timeline->steps(); ++position) {
      state.walk.position = position;
      const CodePanel panel = code_panel(state);
      const Event* just_run = state.walk.timeline->just_run(position);
      const Event* next = state.walk.timeline->next(position);
      int highlighted = 0, outlined = 0;
      for (const CodeBox& box : panel.boxes) {
        for (const CodeRow& row : box.rows) {
          highlighted += row.just_run ? 1 : 0;
          outlined += row.next ? 1 : 0;
          if (row.just_run) REQUIRE((just_run != nullptr && row.line == just_run->line));
          if (row.next) REQUIRE((next != nullptr && row.line == next->line));
        }
        const bool executes = just_run != nullptr && pseudocode_of(just_run->line).procedure == box.procedure;
        REQUIRE(box.depth.has_value() == executes);
        if (executes) REQUIRE(*box.depth == just_run->depth);
      }
      REQUIRE(highlighted == (just_run == nullptr ? 0 : 1));
      REQUIRE(outlined == (next == nullptr ? 0 : 1));
    }
  }
}

TEST_CASE("a walk of paths has its own pseudocode, call and return") {
  Scene scene = busy_scene();
  scene.render.integrator = Integrator::path;
  State state = state_of(scene);
  REQUIRE(state.walk.timeline->of_paths());
  const CodePanel start = code_panel(state);
  CHECK(start.boxes[0].title == "PATH TRACING");
  CHECK(start.boxes[1].title == "FOLLOW PATH (RTNSHADE)");
  CHECK(start.boxes[0].rows.size() + start.boxes[1].rows.size() == path_line_count);
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    state.walk.position = position;
    const Event& ran = *state.walk.timeline->just_run(position);
    int highlighted = 0;
    for (const CodeBox& box : code_panel(state).boxes) {
      for (const CodeRow& row : box.rows) highlighted += row.just_run && row.line == ran.line;
      if (box.depth.value_or(0) > 0) CHECK(box.badge == "RAY " + std::to_string(rays_of_path(state)));
    }
    CHECK(highlighted == 1);
    const StackPanel stack = stack_panel(state);
    if (stack.rows.size() > 1)
      CHECK_THAT(stack.rows[0].title, contains("(ray " + std::to_string(rays_of_path(state)) + ")"));
    CHECK(stack.rows.back().title == "PATH TRACING");
    CHECK(stack.rows.size() == state.walk.timeline->stack(position).size() + 1);
    CHECK_FALSE(sentence(state).empty());
    static_cast<void>(tree_panel(state));
  }
  update(state, action::RunToLine{Line::follow_path});
  update(state, action::SetImageSettings{[] {
           ImageSettings settings;
           settings.integrator = Integrator::whitted;
           return settings;
         }()});
  CHECK_FALSE(state.walk.timeline->of_paths());
  CHECK(code_panel(state).boxes[0].title == "MAIN ALGORITHM");
}

TEST_CASE("the code panel is the pseudocode") {
  const CodePanel panel = code_panel(classic_state());
  CHECK(panel.boxes[0].title == "MAIN ALGORITHM");
  CHECK(panel.boxes[1].title == "SHADE (DEPTH, RTNSHADE)");
  CHECK(panel.boxes[0].rows.size() + panel.boxes[1].rows.size() == line_count);
  CHECK(panel.boxes[1].rows.front().text == "Form shadow ray");
}

TEST_CASE("pointing at a line lights it up, pointing at a ray lights up its lines") {
  State state = busy_state();
  const auto hovered = [&] {
    std::set<Line> lines;
    for (const CodeBox& box : code_panel(state).boxes)
      for (const CodeRow& row : box.rows)
        if (row.hovered) lines.insert(row.line);
    return lines;
  };
  update(state, action::HoverLine{Line::if_reflective});
  CHECK(hovered() == std::set<Line>{Line::if_reflective});
  update(state, action::HoverLine{std::nullopt});
  CHECK(hovered().empty());
  const auto& rays = state.walk.timeline->rays();
  const auto found =
      std::find_if(rays.begin(), rays.end(), [](const RayRecord& ray) { return ray.kind == RayKind::refract; });
  REQUIRE(found != rays.end());
  update(state, action::HoverRay{static_cast<int>(found - rays.begin())});
  CHECK(hovered() == std::set<Line>{Line::form_refract_ray, Line::find_refract_intersect, Line::shade_refract});
}

TEST_CASE("pointing at a line lights up the rays that it formed, in the tree and in the plan") {
  State state = busy_state();
  update(state, action::Jump{state.walk.timeline->steps() / 2});
  update(state, action::Step{true, Grain::pixel});
  update(state, action::Step{false, Grain::line});
  update(state, action::HoverLine{Line::form_shadow_ray});
  int shadows = 0;
  for (const TreeNode& node : tree_panel(state).nodes) {
    CHECK(node.hovered == (node.kind == RayKind::shadow && !node.future));
    shadows += node.hovered ? 1 : 0;
  }
  CHECK(shadows > 0);
}

TEST_CASE("the tree is that of the pixel's rays") {
  State state = busy_state();
  for (int position = 0; position <= state.walk.timeline->steps(); position += 5) {
    state.walk.position = position;
    const TreePanel tree = tree_panel(state);
    const int pixel = state.walk.timeline->current_pixel(position);
    if (pixel < 0) {
      CHECK(tree.nodes.empty());
      CHECK(tree.cell == -1);
      continue;
    }
    const auto range = state.walk.timeline->rays_of_pixel(pixel);
    REQUIRE(static_cast<int>(tree.nodes.size()) == range.last - range.first);
    CHECK(tree.cell == state.walk.timeline->pixels()[static_cast<std::size_t>(pixel)].column);
    std::set<std::pair<double, double>> places;
    int current = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const TreeNode& node = tree.nodes[i];
      const RayRecord& ray = state.walk.timeline->rays()[static_cast<std::size_t>(node.ray)];
      REQUIRE(ray.pixel == pixel);
      REQUIRE(node.kind == ray.kind);
      REQUIRE(node.formed == ray.formed);
      REQUIRE(node.future == (ray.formed_at > position));
      REQUIRE(node.known == (ray.formed_at <= position && ray.found_at <= position));
      REQUIRE(node.label.empty() != node.known);
      REQUIRE(node.symbol.empty() != node.known);
      REQUIRE(node.ending == (node.known ? std::optional(ray.ending) : std::nullopt));
      REQUIRE(node.throughput.empty() == node.future);
      if (node.parent < 0) {
        REQUIRE(node.kind == RayKind::primary);
        REQUIRE(node.y == 0);
      } else {
        const TreeNode& parent = tree.nodes[static_cast<std::size_t>(node.parent)];
        REQUIRE(node.parent < static_cast<int>(i));
        REQUIRE(parent.ray == ray.parent);
        REQUIRE(node.y == parent.y + 1);
      }
      REQUIRE(node.x >= 0);
      REQUIRE(node.x <= tree.columns - 1);
      REQUIRE(node.y < tree.levels);
      REQUIRE(places.emplace(node.x, node.y).second);
      current += node.current ? 1 : 0;
    }
    REQUIRE(current <= 1);
  }
}

TEST_CASE("children stand below their parent in the order in which they were formed") {
  State state = busy_state();
  for (int cell = 0; cell < state.scene().camera.screen.cells; ++cell) {
    update(state, action::JumpToCell{cell});
    const TreePanel tree = tree_panel(state);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      double last = -1, low = 1e9, high = -1;
      for (const TreeNode& child : tree.nodes) {
        if (child.parent != static_cast<int>(i)) continue;
        CHECK(child.x > last);
        last = child.x;
        low = std::min(low, child.x);
        high = std::max(high, child.x);
      }
      if (high < 0) continue;
      CHECK(tree.nodes[i].x >= low);
      CHECK(tree.nodes[i].x <= high);
    }
  }
}

TEST_CASE("the tree's shape does not change while its pixel is walked") {
  State state = busy_state();
  update(state, action::JumpToCell{8});
  const TreePanel first = tree_panel(state);
  while (current_cell(state) == 8) {
    const TreePanel tree = tree_panel(state);
    REQUIRE(tree.nodes.size() == first.nodes.size());
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      REQUIRE(tree.nodes[i].x == first.nodes[i].x);
      REQUIRE(tree.nodes[i].y == first.nodes[i].y);
    }
    update(state, action::Step{true, Grain::line});
  }
}

TEST_CASE("a node that has returned shows the colour that its SHADE returned") {
  State state = classic_state();
  update(state, action::Jump{1 << 20});
  for (int cell = 20; cell >= 0; --cell) {
    update(state, action::JumpToCell{cell});
    update(state, action::Step{true, Grain::pixel});
    for (const TreeNode& node : tree_panel(state).nodes) {
      const RayRecord& ray = state.walk.timeline->rays()[static_cast<std::size_t>(node.ray)];
      CHECK(node.returned == (ray.shade >= 0));
      if (node.returned)
        CHECK(node.shade ==
              display_colour(state.walk.timeline->frames()[static_cast<std::size_t>(ray.shade)].returned));
    }
  }
}

TEST_CASE("the stack lists the open calls, innermost first, and what each waits for") {
  State state = busy_state();
  bool deep = false;
  for (int position = 0; position <= state.walk.timeline->steps(); ++position) {
    state.walk.position = position;
    const StackPanel panel = stack_panel(state);
    std::vector<int> calls = state.walk.timeline->stack(position);
    if (position == 0) {
      CHECK(panel.rows.empty());
      continue;
    }
    // The call that has just computed its shade still stands there, handing it over.
    const bool returning = state.walk.timeline->just_run(position)->line == Line::compute_rtnshade;
    if (returning) calls.insert(calls.begin(), state.walk.timeline->current_frame(position));
    REQUIRE(panel.rows.size() == calls.size() + 1);
    if (returning) {
      const FrameRecord& frame = state.walk.timeline->frames()[static_cast<std::size_t>(calls.front())];
      REQUIRE(panel.rows.front().waiting == fill("stack.returns", state.appearance.language,
                                                 {{"colour", colour_text(frame.returned, state.appearance.language)}}));
    }
    CHECK(panel.rows.back().title == "MAIN ALGORITHM");
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const FrameRecord& frame = state.walk.timeline->frames()[static_cast<std::size_t>(calls[i])];
      const StackRow& row = panel.rows[i];
      REQUIRE(row.title == fill("stack.shade", state.appearance.language, {{"depth", std::to_string(frame.depth)}}));
      REQUIRE(row.ray_index == frame.ray);
      REQUIRE_FALSE(row.object.empty());
      REQUIRE_FALSE(row.waiting.empty());
      const RayKind kind = state.walk.timeline->rays()[static_cast<std::size_t>(frame.ray)].kind;
      const StackRow& caller = panel.rows[i + 1];
      if (returning && i == 0) continue;  // its caller works on already
      if (kind == RayKind::reflect) REQUIRE(caller.waiting == text("stack.waits_refl", state.appearance.language));
      if (kind == RayKind::refract) REQUIRE(caller.waiting == text("stack.waits_refr", state.appearance.language));
      if (kind == RayKind::primary) REQUIRE(caller.waiting == text("stack.waits_final", state.appearance.language));
    }
    deep = deep || calls.size() >= 3;
  }
  CHECK(deep);
}

TEST_CASE("a call shows what has been returned to it") {
  State state = busy_state();
  int shown = 0;
  for (int position = 1; position <= state.walk.timeline->steps(); ++position) {
    const Event* just_run = state.walk.timeline->just_run(position);
    if (just_run->line != Line::compute_rtnshade) continue;
    state.walk.position = position;
    const auto& computed = std::get<ShadeComputed>(just_run->detail);
    const StackPanel panel = stack_panel(state);
    REQUIRE(panel.rows.size() >= 2);
    const StackRow& caller = panel.rows[1];
    REQUIRE_FALSE(caller.returned.empty());
    CHECK(caller.returned.back().linear == computed.total);
    ++shown;
  }
  CHECK(shown > 20);
}

TEST_CASE("counts are those of a walk through the events") {
  State state = busy_state();
  Counts expected;
  for (int position = 0; position <= state.walk.timeline->steps(); ++position) {
    if (position > 0) {
      const EventDetail& detail = state.walk.timeline->just_run(position)->detail;
      if (const auto* formed = std::get_if<RayFormed>(&detail))
        ++expected.formed[static_cast<std::size_t>(formed->kind)];
      if (const auto* found = std::get_if<Found>(&detail)) ++expected.ended[static_cast<std::size_t>(found->ending)];
      if (const auto* stub = std::get_if<RayNotFormed>(&detail)) ++expected.ended[static_cast<std::size_t>(stub->why)];
      if (std::holds_alternative<PixelBegun>(detail)) ++expected.pixel;
      // Total internal reflection leaves a stub.
      if (const auto* decided = std::get_if<Decided>(&detail); decided != nullptr && decided->why)
        ++expected.ended[static_cast<std::size_t>(*decided->why)];
    }
    state.walk.position = position;
    const Counts now = counts(state);
    REQUIRE(now.formed == expected.formed);
    REQUIRE(now.ended == expected.ended);
    REQUIRE(now.pixel == expected.pixel);
    REQUIRE(now.position == position);
  }
  CHECK(expected.ended[static_cast<std::size_t>(Ending::total_internal_reflection)] > 0);
  CHECK_THAT(status_line(state), contains(std::to_string(state.walk.timeline->steps())));
}

TEST_CASE("in Move the sentence says how to get back what is out of view") {
  State state = classic_state();
  update(state, action::SetMode{Mode::move});
  update(state, action::Select{{TargetKind::light, 0}});
  update(state, action::Pan{{5000, 0}});
  CHECK_THAT(sentence(state), contains(state.scene().lights[0].name) && contains("Fit (F)"));
  update(state, action::FitView{});
  CHECK(sentence(state) == text("status.first_step_move", state.appearance.language));
  update(state, action::Zoom{{320, 240}, 0.01});
  CHECK(sentence(state) == text("plan.shown_tiny", state.appearance.language));
}

TEST_CASE("a body of which a part is seen is not said to be out of view") {
  State state = busy_state();
  update(state, action::SetMode{Mode::move});
  for (const Vec2d& way : {Vec2d(1, 0), Vec2d(-1, 0), Vec2d(0, 1), Vec2d(0, -1)}) {
    update(state, action::FitView{});
    update(state, action::Select{{TargetKind::object, 0}});
    const Target& ball = state.plan.selected;
    const auto out = [&] { return sentence(state).find("out of view") != std::string::npos; };
    const auto place = [&] {
      return to_pixels(state.plan.camera, state.plan.viewport, place_of(state, ball, state.plan.viewport));
    };
    const double radius =
        plan_radius(std::get<Sphere<double>>(state.scene().objects[0].shape)) * state.plan.camera.pixels_per_unit;
    // Its middle is half a radius beyond the border, then one and a half.
    const auto beyond = [&](double radii) {
      const Vec2d size(state.plan.viewport.width, state.plan.viewport.height);
      const Vec2d border = size / 2.0 + way * (size / 2.0), aim = border + radii * radius * way;
      update(state, action::Pan{way * dot(aim - place(), way)});
    };
    beyond(0.5);
    CHECK_FALSE(out());
    beyond(1.5);
    CHECK(out());
  }
}

TEST_CASE("total internal reflection leaves a stub along the surface") {
  const State state = busy_state();
  int seen = 0;
  for (const RayRecord& ray : state.walk.timeline->rays()) {
    if (ray.ending != Ending::total_internal_reflection) continue;
    ++seen;
    CHECK_FALSE(ray.formed);
    CHECK(ray.kind == RayKind::refract);
    const RayRecord& parent = state.walk.timeline->rays()[static_cast<std::size_t>(ray.parent)];
    CHECK(ray.origin == parent.end);
    CHECK(std::abs(dot(ray.direction, parent.normal)) < 1e-12);
    CHECK(dot(ray.direction, parent.direction) >= 0);
    CHECK(length(ray.direction) == Approx(1));
  }
  CHECK(seen > 0);
}

TEST_CASE("the longest status has room for every status of the walk") {
  State state = classic_state();
  for (int position = 0; position <= state.walk.timeline->steps(); position += 7) {
    state.walk.position = position;
    CHECK(status_line(state).size() <= widest_status_line(state, false).size() + 2);  // a dash of three bytes
    CHECK(short_status_line(state).size() <= widest_status_line(state, true).size());
  }
}

TEST_CASE("the legend has all kinds of rays of the walk and the signs of the tree") {
  const Legend rows = legend(classic_state());
  REQUIRE(rows.rays.size() == ray_kind_count - 2);  // photons and beams are only where they are walked
  for (const LegendRow& row : rows.rays) CHECK_FALSE(row.meaning.empty());
  for (const Ending ending : {Ending::hit, Ending::missed, Ending::blocked, Ending::reached_light, Ending::depth,
                              Ending::threshold, Ending::facing_away})
    CHECK(std::any_of(rows.signs.begin(), rows.signs.end(),
                      [&](const LegendSign& sign) { return sign.symbol == symbol(ending); }));
}

TEST_CASE("the sentence says what to do first and what comes last") {
  State state = classic_state();
  CHECK(sentence(state) == text("status.first_step_move", state.appearance.language));
  update(state, action::SetMode{Mode::trace});
  CHECK(sentence(state) == text("status.first_step_trace", state.appearance.language));
  update(state, action::SetMode{Mode::help});
  CHECK(sentence(state) == text("status.first_step_help", state.appearance.language));
  update(state, action::Jump{1 << 20});
  CHECK_THAT(sentence(state), contains(std::string(text("status.after_last_step", state.appearance.language))));
  update(state, action::SetMode{Mode::move});
  CHECK_THAT(sentence(state), contains(std::string(text("status.walk_stands_at_end", state.appearance.language))));
  update(state, action::Jump{7});
  update(state, action::SetMode{Mode::move});
  CHECK_THAT(sentence(state), contains("step 7 of " + std::to_string(state.walk.timeline->steps())));
}
