// Naive numerics in the tracers: easy scenes look the same, the hard ones fail as their notes say, and all that the
// design promises of any policy holds of this one too.
#include <cmath>
#include <string>

#include "io/scene_file.h"
#include "render/render.h"
#include "render/scenes.h"
#include "support/catch.h"
#include "trace/paths.h"

using namespace raywalk;

namespace {

Scene shipped(const std::string& name) { return read_scene(RAYWALK_SOURCE_DIR "/scenes/" + name + ".toml")->scene; }

Scene naive(Scene scene, double epsilon = default_epsilon) {
  scene.render.numerics = Numerics::naive;
  scene.render.epsilon = epsilon;
  return scene;
}

Image shown(const Scene& scene, Precision precision, ImageSize size) {
  RenderSettings settings{size, Sampling{}, precision};
  return render(scene, settings).value().image();
}

// The share of pixels that differ by more than a hundredth in some channel.
double differing(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgb<float> off = a.pixels[i] - b.pixels[i];
    count += !(std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) < 0.01f);
  }
  return count / static_cast<double>(a.pixels.size());
}

// How much of a hard scene naive numerics paint wrong.
double wrong(const std::string& name, double epsilon, Precision precision = Precision::double_) {
  const Scene scene = shipped("hard/" + name);
  return differing(shown(naive(scene, epsilon), precision, scene.image), shown(scene, precision, scene.image));
}

}  // namespace

TEST_CASE("easy scenes look the same with naive numerics") {
  for (const char* name : {"classic", "whitted", "quadrics", "mesh", "shadows", "glass"}) {
    INFO(name);
    const Scene scene = shipped(name);
    const double share =
        differing(shown(naive(scene), Precision::double_, {80, 60}), shown(scene, Precision::double_, {80, 60}));
    CHECK(share < 0.01);
  }
}

TEST_CASE("hard scenes fail with naive numerics as their notes say") {
  // Without an epsilon surfaces shade and block themselves.
  for (const char* name : {"bubbles", "mirror_corner", "far_from_origin", "mirrored_transform"}) {
    INFO(name);
    CHECK(wrong(name, 0) > 0.02);
  }
  // Not so where the ray knows what it is inside of.
  CHECK(wrong("grazing_inside", 0) == 0);
  // With one that suits these scenes they do not, in double; a float needs a larger one.
  for (const char* name : {"grazing_inside", "mirror_corner", "mirrored_transform"}) {
    INFO(name);
    CHECK(wrong(name, 1e-6) == 0);
  }
  CHECK(wrong("mirrored_transform", 1e-6, Precision::float_) > 0.02);
  // With the usual one light leaks out of what is smaller, and what lies closer is passed through.
  CHECK(wrong("light_inside", default_epsilon) > 0.3);
  CHECK(wrong("nested_glass", default_epsilon) > 0.3);
  // And no epsilon helps a triangle that is too thin, or digits that are not there.
  CHECK(wrong("slivers", default_epsilon) > 0.02);
  CHECK(wrong("tiny_beside_huge", default_epsilon, Precision::float_) > 0.3);
}

TEMPLATE_TEST_CASE("with naive numerics too the strip is the middle row, and watching changes nothing", "", float,
                   double) {
  for (const Scene& shown : {shipped("classic"), shipped("shadows"), test::busy_scene()}) {
    INFO(shown.title);
    for (const double epsilon : {0.0, default_epsilon}) {
      const Scene scene = naive(shown, epsilon);
      const int cells = scene.camera.screen.cells;
      RenderSettings settings{ImageSize{3 * cells, 5}, Sampling{}, test::precision_of<TestType>()};
      const auto strip = render_strip(scene, settings), image = render(scene, settings);
      int unequal = 0;
      for (int cell = 0; cell < cells; ++cell)
        unequal +=
            !test::same_bits(strip->film_of<TestType>().at(cell, 0), image->film_of<TestType>().at(3 * cell + 1, 2));
      CHECK(unequal == 0);
      test::Recording recording;
      const auto unwatched = test::picture<TestType>(scene, 24, 15),
                 watched = test::watched_picture<TestType>(scene, 24, 15, recording);
      CHECK(watched.pixels == unwatched.pixels);
      CHECK(test::text_of(watched.statistics) == test::text_of(unwatched.statistics));
      CHECK_FALSE(recording.events.empty());
    }
  }
}

TEST_CASE("naive rays are shown where they start: epsilon off the surface") {
  Scene scene;
  scene.objects = {test::object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, Material{})};
  scene.lights = {test::lamp({0, 0, 4})};
  for (const double epsilon : {0.0, 0.25}) {
    const auto recording = test::record_along(naive(scene, epsilon), {-1, 0, 2}, {0, 0, 0});
    const auto formed = recording.all<RayFormed>();
    REQUIRE(formed.size() == 2);
    CHECK(formed[1].origin == Vec3d(0, 0, epsilon));
  }
}

TEST_CASE("paths may be naive too, watched or not") {
  const Scene scene = shipped("cornell");
  test::Recording recording;
  const auto robust = test::path_picture<double>(scene, 24, 18),
             plain = test::path_picture<double>(naive(scene), 24, 18),
             watched = test::path_picture<double>(naive(scene), 24, 18, {}, {}, &recording),
             speckled = test::path_picture<double>(naive(scene, 0), 24, 18);
  CHECK(watched.pixels == plain.pixels);
  CHECK_FALSE(recording.events.empty());
  const auto unequal = [&](const auto& picture) {
    int count = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
      count += length(picture.pixels[i] - robust.pixels[i]) > 1e-3 * (1 + length(robust.pixels[i]));
    return count;
  };
  CHECK(unequal(plain) < 24 * 18 / 20);
  CHECK(unequal(speckled) > 24 * 18 / 4);
}
