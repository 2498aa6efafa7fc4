#include "view/tree/tree_panel.h"
#include "view/text/shown.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/lit.h"

#include <algorithm>

namespace raywalk {

namespace {

std::string name_of(const State& state, const RayRecord& ray) {
  if (ray.object >= 0) return object_name(state, ray.object);
  if (ray.light >= 0) return light_name(state, ray.light);
  if (ray.light == light_of_sky) return std::string(text("equation.sky", state.appearance.language));
  return {};
}

/// Of a beam: how many parts it has; of a part: what it sees, and how much of the pixel or of its cone it is.
std::string label_of_beam(const State& state, const RayRecord& ray) {
  const Language language = state.appearance.language;
  const BeamRecord& beam = state.walk.timeline->beams()[static_cast<std::size_t>(ray.beam)];
  if (beam.parts > 0) return fill("tree.parts", language, {{"count", beam.parts}});
  const std::string sees = ray.object >= 0 ? object_name(state, ray.object) : std::string(text(ray.ending, language));
  const bool told = beam.begun_at <= state.walk.position;
  return told ? sees + ", " + coverage_text(state, beam) : sees;
}

std::string label_of(const State& state, const RayRecord& ray) {
  if (ray.beam >= 0) return label_of_beam(state, ray);
  std::string name = name_of(state, ray);
  switch (ray.ending) {
    case Ending::hit:
    case Ending::scattered:
    case Ending::reached_light:
      return name;
    case Ending::blocked:
    case Ending::missed:
    case Ending::depth:
    case Ending::threshold:
    case Ending::total_internal_reflection:
    case Ending::path_length:
    case Ending::facing_away:
    case Ending::outside_cone:
    case Ending::wrong_side:
      break;
  }
  const std::string why(text(ray.ending, state.appearance.language));
  return ray.ending == Ending::blocked ? why + ": " + name : why;
}

/// Assigns columns from the leaves up: leaves are in the order of their formation, a parent above the middle of its
/// children.
void lay_out(TreePanel& panel) {
  std::vector<std::vector<std::size_t>> children(panel.nodes.size());
  for (std::size_t i = 0; i < panel.nodes.size(); ++i) {
    TreeNode& node = panel.nodes[i];
    if (node.parent < 0) continue;
    children[static_cast<std::size_t>(node.parent)].push_back(i);
    node.y = panel.nodes[static_cast<std::size_t>(node.parent)].y + 1;
    panel.levels = std::max(panel.levels, static_cast<int>(node.y) + 1);
  }
  // Nodes are in depth-first order, so a backward pass visits children before their parents; leaves are counted from
  // the right and mirrored at the end.
  double leaves = 0;
  for (std::size_t i = panel.nodes.size(); i-- > 0;) {
    const auto& below = children[i];
    panel.nodes[i].x = below.empty() ? leaves++ : (panel.nodes[below.front()].x + panel.nodes[below.back()].x) / 2;
  }
  panel.columns = leaves;
  for (TreeNode& node : panel.nodes) node.x = leaves - 1 - node.x;
}

}  // namespace

std::string node_text(const State& state, const TreeNode& node) {
  std::string what = kind_name(state, node.kind);
  if (node.future) return fill("tree.node_future", state.appearance.language, {{"ray", what}});
  if (!node.throughput.empty())
    what = fill("tree.node_share", state.appearance.language, {{"ray", what}, {"share", node.throughput}});
  if (!node.ending) return what + "\n" + std::string(text("tree.node_under_way", state.appearance.language));
  const bool named = *node.ending == Ending::hit || *node.ending == Ending::reached_light;
  const std::string end =
      named ? std::string(text(*node.ending, state.appearance.language)) + ": " + node.label : node.label;
  return what + "\n" + node.symbol + "   " + end;
}

TreePanel tree_panel(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  TreePanel panel;
  const int pixel = timeline.current_pixel(state.walk.position);
  if (pixel < 0) {
    panel.empty = text_without_pixel(state, "tree.empty");
    return panel;
  }
  panel.cell = current_cell(state);
  panel.levels = 1;
  const Timeline::Range range = timeline.rays_of_pixel(pixel);
  const auto formed = static_cast<int>(timeline.rays_at(state.walk.position).size());
  const int current = timeline.current_ray(state.walk.position);
  const int last = hides_rays_to_come(state) ? std::min(range.last, formed) : range.last;
  for (int i = range.first; i < last; ++i) {
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(i)];
    TreeNode node{};
    node.ray = i;
    node.parent = ray.parent < 0 ? -1 : ray.parent - range.first;
    node.kind = ray.kind;
    node.formed = ray.formed;
    node.future = i >= formed;
    node.known = !node.future && ray.found_at <= state.walk.position;
    node.current = i == current;
    node.hovered = i == state.plan.hovered_ray || is_lit(state, i);
    node.colour = ray_style(state.appearance.theme, ray.kind).colour;
    node.shade = palette(state.appearance.theme).empty_cell;
    if (node.known) {
      node.ending = ray.ending;
      node.symbol = symbol(ray.ending);
      node.label = label_of(state, ray);
    }
    if (!node.future) node.throughput = percent_text(max_component(ray.throughput), state.appearance.language);
    if (ray.shade >= 0) {
      const FrameRecord& frame = timeline.frames()[static_cast<std::size_t>(ray.shade)];
      node.returned = frame.returned_at > frame.called_at && frame.returned_at <= state.walk.position;
      if (node.returned) node.shade = display_colour(frame.returned, state.scene().encoding);
    }
    if (ray.beam >= 0)
      if (const BeamRecord& part = timeline.beams()[static_cast<std::size_t>(ray.beam)];
          part.parts == 0 && ray.found_at <= state.walk.position && part.added_at <= state.walk.position) {
        node.returned = true;
        node.shade = display_colour(part.shade, state.scene().encoding);
      }
    panel.nodes.push_back(std::move(node));
  }
  lay_out(panel);
  return panel;
}

}  // namespace raywalk
