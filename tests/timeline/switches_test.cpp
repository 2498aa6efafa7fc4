// Effects that are switched off, to see what they do: no ray of theirs is formed, and nothing else changes.
#include <algorithm>

#include "io/scene_file.h"
#include "render/render.h"
#include "scene/effects.h"
#include "support/catch.h"
#include "timeline/recorder.h"

using namespace raywalk;

namespace {

Scene classic() { return read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml").value().scene; }

template <class Keep>
int count(const Timeline& timeline, Keep keep) {
  return static_cast<int>(std::count_if(timeline.rays().begin(), timeline.rays().end(), keep));
}
int formed(const Timeline& timeline, RayKind kind) {
  return count(timeline, [&](const RayRecord& ray) { return ray.formed && ray.kind == kind; });
}

Rendering drawn(const Scene& scene) {
  RenderSettings settings;
  settings.size = {63, 47};
  return render(scene, settings).value();
}

}  // namespace

TEST_CASE(
    "without shadows no shadow ray is formed, every light in front of a surface reaches it, the rest is as it was") {
  Scene scene = classic();
  scene.render.numerics = GENERATE(Numerics::robust, Numerics::naive);
  const Timeline with = record_strip(scene);
  const Rendering lit = drawn(scene);
  scene.render.switches.shadows = false;
  const Timeline without = record_strip(scene);
  REQUIRE(formed(with, RayKind::shadow) > 0);
  CHECK(formed(without, RayKind::shadow) == 0);
  for (const RayKind kind : {RayKind::primary, RayKind::reflect, RayKind::refract})
    CHECK(formed(without, kind) == formed(with, kind));
  // A pixel is brighter exactly where a shadow ray was blocked or dimmed, else the same bits.
  int brighter = 0;
  for (std::size_t i = 0; i < with.pixels().size(); ++i) {
    const Rgbd before = with.pixels()[i].shade, after = without.pixels()[i].shade;
    CHECK(after.x >= before.x);
    const auto [first, last] = with.rays_of_pixel(static_cast<int>(i));
    const bool dimmed = std::any_of(with.rays().begin() + first, with.rays().begin() + last, [](const RayRecord& ray) {
      return ray.formed && ray.kind == RayKind::shadow && ray.transmittance != Rgbd(1.0);
    });
    if (!dimmed) CHECK(after == before);
    brighter += after.x > before.x ? 1 : 0;
  }
  CHECK(brighter > 0);
  const Rendering unshadowed = drawn(scene);
  CHECK(unshadowed.statistics.formed(RayKind::shadow) == 0);
  CHECK(unshadowed.statistics.formed(RayKind::primary) == lit.statistics.formed(RayKind::primary));
}

TEST_CASE("watched or not, a scene without shadows, reflection or refraction has the same bits") {
  const Numerics numerics = GENERATE(Numerics::robust, Numerics::naive);
  for (int left_out = 0; left_out < 8; ++left_out) {
    Scene scene = classic();
    scene.render.numerics = numerics;
    scene.render.switches = {(left_out & 1) == 0, (left_out & 2) == 0, (left_out & 4) == 0};
    CAPTURE(left_out);
    const Timeline watched = record_strip(scene);
    RenderSettings settings;
    const Rendering strip = render_strip(scene, settings).value();
    const Image image = strip.image();
    for (const PixelRecord& pixel : watched.pixels()) CHECK(image.at(pixel.column, 0) == Rgb<float>(pixel.shade));
  }
}

TEST_CASE("without reflection or refraction none of their rays is formed, but for total reflection inside") {
  Scene scene = classic();
  REQUIRE(formed(record_strip(scene), RayKind::reflect) > 0);
  REQUIRE(formed(record_strip(scene), RayKind::refract) > 0);
  scene.render.switches = {true, true, false};
  CHECK(formed(record_strip(scene), RayKind::refract) == 0);
  CHECK_FALSE(effects_of(scene).used(Effect::refraction));
  scene.render.switches = {true, false, false};
  CHECK(formed(record_strip(scene), RayKind::reflect) == 0);
  CHECK_FALSE(effects_of(scene).used(Effect::reflection));
  scene.render.switches = {true, false, true};
  CHECK(formed(record_strip(scene), RayKind::refract) > 0);
}
