// The sentence, the legend, the counts, and the questions.

#include "view/panels.h"
#include "view/plan_view.h"
#include "view/text.h"

#include <filesystem>

namespace raywalk {

namespace {

std::string str(TextId id) { return std::string(text(id)); }

std::string object_name(const State& state, int index) {
  return state.scene().objects[static_cast<std::size_t>(index)].name;
}

std::string ray_text(const State& state, int index) {
  const Timeline& timeline = *state.timeline;
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(index)];
  std::string what;
  if (ray.parent < 0) {
    const int column = timeline.pixels()[static_cast<std::size_t>(ray.pixel)].column;
    what = fill(TextId::ray_of_cell, {std::string(text(ray.kind)), std::to_string(column + 1)});
  } else {
    const int from = timeline.rays()[static_cast<std::size_t>(ray.parent)].object;
    what = fill(TextId::ray_from, {std::string(text(ray.kind)), from < 0 ? "" : object_name(state, from)});
  }
  const bool known = !ray.formed || ray.found_at <= state.position;
  return known ? what + ": " + std::string(text(ray.ending)) : what;
}

std::string cell_text(const State& state, int cell) {
  const Timeline& timeline = *state.timeline;
  for (std::size_t i = 0; i < timeline.pixels().size(); ++i) {
    const PixelRecord& pixel = timeline.pixels()[i];
    if (pixel.column == cell && timeline.pixel_done(static_cast<int>(i), state.position))
      return fill(TextId::cell_with_shade, {std::to_string(cell + 1), colour_text(pixel.shade)});
  }
  return fill(TextId::cell_number, {std::to_string(cell + 1)});
}

}  // namespace

std::string target_text(const State& state, const Target& target) {
  if (!exists(state, target)) return {};
  const bool moving = state.mode == Mode::move;
  switch (target.kind) {
    case TargetKind::nothing:
      return {};
    case TargetKind::eye:
      return str(moving ? TextId::drag_eye : TextId::eye);
    case TargetKind::view_direction:
      return str(TextId::drag_view_direction);
    case TargetKind::screen_height:
      return str(TextId::drag_screen_height);
    case TargetKind::screen_distance:
      return str(TextId::drag_screen_distance);
    case TargetKind::cell:
      return moving ? str(TextId::drag_screen_distance) : cell_text(state, target.index);
    case TargetKind::object:
    case TargetKind::light: {
      const std::string name = target.kind == TargetKind::object
                                   ? object_name(state, target.index)
                                   : state.scene().lights[static_cast<std::size_t>(target.index)].name;
      return moving ? fill(TextId::drag_move, {name}) : name;
    }
    case TargetKind::radius:
      return fill(TextId::drag_radius, {object_name(state, target.index)});
    case TargetKind::corner:
      return fill(TextId::drag_corner, {object_name(state, target.index)});
    case TargetKind::edge:
      return fill(TextId::drag_edge, {object_name(state, target.index)});
    case TargetKind::rotation:
      return fill(TextId::drag_rotation, {object_name(state, target.index)});
    case TargetKind::ray:
      return ray_text(state, target.index);
  }
  return {};
}

std::string sentence(const State& state) {
  switch (state.mode) {
    case Mode::move:
      return str(TextId::first_step_move);
    case Mode::help:
      return str(TextId::first_step_help);
    case Mode::trace:
      break;
  }
  if (state.position == 0) return str(TextId::first_step_trace);
  const std::string done = sentence_of(describe(state.scene(), *state.timeline, state.position));
  return state.position < state.timeline->steps() ? done : done + " " + str(TextId::after_last_step);
}

Legend legend(const State& state) {
  Legend legend;
  const auto row = [&](RayKind kind, TextId meaning) {
    legend.rays.push_back({kind, ray_style(state.theme, kind), std::string(text(kind)), str(meaning)});
  };
  row(RayKind::primary, TextId::legend_primary);
  row(RayKind::shadow, TextId::legend_shadow);
  row(RayKind::reflect, TextId::legend_reflect);
  row(RayKind::refract, TextId::legend_refract);
  const auto sign = [&](Ending ending, TextId meaning) {
    legend.signs.push_back({std::string(symbol(ending)), str(meaning)});
  };
  sign(Ending::hit, TextId::sign_hit);
  sign(Ending::missed, TextId::sign_missed);
  sign(Ending::blocked, TextId::sign_blocked);
  sign(Ending::reached_light, TextId::sign_reached_light);
  for (const Ending limit : {Ending::depth, Ending::threshold, Ending::facing_away})
    legend.signs.push_back({std::string(symbol(limit)), std::string(text(limit))});
  legend.signs.push_back({"-|", str(TextId::sign_stub)});
  legend.signs.push_back({"->", str(TextId::sign_normal)});
  return legend;
}

Counts counts(const State& state) {
  const Timeline& timeline = *state.timeline;
  Counts counts;
  counts.position = state.position;
  counts.steps = timeline.steps();
  counts.pixel = timeline.current_pixel(state.position) + 1;
  counts.pixels = static_cast<int>(timeline.pixels().size());
  if (const Event* just_run = timeline.just_run(state.position)) counts.depth = just_run->depth;
  for (const RayRecord& ray : timeline.rays_at(state.position)) {
    if (ray.formed) ++counts.formed[static_cast<std::size_t>(ray.kind)];
    if (ray.found_at <= state.position) ++counts.ended[static_cast<std::size_t>(ray.ending)];
  }
  // Total internal reflection leaves no ray and no stub, only a decision.
  for (int i = 0; i < state.position; ++i)
    if (const auto* decided = std::get_if<Decided>(&timeline.event(i).detail); decided != nullptr && decided->why)
      ++counts.ended[static_cast<std::size_t>(*decided->why)];
  return counts;
}

std::string status_line(const State& state) {
  const Counts now = counts(state);
  int rays = 0;
  for (const int formed : now.formed) rays += formed;
  return fill(TextId::status, {std::to_string(now.position), std::to_string(now.steps), std::to_string(now.pixel),
                               std::to_string(now.pixels), std::to_string(rays)});
}

QuestionPanel question_panel(const State& state) {
  using action::Answer;
  QuestionPanel panel;
  if (!state.question) return panel;
  const Question& question = *state.question;
  const auto choice = [&](Answer answer, TextId label) { panel.choices.push_back({answer, str(label)}); };
  const std::string file =
      state.path.empty() ? str(TextId::untitled) : std::filesystem::path(state.path).filename().string();
  switch (question.kind) {
    case Question::Kind::unsaved:
      switch (question.intent) {
        case Intent::new_scene:
          panel.text = fill(TextId::ask_unsaved_new, {file});
          break;
        case Intent::open:
          panel.text = fill(TextId::ask_unsaved_open, {file, question.path});
          break;
        case Intent::quit:
          panel.text = fill(TextId::ask_unsaved_quit, {file});
          break;
      }
      choice(Answer::save, TextId::answer_save);
      choice(Answer::discard, TextId::answer_discard);
      choice(Answer::cancel, TextId::answer_cancel);
      break;
    case Question::Kind::recover:
      panel.text = fill(TextId::ask_recover, {question.path.empty() ? str(TextId::untitled) : question.path});
      choice(Answer::recover, TextId::answer_recover);
      choice(Answer::discard, TextId::answer_throw_away);
      break;
    case Question::Kind::overwrite:
      panel.text = fill(TextId::ask_overwrite, {question.path});
      choice(Answer::cancel, TextId::answer_cancel);
      choice(Answer::save, TextId::answer_overwrite);
      break;
  }
  return panel;
}

}  // namespace raywalk
