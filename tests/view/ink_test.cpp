// Ink over the plan: drawn by the pointer, measured, undone with the edits, exported, and saved on request.
#include "view/ink/ink.h"

#include "contrast.h"
#include "fixtures.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/drawing/svg.h"
#include "view/outline.h"
#include "view/plan/painter.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"

#include <cmath>
#include <numbers>
#include <string>

using namespace raywalk;
using namespace raywalk::test;

namespace {

State inking(InkTool tool, Mode mode = Mode::trace) {
  State state = classic_state();
  state.appearance.language = in_english;
  update(state, action::SetMode{mode});
  update(state, action::SetInk{true});
  update(state, action::ChooseInkTool{tool});
  return state;
}

const Ink& ink_of(const State& state) { return state.document.contents.ink; }

template <class Shape>
const Shape& last(const State& state) {
  REQUIRE_FALSE(ink_of(state).empty());
  const auto* shape = std::get_if<Shape>(&ink_of(state).back().shape);
  REQUIRE(shape != nullptr);
  return *shape;
}

void click(State& state, const Vec2d& at, action::Modifiers modifiers = {}) {
  update(state, action::PointerMoved{at, modifiers});
  update(state, action::PointerPressed{at, action::Button::left, modifiers});
  update(state, action::PointerReleased{at, modifiers});
}

std::string svg_of(const State& state) {
  return svg_file(plan_view(state), state.plan.viewport.width, state.plan.viewport.height,
                  palette(state.appearance.theme).plan, "plan");
}

/// A place of the plan with nothing near.
constexpr Vec2d nowhere{60, 60}, elsewhere{160, 90};

/// The first ray of the walk that is mirrored, with the walk behind it.
const RayRecord& mirrored_ray(State& state) {
  const auto& rays = state.walk.timeline->rays();
  for (const RayRecord& ray : rays) {
    const RayRecord* parent = ray.parent < 0 ? nullptr : &rays[static_cast<std::size_t>(ray.parent)];
    if (ray.kind != RayKind::reflect || !ray.formed || ray.endless || parent == nullptr) continue;
    update(state, action::Jump{ray.found_at});
    return ray;
  }
  FAIL("no ray is mirrored");
  return rays.front();
}

}  // namespace

TEST_CASE("the pen draws in both modes, and zooming leaves the stroke where it is in the scene") {
  for (const Mode mode : {Mode::trace, Mode::move}) {
    State state = inking(InkTool::pen, mode);
    const Scene scene = state.scene();
    const int position = state.walk.position;
    const auto timeline = state.walk.timeline;
    const std::uint64_t revision = state.document.revision;
    drag(state, {100, 100}, {300, 140});
    const PenStroke stroke = last<PenStroke>(state);
    const double pixel = 1 / state.plan.camera.pixels_per_unit;
    CHECK(length(stroke.points.front() - to_scene(state.plan.camera, state.plan.viewport, {100, 100})) < 0.2 * pixel);
    CHECK(length(stroke.points.back() - to_scene(state.plan.camera, state.plan.viewport, {300, 140})) < 0.2 * pixel);
    CHECK(stroke.points.size() == 2);  // what lies on the line is left out
    update(state, action::Zoom{{400, 300}, 2});
    update(state, action::Pan{{30, 10}});
    CHECK(last<PenStroke>(state) == stroke);
    // Nothing else happened: neither the walk nor the picture begins anew.
    CHECK(state.scene() == scene);
    CHECK(state.document.revision == revision);
    CHECK(state.walk.timeline == timeline);
    CHECK(state.walk.position == position);
    CHECK_FALSE(state.document.dirty);
    CHECK(broken_promise(state) == "");
  }
}

TEST_CASE("with ink on, the left button takes hold of nothing, and the right one moves the plan") {
  State state = inking(InkTool::pen, Mode::move);
  const Scene scene = state.scene();
  update(state, action::Select{{TargetKind::object, 0}});
  const Vec2d eye = pixels_of(state, {TargetKind::eye});
  drag(state, eye, eye + Vec2d(40, 40));
  CHECK(state.scene() == scene);
  CHECK(state.plan.selected == Target{TargetKind::object, 0});
  CHECK_FALSE(state.plan.hovered);
  const Vec2d centre = state.plan.camera.centre;
  update(state, action::PointerPressed{{400, 300}, action::Button::right});
  update(state, action::PointerMoved{{450, 300}});
  update(state, action::PointerReleased{{450, 300}});
  CHECK(state.plan.camera.centre.x < centre.x);
  CHECK(ink_of(state).size() == 1);
  // Off again, it does what it did.
  update(state, action::SetInk{false});
  drag(state, pixels_of(state, {TargetKind::eye}), pixels_of(state, {TargetKind::eye}) + Vec2d(0, 40));
  CHECK(state.scene() != scene);
  CHECK(ink_of(state).size() == 1);
}

TEST_CASE("ink and edits are undone and done again in one order") {
  State state = inking(InkTool::arrow, Mode::move);
  drag(state, nowhere, elsewhere);
  const Ink one = ink_of(state);
  REQUIRE(one.size() == 1);
  make_dirty(state);
  const Scene edited = state.scene();
  drag(state, {60, 200}, {160, 230});
  const Ink two = ink_of(state);
  update(state, action::ClearInk{});
  CHECK(ink_of(state).empty());
  update(state, action::Undo{});
  CHECK(ink_of(state) == two);
  update(state, action::Undo{});
  CHECK(ink_of(state) == one);
  CHECK(state.scene() == edited);
  update(state, action::Undo{});
  CHECK(state.scene() != edited);
  CHECK(ink_of(state) == one);
  CHECK_FALSE(state.document.dirty);
  update(state, action::Undo{});
  CHECK(ink_of(state).empty());
  for (int i = 0; i < 4; ++i) update(state, action::Redo{});
  CHECK(ink_of(state).empty());
  CHECK(state.scene() == edited);
  CHECK(state.document.undo.size() == 4);
  // Clearing nothing is no edit.
  update(state, action::ClearInk{});
  CHECK(state.document.undo.size() == 4);
}

TEST_CASE("an arrow is dragged, or pressed at its beginning and at its tip") {
  State state = inking(InkTool::arrow);
  drag(state, nowhere, elsewhere);
  const InkArrow dragged = last<InkArrow>(state);
  click(state, nowhere);
  CHECK(ink_of(state).size() == 1);
  REQUIRE(state.ink.begun);
  update(state, action::PointerMoved{{90, 90}});
  CHECK(length(to_pixels(state, std::get<InkArrow>(state.ink.begun->mark.shape).to) - Vec2d(90, 90)) < 0.2);
  // Drawn meanwhile, and dropped by Escape, which then ends inking.
  CHECK(plan_view(state).size() > plan_view(inking(InkTool::arrow)).size());
  update(state, action::LeaveInk{});
  CHECK_FALSE(state.ink.begun);
  CHECK(state.ink.on);
  click(state, nowhere);
  click(state, elsewhere);
  CHECK(last<InkArrow>(state) == dragged);
  CHECK(ink_of(state).size() == 2);
  update(state, action::LeaveInk{});
  CHECK_FALSE(state.ink.on);
  // Nothing is drawn by two clicks in one place, or by a drag that is taken back.
  update(state, action::SetInk{true});
  click(state, nowhere);
  click(state, nowhere);
  update(state, action::PointerPressed{nowhere});
  update(state, action::PointerMoved{elsewhere});
  update(state, action::CancelDrag{});
  CHECK_FALSE(state.ink.begun);
  CHECK(ink_of(state).size() == 2);
}

TEST_CASE("a ruler keeps to what it measures and reads in the language's format") {
  State state = inking(InkTool::ruler);
  const Vec2d eye = plan(state.scene().camera.eye);
  const int ball = index_of_object(state.scene(), "Solid Sphere");
  const auto& sphere = std::get<Sphere<double>>(state.scene().objects[static_cast<std::size_t>(ball)].shape);
  const Vec2d from = to_pixels(state, eye), to = to_pixels(state, plan(sphere.centre));
  drag(state, from + Vec2d(3, 2), to + Vec2d(-2, 3));
  const Ruler ruler = last<Ruler>(state);
  CHECK(ruler.from == eye);
  CHECK(ruler.to == plan(sphere.centre));
  const double extent = length(plan(sphere.centre) - eye);
  CHECK(reading_of(ink_of(state).back(), in_english) == number_text(extent, in_english));
  CHECK(reading_of({Ruler{{0, 0}, {2.5, 0}}}, in_portuguese) == "2,5");
  CHECK_THAT(svg_of(state), contains(">" + number_text(extent, in_english) + "<"));
  // Control: on the grid; Shift: at an angle of whole 15 degrees.
  action::Modifiers control, shift;
  control.control = shift.shift = true;
  drag(state, nowhere, elsewhere, control);
  const double grid = grid_step(state.plan.camera);
  for (const double value : {last<Ruler>(state).from.x, last<Ruler>(state).from.y, last<Ruler>(state).to.x})
    CHECK(std::abs(value / grid - std::round(value / grid)) < 1e-9);
  drag(state, nowhere, nowhere + Vec2d(100, -55), shift);
  const Vec2d way = last<Ruler>(state).to - last<Ruler>(state).from;
  CHECK(std::abs(std::atan2(way.y, way.x) - std::numbers::pi / 6) < 1e-9);
}

TEST_CASE("a protractor reads the angle between a ray and the normal where it is mirrored") {
  State state = inking(InkTool::protractor);
  const RayRecord ray = mirrored_ray(state);
  const RayRecord incoming = state.walk.timeline->rays()[static_cast<std::size_t>(ray.parent)];
  const Vec2d hit = plan(incoming.end), normal = plan(incoming.normal) / length(plan(incoming.normal));
  const Vec2d back = -plan(incoming.direction) / length(plan(incoming.direction));
  const auto near = [&](const Vec2d& way, double pixels) {
    const Vec2d across(-way.y, way.x);
    return to_pixels(state, hit + (90.0 * way + pixels * across) / state.plan.camera.pixels_per_unit);
  };
  // The vertex and one arm by a drag, the other arm by a click: each a few pixels off.
  drag(state, to_pixels(state, hit) + Vec2d(2, -2), near(back, 4));
  REQUIRE(state.ink.begun);
  CHECK(ink_of(state).empty());
  click(state, near(normal, -4));
  const Protractor tool = last<Protractor>(state);
  const double angle = std::acos(dot(back, normal));
  const Vec2d a = tool.from - tool.vertex, b = tool.to - tool.vertex;
  CHECK(std::abs(std::acos(dot(a, b) / length(a) / length(b)) - angle) < 1e-6);
  CHECK(reading_of(ink_of(state).back(), in_english) ==
        number_text(angle * 180 / std::numbers::pi, in_english) + "\u00b0");
  // By three clicks too, and in a right angle.
  click(state, nowhere);
  click(state, nowhere + Vec2d(80, 0));
  action::Modifiers shift;
  shift.shift = true;
  click(state, nowhere + Vec2d(7, 80), shift);
  CHECK(reading_of(ink_of(state).back(), in_english) == "90\u00b0");
  // Half drawn, it is what undo takes back, and not the mark before.
  const std::size_t marks = ink_of(state).size();
  click(state, nowhere);
  REQUIRE(state.ink.begun);
  update(state, action::Undo{});
  CHECK_FALSE(state.ink.begun);
  CHECK(state.ink.on);
  CHECK(ink_of(state).size() == marks);
  update(state, action::Undo{});
  CHECK(ink_of(state).size() == marks - 1);
}

TEST_CASE("words are written where the plan is pressed") {
  State state = inking(InkTool::text);
  update(state, action::TypeInk{"too early"});
  CHECK(ink_of(state).empty());
  click(state, nowhere);
  REQUIRE(text_begun(state) != nullptr);
  update(state, action::TypeInk{"n = 1.5\n"});
  // For who does not see the window there is a field.
  bool has_field = false;
  for (const OutlineItem& region : outline(state))
    for (const OutlineItem& item : region.items) has_field = has_field || item.does == "ink-type {}";
  CHECK(has_field);
  const auto typed = outlined_action(state, "ink-type {}", "air, n = 1");
  REQUIRE(typed);
  update(state, *typed);
  update(state, action::FinishInk{});
  CHECK(last<InkText>(state).text == "air, n = 1");
  CHECK_THAT(svg_of(state), contains(">air, n = 1<"));
  // The next place, and another tool, end what is being written.
  click(state, elsewhere);
  update(state, action::TypeInk{"\u00e9t\u00e9"});
  click(state, {60, 200});
  CHECK(last<InkText>(state).text == "\u00e9t\u00e9");
  CHECK(text_begun(state) != nullptr);
  update(state, action::TypeInk{"  "});
  update(state, action::ChooseInkTool{InkTool::pen});
  CHECK(ink_of(state).size() == 2);  // blanks alone are nothing
  // Too long a line ends with a whole letter.
  update(state, action::ChooseInkTool{InkTool::text});
  click(state, nowhere);
  std::string longer = "x";
  for (int i = 0; i < 150; ++i) longer += "\u00e9";
  update(state, action::TypeInk{longer});
  update(state, action::FinishInk{});
  CHECK(last<InkText>(state).text == longer.substr(0, longest_ink_text - 1));
  CHECK(broken_promise(state) == "");
}

TEST_CASE("the eraser removes the marks that it touches, and they come back at once") {
  State state = inking(InkTool::pen);
  drag(state, {60, 60}, {60, 160});
  drag(state, {100, 60}, {100, 160});
  drag(state, {140, 60}, {140, 160});
  update(state, action::ChooseInkTool{InkTool::eraser});
  click(state, {80, 110});
  CHECK(ink_of(state).size() == 3);
  // In one sweep, faster than the eraser is wide.
  update(state, action::PointerPressed{{20, 110}});
  update(state, action::PointerMoved{{120, 110}});
  update(state, action::PointerReleased{{120, 110}});
  CHECK(ink_of(state).size() == 1);
  update(state, action::Undo{});
  CHECK(ink_of(state).size() == 3);
  click(state, {140, 100});
  CHECK(ink_of(state).size() == 2);
  // A sweep that is taken back has erased nothing.
  update(state, action::PointerPressed{{20, 110}});
  update(state, action::PointerMoved{{120, 110}});
  CHECK(ink_of(state).empty());
  update(state, action::CancelDrag{});
  CHECK(ink_of(state).size() == 2);
}

TEST_CASE("a finger draws as a mouse does: it presses where nothing pointed before, and is gone when it is lifted") {
  const auto touch = [](State& state, std::initializer_list<Vec2d> way) {
    update(state, action::PointerPressed{*way.begin()});
    for (const Vec2d& at : way) update(state, action::PointerMoved{at});
    update(state, action::PointerReleased{*(way.end() - 1)});
    update(state, action::PointerLeft{});
  };
  State state = inking(InkTool::pen);
  update(state, action::SetTouch{true});
  touch(state, {nowhere, {90, 70}, {120, 65}, elsewhere});
  REQUIRE(ink_of(state).size() == 1);
  update(state, action::ChooseInkTool{InkTool::ruler});
  touch(state, {{60, 200}, {100, 200}, {160, 200}});
  CHECK(ink_of(state).size() == 2);
  // A second finger takes the first one's stroke back before it moves the plan.
  update(state, action::PointerPressed{{60, 260}});
  update(state, action::PointerMoved{{90, 260}});
  update(state, action::CancelDrag{});
  CHECK(ink_of(state).size() == 2);
  // The eraser reaches as far as a finger is wide, which is farther than a mouse's.
  update(state, action::ChooseInkTool{InkTool::eraser});
  const Vec2d beside = nowhere - Vec2d(1.5 * Sizes(state).reach, 0);
  update(state, action::SetTouch{false});
  touch(state, {beside});
  CHECK(ink_of(state).size() == 2);
  update(state, action::SetTouch{true});
  touch(state, {beside});
  CHECK(ink_of(state).size() == 1);
}

TEST_CASE("a stroke keeps its shape with few points, and is drawn round") {
  std::vector<Vec2d> circle;
  for (int i = 0; i <= 720; ++i) {
    const double angle = i * std::numbers::pi / 360;
    circle.emplace_back(100 * std::cos(angle), 100 * std::sin(angle));
  }
  const std::vector<Vec2d> few = simplified(circle, 0.3);
  CHECK(few.size() < 80);
  for (const Vec2d& at : smooth(few, 2)) CHECK(std::abs(length(at) - 100) < 0.4);
  CHECK(simplified({{0, 0}, {1, 0}, {2, 0}, {2, 1}}, 0.1).size() == 3);
  CHECK(rounded({3.4519999, -0.0004}, 0.001) == Vec2d(3.452, 0));
  CHECK(rounded({123456.7, 5}, 60) == Vec2d(123500, 0));
}

TEST_CASE("the plate under words is hardly wider than they are") {
  State state = inking(InkTool::text);
  const std::string words = "Hola, ray (q) 1";
  state.document.contents.ink = {{InkText{{-2, 2}, words}}};
  const DisplayList list = plan_view(state);
  double plate = 0;
  for (const DisplayItem& item : list) {
    if (const auto* text = std::get_if<TextItem>(&item.shape); text != nullptr && text->text == words) {
      CHECK(plate > width_of(words, text->size));
      CHECK(plate < width_of(words, text->size) + text->size);
      return;
    }
    if (const auto* polygon = std::get_if<PolygonItem>(&item.shape); polygon != nullptr && polygon->points.size() == 4)
      plate = polygon->points[1].x - polygon->points[0].x;
  }
  FAIL("the words are not there");
}

TEST_CASE("ink is seen on the plan in every colour and theme") {
  for (const Theme theme : {Theme::dark, Theme::projector})
    for (const auto& [colour, name] : words_of<InkColour>) {
      INFO(name);
      CHECK(contrast(ink_colour(colour, theme), palette(theme).plan) > 4.5);
      for (const Language language : all_languages()) CHECK_FALSE(text(colour, language).empty());
    }
}
