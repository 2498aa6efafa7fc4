// The scenes of scenes/hard: each has one hard case and an answer that is known without tracing it. In both scalar
// types and with every accelerator.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "io/scene_file.h"
#include "render/render.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

struct Shown {
  Image image;
  Statistics statistics;
  [[nodiscard]] const Rgb<float>& middle() const { return image.at(image.width / 2, image.height / 2); }
  [[nodiscard]] std::uint64_t rays(RayKind kind) const { return statistics.rays[static_cast<std::size_t>(kind)]; }
  /// How many pixels have this red.
  [[nodiscard]] int count(float red) const {
    int count = 0;
    for (const Rgb<float>& pixel : image.pixels) count += pixel.x == red;
    return count;
  }
  [[nodiscard]] int size() const { return static_cast<int>(image.pixels.size()); }
};

Scene hard_scene(const std::string& name) {
  const auto document = read_scene(RAYWALK_SOURCE_DIR "/scenes/hard/" + name + ".toml");
  INFO((document ? name : document.error().text()));
  REQUIRE(document);
  CHECK(document->warnings.empty());
  return document->scene;
}

Shown shown(const Scene& scene, Precision precision) {
  RenderSettings settings;
  settings.precision = precision;
  const auto rendering = render(scene, settings);
  REQUIRE(rendering);
  CHECK(rendering->statistics.not_finite == 0);
  return {rendering->image(), rendering->statistics};
}

/// Calls `expect` with what the scene shows in float and in double.
template <class Expect>
void in_both(const std::string& name, Expect expect) {
  const Scene scene = hard_scene(name);
  for (const Precision precision : {Precision::double_, Precision::float_}) {
    INFO(name << (precision == Precision::float_ ? ", float" : ", double"));
    expect(shown(scene, precision));
  }
}

}  // namespace

TEST_CASE("every hard scene is read, says what it is, has no NaN, and looks the same whatever finds its objects") {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RAYWALK_SOURCE_DIR "/scenes/hard")) {
    const std::string name = entry.path().stem().string();
    INFO(name);
    const Scene scene = hard_scene(name);
    CHECK(scene.title.rfind("Hard: ", 0) == 0);
    CHECK_FALSE(scene.description.empty());
    for (const Precision precision : {Precision::double_, Precision::float_}) {
      std::vector<Image> images;
      using enum AcceleratorKind;
      for (const AcceleratorKind kind : {none, bvh, grid, octree, kdtree}) {
        RenderSettings settings;
        settings.precision = precision;
        settings.accelerator = kind;
        const auto rendering = render(scene, settings);
        REQUIRE(rendering);
        CHECK(rendering->statistics.not_finite == 0);
        images.push_back(rendering->image());
        CHECK(images.back() == images.front());
      }
    }
    ++scenes;
  }
  CHECK(scenes == 18);
}

TEST_CASE("a corner of mirrors turns every ray back") {
  in_both("mirror_corner", [](const Shown& picture) {
    int wrong = 0, corner = 0;
    for (const Rgb<float>& pixel : picture.image.pixels) {
      wrong += pixel.x != 1.25f && pixel.x != 1.125f;
      corner += pixel.x == 1.125f;
    }
    CHECK(wrong == 0);
    CHECK(corner <= picture.image.height);  // only the middle column looks into the corner
  });
}

TEST_CASE("a ray that touches the sphere hits it, and its neighbour outwards does not") {
  in_both("tangent_ray", [](const Shown& picture) {
    // Column 0 is the leftmost: left of where one looks is the sphere.
    CHECK(picture.image.at(0, 0) == Rgb<float>(1.0f));
    CHECK(picture.image.at(1, 0) == Rgb<float>(1.0f));
    CHECK(picture.image.at(2, 0) == Rgb<float>(0.0f));
  });
}

TEST_CASE("edges and vertices belong to what they bound") {
  in_both("along_edge", [](const Shown& picture) { CHECK(picture.middle() == Rgb<float>(1.0f)); });
  in_both("through_vertex", [](const Shown& picture) {
    CHECK(picture.middle() == Rgb<float>(1.0f));
    // The octahedron's outline is a square on its corner: |y| + |z| <= 1 at the distance 5.
    const double half = std::tan(15 * 3.14159265358979323846 / 180) * 5;
    int wrong = 0;
    for (int row = 0; row < 41; ++row)
      for (int column = 0; column < 41; ++column) {
        const double reach = half * (std::abs(2 * column + 1 - 41) + std::abs(2 * row + 1 - 41)) / 41;
        wrong += picture.image.at(column, row).x != (reach < 1 ? 1.0f : 0.0f);
      }
    CHECK(wrong == 0);
  });
}

TEST_CASE("at the critical angle all is reflected, on whichever side rounding puts it") {
  in_both("critical_angle", [](const Shown& picture) { CHECK(picture.middle().x == 0.5f); });
}

TEST_CASE("a ray that grazes the inside of a ball is reflected without end") {
  in_both("grazing_inside", [](const Shown& picture) {
    CHECK(picture.count(1.0f) == picture.size());
    CHECK(picture.rays(RayKind::reflect) == 31u * 9u);
    CHECK(picture.rays(RayKind::refract) == 0);
  });
}

TEST_CASE("of coincident surfaces the first is seen everywhere") {
  in_both("coincident_surfaces", [](const Shown& picture) {
    CHECK(picture.count(1.0f) == picture.size());
    for (const Rgb<float>& pixel : picture.image.pixels) CHECK(pixel.y == 0);
  });
}

TEST_CASE("lights on and inside surfaces light nothing else") {
  in_both("light_on_surface", [](const Shown& picture) {
    CHECK(picture.count(0.5f) == picture.size());
    CHECK(picture.rays(RayKind::shadow) == 0);
    CHECK(picture.statistics.ends(Ending::facing_away) == static_cast<std::uint64_t>(picture.size()));
  });
  in_both("light_inside", [](const Shown& picture) {
    CHECK(picture.count(0.5f) == picture.size());
    CHECK(picture.statistics.ends(Ending::reached_light) == 0);
  });
}

TEST_CASE("the eye on a ball sees the sky, and inside of one the ball") {
  in_both("eye_on_surface", [](const Shown& picture) { CHECK(picture.count(0.25f) == picture.size()); });
  in_both("eye_inside", [](const Shown& picture) { CHECK(picture.count(0.75f) == picture.size()); });
}

TEST_CASE("a ray through three nested balls meets six surfaces") {
  in_both("nested_glass", [](const Shown& picture) {
    CHECK(picture.count(0.5f + 6 * 0.015625f) == picture.size());
    CHECK(picture.rays(RayKind::refract) == 6u * 25u);
  });
}

TEST_CASE("bubbles in glass mirror each other to the last bit") {
  in_both("bubbles", [](const Shown& picture) {
    int differing = 0;
    for (int row = 0; row < 33; ++row)
      for (int column = 0; column < 33; ++column)
        differing += picture.image.at(column, row) != picture.image.at(32 - column, row);
    CHECK(differing == 0);
    CHECK(picture.rays(RayKind::refract) > 3000);
  });
}

TEST_CASE("a thousand reflections between two mirrors add up exactly") {
  in_both("facing_mirrors", [](const Shown& picture) {
    CHECK(picture.middle().x == 1000.0f / 1024);
    CHECK(picture.rays(RayKind::reflect) == 999);
  });
}

TEST_CASE("a tiny ball is seen before a huge one") {
  in_both("tiny_beside_huge", [](const Shown& picture) {
    CHECK(picture.middle().x == 1.0f);
    CHECK(picture.count(1.0f) == 1);
    CHECK(picture.count(0.25f) == picture.size() - 1);
  });
}

TEST_CASE("far from the origin a scene shows what it shows there") {
  const Scene far = hard_scene("far_from_origin");
  Scene near = far;
  const Vec3d back(-1073741824, 1073741824, 0);
  near.camera.eye += back;
  near.camera.look_at += back;
  std::get<PointLight>(near.lights[0].kind).position += back;
  for (Object& object : near.objects) {
    if (auto* ball = std::get_if<Sphere<double>>(&object.shape)) ball->centre += back;
    if (auto* plane = std::get_if<Plane<double>>(&object.shape)) plane->point += back;
  }
  const Shown out_there = shown(far, Precision::double_), here = shown(near, Precision::double_);
  CHECK(here.rays(RayKind::primary) == out_there.rays(RayKind::primary));
  // Primary rays start on the grid; what is reflected starts where it was rounded to the grid out there.
  int differing = 0;
  for (int i = 0; i < here.size(); ++i) {
    const Rgb<float> off =
        here.image.pixels[static_cast<std::size_t>(i)] - out_there.image.pixels[static_cast<std::size_t>(i)];
    differing += std::abs(off.x) + std::abs(off.y) + std::abs(off.z) > 1e-5f;
  }
  CHECK(differing == 0);
  std::set<float> reds;
  for (const Rgb<float>& pixel : here.image.pixels) reds.insert(pixel.x);
  CHECK(reds.size() > 100);
}

TEST_CASE("slivers close a wall without a gap") {
  in_both("slivers", [](const Shown& picture) {
    // The wall is a square on its corner, |y| / 2 + |z| / 4 <= 1; the view is narrower but at its corners.
    const double half = std::tan(10 * 3.14159265358979323846 / 180) * 4;
    int wrong = 0;
    for (int row = 0; row < 31; ++row)
      for (int column = 0; column < 41; ++column) {
        const double y = half * (2 * column + 1 - 41) / 41, z = half * (2 * row + 1 - 31) / 41;
        wrong += picture.image.at(column, row).x != (std::abs(y) / 2 + std::abs(z) / 4 < 1 ? 1.0f : 0.0f);
      }
    CHECK(wrong == 0);
  });
}

TEST_CASE("a mirrored object is lit as its image is") {
  in_both("mirrored_transform", [](const Shown& picture) {
    int differing = 0, lit = 0;
    for (int row = 0; row < 31; ++row)
      for (int column = 0; column < 41; ++column) {
        const Rgb<float>& pixel = picture.image.at(column, row);
        differing += length(Vec3<float>(pixel - picture.image.at(40 - column, row))) > 1e-5f;
        lit += pixel.x > 0.12f;
      }
    CHECK(differing == 0);
    CHECK(lit > 20);
  });
}
