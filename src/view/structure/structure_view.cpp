// The boxes of the current accelerator, in the plan and in space: all of them faint, those that the search has reached
// strong, solid if entered and dashed if skipped.

#include "inspect/search_walk.h"
#include "view/plan/painter.h"
#include "view/structure/structure.h"
#include "view/text/text.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

enum class Manner {
  there,  ///< part of the structure, not reached
  entered,
  skipped,
  current,
};

struct BoxMark {
  Bounds<double> box;
  Manner manner = Manner::there;
  int depth = 0;
  bool dashed = false;  ///< skipped, even if it is the current one
  std::string label{};
};

std::string label_of(const State& state, const SearchEvent& event) {
  const auto say = [&](std::string_view id) { return std::string(text(id, state.appearance.language)); };
  const bool to_light = state.structure.searches->kind == RayKind::shadow;
  switch (event.skip) {
    case Skip::missed:
      return say(is_off_plan(state, event.box) ? "structure.label_off_plan" : "structure.label_missed");
    case Skip::behind:
      return say("structure.label_behind");
    case Skip::beyond:
      return say(to_light ? "structure.label_light" : "structure.label_beyond");
  }
  return {};
}

/// How deep it is drawn: cells are fine.
int drawn_depth(const StructureNode& node) { return node.leaf ? std::max(node.depth, 2) : node.depth; }

/// The finished structure, upper boxes first.
std::vector<BoxMark> standing(const State& state) {
  std::vector<const StructureNode*> nodes;
  for (const StructureNode& node : state.structure.walks->build(state.structure.kind).nodes) nodes.push_back(&node);
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const StructureNode* a, const StructureNode* b) { return drawn_depth(*a) < drawn_depth(*b); });
  if (nodes.size() > max_boxes_drawn) nodes.resize(max_boxes_drawn);
  std::vector<BoxMark> marks;
  for (const StructureNode* node : nodes) marks.push_back({node->box, Manner::there, drawn_depth(*node)});
  return marks;
}

std::vector<BoxMark> marks_of_search(const State& state) {
  const StructureRoom& sitting = state.structure;
  std::vector<BoxMark> marks = standing(state);
  if (!sitting.searches) return marks;
  const std::vector<SearchEvent>& events = sitting.searches->in[watched_index(sitting.kind)].events;
  for (int i = 0; i < sitting.step; ++i) {
    const SearchEvent& event = events[static_cast<std::size_t>(i)];
    const bool now = i == sitting.step - 1, skipped = event.kind == SearchEvent::Kind::skipped;
    const bool entered = event.kind == SearchEvent::Kind::entered || event.kind == SearchEvent::Kind::opened;
    if (event.box.empty() || (!now && !skipped && !entered)) continue;
    marks.push_back({event.box,
                     now       ? Manner::current
                     : skipped ? Manner::skipped
                               : Manner::entered,
                     0, skipped, skipped ? label_of(state, event) : std::string()});
  }
  return marks;
}

/// The structure built so far, the current step on top.
std::vector<BoxMark> marks_of_build(const State& state) {
  const std::vector<BuildStep>& steps = state.structure.walks->build(state.structure.kind).steps;
  std::vector<BoxMark> marks;
  if (steps.empty()) return marks;
  marks.push_back({steps.front().box, Manner::there, 0});
  for (int i = 0; i < state.structure.build_step; ++i) {
    const BuildStep& step = steps[static_cast<std::size_t>(i)];
    const bool now = i == state.structure.build_step - 1;
    if (step.kind == BuildStep::Kind::cells)
      for (const BoxMark& cell : standing(state)) marks.push_back(cell);
    for (const BuildStep::Part& part : step.parts)
      marks.push_back({part.box, now ? Manner::entered : Manner::there, step.depth + 1, false,
                       now ? std::to_string(part.items) : std::string()});
    if (now) marks.push_back({step.box, Manner::current, step.depth});
  }
  return marks;
}

std::vector<BoxMark> marks_of(const State& state) {
  if (!shows_structure(state) || !state.structure.walks || state.structure.walks->too_large()) return {};
  std::vector<BoxMark> marks =
      state.structure.page == StructurePage::search ? marks_of_search(state) : marks_of_build(state);
  // Of unreached boxes, only those cut by the plan are shown.
  std::erase_if(marks, [&](const BoxMark& mark) {
    return !mark.box.bounded() || (mark.manner == Manner::there && is_off_plan(state, mark.box));
  });
  return marks;
}

Stroke stroke_of(const Painter& painter, const BoxMark& mark) {
  const double unit = painter.sizes.unit;
  const DashPattern dashes = painter.scaled({{7, 4}, 2});
  switch (mark.manner) {
    case Manner::there:  // the deeper, the finer
      return {painter.colours.text.with_alpha(mark.depth == 0 ? 120 : 75),
              unit * std::max(0.6, 1.6 - 0.4 * mark.depth)};
    case Manner::entered:
      return {painter.colours.text, 1.8 * unit};
    case Manner::skipped:
      return {painter.colours.dim_text, 1.3 * unit, dashes};
    case Manner::current:
      return {painter.colours.next, 3 * unit, mark.dashed ? dashes : DashPattern{}};
  }
  return {};
}

constexpr int max_bodies = 500;  ///< with more, there is no room for text

/// The boxes of the primitives, in the plan.
std::vector<PixelRect> bodies_of(const Painter& painter) {
  std::vector<PixelRect> bodies;
  const SearchWalks& walks = *painter.state.structure.walks;
  for (int i = 0; i < std::min(walks.primitives(), max_bodies); ++i) {
    const Bounds<double> box = walks.box(i);
    if (!box.bounded() || is_off_plan(painter.state, box)) continue;
    const Vec2d a = painter.pixels(plan(box.min)), b = painter.pixels(plan(box.max));
    bodies.push_back({{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}});
  }
  return bodies;
}

/// Why a box was skipped, in a free corner of it; else only the list of steps says so.
void draw_reason(Painter& painter, const BoxMark& mark, const PixelRect& box, const std::vector<PixelRect>& bodies) {
  const double size = 0.8 * painter.sizes.text, margin = 2 * painter.sizes.unit;
  const Vec2d half(text_width(mark.label, size) / 2 + 0.2 * size, 0.6 * size);
  const Vec2d low = box.min + half + margin, high = box.max - half - margin;
  if (low.x > high.x || low.y > high.y) return;
  for (const Vec2d& at : {low, Vec2d(high.x, low.y), Vec2d(low.x, high.y), high, (low + high) / 2.0}) {
    const PixelRect place{at - half, at + half};
    if (painter.covers_kept(place)) continue;
    if (std::any_of(bodies.begin(), bodies.end(), [&](const PixelRect& taken) { return place.overlap(taken) > 0; }))
      continue;
    painter.add(TextItem{at, mark.label, size, painter.colours.dim_text, TextAnchor::middle});
    return painter.kept_free.push_back(place);
  }
}

void draw_mark(Painter& painter, const BoxMark& mark, const std::vector<PixelRect>& bodies) {
  // Boxes share edges: skipped ones are drawn slightly smaller, so that their dashes are not covered.
  const double inset = (mark.dashed ? 3 : 0) * painter.sizes.unit;
  const Vec2d a = painter.pixels(plan(mark.box.min)), b = painter.pixels(plan(mark.box.max));
  Vec2d low(std::min(a.x, b.x) + inset, std::min(a.y, b.y) + inset);
  Vec2d high(std::max(a.x, b.x) - inset, std::max(a.y, b.y) - inset);
  high = {std::max(high.x, low.x), std::max(high.y, low.y)};
  const Vec2d corners[]{low, {high.x, low.y}, high, {low.x, high.y}};
  const Stroke stroke = stroke_of(painter, mark);
  if (mark.manner == Manner::current) {
    const auto within = [&](const Vec2d& p) {
      return Vec2d(std::clamp(p.x, 0.0, painter.viewport.width), std::clamp(p.y, 0.0, painter.viewport.height));
    };
    PolygonItem ground{{}, painter.colours.next.with_alpha(38), std::nullopt};
    for (const Vec2d& corner : corners) ground.points.push_back(within(corner));
    painter.add(std::move(ground));
  }
  for (std::size_t i = 0; i < 4; ++i) painter.add_clipped({corners[i], corners[(i + 1) % 4], stroke});
  if (mark.label.empty()) return;
  if (mark.manner != Manner::current) {
    if (painter.state.structure.walks->primitives() <= max_bodies) draw_reason(painter, mark, {low, high}, bodies);
    return;
  }
  painter.note({(low.x + high.x) / 2, low.y - 0.8 * painter.sizes.text}, mark.label);
}

/// A cross on what was missed, a disc where something was hit.
void draw_tests(Painter& painter) {
  const StructureRoom& sitting = painter.state.structure;
  const double size = 5 * painter.sizes.unit;
  const std::vector<SearchEvent>& events = sitting.searches->in[watched_index(sitting.kind)].events;
  for (int i = 0; i < sitting.step; ++i) {
    const SearchEvent& event = events[static_cast<std::size_t>(i)];
    if (event.kind != SearchEvent::Kind::tested) continue;
    const bool now = i == sitting.step - 1;
    const Stroke stroke{now ? painter.colours.next : painter.colours.text, (now ? 3.0 : 1.8) * painter.sizes.unit};
    if (event.test != SearchEvent::Test::missed) {
      const Vec2d at = painter.pixels(plan(sitting.searches->origin + event.t * sitting.searches->direction));
      painter.add(CircleItem{at, size, painter.colours.plan, stroke});
      continue;
    }
    const Bounds<double> box = sitting.walks->box(event.primitive);
    if (!box.bounded()) continue;
    const Vec2d at = painter.pixels(plan((box.min + box.max) / 2.0)) + Vec2d(0, 2.6 * size);  // where its name is
    painter.add(LineItem{at - Vec2d(size), at + Vec2d(size), stroke});
    painter.add(LineItem{at + Vec2d(size, -size), at + Vec2d(-size, size), stroke});
  }
}

}  // namespace

void StructureRoom::draw_in_plan(Painter& painter) {
  const std::vector<BoxMark> marks = marks_of(painter.state);
  if (marks.empty()) return;
  const std::vector<PixelRect> bodies = bodies_of(painter);
  for (const BoxMark& mark : marks) draw_mark(painter, mark, bodies);
  if (painter.state.structure.page == StructurePage::search && painter.state.structure.searches) draw_tests(painter);
}

std::vector<StructureEdge> structure_edges(const Painter& painter) {
  std::vector<StructureEdge> edges;
  for (const BoxMark& mark : marks_of(painter.state)) {
    const Stroke stroke = stroke_of(painter, mark);
    const auto corner = [&](unsigned bits) {
      return Vec3d((bits & 1U ? mark.box.max : mark.box.min).x, (bits & 2U ? mark.box.max : mark.box.min).y,
                   (bits & 4U ? mark.box.max : mark.box.min).z);
    };
    for (unsigned from = 0; from < 8; ++from)
      for (const unsigned axis : {1U, 2U, 4U})
        if ((from & axis) == 0) edges.push_back({corner(from), corner(from | axis), stroke});
  }
  return edges;
}

}  // namespace raywalk
