// Any sequence of actions keeps the promises of view/state.h.

#include "fixtures.h"
#include "view/action_text.h"

#include <limits>
#include <random>

#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Random actions, among them many that make no sense where they come.
class RandomActions {
 public:
  explicit RandomActions(unsigned seed) : engine_(seed) {}

  Action next(const State& state) {
    switch (whole(0, 41)) {
      case 0:
        return action::SetMode{static_cast<Mode>(whole(0, 2))};
      case 1:
        return action::Step{flip(), static_cast<Grain>(whole(0, 2))};
      case 2:
        return action::Step{flip(), {}};
      case 3:
        return action::Jump{whole(-5, 3000)};
      case 4:
        return action::JumpToRay{whole(-1, 300)};
      case 5:
        return action::JumpToCell{whole(-1, 30)};
      case 6:
        return action::RunToLine{static_cast<Line>(whole(0, line_count + path_line_count - 1))};
      case 7:
        return action::PlayPause{};
      case 8:
        return action::SetSpeed{real(-1, 300)};
      case 9:
        return action::SetGrain{static_cast<Grain>(whole(0, 2))};
      case 10:
        return action::Clear{};
      case 11:
        return action::Tick{real(0, 0.5)};
      case 12:
        return action::ResizePlan{{real(-10, 1500), real(-10, 1000)}};
      case 13:
      case 14:
      case 15:
      case 16:
        return action::PointerMoved{pixels(state), modifiers()};
      case 17:
      case 18:
      case 19:
        return action::PointerPressed{pixels(state), static_cast<action::Button>(whole(0, 5) / 3), modifiers(),
                                      whole(0, 4) == 0};
      case 20:
      case 21:
        return action::PointerReleased{pixels(state), modifiers()};
      case 22:
        return flip() ? Action(action::PointerLeft{}) : Action(action::CancelDrag{});
      case 23:
        return action::Zoom{pixels(state), std::exp(real(-2, 2))};
      case 24:
        return flip() ? Action(action::Pan{{real(-90, 90), real(-90, 90)}}) : Action(action::FitView{});
      case 25:
        return action::HoverRay{whole(-1, 300)};
      case 26:
        return action::HoverLine{flip() ? std::optional(static_cast<Line>(whole(0, line_count + path_line_count - 1)))
                                        : std::nullopt};
      case 27:
        return action::Select{target()};
      case 28:
        return action::AddObject{static_cast<action::ObjectKind>(whole(0, 3))};
      case 29:
        return action::RemoveSelected{};
      case 30:
        return action::InsertCorner{whole(-1, 6), whole(-1, 6), {real(-5, 5), real(-5, 5)}};
      case 31:
        return action::RemoveCorner{whole(-1, 6), whole(-1, 6)};
      case 32:
        return action::Rename{target(), flip() ? "Mirror" : "Name " + std::to_string(whole(0, 9))};
      case 33:
        return action::SetMaterial{whole(-1, 6), material(), flip()};
      case 34:
        return shape();
      case 35:
        return action::SetLight{whole(-1, 3), {"Any", Rgbd(real(-0.2, 2)), PointLight{point(), {1, 0, 0}}}, flip()};
      case 36:
        return camera(state);
      case 37:
        return action::SetLimits{{whole(-1, 6), real(-0.1, 0.2)}, flip()};
      case 38:
        return action::Nudge{{real(-3, 3), real(-3, 3)}, flip()};
      case 39:
      case 40:
        return flip() ? Action(action::Undo{}) : Action(action::Redo{});
      case 41:
        return other();
      default:
        break;
    }
    return action::DismissNotice{};
  }

 private:
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  double real(double low, double high) {
    // Now and then something that no window would send.
    if (whole(0, 199) == 0) return std::numeric_limits<double>::quiet_NaN();
    if (whole(0, 199) == 0) return std::numeric_limits<double>::infinity();
    if (whole(0, 199) == 0) return flip() ? 1e300 : -1e300;
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  bool flip() { return whole(0, 1) == 1; }
  Vec2d pixels(const State& state) {
    if (flip()) {
      // Somewhere that can be taken hold of.
      const Target there = target();
      if (exists(state, there)) return pixels_of(state, there);
    }
    return {real(-20, 820), real(-20, 620)};
  }
  Vec3d point() { return {real(-6, 6), real(-6, 6), whole(0, 5) == 0 ? real(-1, 1) : 0.0}; }
  action::Modifiers modifiers() { return {whole(0, 3) == 0, whole(0, 5) == 0, false}; }
  Target target() {
    return {static_cast<TargetKind>(whole(0, static_cast<int>(TargetKind::ray))), whole(-1, 6), whole(-1, 5)};
  }
  Material material() {
    Material material;
    material.diffuse = Rgbd(real(-0.05, 1));
    material.reflection = Rgbd(flip() ? real(0, 1) : 0.0);
    material.transmission = Rgbd(flip() ? real(0, 1) : 0.0);
    material.ior = real(0.5, 2.5);
    material.dielectric = flip();
    return material;
  }
  Action shape() {
    switch (whole(0, 2)) {
      case 0:
        return action::SetShape{whole(-1, 6), Sphere<double>{point(), real(-0.2, 2)}, flip()};
      case 1:
        return action::SetShape{whole(-1, 6), Plane<double>{point(), point()}, flip()};
      default:
        return action::SetShape{
            whole(-1, 6), Prism<double>{{plan(point()), plan(point()), plan(point()), plan(point())}, real(-0.1, 2)},
            flip()};
    }
  }
  Action camera(const State& state) {
    Camera camera = state.scene().camera;
    camera.eye = point();
    if (flip()) camera.look_at = point();
    if (flip()) camera.screen.cells = whole(0, 40);
    return action::SetCamera{camera, flip()};
  }
  SpaceView view() { return flip() ? SpaceView::image : SpaceView::lines; }
  Action cost() {
    study::Setup setup;
    setup.samples = whole(-3, 9000);
    setup.depth = whole(-3, 90);
    setup.threshold = real(-1, 2);
    switch (whole(0, 4)) {
      case 0:
        return action::SetCostKnobs{setup};
      case 1:
        return action::TryCost{flip()};
      case 2:
        return action::ChooseCost{whole(-3, 70), flip()};
      case 3:
        return action::ShowCosts{flip() ? CostPicture::split : CostPicture::difference, study::CostAxis::tests,
                                 real(-2, 3)};
      default:
        if (flip()) return action::ShowCostPage{flip() ? CostPage::tries : CostPage::effects};
        return whole(0, 9) > 0 ? Action(action::SetTab{Tab::cost}) : Action(action::ForgetCosts{});
    }
  }
  Action bug() {
    switch (whole(0, 8)) {
      case 0:
        return action::ShowBugs{flip()};
      case 1:
      case 2:
        return action::HuntBug{whole(0, 9), flip()};
      case 3:
        return action::MarkLine{static_cast<Line>(whole(0, line_count + path_line_count - 1))};
      case 4:
        return action::JudgeLine{};
      case 5:
        return action::ShowCure{};
      case 6:
      case 7:
        return action::MendBug{flip()};
      default:
        return action::LeaveHunt{};
    }
  }
  Action structure() {
    switch (whole(0, 3)) {
      case 0:
        return action::SetTab{Tab::structure};
      case 1:
        return action::ChooseStructure{static_cast<AcceleratorKind>(whole(0, 8))};
      case 2:
        return action::ShowStructurePage{flip() ? StructurePage::build : StructurePage::search};
      default:
        return action::GoInStructure{whole(-5, 60)};
    }
  }
  Action other() {
    switch (whole(0, 26)) {
      case 23:
        return cost();
      case 24:
        return bug();
      case 19:
        return action::RunOn{flip()};
      case 20:
        return action::ToggleBreakpoint{static_cast<Line>(whole(0, line_count + path_line_count - 1))};
      case 21: {
        Breakpoints breakpoints;
        if (flip()) breakpoints.depth = whole(-1, 9);
        if (flip()) breakpoints.pixel = whole(-1, 40);
        breakpoints.total_internal_reflection = flip();
        if (flip()) breakpoints.object = "Mirror";
        return action::SetBreakpoints{breakpoints};
      }
      case 22:
        return flip() ? Action(action::Hold{flip()}) : Action(action::Release{});
      case 10:
        return action::WalkPixel{whole(-1, 70), whole(-1, 50), {63, 47}};
      case 11:
        return action::WalkStrip{};
      case 12:
        return action::Orbit{view(), {real(-4, 4), real(-4, 4)}};
      case 13:
        return action::Shift{view(), {real(-1, 1), real(-1, 1)}};
      case 14:
        return action::Approach{view(), std::exp(real(-9, 9))};
      case 15:
        return action::ResetView{view()};
      case 16:
        return action::UseImageCamera{};
      case 17:
        return flip() ? Action(action::ShowLines{flip()}) : Action(action::ShowGhosts{flip()});
      case 18: {
        ImageSettings settings;
        settings.samples = whole(-3, 2000);
        settings.single_precision = flip();
        settings.heat = static_cast<Heat>(whole(0, 3));
        return action::SetImageSettings{settings};
      }
      case 25:
        return action::SetNumerics{flip() ? Numerics::naive : Numerics::robust, real(-0.01, 0.1), flip()};
      case 26:
        return flip() ? Action(action::Magnify{real(-0.5, 1.5)}) : structure();
      case 0:
        return action::New{};
      case 1:
        return action::Open{"no such file.toml"};
      case 2:
        return action::Save{};
      case 3:
        return action::SaveAs{"/no/such/folder/scene"};
      case 4:
        return flip() ? Action(action::AskOpen{}) : Action(action::AskSaveAs{});
      case 5:
        return action::CancelPrompt{};
      case 6:
        return action::SetTheme{flip() ? Theme::dark : Theme::projector};
      case 7:
        return action::SetUiScale{real(0, 4)};
      case 8:
        return action::SetSurroundings{Rgbd(real(-0.1, 1)), Rgbd(real(-0.1, 1)), flip()};
      default:
        return action::SetTab{static_cast<Tab>(whole(0, 6))};
    }
  }

  std::mt19937 engine_;
};

}  // namespace

TEST_CASE("ten thousand random actions keep every promise, and undo leads all the way back") {
  const unsigned seed = GENERATE(1u, 2u, 3u, 4u);
  RandomActions actions(seed);
  State state = busy_state();
  state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  std::vector<std::string> latest;
  for (int i = 0; i < rounds(2500); ++i) {
    const Action action = actions.next(state);
    latest.push_back(write_action(action));
    // Too many objects make the rest of the test slow, not better.
    if (std::holds_alternative<action::AddObject>(action) && state.scene().objects.size() > 8) continue;
    update(state, action);
    if (state.question) {
      update(state, action::AnswerQuestion{action::Answer::cancel});
      CHECK_FALSE(state.question);
    }
    const std::string broken = broken_promise(state);
    if (broken.empty()) continue;
    std::string way;
    for (std::size_t j = latest.size() > 6 ? latest.size() - 6 : 0; j < latest.size(); ++j) way += latest[j] + "\n";
    INFO("seed " << seed << ", action " << i << ", after\n" << way);
    REQUIRE(broken == "");
  }
  CHECK_FALSE(state.quit);

  // Undo all the way and redo all the way: the same scenes in the opposite order.
  update(state, action::CancelPrompt{});
  update(state, action::CancelDrag{});
  update(state, action::LeaveHunt{});
  std::vector<Scene> scenes{state.scene()};
  while (!state.undo.empty()) {
    update(state, action::Undo{});
    CHECK(state.scene() != scenes.back());
    scenes.push_back(state.scene());
    REQUIRE(broken_promise(state) == "");
  }
  REQUIRE(scenes.size() > (sanitized ? 2 : 20));
  if (scenes.size() <= undo_entries) CHECK(scenes.back() == saved_scene(state));
  while (!state.redo.empty() && scenes.size() > 1) {
    scenes.pop_back();
    update(state, action::Redo{});
    REQUIRE(state.scene() == scenes.back());
  }
}
