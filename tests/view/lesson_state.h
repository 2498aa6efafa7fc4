// The state in which lessons are played by tests.
#pragma once

#include "fixtures.h"
#include "support/languages.h"
#include "view/lesson/lesson_panel.h"
#include "view/walk/asked.h"

namespace raywalk::test {

/// The classic scene, with all lessons open to a student.
inline State state_with_lessons() {
  const std::string root = RAYWALK_SOURCE_DIR;
  State state = make_state(read_scene(root + "/scenes/classic.toml").value());
  state.appearance.language = in_english;
  state.lessons.folder = root + "/lessons";
  state.lessons.scenes_folder = root + "/scenes";
  state.plan.viewport = {800, 600};
  update(state, action::ShowLessons{true});
  update(state, action::SetLessonOptions{false, true});
  return state;
}

}  // namespace raywalk::test
