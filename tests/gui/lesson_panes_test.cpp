// Every step of every lesson in windows of every shape: no button, tab or kind of ray of the legend is cut by the
// window or covered by another.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "gui/bench.h"
#include "gui/command.h"
#include "gui/fonts.h"
#include "gui/layout.h"
#include "support/catch.h"
#include "support/effort.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

struct WindowShape {
  float width, height, unit;
};
// 1280x720 and 768x1024 also with the projector's larger letters.
constexpr std::array windows{WindowShape{1280, 720, 1},    WindowShape{1280, 720, 1.25f}, WindowShape{1920, 1080, 1},
                             WindowShape{1920, 1080, 2},   WindowShape{2560, 1440, 3},    WindowShape{768, 1024, 1},
                             WindowShape{768, 1024, 1.25f}};

// Buttons that stand where they are: those of commands, of the lesson below its text, and of the legend.
bool stands(const std::string& name) {
  static constexpr std::array of_lesson{"lesson-list", "lesson-back", "lesson-reveal", "lesson-next",
                                        "lesson-presenter"};
  if (std::find(of_lesson.begin(), of_lesson.end(), name) != of_lesson.end() || name.starts_with("legend/"))
    return true;
  if (name == "lines") return false;  // the whole pane has the name of its button
  return std::any_of(commands().begin(), commands().end(), [&](const Command* each) { return each->name == name; });
}

// In units: more is no rounding.
constexpr float rounding = 1;

float common(const Rect& a, const Rect& b) {
  return std::min(std::min(a.right(), b.right()) - std::max(a.x, b.x),
                  std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y));
}

// Returns how many there are.
std::size_t check_buttons(const Bench& bench, const WindowShape& window) {
  std::vector<std::pair<std::string, Rect>> buttons;
  std::string wrong;
  for (const auto& [name, where] : bench.interface().items()) {
    if (stands(name) && !where.empty()) buttons.emplace_back(name, where);
    if (name.ends_with("/clipped")) wrong += name + "; ";
  }
  for (std::size_t a = 0; a < buttons.size(); ++a) {
    const auto& [name, where] = buttons[a];
    if (where.x < -rounding || where.right() > window.width + rounding || where.y < -rounding ||
        where.bottom() > window.height + rounding)
      wrong += name + " is cut; ";
    for (std::size_t b = 0; b < a; ++b)
      if (common(where, buttons[b].second) > rounding) wrong += name + " covers " + buttons[b].first + "; ";
  }
  CHECK(wrong == "");
  return buttons.size();
}

}  // namespace

TEST_CASE("no button of a lesson's step is cut or covered, in windows of every shape and in every language") {
  const FontFiles files = find_fonts(font_folders(""));
  Bench bench(classic_with_lessons(), 1280, 720, files);
  bench.settle = 1;
  bench.state.lessons.unlocked = true;
  update(bench.state, action::ShowLessons{true});
  unsigned turn = 0;
  std::size_t steps = 0, looked_at = 0;
  for (const LessonEntry& entry : std::vector<LessonEntry>(bench.state.lessons.list)) {
    update(bench.state, action::OpenLesson{entry.name});
    for (int step = 0; step < entry.steps; ++step) {
      update(bench.state, action::GoToLessonStep{step});
      if (bench.state.lessons.at() == nullptr) continue;
      ++steps;
      for (std::size_t shape = 0; shape < windows.size(); ++shape) {
        // Sanitizers make a frame ten times slower: there one shape a step, in turn.
        if (sanitized ? shape != steps % windows.size() : left_to_all(shape + steps, 3)) continue;
        const WindowShape& window = windows[shape];
        // Before and after the answer, and the languages, in turn, so that each meets every window.
        if (turn % 2 == 1) update(bench.state, action::RevealLesson{});
        bench.state.appearance.language = all_languages()[turn++ % all_languages().size()];
        bench.unit = window.unit * shrink_to_fit(window.width, window.height, window.unit, true);
        bench.resize(window.width, window.height);
        bench.frames(1);
        INFO(entry.name << ", step " << step + 1 << ", " << window.width << " x " << window.height << " at "
                        << window.unit << ", " << bench.state.appearance.language.code());
        looked_at += check_buttons(bench, window);
        if (step > 0) continue;
        INFO("in Move");
        update(bench.state, action::SetMode{Mode::move});
        bench.frames(1);
        CHECK(bench.has("add-polygon"));
        check_buttons(bench, window);
        update(bench.state, action::SetMode{Mode::trace});
      }
    }
  }
  CHECK(looked_at > (sanitized ? 1000U : thorough() ? 10000U : 3000U));
}
