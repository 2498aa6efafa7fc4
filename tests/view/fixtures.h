// Scenes and helpers that the tests of `view` share.
#pragma once

#include "support/temporary_folder.h"
#include "view/action.h"
#include "view/plan/plan_view.h"

#include <string>
#include <variant>
#include <vector>

namespace raywalk::test {

/// Paths of all scenes that the program ships.
std::vector<std::string> shipped_scenes();
SceneDocument read_document(const std::string& path);

/// The classic scene, in a pane of 800 x 600 pixels, in move mode.
State classic_state();
/// A scene of every kind of shape and light: a mirror, glass inside which light is totally reflected, a wall, a polygon
/// with a notch, a point light and a directional one, and a threshold.
Scene busy_scene();
State busy_state();
State state_of(const Scene& scene);

int index_of_object(const Scene& scene, const std::string& name);

Vec2d to_pixels(const State& state, const Vec2d& point);
/// Where the handle or the middle of a target is, in pixels.
Vec2d pixels_of(const State& state, const Target& target);

/// Whether some text of a drawing is these words.
bool has_text(const DisplayList& list, std::string_view words);
/// The first text of a drawing that these words are part of; null: none.
const TextItem* text_with(const DisplayList& list, const std::string& part);
/// What stands for a target in a drawing.
std::vector<DisplayItem> items_of(const DisplayList& list, const Target& target);

/// After the first event with this detail from a position on; -1 where there is none.
template <class Detail>
int position_after(const Timeline& timeline, int from = 0) {
  for (int i = from; i < timeline.steps(); ++i)
    if (std::holds_alternative<Detail>(timeline.event(i).detail)) return i + 1;
  return -1;
}

void drag(State& state, const Vec2d& from, const Vec2d& to, action::Modifiers modifiers = {});
/// Takes hold of a target's handle and moves the pointer by so many pixels.
void drag_by(State& state, const Target& target, const Vec2d& by, action::Modifiers modifiers = {});

/// What must hold after whatever action: empty when it does, else what does not.
std::string broken_promise(const State& state);

/// Edits the scene so that it is not saved.
void make_dirty(State& state);
/// What its window held is free, as when that has crashed; the files stay.
void crash(State& state);
/// The busy scene, saved in `folder`, with the folder of its state beside it.
State saved_state(const TemporaryFolder& folder, const std::string& name = "scene.toml");

}  // namespace raywalk::test
