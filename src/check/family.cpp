#include "check/family.h"

#include <fmt/format.h>

#include <iterator>

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
  std::vector<Family> all;
  for (auto* make : {round_families, flat_families, quadric_families, mesh_families, spawn_families,
                     accelerator_families, invariance_families, symmetry_families, normal_families}) {
    std::vector<Family> some = make();
    all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  }
  return all;
}

}  // namespace raywalk::check
