#include "view/walk/code_panel.h"
#include "timeline/stops.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/fault.h"
#include "view/walk/lit.h"

namespace raywalk {

namespace {

Blame blame_of(const State& state, Line line) {
  const std::optional<Bug>& bug = state.walk.bug;
  if (bug && bug->known && faulty_line(bug->fault) == line) return bug->mended ? Blame::none : Blame::at_fault;
  return marked_line(state) == line ? Blame::marked : Blame::none;
}

/// The procedure that is shown below the one that runs first: the one under way, or the one that is called next.
Procedure called_procedure(const Timeline& timeline, int position) {
  const Procedure first = timeline.pseudocode().lines.front().procedure;
  const Event* ran = timeline.just_run(position);
  if (ran != nullptr && pseudocode_of(ran->line).procedure != first) return pseudocode_of(ran->line).procedure;
  for (int at = position; at < timeline.steps() && at < position + 8; ++at) {
    const Procedure next = pseudocode_of(timeline.event(at).line).procedure;
    if (next != first) return next;
  }
  return timeline.pseudocode().lines.back().procedure;
}

CodeRow row_of(const State& state, const PseudocodeLine& line) {
  CodeRow row{line.line, line.indent, std::string(text(line.line, state.appearance.code_language()))};
  const Event* just_run = state.walk.timeline->just_run(state.walk.position);
  const Event* next = state.walk.timeline->next(state.walk.position);
  row.just_run = just_run != nullptr && just_run->line == line.line;
  row.next = next != nullptr && next->line == line.line;
  row.breakpoint = state.walk.breakpoints.is_before(line.line);
  row.blame = blame_of(state, line.line);
  row.hovered = state.plan.hovered_line == line.line;
  if (state.plan.hovered_ray >= 0)
    row.hovered =
        row.hovered ||
        concerns(line.line, state.walk.timeline->rays()[static_cast<std::size_t>(state.plan.hovered_ray)].kind);
  return row;
}

}  // namespace

CodePanel code_panel(const State& state) {
  CodePanel panel;
  const Timeline& timeline = *state.walk.timeline;
  const Event* just_run = timeline.just_run(state.walk.position);
  const Pseudocode& code = timeline.pseudocode();
  const Procedure procedures[] = {code.lines.front().procedure, called_procedure(timeline, state.walk.position)};
  for (std::size_t i = 0; i < panel.boxes.size(); ++i) {
    CodeBox& box = panel.boxes[i];
    box.procedure = procedures[i];
    box.title = text(box.procedure, state.appearance.code_language());
    if (just_run != nullptr && pseudocode_of(just_run->line).procedure == box.procedure)
      box.depth = depth_after(*just_run);
    if (box.depth.value_or(0) > 0)
      box.badge = fill(code.recursive ? "code.depth_badge" : "code.rays_badge", state.appearance.language,
                       {{"number", *box.depth}});
    for (const PseudocodeLine& line : code.lines)
      if (line.procedure == box.procedure && timeline.walks(line.line)) box.rows.push_back(row_of(state, line));
  }
  return panel;
}

}  // namespace raywalk
