#include "view/state.h"

#include "inspect/search_walk.h"
#include "view/document/document.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"

#include <algorithm>

namespace raywalk {

State make_state(SceneDocument document, std::string path, std::string state_dir, const Stop& stop, Language language) {
  State state;
  state.appearance.language = language;  // of what is said about the walk
  state.document.stop = stop;
  state.walk.timeline = std::make_shared<const Timeline>();
  state.document.state_dir = std::move(state_dir);
  state.structure.kind = watched_accelerators.front();
  show_document(state, std::move(document), std::move(path));
  return state;
}

const Scene& saved_scene(const State& state) { return state.document.saved ? *state.document.saved : state.scene(); }

SceneDocument saved_document(const State& state) {
  SceneDocument document = state.document.contents;
  document.scene = saved_scene(state);
  if (document.ink_of_file() != state.document.saved_ink) {
    document.ink = state.document.saved_ink;
    document.keeps_ink = !document.ink.empty();
  }
  return document;
}

const Camera& image_camera(const State& state) {
  return state.picture.camera ? *state.picture.camera : state.scene().camera;
}

void choose(const State& state, RenderChoices& choices) {
  if (state.walk.bug) {
    // A fault of the tracer makes it the tracer's; of other procedures there is only what the scene itself asks for.
    const IntegratorTraits& traits = traits_of(choices.integrator);
    if (integrator_of(state.walk.bug->fault) == Integrator::automatic && (traits.is_global || traits.has_width))
      choices.integrator = Integrator::automatic;
    choices.numerics = Numerics::naive;
    return;
  }
  choices.integrator = state.picture.settings.integrator.value_or(choices.integrator);
  choices.switches = state.effects.switches();
}

namespace {

SceneSeen seen_from(const State& state, const Camera& camera) {
  RenderChoices choices = state.scene().render;
  choose(state, choices);
  SceneSeen seen(state.scene());
  seen.set(camera);
  seen.set(choices);
  TraceLimits limits = state.scene().limits;
  limits.depth = state.effects.depth.value_or(limits.depth);
  seen.set(limits);
  if (std::optional<Scene> without = without_effects(state, *seen)) seen.set(std::move(*without));
  return seen;
}

}  // namespace

SceneSeen pictured_scene(const State& state) { return seen_from(state, image_camera(state)); }

SceneSeen walked_scene(const State& state) {
  return seen_from(state,
                   state.walk.pixel && state.walk.pixel->camera ? *state.walk.pixel->camera : state.scene().camera);
}

bool shows_lines(const State& state) {
  if (state.walk.mode != Mode::trace) return false;  // bodies are moved in the plan
  return state.space.lines_wanted.value_or(state.walk.pixel.has_value() || !state.walk.planar);
}

int current_cell(const State& state) {
  if (!state.walk.timeline->of_strip()) return -1;
  const int pixel = state.walk.timeline->current_pixel(state.walk.position);
  return pixel < 0 ? -1 : state.walk.timeline->pixels()[static_cast<std::size_t>(pixel)].column;
}

int position_shown(const State& state) { return state.live.shown ? state.walk.timeline->steps() : state.walk.position; }

int live_cell(const State& state) {
  const int cells = state.scene().camera.screen.cells;
  if (state.live.cell >= 0) return std::min(state.live.cell, cells - 1);
  const int walked = current_cell(state);
  return walked >= 0 ? walked : cells / 2;
}

bool holds_unsaved_work(const State& state) {
  return state.document.dirty && !state.bugs.hunt && !state.document.state_dir.empty();
}

bool wants_autosave(const State& state) {
  return holds_unsaved_work(state) && state.document.revision != state.document.autosaved_revision;
}

std::string document_title(const State& state) {
  const std::size_t slash = state.document.path.find_last_of('/');
  const OpenedLesson* lesson = state.lessons.open.get();
  const std::string name = state.document.path.empty() && lesson ? lesson->lesson.told(state.appearance.language).title
                           : state.document.path.empty()
                               ? std::string(text("scene.untitled", state.appearance.language))
                           : slash == std::string::npos ? state.document.path
                                                        : state.document.path.substr(slash + 1);
  return (state.document.dirty ? "*" : "") + name;
}

}  // namespace raywalk
