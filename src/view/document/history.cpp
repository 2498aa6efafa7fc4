#include "view/action.h"
#include "view/document/document.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

namespace raywalk {

namespace {

std::size_t bytes_of(const Scene& scene) {
  std::size_t bytes = sizeof(Scene) + scene.lights.size() * sizeof(Light) + scene.objects.size() * sizeof(Object);
  for (const Object& object : scene.objects)
    if (const auto* prism = std::get_if<Prism<double>>(&object.shape)) bytes += prism->corners.size() * sizeof(Vec2d);
  return bytes;
}

/// Drops the oldest entries beyond the bounds. Both stacks hold similar versions of one scene, so the size of the
/// current one is used for all.
void trim(State& state) {
  const std::size_t by_bytes = undo_bytes / bytes_of(state.scene());
  const std::size_t most = std::max<std::size_t>(1, std::min(undo_entries, by_bytes));
  if (state.document.undo.size() > most)
    state.document.undo.erase(state.document.undo.begin(),
                              state.document.undo.end() - static_cast<std::ptrdiff_t>(most));
}

void step_history(State& state, std::vector<Scene>& from, std::vector<Scene>& to, std::string_view when_empty) {
  if (from.empty()) return inform(state, std::string(text(when_empty, state.appearance.language)));
  Scene next = std::move(from.back());
  from.pop_back();
  to.push_back(state.scene());
  state.document.last_edit.reset();
  replace_scene(state, std::move(next));
}

}  // namespace

void replace_scene(State& state, Scene next) {
  if (!state.document.saved) state.document.saved = std::move(state.document.contents.scene);
  state.document.contents.scene = std::move(next);
  state.document.worlds = std::make_shared<WorldCache>();
  ++state.document.revision;
  state.document.dirty = state.document.contents.scene != *state.document.saved;
  if (!state.document.dirty) state.document.saved.reset();
  if (!state.document.dirty) forget_autosave(state);  // nothing to recover any more
  record_again(state);
}

void remember(State& state, Scene before) {
  state.document.undo.push_back(std::move(before));
  state.document.redo.clear();
  trim(state);
}

void commit(State& state, Scene next, EditMark mark, bool continues) {
  if (next == state.scene()) return;
  const bool joins =
      continues && !state.document.undo.empty() && state.document.last_edit && *state.document.last_edit == mark;
  if (!joins) remember(state, state.scene());
  state.document.last_edit = mark;
  state.document.notice.reset();
  replace_scene(state, std::move(next));
}

std::string why_refused(const Scene& scene, int object, int light) {
  // The format's own reader and writer know every rule: checks a scene of just these parts with them.
  Scene part = scene;
  part.objects.clear();
  part.lights.clear();
  if (object >= 0) part.objects.push_back(scene.objects[static_cast<std::size_t>(object)]);
  if (light >= 0) part.lights.push_back(scene.lights[static_cast<std::size_t>(light)]);
  const Result<std::string> written = format_scene(part);
  return written ? std::string() : written.error().message;
}

bool commit_if_valid(State& state, Scene next, int object, int light, EditMark mark, bool continues) {
  const std::string why = why_refused(next, object, light);
  if (!why.empty()) {
    complain(state, fill("notice.refused", state.appearance.language, {{"why", why}}));
    return false;
  }
  commit(state, std::move(next), mark, continues);
  return true;
}

void action::Undo::apply(State& state) const {
  // Once all edits in a hunt are undone, undo leaves the hunt.
  if (state.document.undo.empty() && state.bugs.hunt) return LeaveHunt{}.apply(state);
  step_history(state, state.document.undo, state.document.redo, "notice.nothing_to_undo");
}

void action::Redo::apply(State& state) const {
  step_history(state, state.document.redo, state.document.undo, "notice.nothing_to_redo");
}

}  // namespace raywalk
