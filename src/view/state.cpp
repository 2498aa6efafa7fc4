#include "view/state.h"

#include "inspect/search_walk.h"
#include "view/document/document.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"

namespace raywalk {

State make_state(SceneDocument document, std::string path, std::string state_dir, const Stop& stop) {
  State state;
  state.stop = stop;
  state.timeline = std::make_shared<const Timeline>();
  state.state_dir = std::move(state_dir);
  state.structure.kind = watched_accelerators.front();
  show_document(state, std::move(document), std::move(path));
  state.notice.reset();
  return state;
}

const Scene& saved_scene(const State& state) { return state.saved ? *state.saved : state.scene(); }

const Camera& image_camera(const State& state) {
  return state.image_camera ? *state.image_camera : state.scene().camera;
}

void choose(const State& state, RenderChoices& choices) {
  if (state.bug) {
    if (choices.integrator == Integrator::path) choices.integrator = Integrator::automatic;
    choices.numerics = Numerics::naive;
    return;
  }
  choices.integrator = state.image.integrator.value_or(choices.integrator);
}

namespace {

SceneSeen seen_from(const State& state, const Camera& camera) {
  RenderChoices choices = state.scene().render;
  choose(state, choices);
  SceneSeen seen(state.scene());
  seen.set(camera);
  seen.set(choices);
  return seen;
}

}  // namespace

SceneSeen pictured_scene(const State& state) { return seen_from(state, image_camera(state)); }

SceneSeen walked_scene(const State& state) {
  return seen_from(state, state.walk && state.walk->camera ? *state.walk->camera : state.scene().camera);
}

bool shows_lines(const State& state) {
  if (state.mode != Mode::trace) return false;  // bodies are moved in the plan
  return state.lines_wanted.value_or(state.walk.has_value() || !state.planar);
}

int current_cell(const State& state) {
  if (!state.timeline->of_strip()) return -1;
  const int pixel = state.timeline->current_pixel(state.position);
  return pixel < 0 ? -1 : state.timeline->pixels()[static_cast<std::size_t>(pixel)].column;
}

bool wants_autosave(const State& state) {
  return state.dirty && !state.bugs.hunt && state.revision != state.autosaved_revision && !state.state_dir.empty();
}

std::string document_title(const State& state) {
  const std::size_t slash = state.path.find_last_of('/');
  const OpenedLesson* lesson = state.lessons.open.get();
  const std::string name = state.path.empty() && lesson ? lesson->lesson.told(state.language).title
                           : state.path.empty()         ? std::string(text("scene.untitled", state.language))
                           : slash == std::string::npos ? state.path
                                                        : state.path.substr(slash + 1);
  return (state.dirty ? "*" : "") + name;
}

}  // namespace raywalk
