// The sentence, the legend, the counts, and the questions.

#include "view/panels.h"
#include "view/plan_geometry.h"
#include "view/plan_view.h"
#include "view/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace raywalk {

namespace {

template <class Id>
std::string str(const State& state, Id id) {
  return std::string(text(id, state.language));
}

std::string object_name(const State& state, int index) {
  return state.scene().objects[static_cast<std::size_t>(index)].name;
}

std::string ray_text(const State& state, int index) {
  const Timeline& timeline = *state.timeline;
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(index)];
  std::string what;
  if (ray.parent < 0) {
    const int column = timeline.pixels()[static_cast<std::size_t>(ray.pixel)].column;
    what = timeline.of_strip()
               ? fill(TextId::ray_of_cell, state.language,
                      {std::string(text(ray.kind, state.language)), std::to_string(column)})
               : fill(TextId::ray_of_pixel, state.language, {std::string(text(ray.kind, state.language))});
  } else {
    const int from = timeline.rays()[static_cast<std::size_t>(ray.parent)].object;
    what = fill(TextId::ray_from, state.language,
                {std::string(text(ray.kind, state.language)), from < 0 ? "" : object_name(state, from)});
  }
  const bool known = !ray.formed || ray.found_at <= state.position;
  return known ? what + ": " + std::string(text(ray.ending, state.language)) : what;
}

/// The name of an object or a light, or EYE or SCREEN.
std::string short_name(const State& state, const Target& target) {
  if (target.kind == TargetKind::light) return state.scene().lights[static_cast<std::size_t>(target.index)].name;
  if (detail::belongs_to_object(target)) return object_name(state, target.index);
  return str(state, target.kind == TargetKind::eye || target.kind == TargetKind::view_direction ? TextId::eye
                                                                                                : TextId::screen);
}

std::string cell_text(const State& state, int cell) {
  const Timeline& timeline = *state.timeline;
  std::optional<Rgbd> shade;
  for (std::size_t i = 0; timeline.of_strip() && i < timeline.pixels().size(); ++i) {
    const PixelRecord& pixel = timeline.pixels()[i];
    if (pixel.column == cell && timeline.pixel_done(static_cast<int>(i), state.position)) shade = pixel.mean;
  }
  if (shade)
    return fill(TextId::cell_with_shade, state.language, {std::to_string(cell), colour_text(*shade, state.language)});
  return fill(TextId::cell_number, state.language, {std::to_string(cell)});
}

/// Why the plan does not show what one may look for, and how to get it back; empty when it does.
std::string view_hint(const State& state) {
  constexpr double tiny = 0.15;  // of the size that fits
  if (state.camera.pixels_per_unit < tiny * fitted(state).pixels_per_unit) return str(state, PanelText::shown_tiny);
  if (!state.selected || !exists(state, state.selected) || state.drag) return {};
  const Vec2d at = to_pixels(state.camera, state.viewport, detail::place_of(state, state.selected, state.viewport));
  const bool inside = at.x >= 0 && at.y >= 0 && at.x <= state.viewport.width && at.y <= state.viewport.height;
  return inside ? std::string() : fill(PanelText::out_of_view, state.language, {short_name(state, state.selected)});
}

std::string move_sentence(const State& state) {
  std::string said = str(state, PanelText::first_step_move);
  const int steps = state.timeline->steps();
  if (const std::string hint = view_hint(state); !hint.empty()) return hint;
  if (state.position == 0) return said;
  if (state.position == steps) return said + " " + str(state, PanelText::walk_stands_at_end);
  return said + " " +
         fill(PanelText::walk_stands_at, state.language, {std::to_string(state.position), std::to_string(steps)});
}

}  // namespace

std::string target_text(const State& state, const Target& target) {
  if (!exists(state, target)) return {};
  const bool moving = state.mode == Mode::move;
  switch (target.kind) {
    case TargetKind::nothing:
      return {};
    case TargetKind::eye:
      return str(state, moving ? TextId::drag_eye : TextId::eye);
    case TargetKind::view_direction:
      return str(state, TextId::drag_view_direction);
    case TargetKind::screen_height:
      return str(state, TextId::drag_screen_height);
    case TargetKind::screen_distance:
      return str(state, TextId::drag_screen_distance);
    case TargetKind::cell:
      return moving ? str(state, TextId::drag_screen_distance) : cell_text(state, target.index);
    case TargetKind::object:
    case TargetKind::light: {
      const std::string name = target.kind == TargetKind::object
                                   ? object_name(state, target.index)
                                   : state.scene().lights[static_cast<std::size_t>(target.index)].name;
      return moving ? fill(TextId::drag_move, state.language, {name}) : name;
    }
    case TargetKind::radius:
      return fill(TextId::drag_radius, state.language, {object_name(state, target.index)});
    case TargetKind::corner:
      return fill(TextId::drag_corner, state.language, {object_name(state, target.index)});
    case TargetKind::edge:
      return fill(TextId::drag_edge, state.language, {object_name(state, target.index)});
    case TargetKind::rotation:
      return fill(TextId::drag_rotation, state.language, {object_name(state, target.index)});
    case TargetKind::ray:
      return ray_text(state, target.index);
  }
  return {};
}

std::string sentence(const State& state) {
  switch (state.mode) {
    case Mode::move:
      return move_sentence(state);
    case Mode::help:
      return str(state, PanelText::first_step_help);
    case Mode::trace:
      break;
  }
  if (state.position == 0) return str(state, PanelText::first_step_trace);
  const std::string done = sentence_of(describe(state.scene(), *state.timeline, state.position), state.language);
  if (state.position < state.timeline->steps()) return done;
  return done + " " + str(state, state.walk ? PanelText::after_last_step_of_pixel : PanelText::after_last_step);
}

Legend legend(const State& state) {
  Legend legend;
  const auto row = [&](RayKind kind, PanelText in_short, PanelText meaning) {
    legend.rays.push_back({kind, ray_style(state.theme, kind), std::string(text(kind, state.language)),
                           str(state, in_short), str(state, meaning)});
  };
  row(RayKind::primary, PanelText::short_primary, PanelText::legend_primary);
  row(RayKind::shadow, PanelText::short_shadow, PanelText::legend_shadow);
  row(RayKind::reflect, PanelText::short_reflect, PanelText::legend_reflect);
  row(RayKind::refract, PanelText::short_refract, PanelText::legend_refract);
  const auto sign = [&](Ending ending, PanelText meaning) {
    legend.signs.push_back({std::string(symbol(ending)), str(state, meaning)});
  };
  sign(Ending::hit, PanelText::sign_hit);
  sign(Ending::missed, PanelText::sign_missed);
  sign(Ending::blocked, PanelText::sign_blocked);
  sign(Ending::reached_light, PanelText::sign_reached_light);
  for (const Ending limit : {Ending::depth, Ending::threshold, Ending::total_internal_reflection, Ending::facing_away})
    legend.signs.push_back({std::string(symbol(limit)), std::string(text(limit, state.language))});
  legend.signs.push_back({"-|", str(state, PanelText::sign_stub)});
  legend.signs.push_back({"->", str(state, PanelText::sign_normal)});
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
  return counts;
}

std::string status_line(const State& state) {
  const Counts now = counts(state);
  int rays = 0;
  for (const int formed : now.formed) rays += formed;
  const int cell = current_cell(state);
  const std::string pixel = state.walk ? std::to_string(state.walk->column) + "," + std::to_string(state.walk->row)
                            : cell < 0 ? str(state, PanelText::status_none)
                                       : std::to_string(cell);
  return fill(PanelText::status, state.language,
              {std::to_string(now.position), std::to_string(now.steps), pixel, std::to_string(rays)});
}

std::string short_status_line(const State& state) {
  return fill(PanelText::status_short, state.language,
              {std::to_string(state.position), std::to_string(state.timeline->steps())});
}

std::string widest_status_line(const State& state, bool in_short) {
  // As many digits as most walks have, so that an edit that makes the walk a little longer changes nothing.
  const auto digits = [](int number, std::size_t least) {
    return std::string(std::max(std::to_string(number).size(), least), '0');
  };
  const std::string steps = digits(state.timeline->steps(), 4);
  if (in_short) return fill(PanelText::status_short, state.language, {steps, steps});
  return fill(PanelText::status, state.language,
              {steps, steps, state.walk ? "0000,0000" : digits(state.scene().camera.screen.cells - 1, 2),
               digits(static_cast<int>(state.timeline->rays().size()), 3)});
}

namespace {

/// A lesson as the list names it: "5 Refraction and total reflection".
std::string lesson_title(const State& state, const std::string& name) {
  const std::vector<LessonEntry>& list = state.lessons.list;
  const auto entry = std::find_if(list.begin(), list.end(), [&](const LessonEntry& each) { return each.name == name; });
  if (entry == list.end()) return name;
  const auto title = entry->titles.find(state.language);
  return fmt::format("{} {}", entry - list.begin() + 1, title == entry->titles.end() ? name : title->second);
}

}  // namespace

QuestionPanel question_panel(const State& state) {
  using action::Answer;
  QuestionPanel panel;
  if (!state.question) return panel;
  const Question& question = *state.question;
  const auto choice = [&](Answer answer, TextId label) { panel.choices.push_back({answer, str(state, label)}); };
  const std::string file =
      state.path.empty() ? str(state, TextId::untitled) : std::filesystem::path(state.path).filename().string();
  switch (question.kind) {
    case Question::Kind::unsaved:
      switch (question.intent) {
        case Intent::new_scene:
          panel.text = fill(TextId::ask_unsaved_new, state.language, {file});
          break;
        case Intent::lesson:
          panel.text = fill(TextId::ask_unsaved_open, state.language, {file, lesson_title(state, question.path)});
          break;
        case Intent::open:
          panel.text = fill(TextId::ask_unsaved_open, state.language, {file, question.path});
          break;
        case Intent::leave_lesson:
          panel.text = str(state, TextId::ask_unsaved_lesson);
          break;
        case Intent::quit:
          panel.text = fill(TextId::ask_unsaved_quit, state.language, {file});
          break;
      }
      choice(Answer::save, TextId::answer_save);
      choice(Answer::discard, TextId::answer_discard);
      choice(Answer::cancel, TextId::answer_cancel);
      break;
    case Question::Kind::recover:
      panel.text =
          question.path == state.path
              ? fill(TextId::ask_recover, state.language, {file, question.when})
              : fill(TextId::ask_recover_other, state.language,
                     {question.path.empty() ? str(state, TextId::untitled) : question.path, question.when, file});
      choice(Answer::recover, TextId::answer_recover);
      choice(Answer::cancel, TextId::answer_later);
      choice(Answer::discard, TextId::answer_throw_away);
      break;
    case Question::Kind::overwrite:
      panel.text = fill(TextId::ask_overwrite, state.language, {question.path});
      choice(Answer::cancel, TextId::answer_cancel);
      choice(Answer::save, TextId::answer_overwrite);
      break;
  }
  return panel;
}

}  // namespace raywalk
