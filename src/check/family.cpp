#include "check/family.h"

#include <fmt/format.h>

#include <utility>

namespace raywalk::check {

std::string broken_goal(const Goals& goals, const Tally& tally) {
  std::string broken;
  const auto say = [&](bool fails, const std::string& words) {
    if (fails) broken += (broken.empty() ? "" : ", ") + words;
  };
  say(tally.rays == 0, "no ray could be formed");
  say(goals.decisions && tally.missed > 0, fmt::format("{} missed", tally.missed));
  say(goals.decisions && tally.false_hits > 0, fmt::format("{} false", tally.false_hits));
  say(!goals.decisions && tally.missed + tally.false_hits > tally.excused,
      fmt::format("{} wrong for every ray nearby", tally.missed + tally.false_hits - tally.excused));
  say(tally.leaks > 0, fmt::format("{} leaks", tally.leaks));
  say(tally.self_hits > 0, fmt::format("{} self-hits", tally.self_hits));
  say(tally.sheet_missed > 0, fmt::format("near sheet missed {} times", tally.sheet_missed));
  say(tally.unequal > 0, fmt::format("{} answers differ that must be the same bits", tally.unequal));
  say(!(tally.exact_ulps <= goals.exact_ulps), fmt::format("t {:.3g} ulps off in the exact tier", tally.exact_ulps));
  say(!(tally.fast_ulps_by_condition <= goals.fast_ulps_by_condition),
      fmt::format("t {:.3g} times its condition off in the fast tier", tally.fast_ulps_by_condition));
  return broken;
}

std::vector<Family> all_families() {
  ShapeFamilies of_shapes;
  for (auto* add : {add_round_shapes, add_flat_shapes, add_quadrics}) add(of_shapes);
  std::vector<Family> all = std::move(of_shapes.own);
  for (const Family& family : {mesh_family(), of_shapes.spawned, of_shapes.spawned_polygon, accelerator_family(),
                               of_shapes.laws, of_shapes.permuted, of_shapes.reversed, of_shapes.normals})
    all.push_back(family);
  return all;
}

}  // namespace raywalk::check
