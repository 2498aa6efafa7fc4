#include "view/bug_panel.h"

#include "view/bug_text.h"
#include "view/text.h"

#include <algorithm>
#include <span>

namespace raywalk {

namespace {

std::string line_text(Line line) { return std::string(pseudocode_of(line).text); }

}  // namespace

BugPanel bug_panel(const State& state) {
  const BugSitting& bugs = state.bugs;
  const Language language = state.language;
  const auto say = [&](BugText id, const std::vector<std::string>& arguments = {}) {
    return fill(id, language, arguments);
  };
  BugPanel panel;
  const auto found = std::count(bugs.ends.begin(), bugs.ends.end(), BugEnd::found);
  if (found > 0) panel.tally = say(BugText::tally, {std::to_string(found), std::to_string(all_faults.size())});
  panel.hunting = bugs.hunt.has_value();
  if (!bugs.hunt) {
    panel.heading = say(BugText::title);
    panel.said.push_back({{}, say(BugText::intro)});
    for (std::size_t i = 0; i < bugs.ends.size(); ++i) panel.rows.push_back({static_cast<int>(i) + 1, bugs.ends[i]});
    return panel;
  }
  const BugHunt& hunt = *bugs.hunt;
  const auto know = [&](FaultText id) { return std::string(text(FaultTextOf{state.bug->fault, id}, language)); };
  panel.heading = hunt.surprise && hunt.end == BugEnd::open ? say(BugText::surprise_title)
                                                            : say(BugText::number, {std::to_string(hunt.number)});
  panel.said.push_back({say(BugText::seen), know(FaultText::symptom)});
  switch (hunt.end) {
    case BugEnd::open:
      panel.said.push_back({{}, say(BugText::task, {std::to_string(hunt.pixel)})});
      panel.marked = hunt.marked ? say(BugText::line_marked, {line_text(*hunt.marked)}) : say(BugText::no_line_marked);
      panel.can_judge = hunt.marked.has_value();
      panel.can_give_up = true;
      if (!hunt.acquitted) return panel;
      panel.verdict = say(BugText::not_right, {std::string(text(DutyOf{*hunt.acquitted}, language))});
      panel.learnt.push_back({say(BugText::hint), know(FaultText::hint)});
      return panel;
    case BugEnd::found:
    case BugEnd::given_up:
      panel.is_right = hunt.end == BugEnd::found;
      panel.verdict = say(panel.is_right ? BugText::right : BugText::was, {line_text(faulty_line(state.bug->fault))});
      panel.learnt = {{say(BugText::wrong), know(FaultText::wrong)}, {say(BugText::cure), know(FaultText::cure)}};
      if (!other_rays(state).empty())
        panel.learnt.push_back({{}, say(state.bug->mended ? BugText::other_rays_broken : BugText::other_rays_whole)});
      panel.can_mend = true;
      return panel;
  }
  return panel;
}

int surprising_bug(const BugSitting& bugs, unsigned draw) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < bugs.ends.size(); ++i)
    if (bugs.ends[i] != BugEnd::found) numbers.push_back(static_cast<int>(i) + 1);
  if (numbers.empty()) return 1 + static_cast<int>(draw % bugs.ends.size());
  return numbers[draw % numbers.size()];
}

std::vector<RayRecord> other_rays(const State& state) {
  const std::optional<Bug>& bug = state.bug;
  if (!bug || !bug->known || !bug->other) return {};
  const int pixel = state.timeline->current_pixel(state.position);
  if (pixel < 0 || pixel >= static_cast<int>(bug->other->pixels().size())) return {};
  const auto rays_of = [&](const Timeline& timeline) {
    const auto [first, last] = timeline.rays_of_pixel(pixel);
    return std::span(timeline.rays()).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
  };
  const auto own = rays_of(*state.timeline);
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
  if (!state.bug) return {};
  return std::string(text(state.bug->mended ? BugText::banner_mended : BugText::banner, state.language));
}

}  // namespace raywalk
