
#include "view/bugs/bug_panel.h"
#include "view/plan/plan_view.h"
#include "view/text/choice_text.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace raywalk {

namespace {

/// Whether one of these is long enough for the plan.
bool any_is_seen(const State& state, const std::vector<RayRecord>& rays) {
  constexpr double few = 3;
  const auto pixels = [&](const Vec3d& at) { return to_pixels(state.plan.camera, state.plan.viewport, plan(at)); };
  return std::any_of(rays.begin(), rays.end(), [&](const RayRecord& ray) {
    return ray.endless || length(pixels(ray.end) - pixels(ray.origin)) > few;
  });
}

}  // namespace

std::string_view duty_of(Line line) {
  constexpr std::array<std::string_view, line_count> duties{
      "duty.for_each_pixel",  "duty.form_primary_ray", "duty.find_closest_intersection", "duty.if_intersect_something",
      "duty.shade_final",     "duty.put_final_shade",  "duty.form_shadow_ray",           "duty.find_intersection",
      "duty.if_reflective",   "duty.form_reflect_ray", "duty.find_reflect_intersect",    "duty.shade_reflect",
      "duty.if_transparent",  "duty.form_refract_ray", "duty.find_refract_intersect",    "duty.shade_refract",
      "duty.compute_rtnshade"};
  const auto number = static_cast<std::size_t>(line);
  return number < duties.size() ? duties[number] : std::string_view();
}

BugPanel bug_panel(const State& state) {
  const BugRoom& bugs = state.bugs;
  const Language language = state.appearance.language;
  const auto say = [&](std::string_view id, const TextArguments& arguments = {}) {
    return fill(id, language, arguments);
  };
  BugPanel panel;
  const auto found = std::count(bugs.ends.begin(), bugs.ends.end(), BugEnd::found);
  if (found > 0) panel.tally = say("bug.tally", {{"found", found}, {"all", values_of<Fault>.size()}});
  panel.hunting = bugs.hunt.has_value();
  if (!bugs.hunt) {
    panel.heading = say("bug.title");
    panel.said.push_back({{}, say("bug.intro")});
    for (std::size_t i = 0; i < bugs.ends.size(); ++i) {
      BugRow row{static_cast<int>(i) + 1, bugs.ends[i], {}};
      if (const Integrator its = integrator_of(values_of<Fault>[i]); its != Integrator::automatic)
        row.of = text(its, language);
      row.chosen = bugs.chosen == row.number;
      panel.rows.push_back(std::move(row));
    }
    return panel;
  }
  const BugHunt& hunt = *bugs.hunt;
  const auto know = [&](std::string_view what) {
    return say(fmt::format("fault.{}.{}", name_of(state.walk.bug->fault), what));
  };
  panel.heading = hunt.surprise && hunt.end == BugEnd::open ? say("bug.surprise_title")
                                                            : say("bug.number", {{"number", hunt.number}});
  panel.said.push_back({say("bug.seen"), know("symptom")});
  switch (hunt.end) {
    case BugEnd::open:
      panel.said.push_back({{}, say(hunt.from_start ? "bug.task_from_start" : "bug.task", {{"pixel", hunt.pixel}})});
      panel.marked =
          hunt.marked ? say("bug.line_marked", {{"line", line_told(state, *hunt.marked)}}) : say("bug.no_line_marked");
      panel.can_judge = hunt.marked.has_value();
      panel.can_give_up = true;
      if (!hunt.acquitted) return panel;
      if (const std::string_view duty = duty_of(*hunt.acquitted); !duty.empty())
        panel.verdict = say("bug.not_right", {{"duty", say(duty)}});
      else
        panel.verdict = say("bug.not_right_line", {{"line", line_told(state, *hunt.acquitted)}});
      panel.learnt.push_back({say("bug.hint"), know("hint")});
      return panel;
    case BugEnd::found:
    case BugEnd::given_up:
      panel.is_right = hunt.end == BugEnd::found;
      panel.verdict = say(panel.is_right ? "bug.right" : "bug.was",
                          {{"line", line_told(state, faulty_line(state.walk.bug->fault))}});
      panel.learnt = {{say("bug.wrong"), know("wrong")}, {say("bug.cure"), know("cure")}};
      if (const std::vector<RayRecord> others = other_rays(state); !others.empty() && !shows_lines(state)) {
        const bool mended = state.walk.bug->mended, seen = any_is_seen(state, others);
        if (seen || mended)
          panel.learnt.push_back({{},
                                  say(!seen    ? "bug.other_rays_short"
                                      : mended ? "bug.other_rays_broken"
                                               : "bug.other_rays_whole")});
      }
      return panel;
  }
  return panel;
}

int surprising_bug(const BugRoom& bugs, unsigned draw) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < bugs.ends.size(); ++i)
    if (bugs.ends[i] != BugEnd::found) numbers.push_back(static_cast<int>(i) + 1);
  if (numbers.empty()) return 1 + static_cast<int>(draw % bugs.ends.size());
  return numbers[draw % numbers.size()];
}

std::vector<RayRecord> other_rays(const State& state) {
  const std::optional<Bug>& bug = state.walk.bug;
  if (!bug || !bug->known || !bug->other) return {};
  const int pixel = state.walk.timeline->current_pixel(state.walk.position);
  if (pixel < 0 || pixel >= static_cast<int>(bug->other->pixels().size())) return {};
  const auto rays_of = [&](const Timeline& timeline) {
    const auto [first, last] = timeline.rays_of_pixel(pixel);
    return std::span(timeline.rays()).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
  };
  const auto own = rays_of(*state.walk.timeline);
  std::vector<RayRecord> others;
  for (const RayRecord& ray : rays_of(*bug->other)) {
    const auto same_way = [&](const RayRecord& a) {
      return a.formed && a.kind == ray.kind && a.origin == ray.origin && a.end == ray.end && a.endless == ray.endless;
    };
    if (ray.formed && std::none_of(own.begin(), own.end(), same_way)) others.push_back(ray);
  }
  return others;
}

std::string bug_banner(const State& state) {
  if (!state.walk.bug) return {};
  return std::string(text(state.walk.bug->mended ? "bug.banner_mended" : "bug.banner", state.appearance.language));
}

}  // namespace raywalk
