// Walking by calls, and breakpoints, against what the events themselves say.
#include "timeline/stops.h"

#include "io/scene_file.h"
#include "support/catch.h"
#include "timeline/recorder.h"

using namespace raywalk;

namespace {

Scene shipped(const std::string& name) {
  return read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml").value().scene;
}

bool calls(const Event& event) {
  const auto* called = std::get_if<ShadeCalled>(&event.detail);
  return called != nullptr && !called->missed;
}
bool returns(const Event& event) { return std::holds_alternative<ShadeComputed>(event.detail); }

/// All positions at which `breakpoints` stop.
std::vector<int> all_stops(const Breakpoints& breakpoints, const Scene& scene, const Timeline& timeline) {
  std::vector<int> stops;
  for (int at = 0; at < timeline.steps();) {
    at = next_stop(breakpoints, scene, timeline, at, timeline.steps());
    if (at < timeline.steps()) stops.push_back(at);
  }
  return stops;
}

}  // namespace

TEST_CASE("a step over a call ends where as many SHADEs have returned as were called") {
  const Timeline timeline = record_strip(shipped("classic"));
  for (int position = 0; position < timeline.steps(); ++position) {
    int open = 0, expected = position;
    do {
      const Event& event = timeline.event(expected++);
      open += calls(event) ? 1 : 0;
      open -= returns(event) ? 1 : 0;
    } while (open > 0);
    REQUIRE(step_over(timeline, position) == expected);
  }
  CHECK(step_over(timeline, timeline.steps()) == timeline.steps());
}

TEST_CASE("a step out of SHADE ends with its last line, and in MAIN ALGORITHM with the pixel") {
  const Timeline timeline = record_strip(shipped("classic"));
  int inside = 0;
  for (int position = 0; position < timeline.steps(); ++position) {
    if (position > 0)
      inside += calls(timeline.event(position - 1)) ? 1 : returns(timeline.event(position - 1)) ? -1 : 0;
    int open = inside, expected = position;
    while (inside > 0 ? open >= inside
                      : expected == position || timeline.event(expected - 1).line != Line::put_final_shade) {
      const Event& event = timeline.event(expected++);
      open += calls(event) ? 1 : returns(event) ? -1 : 0;
    }
    REQUIRE(step_out(timeline, position) == expected);
  }
}

TEST_CASE("back over and back out lead to before the call that over and out end") {
  const Timeline timeline = record_strip(shipped("classic"));
  for (int position = 0; position < timeline.steps(); ++position) {
    const int over = step_over(timeline, position);
    // From the end of a SHADE the way back is to before its call, whether or not one came from inside.
    if (returns(timeline.event(position))) {
      const Event& called = timeline.event(step_back_over(timeline, over));
      REQUIRE(calls(called));
      REQUIRE(called.depth + 1 == timeline.event(position).depth);
      continue;
    }
    REQUIRE(step_back_over(timeline, over) == position);
    if (calls(timeline.event(position))) {
      REQUIRE(step_out(timeline, position + 1) == over);
      REQUIRE(step_back_out(timeline, position + 1) == position);
    }
  }
  CHECK(step_back_over(timeline, 0) == 0);
  CHECK(step_back_out(timeline, 0) == 0);
}

TEST_CASE("a breakpoint on a line stops before each of its runs, and nowhere else") {
  const Scene scene = shipped("classic");
  const Timeline timeline = record_strip(scene);
  for (const PseudocodeLine& row : pseudocode) {
    Breakpoints breakpoints;
    breakpoints.before[static_cast<std::size_t>(row.line)] = true;
    std::vector<int> expected;
    for (int i = 1; i < timeline.steps(); ++i)
      if (timeline.event(i).line == row.line) expected.push_back(i);
    INFO(row.text);
    REQUIRE_FALSE(expected.empty());
    REQUIRE(all_stops(breakpoints, scene, timeline) == expected);
    // Backwards the same places, from the end.
    REQUIRE(previous_stop(breakpoints, scene, timeline, timeline.steps()) == expected.back());
    REQUIRE(previous_stop(breakpoints, scene, timeline, expected.front()) == 0);
  }
  CHECK(all_stops({}, scene, timeline).empty());
}

TEST_CASE("a depth stops at each call that reaches it, and not at the deeper ones") {
  const Scene scene = shipped("classic");
  const Timeline timeline = record_strip(scene);
  for (const int depth : {1, 2, 3}) {
    Breakpoints breakpoints;
    breakpoints.depth = depth;
    std::vector<int> expected;
    for (const FrameRecord& frame : timeline.frames())
      if (frame.depth == depth) expected.push_back(frame.called_at);
    REQUIRE(expected.size() > 1);
    CHECK(all_stops(breakpoints, scene, timeline) == expected);
  }
}

TEST_CASE("a walk stops where total internal reflection, an object or a pixel asks for it") {
  const Scene scene = shipped("glass");
  const Timeline timeline = record_strip(scene);
  std::vector<int> total, hits, begun;
  for (int i = 0; i < timeline.steps(); ++i) {
    const EventDetail& detail = timeline.event(i).detail;
    const auto* decided = std::get_if<Decided>(&detail);
    const auto* found = std::get_if<Found>(&detail);
    const auto* pixel = std::get_if<PixelBegun>(&detail);
    if (decided != nullptr && decided->why) total.push_back(i + 1);
    if (found != nullptr && found->ending == Ending::hit &&
        scene.objects[static_cast<std::size_t>(found->object)].name == "Prism")
      hits.push_back(i + 1);
    if (pixel != nullptr && pixel->column == 7) begun.push_back(i + 1);
  }
  REQUIRE_FALSE(total.empty());
  REQUIRE(hits.size() > 3);
  REQUIRE(begun.size() == 1);
  Breakpoints at_total, at_object, at_pixel;
  at_total.total_internal_reflection = true;
  at_object.object = "Prism";
  at_pixel.pixel = 7;
  CHECK(all_stops(at_total, scene, timeline) == total);
  CHECK(all_stops(at_object, scene, timeline) == hits);
  CHECK(all_stops(at_pixel, scene, timeline) == begun);
}

TEST_CASE("a depth of a traced path counts its rays") {
  Scene scene = shipped("classic");
  scene.render.integrator = Integrator::path;
  const Timeline timeline = record_strip(scene);
  REQUIRE(timeline.of_paths());
  Breakpoints breakpoints;
  breakpoints.depth = 2;
  std::vector<int> expected;
  for (int i = 0; i < timeline.steps(); ++i) {
    const Event& event = timeline.event(i);
    if (event.line == Line::form_next_ray && timeline.event(i + 1).depth == 2) expected.push_back(i + 1);
  }
  REQUIRE_FALSE(expected.empty());
  CHECK(all_stops(breakpoints, scene, timeline) == expected);
}

TEST_CASE("a depth of photons, and of the rays that gather them, counts too") {
  const Scene scene = shipped("caustic");
  const Timeline timeline = record_strip(scene);
  REQUIRE(timeline.of_photons());
  Breakpoints breakpoints;
  breakpoints.depth = 2;
  std::vector<int> formed;
  for (int i = 0; i + 1 < timeline.steps(); ++i) {
    const Line line = timeline.event(i).line;
    const bool forms = line == Line::photon_form_next_ray || line == Line::gather_form_next_ray;
    if (forms && timeline.event(i).depth == 1) formed.push_back(i + 1);
  }
  REQUIRE_FALSE(formed.empty());
  CHECK(all_stops(breakpoints, scene, timeline) == formed);
}

TEST_CASE("a walk of beams or cones stops where a part sees the object") {
  for (const Integrator integrator : {Integrator::beams, Integrator::cones}) {
    Scene scene = shipped("beams");
    scene.render.integrator = integrator;
    const Timeline timeline = record_strip(scene);
    REQUIRE(timeline.has_width());
    Breakpoints breakpoints;
    breakpoints.object = "Red Post";
    std::vector<int> expected;
    for (int i = 0; i < timeline.steps(); ++i) {
      const EventDetail& detail = timeline.event(i).detail;
      bool sees = false;
      if (const auto* cut = std::get_if<BeamCut>(&detail))
        for (const BeamPiece& piece : cut->pieces)
          sees =
              sees || (piece.object >= 0 && scene.objects[static_cast<std::size_t>(piece.object)].name == "Red Post");
      if (const auto* found = std::get_if<Found>(&detail))
        sees = found->ending == Ending::hit && found->object >= 0 &&
               scene.objects[static_cast<std::size_t>(found->object)].name == "Red Post";
      if (sees) expected.push_back(i + 1);
    }
    REQUIRE_FALSE(expected.empty());
    CHECK(all_stops(breakpoints, scene, timeline) == expected);
  }
}
