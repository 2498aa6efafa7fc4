#include "check/family.h"

#include <fmt/format.h>

#include <iterator>

namespace raywalk::check {

std::string broken_goal(const Goals& goals, const Row& row) {
  std::string broken;
  const auto say = [&](bool fails, const std::string& words) {
    if (fails) broken += (broken.empty() ? "" : ", ") + words;
  };
  say(row.rays == 0, "no ray could be formed");
  say(goals.decisions && row.missed > 0, fmt::format("{} missed", row.missed));
  say(goals.decisions && row.false_hits > 0, fmt::format("{} false", row.false_hits));
  say(!goals.decisions && row.missed + row.false_hits > row.excused,
      fmt::format("{} wrong for every ray nearby", row.missed + row.false_hits - row.excused));
  say(row.leaks > 0, fmt::format("{} leaks", row.leaks));
  say(row.self_hits > 0, fmt::format("{} self-hits", row.self_hits));
  say(row.sheet_missed > 0, fmt::format("near sheet missed {} times", row.sheet_missed));
  say(row.unequal > 0, fmt::format("{} answers differ that must be the same bits", row.unequal));
  say(!(row.exact_ulps <= goals.exact_ulps), fmt::format("t {:.3g} ulps off in the exact tier", row.exact_ulps));
  say(!(row.fast_ulps_by_condition <= goals.fast_ulps_by_condition),
      fmt::format("t {:.3g} times its condition off in the fast tier", row.fast_ulps_by_condition));
  return broken;
}

std::vector<Family> all_families() {
  std::vector<Family> all;
  for (auto* make : {round_families, flat_families, quadric_families, mesh_families, spawn_families,
                     accelerator_families, law_families, symmetry_families, normal_families}) {
    std::vector<Family> some = make();
    all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  }
  return all;
}

}  // namespace raywalk::check
