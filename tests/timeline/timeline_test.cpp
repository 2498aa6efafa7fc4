#include "timeline/timeline.h"

#include "timeline/recorder.h"

#include "support/catch.h"

using namespace raywalk;

namespace {

Scene small_scene() {
  Scene scene;
  scene.camera.eye = Vec3d(-5, 0, 0);
  scene.camera.screen = Screen{2, 2.0, 9};
  scene.limits.depth = 4;
  scene.lights.push_back({"Lamp", Rgbd(1.0), PointLight{Vec3d(-2, 3, 0), {}}});
  Material glass;
  glass.reflection = Rgbd(0.2);
  glass.transmission = Rgbd(0.7);
  scene.objects.push_back({"Ball", Sphere<double>{Vec3d(0.0), 1}, glass});
  scene.objects.push_back({"Block", Prism<double>{{{2, -2}, {3, -2}, {3, 2}, {2, 2}}, 1}, Material{}});
  return scene;
}

/// What a naive player holds after the first k events.
struct Replayed {
  int rays = 0;
  int pixel = -1;
  std::vector<int> stack;  ///< frames, innermost last
  int frames = 0;
};

void replay(Replayed& state, const Event& event) {
  if (std::holds_alternative<PixelBegun>(event.detail)) ++state.pixel;
  if (std::holds_alternative<RayFormed>(event.detail) || std::holds_alternative<RayNotFormed>(event.detail))
    ++state.rays;
  if (const auto* called = std::get_if<ShadeCalled>(&event.detail); called != nullptr && !called->missed)
    state.stack.push_back(state.frames++);
  if (std::holds_alternative<ShadeComputed>(event.detail)) state.stack.pop_back();
}

}  // namespace

TEST_CASE("the state at every position is that of a replay of the events before it") {
  const Timeline timeline = record_strip(small_scene());
  REQUIRE(timeline.steps() > 100);
  Replayed expected;
  for (int position = 0; position <= timeline.steps(); ++position) {
    if (position > 0) replay(expected, timeline.event(position - 1));
    REQUIRE(static_cast<int>(timeline.rays_at(position).size()) == expected.rays);
    REQUIRE(timeline.current_pixel(position) == expected.pixel);
    REQUIRE(timeline.stack(position) == std::vector<int>(expected.stack.rbegin(), expected.stack.rend()));
    REQUIRE((timeline.just_run(position) == nullptr) == (position == 0));
    REQUIRE((timeline.next(position) == nullptr) == (position == timeline.steps()));
  }
  CHECK(expected.stack.empty());
}

TEST_CASE("a pixel's rays are contiguous, parents before children") {
  const Timeline timeline = record_strip(small_scene());
  int next = 0;
  for (int pixel = 0; pixel < static_cast<int>(timeline.pixels().size()); ++pixel) {
    const Timeline::Range range = timeline.rays_of_pixel(pixel);
    CHECK(range.first == next);
    next = range.last;
    for (int i = range.first; i < range.last; ++i) {
      const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(i)];
      CHECK(ray.pixel == pixel);
      CHECK(ray.parent < i);
      CHECK((ray.parent >= range.first || ray.kind == RayKind::primary));
      CHECK(ray.formed_at <= ray.found_at);
    }
  }
  CHECK(next == static_cast<int>(timeline.rays().size()));
}

TEST_CASE("grains stop where they say, and backwards visits what forwards visited") {
  const Timeline timeline = record_strip(small_scene());
  const auto walk = [&](auto forward, auto back) {
    std::vector<int> there{0}, home{timeline.steps()};
    while (there.back() < timeline.steps()) there.push_back((timeline.*forward)(there.back()));
    while (home.back() > 0) home.push_back((timeline.*back)(home.back()));
    CHECK(there == std::vector<int>(home.rbegin(), home.rend()));
    return there;
  };
  const auto rays = walk(&Timeline::next_ray, &Timeline::previous_ray);
  for (std::size_t i = 1; i + 1 < rays.size(); ++i)
    CHECK(timeline.rays_at(rays[i]).size() == timeline.rays_at(rays[i] - 1).size() + 1);
  const auto pixels = walk(&Timeline::next_pixel, &Timeline::previous_pixel);
  CHECK(pixels.size() == timeline.pixels().size() + 1);
  for (std::size_t i = 1; i < pixels.size(); ++i) CHECK(timeline.just_run(pixels[i])->line == Line::put_final_shade);
}

TEST_CASE("a frame is on the stack from its call until it returns") {
  const Timeline timeline = record_strip(small_scene());
  for (std::size_t i = 0; i < timeline.frames().size(); ++i) {
    const FrameRecord& frame = timeline.frames()[i];
    const auto on_stack = [&](int position) {
      for (const int call : timeline.stack(position))
        if (call == static_cast<int>(i)) return true;
      return false;
    };
    CHECK_FALSE(on_stack(frame.called_at - 1));
    CHECK(on_stack(frame.called_at));
    CHECK(on_stack(frame.returned_at - 1));
    CHECK_FALSE(on_stack(frame.returned_at));
    const auto& computed = std::get<ShadeComputed>(timeline.just_run(frame.returned_at)->detail);
    CHECK(computed.total == frame.returned);
    CHECK(timeline.current_frame(frame.returned_at) == static_cast<int>(i));
  }
}

TEST_CASE("rays end where events say, endless ones nowhere") {
  const Timeline timeline = record_strip(small_scene());
  for (const RayRecord& ray : timeline.rays()) {
    if (!ray.formed) continue;
    CHECK(ray.endless == (ray.ending == Ending::missed));
    if (ray.ending == Ending::hit) CHECK(ray.object >= 0);
    if (ray.ending == Ending::reached_light) CHECK(length(ray.end - Vec3d(-2, 3, 0)) < 1e-12);
    CHECK(std::abs(length(cross(ray.end - ray.origin, ray.direction))) < 1e-9);
  }
}

TEST_CASE("an empty timeline has one position") {
  const Timeline timeline;
  CHECK(timeline.steps() == 0);
  CHECK(timeline.just_run(0) == nullptr);
  CHECK(timeline.next(0) == nullptr);
  CHECK(timeline.current_pixel(0) == -1);
  CHECK(timeline.stack(0).empty());
  CHECK(timeline.next_ray(0) == 0);
  CHECK(timeline.previous_pixel(0) == 0);
}
