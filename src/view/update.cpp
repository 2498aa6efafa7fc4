#include "view/action.h"
#include "view/lesson_panel.h"
#include "view/plan_view.h"
#include "view/text.h"
#include "view/update_parts.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

using namespace action;

bool finite(double value) { return std::isfinite(value); }
bool finite(const Vec2d& v) { return finite(v.x) && finite(v.y); }

/// Whether all of the action's numbers for the plan, the speed and the scale are finite. Whole values (a material, a
/// shape) are checked by the rules of the scene format.
bool is_finite(const Action& action) {
  return std::visit(Overloaded{
                        [](const SetSpeed& a) { return finite(a.lines_per_second); },
                        [](const Tick& a) { return finite(a.seconds) && a.seconds >= 0; },
                        [](const ResizePlan& a) { return finite(a.viewport.width) && finite(a.viewport.height); },
                        [](const PointerMoved& a) { return finite(a.at); },
                        [](const PointerPressed& a) { return finite(a.at); },
                        [](const PointerReleased& a) { return finite(a.at); },
                        [](const Zoom& a) { return finite(a.at) && finite(a.factor) && a.factor > 0; },
                        [](const Pan& a) { return finite(a.by); },
                        [](const Orbit& a) { return finite(a.angles); },
                        [](const Shift& a) { return finite(a.parts); },
                        [](const Approach& a) { return finite(a.factor) && a.factor > 0; },
                        [](const InsertCorner& a) { return finite(a.at); },
                        [](const Nudge& a) { return finite(a.direction); },
                        [](const SetUiScale& a) { return finite(a.scale); },
                        [](const SetCostKnobs& a) {
                          return finite(a.knobs.threshold) && finite(a.knobs.tolerance) && finite(a.knobs.epsilon);
                        },
                        [](const ShowCosts& a) { return finite(a.split); },
                        [](const Magnify& a) { return finite(a.part); },
                        [](const GuessWay& a) { return finite(a.towards); },
                        [](const auto&) { return true; },
                    },
                    action);
}

template <class T, class... Kinds>
constexpr bool one_of = (std::is_same_v<T, Kinds> || ...);

/// Actions allowed while a question is open.
bool goes_through(const State& state, const Action& action) {
  return std::visit(
      [&]<class T>(const T&) {
        if constexpr (one_of<T, Tick, ResizePlan, SetTheme, SetLanguage, SetUiScale, PointerLeft, PointerReleased,
                             DismissNotice, FinishExport>)
          return true;
        // An undecided autosave waits for the next start.
        const bool may_leave = state.question && state.question->kind == Question::Kind::recover;
        if (state.question) return one_of<T, AnswerQuestion> || (may_leave && one_of<T, Quit>);
        if (state.prompt != PathPrompt::none)
          return one_of<T, Open, SaveAs, SavePredictions, Export, CancelPrompt, Quit>;
        return true;
      },
      action);
}

/// Actions that do not end a drag.
bool leaves_drag(const Action& action) {
  return std::visit(
      []<class T>(const T&) {
        return one_of<T, Tick, ResizePlan, SetTheme, SetLanguage, SetUiScale, PointerMoved, PointerReleased,
                      PointerLeft, CancelDrag, Zoom, HoverRay, HoverLine, SetTab, DismissNotice, SetSpeed, SetGrain,
                      SetImageSettings, Magnify>;
      },
      action);
}

/// Actions that do not end a tween.
bool leaves_tween(const Action& action) {
  return std::visit(
      []<class T>(const T&) { return one_of<T, Tick, ResizePlan, PointerMoved, PointerLeft, HoverRay, HoverLine>; },
      action);
}

bool has_object(const State& state, int object) { return exists(state, {TargetKind::object, object}); }

void set_material(State& state, const SetMaterial& set) {
  if (!has_object(state, set.object)) return;
  Scene next = state.scene();
  next.objects[static_cast<std::size_t>(set.object)].material = set.material;
  detail::commit_if_valid(state, std::move(next), set.object, -1, {Action(set).index(), set.object}, set.continues);
}

void set_shape(State& state, const SetShape& set) {
  if (!has_object(state, set.object)) return;
  Scene next = state.scene();
  next.objects[static_cast<std::size_t>(set.object)].shape = set.shape;
  detail::commit_if_valid(state, std::move(next), set.object, -1, {Action(set).index(), set.object}, set.continues);
}

void set_light(State& state, const SetLight& set) {
  if (!exists(state, {TargetKind::light, set.light})) return;
  Scene next = state.scene();
  Light& light = next.lights[static_cast<std::size_t>(set.light)];
  const std::string name = light.name;  // a name changes through Rename, which keeps it unique
  light = set.value;
  light.name = name;
  detail::commit_if_valid(state, std::move(next), -1, set.light, {Action(set).index(), set.light}, set.continues);
}

void refit(State& state) {
  if (state.camera.fitted) state.camera = fitted(state);
}

/// Actions on the user's own scene: they end a hunt first.
bool leaves_hunt(const Action& action) {
  return std::visit(
      []<class T>(const T& a) {
        if constexpr (one_of<T, ShowLessons>) return a.shown;
        return one_of<T, New, Open, Save, SaveAs, AskOpen, AskSaveAs, Quit, OpenLesson>;
      },
      action);
}

/// Applies a valid action.
void apply(State& state, const Action& action) {
  std::visit(
      Overloaded{
          [&](const SetMode& a) {
            if (a.mode == Mode::help && state.mode != Mode::help) state.before_help = state.mode;
            state.mode = a.mode;
            if (a.mode != Mode::trace) {
              state.playing = false;
              state.hold.reset();
            }
            detail::hover(state);
          },
          [&](const Step& a) {
            if (!a.forward || !detail::answered_by_step(state)) detail::walk(state, a);
          },
          [&](const Jump& a) { detail::go_to(state, a.position); },
          [&](const JumpToRay& a) {
            if (exists(state, {TargetKind::ray, a.ray}))
              detail::go_to(state, state.timeline->rays()[static_cast<std::size_t>(a.ray)].formed_at);
          },
          [&](const JumpToCell& a) {
            detail::walk_strip(state);
            for (const PixelRecord& pixel : state.timeline->pixels())
              if (pixel.column == a.cell) return detail::go_to(state, pixel.begun_at);
          },
          [&](const RunToLine& a) { detail::run_to_line(state, a.line); },
          [&](const RunOn& a) { detail::run_on(state, a.forward); },
          [&](const ToggleBreakpoint& a) { detail::toggle_breakpoint(state, a.line); },
          [&](const SetBreakpoints& a) { state.breakpoints = a.breakpoints; },
          [&](const action::Hold& a) {
            if (a.forward && question_waits(state)) return;
            detail::go_to(state, state.position);
            state.hold = raywalk::Hold{a.forward};
          },
          [&](const Release&) { state.hold.reset(); },
          [&](const PlayPause&) {
            if (!state.playing && detail::answered_by_step(state)) return;
            state.owed = 0;
            state.hold.reset();
            state.mode = Mode::trace;
            const bool at_end = state.position == state.timeline->steps();
            state.playing = !state.playing && !at_end;
          },
          [&](const SetSpeed& a) { state.lines_per_second = std::clamp(a.lines_per_second, min_speed, max_speed); },
          [&](const SetGrain& a) { state.grain = a.grain; },
          [&](const Clear&) { detail::go_to(state, 0); },
          [&](const Tick& a) {
            if (state.tween) state.tween->seconds += a.seconds;
            detail::play(state, a.seconds);
            detail::autosave(state, a.seconds);
          },
          [&](const ResizePlan& a) {
            state.viewport = {std::clamp(a.viewport.width, 1.0, 1e5), std::clamp(a.viewport.height, 1.0, 1e5)};
            refit(state);
          },
          [&](const PointerMoved& a) { detail::pointer_moved(state, a); },
          [&](const PointerPressed& a) { detail::pointer_pressed(state, a); },
          [&](const PointerReleased& a) { detail::pointer_released(state, a); },
          [&](const PointerLeft&) {
            state.pointer.reset();
            if (state.drag) return;
            state.hovered = {};
            state.hovered_ray = -1;
          },
          [&](const CancelDrag&) { detail::cancel_drag(state); },
          [&](const Zoom& a) { detail::zoom(state, a.at, a.factor); },
          [&](const Pan& a) { detail::pan(state, a.by); },
          [&](const FitView&) { state.camera = fitted(state); },
          [&](const WalkPixel& a) { detail::walk_pixel(state, a); },
          [&](const WalkStrip&) { detail::walk_strip(state); },
          [&](const Orbit& a) { detail::orbit(state, a); },
          [&](const Shift& a) { detail::shift(state, a); },
          [&](const Approach& a) { detail::approach(state, a); },
          [&](const ResetView& a) { detail::reset_view(state, a.view); },
          [&](const UseImageCamera&) { detail::use_image_camera(state); },
          [&](const ShowLines& a) {
            state.lines_wanted = a.shown;
            state.mode = a.shown ? Mode::trace : state.mode;
          },
          [&](const ShowGhosts& a) {
            state.shows_ghosts = a.shown;
            state.mode = a.shown ? Mode::trace : state.mode;
          },
          [&](const SetTweens& a) { state.tweens = a.on; },
          [&](const SetImageSettings& a) { detail::set_image_settings(state, a.settings); },
          [&](const HoverRay& a) { state.hovered_ray = exists(state, {TargetKind::ray, a.ray}) ? a.ray : -1; },
          [&](const HoverLine& a) { state.hovered_line = a.line; },
          [&](const Select& a) {
            if (exists(state, a.target)) state.selected = a.target;
          },
          [&](const AddObject& a) { detail::add_object(state, a.kind); },
          [&](const RemoveSelected&) { detail::remove_selected(state); },
          [&](const InsertCorner& a) { detail::insert_corner(state, a); },
          [&](const RemoveCorner& a) { detail::remove_corner(state, a.object, a.corner); },
          [&](const Rename& a) { detail::rename(state, a); },
          [&](const SetMaterial& a) { set_material(state, a); },
          [&](const SetShape& a) { set_shape(state, a); },
          [&](const SetLight& a) { set_light(state, a); },
          [&](const SetCamera& a) {
            Scene next = state.scene();
            next.camera = a.camera;
            detail::commit_if_valid(state, std::move(next), -1, -1, {action.index(), -1}, a.continues);
          },
          [&](const SetLimits& a) {
            Scene next = state.scene();
            next.limits = a.limits;
            detail::commit_if_valid(state, std::move(next), -1, -1, {action.index(), -1}, a.continues);
          },
          [&](const SetNumerics& a) {
            Scene next = state.scene();
            next.render.numerics = a.numerics;
            next.render.epsilon = a.epsilon;
            detail::commit_if_valid(state, std::move(next), -1, -1, {action.index(), -1}, a.continues);
          },
          [&](const SetSurroundings& a) {
            Scene next = state.scene();
            next.background = a.background;
            next.ambient = a.ambient;
            detail::commit_if_valid(state, std::move(next), -1, -1, {action.index(), -1}, a.continues);
          },
          [&](const Nudge& a) { detail::nudge(state, a); },
          [&](const Undo&) { detail::undo(state); },
          [&](const Redo&) { detail::redo(state); },
          [&](const New&) { detail::ask_or_do(state, Intent::new_scene, {}); },
          [&](const Open& a) { detail::open(state, a.path); },
          [&](const Save&) { detail::save(state); },
          [&](const SaveAs& a) { detail::save_as(state, a.path); },
          [&](const AskOpen&) { detail::ask_path(state, PathPrompt::open); },
          [&](const AskSaveAs&) { detail::ask_path(state, PathPrompt::save_as); },
          [&](const CancelPrompt&) {
            state.prompt = PathPrompt::none;
            state.after_save.reset();
          },
          [&](const AnswerQuestion& a) { detail::answer(state, a.answer); },
          [&](const Quit&) {
            if (state.question) {
              state.quit = true;
              return;
            }
            state.prompt = PathPrompt::none;
            detail::ask_or_do(state, Intent::quit, {});
          },
          [&](const SetTheme& a) {
            state.theme = a.theme;
            refit(state);
          },
          [&](const SetLanguage& a) {
            const std::optional<Language> found = state.language.others().find(a.code);
            if (!found)
              return detail::complain(state, fill("notice.no_language", state.language, {{"language", a.code}}));
            state.language = *found;
            state.notice.reset();  // it is in the old language
          },
          [&](const SetUiScale& a) {
            state.ui_scale = std::clamp(a.scale, min_ui_scale, max_ui_scale);
            refit(state);
          },
          [&](const SetTab& a) {
            state.tab = a.tab;
            if (a.tab == Tab::structure) {  // it draws into the plan of a walk
              detail::end_drag(state);
              state.mode = Mode::trace;
            }
            if (a.tab == Tab::image) state.turned_last = SpaceView::image;  // keys turn the selected view
          },
          [&](const DismissNotice&) { state.notice.reset(); },
          [&](const SetCostKnobs& a) { detail::set_cost_knobs(state, a.knobs); },
          [&](const TryCost& a) { detail::try_cost(state, a.ladder); },
          [&](const ForgetCosts&) { detail::forget_costs(state); },
          [&](const ChooseCost& a) { detail::choose_cost(state, a); },
          [&](const ShowCosts& a) { detail::show_costs(state, a); },
          [&](const ShowCostPage& a) { detail::show_cost_page(state, a.page); },
          [&](const ChooseStructure& a) { detail::choose_structure(state, a.kind); },
          [&](const ShowStructurePage& a) { state.structure.page = a.page; },
          [&](const GoInStructure& a) { detail::go_in_structure(state, a.step); },
          [&](const Magnify& a) { state.magnified = std::clamp(a.part, 0.0, 1.0); },
          [&](const ShowLessons& a) { detail::show_lessons(state, a.shown); },
          [&](const OpenLesson& a) { detail::open_lesson(state, a.name); },
          [&](const LeaveLesson&) { detail::leave_lesson(state); },
          [&](const GoToLessonStep& a) { detail::go_to_lesson_step(state, a.step); },
          [&](const GuessChoice& a) { detail::guess_choice(state, a.choice); },
          [&](const GuessNumber& a) { detail::guess_number(state, a.number); },
          [&](const RevealLesson&) { detail::reveal_lesson(state); },
          [&](const ShowHands& a) { detail::show_hands(state, a); },
          [&](const SetLessonOptions& a) { detail::set_lesson_options(state, a); },
          [&](const ShowBugs& a) { detail::show_bugs(state, a.shown); },
          [&](const HuntBug& a) { detail::hunt_bug(state, a); },
          [&](const MarkLine& a) { detail::mark_line(state, a.line); },
          [&](const JudgeLine&) { detail::judge_line(state); },
          [&](const ShowCure&) { detail::show_cure(state); },
          [&](const MendBug& a) { detail::mend_bug(state, a.mended); },
          [&](const LeaveHunt&) { detail::leave_hunt(state); },
          [&](const AskExport&) { detail::ask_path(state, PathPrompt::export_walk); },
          [&](const Export& a) { detail::export_walk(state, a.path); },
          [&](const FinishExport& a) { detail::finish_export(state, a.why_not); },
          [](const Wait&) {},
          [&](const SetPredictions& a) { detail::set_predictions(state, a.on); },
          [&](const GuessWay& a) { detail::guess_way(state, a.towards); },
          [&](const GuessEnd& a) { detail::guess_end(state, a.met); },
          [&](const AskSavePredictions&) { detail::ask_save_predictions(state); },
          [&](const SavePredictions& a) { detail::save_predictions(state, a.path); },
      },
      action);
}

}  // namespace

void update(State& state, const Action& action) {
  if (!is_finite(action) || !goes_through(state, action)) return;
  if (state.drag && !leaves_drag(action)) detail::end_drag(state);
  if (state.bugs.hunt && leaves_hunt(action)) detail::leave_hunt(state);
  if (!leaves_tween(action)) state.tween.reset();
  const std::shared_ptr<const Timeline> walked = state.timeline;
  const int position = state.position;
  apply(state, action);
  detail::follow_with_tween(state, walked.get(), position);
  detail::follow_with_ghosts(state);
  detail::follow_with_predictions(state);
  detail::follow_with_structure(state);
}

bool exists(const State& state, const Target& target) {
  const Scene& scene = state.scene();
  const auto within = [&](std::size_t size) {
    return target.index >= 0 && static_cast<std::size_t>(target.index) < size;
  };
  const auto shape = [&]<class S>(std::in_place_type_t<S>) -> const S* {
    if (!within(scene.objects.size())) return nullptr;
    const Object& object = scene.objects[static_cast<std::size_t>(target.index)];
    return object.transform.empty() ? std::get_if<S>(&object.shape) : nullptr;  // transformed shapes have no handles
  };
  switch (target.kind) {
    case TargetKind::nothing:
    case TargetKind::eye:
    case TargetKind::view_direction:
    case TargetKind::screen_distance:
      return true;
    case TargetKind::screen_height:
      return target.part == 0 || target.part == 1;
    case TargetKind::cell:
      return target.index >= 0 && target.index < scene.camera.screen.cells;
    case TargetKind::object:
      return within(scene.objects.size());
    case TargetKind::radius:
      return shape(std::in_place_type<Sphere<double>>) != nullptr;
    case TargetKind::corner:
    case TargetKind::edge: {
      const auto* prism = shape(std::in_place_type<Prism<double>>);
      return prism != nullptr && target.part >= 0 && target.part < prism->sides();
    }
    case TargetKind::rotation:
      return shape(std::in_place_type<Prism<double>>) != nullptr;
    case TargetKind::light:
      return within(scene.lights.size());
    case TargetKind::ray:
      return within(state.timeline->rays().size());
  }
  return false;
}

}  // namespace raywalk
