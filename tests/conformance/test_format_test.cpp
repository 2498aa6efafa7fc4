// The course scene with a known solution, and that the other ones can be read and show something.

#include "image/image_file.h"
#include "io/scene_file.h"
#include "png.h"
#include "render/render.h"
#include "support/catch.h"
#include "support/shared.h"
#include "text/file.h"

#include <algorithm>
#include <cstdlib>
#include <string>

using namespace raywalk;
using namespace raywalk::test;

namespace {

Picture picture_of(const std::filesystem::path& file) {
  const auto bytes = read_file(file.string(), std::size_t{1} << 26);
  return bytes ? decode_png(*bytes) : Picture{};
}

struct Difference {
  int pixels = 0;      ///< compared
  int off_by_one = 0;  ///< in a channel, at most
  int off_by_more = 0;
  int largest = 0;
};

Difference difference(const Picture& a, const Picture& b, const Picture& mask) {
  Difference result;
  for (std::size_t i = 0; i < a.bytes.size(); i += 3) {
    if (mask.bytes[i] >= 128) continue;
    int off = 0;
    for (std::size_t channel = i; channel < i + 3; ++channel)
      off = std::max(off, std::abs(int{a.bytes[channel]} - int{b.bytes[channel]}));
    ++result.pixels;
    if (off == 1) ++result.off_by_one;
    if (off > 1) ++result.off_by_more;
    result.largest = std::max(result.largest, off);
  }
  return result;
}

}  // namespace

TEST_CASE("scene4-ambient.test is its solution: no pixel outside the mask is off by more than 1") {
  const auto scene_path = shared_file("conformance/scene4-ambient.test");
  if (!std::filesystem::exists(scene_path)) RAYWALK_SKIP("no " << scene_path.string());
  const auto document = read_scene(scene_path.string());
  REQUIRE(document);
  const auto rendering = render(document->scene);
  REQUIRE(rendering);
  const auto png = encode_png(rendering->image(), document->scene.encoding);
  REQUIRE(png);
  const Picture ours = decode_png(*png), solution = picture_of(shared_file("conformance/scene4-ambient.solution.png")),
                mask = picture_of(shared_file("conformance/scene4-ambient.mask.png"));
  REQUIRE(solution.bytes.size() == 3 * 640 * 480);
  REQUIRE(mask.bytes.size() == solution.bytes.size());
  REQUIRE(ours.bytes.size() == solution.bytes.size());
  const Difference off = difference(ours, solution, mask);
  INFO(off.pixels << " pixels compared, " << off.off_by_one << " off by 1, largest difference " << off.largest);
  CHECK(off.pixels > 290'000);
  CHECK(off.off_by_more == 0);
  CHECK(off.off_by_one == 0);
}

TEST_CASE("the course scenes are read, and show what they describe") {
  struct Course {
    std::string name;
    double entries;  ///< objects, and triangles of meshes
    std::size_t lights;
    double least_covered, most_covered;  ///< share of the pixels that are not background
  };
  // A quad; dice of 12 triangles and 21 spheres; a table with things on it; a thousand spheres.
  for (const Course& course : {Course{"scene1", 2, 2, 0.02, 0.6}, Course{"scene2", 33, 0, 0.1, 0.9},
                               Course{"scene3", 60, 0, 0.05, 0.95}, Course{"scene5", 1000, 2, 0.2, 1}}) {
    const auto path = shared_file("conformance/" + course.name + ".test");
    if (!std::filesystem::exists(path)) RAYWALK_SKIP("no " << path.string());
    INFO(course.name);
    const auto document = read_scene(path.string());
    REQUIRE(document);
    CHECK(document->warnings.empty());
    const Scene& scene = document->scene;
    INFO(entries_of(scene.objects) << " objects and triangles");
    CHECK(entries_of(scene.objects) >= course.entries);
    CHECK(scene.lights.size() == course.lights);
    RenderSettings settings;
    settings.size = ImageSize{160, 120};
    const auto rendering = render(scene, settings);
    REQUIRE(rendering);
    const Image image = rendering->image();
    const auto covered = std::count_if(image.pixels.begin(), image.pixels.end(),
                                       [](const Rgb<float>& pixel) { return !is_black(pixel); });
    const double share = static_cast<double>(covered) / static_cast<double>(image.pixels.size());
    INFO("covered: " << share);
    CHECK(share >= course.least_covered);
    CHECK(share <= course.most_covered);
  }
}
