#include "view/walk/status.h"

#include "view/action.h"
#include "view/document/properties.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/text/shown.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace raywalk {

namespace {

template <class Id>
std::string str(const State& state, Id id) {
  return std::string(text(id, state.appearance.language));
}

std::string ray_text(const State& state, int index) {
  const Timeline& timeline = *state.walk.timeline;
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(index)];
  std::string what;
  if (timeline.part_of(index) == index) {
    const BeamRecord& part = timeline.beams()[static_cast<std::size_t>(ray.beam)];
    const std::string sees = ray.object < 0 ? str(state, ray.ending) : object_name(state, ray.object);
    const bool cones = timeline.of_cones();
    if (part.begun_at > state.walk.position)
      return fill(cones ? "pointed.cone_part" : "pointed.part", state.appearance.language, {{"object", sees}});
    return fill(cones ? "pointed.cone_part_covers" : "pointed.part_covers", state.appearance.language,
                {{"object", sees}, {"coverage", coverage_text(state, part)}});
  }
  if (ray.parent < 0) {
    const int column = timeline.pixels()[static_cast<std::size_t>(ray.pixel)].column;
    what = timeline.of_strip()
               ? fill("pointed.ray_of_cell", state.appearance.language,
                      {{"ray", kind_name(state, ray.kind)}, {"cell", column}})
               : fill("pointed.ray_of_pixel", state.appearance.language, {{"ray", kind_name(state, ray.kind)}});
  } else {
    const int from = timeline.rays()[static_cast<std::size_t>(ray.parent)].object;
    what = fill("pointed.ray_from", state.appearance.language,
                {{"ray", kind_name(state, ray.kind)}, {"object", from < 0 ? "" : object_name(state, from)}});
  }
  const bool known = !ray.formed || ray.found_at <= state.walk.position;
  return known ? what + ": " + std::string(text(ray.ending, state.appearance.language)) : what;
}

/// The name of an object or a light, or EYE or SCREEN.
std::string short_name(const State& state, const Target& target) {
  if (target.kind == TargetKind::light) return light_name(state, target.index);
  if (belongs_to_object(target)) return object_name(state, target.index);
  return str(state, target.kind == TargetKind::eye || target.kind == TargetKind::view_direction ? "object.eye"
                                                                                                : "object.screen");
}

/// Why the plan does not show the scene well, and how to fix that; empty if it does.
std::string view_hint(const State& state) {
  constexpr double tiny = 0.15;  // of the size that fits
  if (state.plan.camera.pixels_per_unit < tiny * fitted(state).pixels_per_unit) return str(state, "plan.shown_tiny");
  if (!state.plan.selected || !exists(state, state.plan.selected) || state.plan.drag) return {};
  return is_in_view(state, state.plan.selected)
             ? std::string()
             : fill("plan.out_of_view", state.appearance.language, {{"name", short_name(state, state.plan.selected)}});
}

/// The first few properties of what is selected, or the one that a handle changes, where there is no room for the rest.
std::string values_of_selected(const State& state) {
  constexpr int most = 3;
  const Target& target = state.plan.selected;
  const std::string own = target.kind == TargetKind::corner ? fmt::format("corners.{}", target.part + 1)
                          : target.kind == TargetKind::radius || target.kind == TargetKind::light_radius ? "radius"
                                                                                                         : "";
  std::string said = properties_title(state);
  int count = 0;
  for (const PropertyText& each : property_texts(state, target)) {
    const bool is_wanted =
        own.empty() ? each.key != "name" && each.words.empty() && !each.value.empty() : each.key == own;
    if (!is_wanted) continue;
    if (count == most) return said + " … " + str(state, "status.other_fields");
    said += fmt::format("{}{} {}", count++ == 0 ? ": " : " · ", each.label, each.value);
  }
  return said;
}

std::string move_sentence(const State& state) {
  std::string said = str(state, "status.first_step_move");
  const int steps = state.walk.timeline->steps();
  if (const std::string hint = view_hint(state); !hint.empty()) return hint;
  // Focus folds their fields.
  if (state.focus.on && shows_properties(state)) return values_of_selected(state);
  if (state.walk.position == 0) return said;
  if (state.walk.position == steps) return said + " " + str(state, "status.walk_stands_at_end");
  return said + " " +
         fill("status.walk_stands_at", state.appearance.language,
              {{"position", state.walk.position}, {"steps", steps}});
}

}  // namespace

std::string cell_text(const State& state, int cell, const std::optional<Rgbd>& shade) {
  const Language language = state.appearance.language;
  return shade ? fill("pointed.cell_with_shade", language, {{"cell", cell}, {"colour", colour_text(*shade, language)}})
               : fill("pointed.cell", language, {{"cell", cell}});
}

std::string target_text(const State& state, const Target& target) {
  if (!exists(state, target)) return {};
  const bool moving = state.walk.mode == Mode::move;
  switch (target.kind) {
    case TargetKind::nothing:
      return {};
    case TargetKind::eye:
      return str(state, moving ? "drag.eye" : "object.eye");
    case TargetKind::view_direction:
      return str(state, "drag.view_direction");
    case TargetKind::screen_height:
      return str(state, "drag.screen_height");
    case TargetKind::screen_distance:
      return str(state, "drag.screen_distance");
    case TargetKind::cell:
      return moving ? str(state, "drag.screen_distance")
                    : cell_text(state, target.index, shades_shown(state)[static_cast<std::size_t>(target.index)]);
    case TargetKind::object:
    case TargetKind::light: {
      const std::string name =
          target.kind == TargetKind::object ? object_name(state, target.index) : light_name(state, target.index);
      return moving ? fill("drag.move", state.appearance.language, {{"name", name}}) : name;
    }
    case TargetKind::radius:
      return fill("drag.radius", state.appearance.language, {{"name", object_name(state, target.index)}});
    case TargetKind::light_radius:
      return fill("drag.radius", state.appearance.language, {{"name", light_name(state, target.index)}});
    case TargetKind::corner:
      return fill("drag.corner", state.appearance.language, {{"name", object_name(state, target.index)}});
    case TargetKind::edge:
      return fill("drag.edge", state.appearance.language, {{"name", object_name(state, target.index)}});
    case TargetKind::rotation:
      return fill("drag.rotation", state.appearance.language, {{"name", object_name(state, target.index)}});
    case TargetKind::ray:
      return ray_text(state, target.index);
  }
  return {};
}

std::string sentence(const State& state) {
  switch (state.walk.mode) {
    case Mode::move:
      return move_sentence(state);
    case Mode::help:
      return str(state, "status.first_step_help");
    case Mode::trace:
      break;
  }
  if (state.walk.position == 0)
    return str(state, question_waits(state) ? "lesson.predict_first" : "status.first_step_trace");
  const std::string done = sentence_of(
      state.scene(), describe(state.scene(), *state.walk.timeline, state.walk.position), state.appearance.language);
  if (state.walk.position < state.walk.timeline->steps()) return done;
  return done + " " + str(state, state.walk.pixel ? "status.after_last_step_of_pixel" : "status.after_last_step");
}

Counts counts(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  Counts counts;
  counts.position = state.walk.position;
  counts.steps = timeline.steps();
  counts.pixel = timeline.current_pixel(state.walk.position) + 1;
  counts.pixels = static_cast<int>(timeline.pixels().size());
  if (const Event* just_run = timeline.just_run(state.walk.position)) counts.depth = just_run->depth;
  for (const RayRecord& ray : timeline.rays_at(state.walk.position)) {
    if (ray.formed) ++counts.formed[static_cast<std::size_t>(ray.kind)];
    if (ray.found_at <= state.walk.position) ++counts.ended[static_cast<std::size_t>(ray.ending)];
  }
  return counts;
}

std::string status_line(const State& state) {
  const Counts now = counts(state);
  int rays = 0;
  for (const int formed : now.formed) rays += formed;
  const int cell = current_cell(state);
  const std::string pixel = state.walk.pixel
                                ? std::to_string(state.walk.pixel->column) + "," + std::to_string(state.walk.pixel->row)
                            : cell < 0 ? str(state, "status.no_pixel")
                                       : std::to_string(cell);
  return fill("status.whole", state.appearance.language,
              {{"position", now.position}, {"steps", now.steps}, {"pixel", pixel}, {"rays", rays}});
}

std::string short_status_line(const State& state) {
  return fill("status.short", state.appearance.language,
              {{"position", state.walk.position}, {"steps", state.walk.timeline->steps()}});
}

std::string widest_status_line(const State& state, bool in_short) {
  // Enough digits for most walks, so that a slightly longer walk does not change the layout.
  const auto digits = [](int number, std::size_t least) {
    return std::string(std::max(std::to_string(number).size(), least), '0');
  };
  const std::string steps = digits(state.walk.timeline->steps(), 4);
  if (in_short) return fill("status.short", state.appearance.language, {{"position", steps}, {"steps", steps}});
  return fill("status.whole", state.appearance.language,
              {{"position", steps},
               {"steps", steps},
               {"pixel", state.walk.pixel ? "0000,0000" : digits(state.scene().camera.screen.cells - 1, 2)},
               {"rays", digits(static_cast<int>(state.walk.timeline->rays().size()), 3)}});
}

}  // namespace raywalk
