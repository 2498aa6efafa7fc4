// Implements the actions of spot the bug.

#include "lesson/staging.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/plan_view.h"
#include "view/walk/asked.h"
#include "view/walk/fault.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk {

namespace {

/// A shipped scene in whose strip and picture the fault is visible.
std::string_view bug_scene(Fault fault) {
  switch (fault) {
    case Fault::shadow_ray_misaimed:
    case Fault::reflection_flipped:
    case Fault::epsilon_wrong_side:
    case Fault::second_root_dropped:
    case Fault::epsilon_too_small:
      return "classic";
    case Fault::refraction_inverted:
      return "glass";
    case Fault::attenuation_forgotten:
      return "shadows";
    case Fault::depth_not_counted:
      return "mirrors";
    case Fault::second_side_black:
    case Fault::cosine_counted_twice:
    case Fault::emission_not_weighted:
    case Fault::emitter_area_forgotten:
      return "cornell";
    case Fault::photons_from_behind:
    case Fault::power_of_another_pass:
    case Fault::pi_forgotten:
      return "caustic";
    case Fault::reflectance_forgotten:
      return "radiosity";
  }
  return {};
}

/// What is changed of it.
std::string_view changes_for(Fault fault) {
  // A thin wall, seen from the side that is in the dark.
  if (fault == Fault::photons_from_behind)
    return "camera.eye = [7, 0]\n"
           "Wall.min = [2.6, -4, -1.2]\nWall.max = [2.63, 4, 2.6]\n"
           "render.photons.count = 20000";
  // Its corners the other way round: the wall shows its second side.
  if (fault == Fault::second_side_black)
    return "'Red wall'.corners = [[0, 1.5, 3], [3, 1.5, 3], [3, 1.5, 0], [0, 1.5, 0]]";
  // So that a walk begins at once, with the fault and without it.
  if (integrator_of(fault) == Integrator::photons) return "render.photons.count = 20000";
  // A large panel, which rays meet by chance now and then.
  if (fault == Fault::emission_not_weighted)
    return "Lamp.corners = [[0.3, -1.2, 2.9], [0.3, 1.2, 2.9], [2.7, 1.2, 2.9], [2.7, -1.2, 2.9]]\n"
           "Lamp.material.emission = [2.4, 2.2, 1.9]";
  return {};
}

/// The first pixel of the strip that the bug changes visibly, as index in the walk's pixels.
int first_spoilt(const Timeline& broken, const Timeline& whole) {
  constexpr double seen = 0.03;
  const auto alike = [](const PixelRecord& a, const PixelRecord& b) {
    const Rgbd off = a.shade - b.shade;
    return std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) < seen;
  };
  const auto at = std::mismatch(broken.pixels().begin(), broken.pixels().end(), whole.pixels().begin(),
                                whole.pixels().end(), alike);
  return at.first == broken.pixels().end() ? 0 : static_cast<int>(at.first - broken.pixels().begin());
}

/// Else it runs before the pixels.
bool runs_in(const Timeline& walk, const PixelRecord& pixel, Line line) {
  for (int i = pixel.begun_at; i < pixel.done_at; ++i)
    if (walk.event(i).line == line) return true;
  return false;
}

void end_hunt(State& state, BugEnd end) {
  BugHunt& hunt = *state.bugs.hunt;
  hunt.end = end;
  BugEnd& best = state.bugs.ends[static_cast<std::size_t>(hunt.number - 1)];
  if (best != BugEnd::found) best = end;
  state.walk.bug->known = true;
}

}  // namespace

void action::ShowBugs::apply(State& state) const {
  state.bugs.chosen.reset();
  if (!shown) {
    state.bugs.shown = false;
    return LeaveHunt{}.apply(state);
  }
  ShowLessons{false}.apply(state);
  state.bugs.shown = true;
  state.appearance.front = Front::lesson;
  if (state.walk.mode == Mode::help) state.walk.mode = Mode::trace;
}

void action::ChooseBug::apply(State& state) const {
  if (!state.bugs.shown || state.bugs.hunt) return;
  const int all = static_cast<int>(values_of<Fault>.size());
  state.bugs.chosen = std::clamp(state.bugs.chosen.value_or(by > 0 ? 0 : all + 1) + by, 1, all);
}

void action::HuntBug::apply(State& state) const {
  if (number < 1 || number > static_cast<int>(values_of<Fault>.size())) return;
  const Fault fault = values_of<Fault>[static_cast<std::size_t>(number - 1)];
  auto document = stage_scene(std::string(bug_scene(fault)), {}, state.lessons.scenes_folder);
  if (document && !changes_for(fault).empty())
    document = changed_scene(*document, changes_for(fault), {}, document->path);
  if (!document) return complain(state, document.error().text());
  std::shared_ptr<const State> before;
  if (state.bugs.hunt) {
    before = state.bugs.hunt->before;
  } else {
    autosave(state, autosave_every);  // the hunt does not autosave
    before = std::make_shared<const State>(state);
  }
  ShowBugs{true}.apply(state);
  state.bugs.hunt = BugHunt{};  // before the scene, so that the autosave is not touched
  state.picture.settings.single_precision = false;
  state.picture.settings.integrator.reset();
  state.picture.settings.walk_samples = 1;
  state.picture.settings.heat = Heat::none;
  state.lessons.open.reset();
  EffectsRoom::close(state);
  show_document(state, std::move(*document), {});
  set_bug(state, fault);
  BugHunt& hunt = *state.bugs.hunt;
  hunt.number = number;
  hunt.surprise = surprise;
  hunt.before = std::move(before);
  hunt.first_pixel = first_spoilt(*state.walk.timeline, *state.walk.bug->other);
  const auto& pixels = state.walk.timeline->pixels();
  if (hunt.first_pixel >= static_cast<int>(pixels.size())) return;
  const PixelRecord& pixel = pixels[static_cast<std::size_t>(hunt.first_pixel)];
  hunt.pixel = pixel.column;
  state.appearance.tab = PictureRoom::tab;
  hunt.from_start = !runs_in(*state.walk.timeline, pixel, faulty_line(fault));
  go_to(state, hunt.from_start ? 0 : pixel.begun_at);
}

void action::MarkLine::apply(State& state) const {
  if (!asks_for_line(state) || static_cast<int>(line) >= all_lines_count) return;
  if (&pseudocode_with(line) != &state.walk.timeline->pseudocode()) return;
  if (!state.bugs.hunt) {
    state.lessons.guess.line = line;
    return;
  }
  state.bugs.hunt->marked = line;
  state.bugs.hunt->acquitted.reset();
}

void action::JudgeLine::apply(State& state) const {
  if (!state.bugs.hunt || !state.bugs.hunt->marked || state.bugs.hunt->end != BugEnd::open) return;
  BugHunt& hunt = *state.bugs.hunt;
  if (*hunt.marked == faulty_line(state.walk.bug->fault)) return end_hunt(state, BugEnd::found);
  hunt.acquitted = std::exchange(hunt.marked, std::nullopt);
}

void action::ShowCure::apply(State& state) const {
  if (!state.bugs.hunt || state.bugs.hunt->end != BugEnd::open) return;
  // Whoever has marked it already has found it.
  if (state.bugs.hunt->marked == faulty_line(state.walk.bug->fault)) return end_hunt(state, BugEnd::found);
  state.bugs.hunt->marked = faulty_line(state.walk.bug->fault);
  state.bugs.hunt->acquitted.reset();
  end_hunt(state, BugEnd::given_up);
}

void action::MendBug::apply(State& state) const {
  if (!state.walk.bug || !state.walk.bug->known || state.walk.bug->mended == mended) return;
  state.walk.bug->mended = mended;
  ++state.picture.revision;
  record_again(state);
}

void action::LeaveHunt::apply(State& state) const {
  if (!state.bugs.hunt) return;
  State back = *state.bugs.hunt->before;
  // Appearance and progress are kept, but for what the hunt itself has opened.
  const Tab tab = back.appearance.tab;
  const Front front = back.appearance.front;
  back.appearance = std::move(state.appearance);
  back.appearance.tab = tab;
  back.appearance.front = front;
  back.plan.viewport = state.plan.viewport;
  back.walk.tweens = state.walk.tweens;
  back.link = std::move(state.link);
  back.bugs = std::move(state.bugs);
  back.bugs.hunt.reset();
  const bool autosaved = back.document.autosaved_revision == back.document.revision;
  back.document.revision = state.document.revision + 1;
  if (autosaved) back.document.autosaved_revision = back.document.revision;
  back.document.autosave_in = state.document.autosave_in;
  back.picture.revision = state.picture.revision + 1;
  back.walk.playing = false;
  back.walk.hold.reset();
  back.document.notice.reset();
  if (back.plan.camera.fitted) back.plan.camera = fitted(back);
  state = std::move(back);
  if (state.bugs.shown && state.lessons.shown) ShowLessons{false}.apply(state);  // there is room for one
}

}  // namespace raywalk
