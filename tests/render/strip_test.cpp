// Invariant 1 of CONTRIBUTING.md: the strip is the middle row of the image, bit for bit.
#include "render/render.h"
#include "render/scenes.h"

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// How many cells of the strip differ from the pixels of the image's middle row that lie at their centres, or nearest to
// them where the multiple is even.
template <class T>
int cells_that_differ(const Film<T>& strip, const Film<T>& image) {
  const int cells = strip.size().width, multiple = image.size().width / cells, row = image.size().height / 2;
  int count = 0;
  for (int cell = 0; cell < cells; ++cell)
    if (!same_bits(strip.at(cell, 0), image.at(multiple * cell + multiple / 2, row))) ++count;
  return count;
}

template <class T>
Film<T> strip_of(const Scene& scene, ImageSize whole, int samples = 1) {
  RenderSettings settings{whole, Sampling{samples}, precision_of<T>()};
  return render_strip(scene, settings).value().template film_of<T>();
}

template <class T>
Film<T> image_of_size(const Scene& scene, ImageSize size, int samples = 1) {
  RenderSettings settings{size, Sampling{samples}, precision_of<T>()};
  return render(scene, settings).value().template film_of<T>();
}

}  // namespace

TEMPLATE_TEST_CASE("the strip equals the middle row of every planar scene", "", float, double) {
  for (const NamedScene& named : planar_scenes()) {
    INFO(named.name);
    // A cone of the strip is cut by an endless world's outlines, one of the picture by what is in space.
    if (traits_of(named.scene.render.integrator).has_width) continue;
    const int cells = named.scene.camera.screen.cells;
    for (const int multiple : {1, 3, 5, 7, 21, 33, 101}) {
      CAPTURE(multiple);
      const ImageSize size{cells * multiple, multiple % 4 == 1 ? 1 : 5};
      CHECK(cells_that_differ(strip_of<TestType>(named.scene, size), image_of_size<TestType>(named.scene, size)) == 0);
    }
  }
}

TEMPLATE_TEST_CASE("the strip equals the middle row for any number of cells", "", float, double) {
  Scene scene = busy_scene();
  for (const int cells : {1, 2, 20, 49, 401}) {
    CAPTURE(cells);
    scene.camera.screen.cells = cells;
    const ImageSize size{3 * cells, 3};
    CHECK(cells_that_differ(strip_of<TestType>(scene, size), image_of_size<TestType>(scene, size)) == 0);
  }
}

TEMPLATE_TEST_CASE("with an angle along y the strip follows the image's aspect", "", float, double) {
  Scene scene = busy_scene();
  scene.camera.fov = FieldOfView{41, FovAxis::y};
  scene.camera.screen.width = std::nullopt;
  const ImageSize size{63, 35};
  const auto image = image_of_size<TestType>(scene, size);
  CHECK(cells_that_differ(strip_of<TestType>(scene, size), image) == 0);
  // A strip made for another aspect is told apart.
  CHECK(cells_that_differ(strip_of<TestType>(scene, {63, 37}), image) > 0);
}

TEMPLATE_TEST_CASE("at several samples a strip as wide as the image equals its middle row", "", float, double) {
  const Scene scene = busy_scene();
  const ImageSize size{scene.camera.screen.cells, 9};
  const auto strip = strip_of<TestType>(scene, size, 5), image = image_of_size<TestType>(scene, size, 5);
  // Samples leave the row, so there the strip's pixels have to be as high as the image's: they are square in both.
  CHECK(cells_that_differ(strip, image) == 0);
  CHECK(cells_that_differ(strip_of<TestType>(scene, size, 4), image) > 0);
}

TEMPLATE_TEST_CASE("the comparison of strip and row can fail", "", float, double) {
  const Scene scene = busy_scene();
  const int cells = scene.camera.screen.cells;
  // Where the width is an even multiple, no pixel lies at a cell's centre; with an even number of rows, none in z = 0.
  CHECK(cells_that_differ(strip_of<TestType>(scene, {4 * cells, 5}), image_of_size<TestType>(scene, {4 * cells, 5})) >
        0);
  CHECK(cells_that_differ(strip_of<TestType>(scene, {3 * cells, 4}), image_of_size<TestType>(scene, {3 * cells, 4})) >
        0);
  // From an eye above the plan the row sees something else.
  Scene raised = scene;
  raised.camera.eye.z = 0.25;
  CHECK_FALSE(is_planar(raised));
  CHECK(cells_that_differ(strip_of<TestType>(raised, {3 * cells, 5}), image_of_size<TestType>(scene, {3 * cells, 5})) >
        0);
}
