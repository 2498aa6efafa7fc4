// The state in which lessons are played by tests.
#pragma once

#include "fixtures.h"
#include "support/languages.h"
#include "view/lesson/lesson_panel.h"
#include "view/walk/asked.h"

namespace raywalk::test {

/// The classic scene, beside lessons that nobody has looked at yet. What is finished of them is kept in `state_dir`, if
/// that is not empty.
inline State before_lessons(const std::string& state_dir = {}) {
  const std::string root = RAYWALK_SOURCE_DIR;
  State state = make_state(read_scene(root + "/scenes/classic.toml").value(), {}, state_dir);
  state.appearance.language = in_english;
  state.lessons.folder = root + "/lessons";
  state.lessons.scenes_folder = root + "/scenes";
  return state;
}

/// The same with the list of lessons shown.
inline State with_lessons(const std::string& state_dir = {}) {
  State state = before_lessons(state_dir);
  update(state, action::ShowLessons{true});
  return state;
}

/// The same with all lessons open to a student.
inline State state_with_lessons() {
  State state = before_lessons();
  state.plan.viewport = {800, 600};
  update(state, action::ShowLessons{true});
  update(state, action::SetLessonOptions{false, true});
  return state;
}

}  // namespace raywalk::test
