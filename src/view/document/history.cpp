#include "view/action.h"
#include "view/document/document.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <utility>

namespace raywalk {

namespace {

std::size_t bytes_of(const Scene& scene) {
  std::size_t bytes = sizeof(Scene) + scene.lights.size() * sizeof(Light) + scene.objects.size() * sizeof(Object);
  for (const Object& object : scene.objects)
    if (const auto* prism = std::get_if<Prism<double>>(&object.shape)) bytes += prism->corners.size() * sizeof(Vec2d);
  return bytes;
}

std::size_t bytes_of(const Ink& ink) {
  std::size_t bytes = ink.size() * sizeof(InkMark);
  for (const InkMark& mark : ink)
    if (const auto* stroke = std::get_if<PenStroke>(&mark.shape)) bytes += stroke->points.size() * sizeof(Vec2d);
  return bytes;
}

/// Drops the oldest entries beyond the bounds. Both stacks hold similar versions of one scene and of one drawing, so
/// the size of the current ones is used for all.
void trim(State& state) {
  const std::size_t by_bytes = undo_bytes / std::max(bytes_of(state.scene()), bytes_of(state.document.contents.ink));
  const std::size_t most = std::max<std::size_t>(1, std::min(undo_entries, by_bytes));
  if (state.document.undo.size() > most)
    state.document.undo.erase(state.document.undo.begin(),
                              state.document.undo.end() - static_cast<std::ptrdiff_t>(most));
}

/// After a change of the scene or of the ink.
void compare_with_file(State& state) {
  DocumentRoom& document = state.document;
  if (document.saved && document.contents.scene == *document.saved) document.saved.reset();
  document.dirty = document.saved || document.contents.ink_of_file() != document.saved_ink;
  if (!document.dirty) forget_autosave(state);  // nothing to recover any more
}

void replace_ink(State& state, Ink next) {
  state.document.contents.ink = std::move(next);
  if (state.document.contents.keeps_ink) state.document.autosaved_revision = 0;
  compare_with_file(state);
}

/// Where the thing of this index is in `after`; -1 if it is gone. A name that is new there is another one of it.
template <class Thing>
int found_again(int index, const std::vector<Thing>& before, const std::vector<Thing>& after) {
  if (index < 0 || static_cast<std::size_t>(index) >= before.size()) return -1;
  const auto called = [](const std::string& name) { return [&](const Thing& thing) { return thing.name == name; }; };
  const auto at = static_cast<std::size_t>(index);
  const auto found = std::find_if(after.begin(), after.end(), called(before[at].name));
  if (found != after.end()) return static_cast<int>(found - after.begin());
  const bool renamed =
      before.size() == after.size() && std::none_of(before.begin(), before.end(), called(after[at].name));
  return renamed ? index : -1;
}

int corners_of(const Scene& scene, int object) {
  const auto* prism = std::get_if<Prism<double>>(&scene.objects[static_cast<std::size_t>(object)].shape);
  return prism == nullptr ? 0 : prism->sides();
}

/// The same thing in another version of the scene; nothing if it is gone. A corner of a polygon that has another
/// number of them then is its object.
Target found_again(Target target, const Scene& before, const Scene& after) {
  const int index = target.index;
  switch (target.kind) {
    case TargetKind::light:
    case TargetKind::light_radius:
      target.index = found_again(index, before.lights, after.lights);
      break;
    case TargetKind::object:
    case TargetKind::radius:
    case TargetKind::rotation:
      target.index = found_again(index, before.objects, after.objects);
      break;
    case TargetKind::corner:
    case TargetKind::edge:
      target.index = found_again(index, before.objects, after.objects);
      if (target.index >= 0 && corners_of(before, index) != corners_of(after, target.index))
        return {TargetKind::object, target.index};
      break;
    default:
      return target;
  }
  return target.index < 0 ? Target{} : target;
}

void step_history(State& state, History& from, History& to, std::string_view when_empty) {
  if (from.empty()) return inform(state, std::string(text(when_empty, state.appearance.language)));
  const std::shared_ptr<const Undone> next = from.back();
  from.pop_back();
  state.document.last_edit.reset();
  state.document.replaced_redo.clear();
  if (const Scene* const scene = std::get_if<Scene>(next.get())) {
    to.push_back(std::make_shared<const Undone>(state.scene()));
    const Target selected = found_again(state.plan.selected, state.scene(), *scene);
    replace_scene(state, *scene);
    state.plan.selected = exists(state, selected) ? selected : Target{};
    state.plan.hovered = {};
  } else {
    to.push_back(std::make_shared<const Undone>(state.document.contents.ink));
    replace_ink(state, std::get<Ink>(*next));
  }
}

}  // namespace

namespace {

/// A walk goes on stopping at an object that is called otherwise in `next`. One that is gone may come back by Undo.
void rename_stop(std::string& stop, const Scene& before, const Scene& next) {
  const auto at = std::find_if(before.objects.begin(), before.objects.end(),
                               [&](const Object& object) { return object.name == stop; });
  if (stop.empty() || at == before.objects.end()) return;
  const int found = found_again(static_cast<int>(at - before.objects.begin()), before.objects, next.objects);
  if (found >= 0) stop = next.objects[static_cast<std::size_t>(found)].name;
}

}  // namespace

void replace_scene(State& state, Scene next) {
  rename_stop(state.walk.breakpoints.object, state.scene(), next);
  if (!state.document.saved) state.document.saved = std::move(state.document.contents.scene);
  state.document.contents.scene = std::move(next);
  state.document.worlds = std::make_shared<WorldCache>();
  ++state.document.revision;
  compare_with_file(state);
  record_again(state);
}

void remember(State& state, Undone before) {
  state.document.undo.push_back(std::make_shared<const Undone>(std::move(before)));
  state.document.replaced_redo = std::exchange(state.document.redo, {});
  trim(state);
}

History all_undone(const DocumentRoom& document) {
  History redo = document.redo;
  auto scene = std::make_shared<const Undone>(document.contents.scene);
  auto ink = std::make_shared<const Undone>(document.contents.ink);
  for (auto before = document.undo.rbegin(); before != document.undo.rend(); ++before)
    redo.push_back(std::exchange(std::holds_alternative<Scene>(**before) ? scene : ink, *before));
  return redo;
}

void commit(State& state, Scene next, EditMark mark, bool continues) {
  if (next == state.scene()) return;
  DocumentRoom& document = state.document;
  const bool joins = continues && !document.undo.empty() && document.last_edit && *document.last_edit == mark;
  const Scene* const begun_with = joins ? std::get_if<Scene>(document.undo.back().get()) : nullptr;
  if (begun_with != nullptr && next == *begun_with) {
    document.undo.pop_back();
    document.redo = std::exchange(document.replaced_redo, {});
    document.last_edit.reset();
  } else {
    if (!joins) remember(state, state.scene());
    document.last_edit = mark;
  }
  forget_notice(state);
  replace_scene(state, std::move(next));
}

void commit_ink(State& state, Ink next, bool joins) {
  if (next == state.document.contents.ink) return;
  if (!joins) remember(state, state.document.contents.ink);
  state.document.last_edit.reset();
  replace_ink(state, std::move(next));
}

void keep_ink(State& state, bool kept) {
  state.document.contents.keeps_ink = kept;
  state.document.autosaved_revision = 0;
  compare_with_file(state);
}

namespace {

/// The message of a file for the window: without what that shows anyway, which object it is and the rule of the format.
std::string without_place_and_rule(std::string message) {
  const std::size_t of = message.find(" of [["), colon = message.find(": ", of == std::string::npos ? 0 : of);
  if (of != std::string::npos && colon != std::string::npos) message.erase(of, colon - of);
  if (const std::size_t rule = message.find(" (expected "); rule != std::string::npos) message.erase(rule);
  return message;
}

}  // namespace

std::string why_refused(const Scene& scene, int object, int light) {
  // The format's own reader and writer know every rule: checks a scene of just these parts with them.
  Scene part = scene;
  part.objects.clear();
  part.lights.clear();
  if (object >= 0) part.objects.push_back(scene.objects[static_cast<std::size_t>(object)]);
  if (light >= 0) part.lights.push_back(scene.lights[static_cast<std::size_t>(light)]);
  const Result<std::string> written = format_scene(part);
  return written ? std::string() : without_place_and_rule(written.error().message);
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
  // What is begun is the last that was done.
  if (state.ink.begun) return LeaveInk{}.apply(state);
  // It leaves a hunt in which nothing was done; what was found out in one is not thrown away.
  if (state.document.undo.empty() && state.bugs.hunt && state.bugs.hunt->is_new()) return LeaveHunt{}.apply(state);
  step_history(state, state.document.undo, state.document.redo, "notice.nothing_to_undo");
}

void action::Redo::apply(State& state) const {
  step_history(state, state.document.redo, state.document.undo, "notice.nothing_to_redo");
}

}  // namespace raywalk
