#include "render/preview.h"

#include "image/srgb.h"
#include "render/render.h"
#include "render/scenes.h"

#include "support/catch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Refines with no time to spend: one row a call. Calls needed.
int refine_to_the_end(Preview& preview, int threads = 1) {
  int calls = 0;
  while (preview.refine(0, threads)) ++calls;
  return calls;
}

template <class T>
Film<T> rendered(const Scene& scene, ImageSize size, int samples, Statistics* statistics = nullptr) {
  RenderSettings settings{size, Sampling{samples}, precision_of<T>()};
  settings.shadow_cache = false;  // a preview has none: what one saves depends on the order of the pixels
  const auto rendering = render(scene, settings).value();
  if (statistics) *statistics += rendering.statistics;
  return rendering.template film_of<T>();
}

template <class T>
std::vector<std::uint8_t> rgba_of(const Film<T>& film) {
  std::vector<std::uint8_t> bytes;
  for (const Rgb<T>& pixel : film.pixels()) {
    for (int channel = 0; channel < 3; ++channel) bytes.push_back(to_srgb8(static_cast<float>(pixel[channel])));
    bytes.push_back(255);
  }
  return bytes;
}

std::uint32_t pixel_at(const Preview& preview, int column, int row) {
  std::uint32_t pixel = 0;
  const std::size_t index =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(preview.size().width) + static_cast<std::size_t>(column);
  std::memcpy(&pixel, preview.rgba().data() + 4 * index, 4);
  return pixel;
}

}  // namespace

TEST_CASE("a preview shows a scene as its picture files have it") {
  Scene scene = planar_scenes().front().scene;
  scene.encoding = Encoding::truncated;
  Preview preview(scene, {{21, 11}, Precision::double_, 1});
  refine_to_the_end(preview);
  const auto film = rendered<double>(scene, {21, 11}, 1);
  int other = 0;
  for (std::size_t i = 0; i < film.pixels().size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const double linear = std::clamp(static_cast<double>(static_cast<float>(film.pixels()[i][channel])), 0.0, 1.0);
      const int byte = preview.rgba()[4 * i + static_cast<std::size_t>(channel)];
      REQUIRE(byte == static_cast<int>(std::floor(255 * linear)));
      other += byte != to_srgb8(static_cast<float>(linear));
    }
  CHECK(other > 100);
}

TEMPLATE_TEST_CASE("a finished preview is the render, bit for bit, and has traced nothing twice", "", float, double) {
  for (const NamedScene& named : planar_scenes()) {
    INFO(named.name);
    for (const ImageSize size :
         {ImageSize{63, 41}, ImageSize{64, 48}, ImageSize{7, 3}, ImageSize{1, 1}, ImageSize{1, 30}}) {
      CAPTURE(size.width, size.height);
      Preview preview(named.scene, {size, precision_of<TestType>(), 1});
      CHECK_FALSE(preview.finished());
      refine_to_the_end(preview);
      CHECK(preview.finished());
      CHECK(preview.done() == 1);
      Statistics statistics;
      const auto expected = rendered<TestType>(named.scene, size, 1, &statistics);
      CHECK(pixels_that_differ(preview.film<TestType>(), expected) == 0);
      CHECK(preview.rgba() == rgba_of(expected));
      CHECK(text_of(preview.statistics()) == text_of(statistics));
    }
  }
}

TEMPLATE_TEST_CASE("with more samples a preview passes the plain render and ends as the antialiased one", "", float,
                   double) {
  const Scene scene = busy_scene();
  const ImageSize size{45, 31};
  const int threads = GENERATE(1, 3);
  Preview preview(scene, {size, precision_of<TestType>(), 5});
  Statistics statistics;
  const auto plain = rendered<TestType>(scene, size, 1, &statistics);
  while (!preview.has_every_pixel()) REQUIRE(preview.refine(0, threads));
  CHECK(pixels_that_differ(preview.film<TestType>(), plain) == 0);
  CHECK(preview.rgba() == rgba_of(plain));
  refine_to_the_end(preview, threads);
  const auto smooth = rendered<TestType>(scene, size, 5, &statistics);
  CHECK(pixels_that_differ(preview.film<TestType>(), smooth) == 0);
  CHECK(preview.rgba() == rgba_of(smooth));
  CHECK(text_of(preview.statistics()) == text_of(statistics));
  // The comparison can fail.
  CHECK(pixels_that_differ(preview.film<TestType>(), plain) > 0);
  CHECK(pixels_that_differ(preview.film<TestType>(), rendered<TestType>(scene, size, 4)) > 0);
}

TEST_CASE("a preview is coarse first: blocks around the pixels traced so far") {
  const ImageSize size{45, 31};
  const Scene scene = busy_scene();
  const Film<double> whole = rendered<double>(scene, size, 1);
  const std::vector<std::uint8_t> bytes = rgba_of(whole);
  Preview preview(scene, {size, Precision::double_, 1});
  for (const int stride : {8, 4, 2, 1}) {
    // One row a call, so that the pass ends after as many calls as it has rows.
    for (int row = 0; row < size.height; row += stride) preview.refine(0, 1);
    CAPTURE(stride);
    const int columns = (size.width + stride - 1) / stride, rows = (size.height + stride - 1) / stride;
    CHECK(preview.statistics().formed(RayKind::primary) == static_cast<std::uint64_t>(columns * rows));
    // Each pixel shows the traced one nearest to it (of two as near the later), the last one towards the border.
    const auto traced_for = [&](int at, int count) { return std::min((at + stride / 2) / stride, count - 1) * stride; };
    int wrong = 0;
    for (int row = 0; row < size.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        const int from = traced_for(row, rows) * size.width + traced_for(column, columns);
        std::uint32_t expected = 0;
        std::memcpy(&expected, bytes.data() + 4 * static_cast<std::ptrdiff_t>(from), 4);
        if (pixel_at(preview, column, row) != expected) ++wrong;
      }
    }
    CHECK(wrong == 0);
  }
  CHECK(preview.finished());
}

TEST_CASE("a preview's work is bounded and never goes back") {
  const ImageSize size{700, 500};
  Preview preview(busy_scene(), {size, Precision::float_, 16});
  REQUIRE(preview.done() == 0);
  double done = 0;
  std::uint64_t revision = preview.revision();
  for (int i = 0; i < 20; ++i) {
    REQUIRE(preview.refine(0.01, 2));
    CHECK(preview.done() > done);
    CHECK(preview.revision() != revision);
    done = preview.done();
    revision = preview.revision();
  }
  // 5.6 million samples do not fit into 20 times a hundredth of a millisecond and a row.
  CHECK(done < 0.5);
}

TEST_CASE("a preview that is done stays as it is") {
  Preview preview(busy_scene(), {{9, 9}, Precision::double_, 2});
  refine_to_the_end(preview);
  const auto revision = preview.revision();
  const auto picture = preview.rgba();
  CHECK_FALSE(preview.refine(1000, 2));
  CHECK(preview.revision() == revision);
  CHECK(preview.rgba() == picture);
}

TEST_CASE("a preview starts afresh after an edit, with the old picture until the new one comes") {
  Scene scene = busy_scene();
  Preview preview(scene, {{33, 21}, Precision::double_, 1});
  refine_to_the_end(preview);
  const auto old_picture = preview.rgba();
  const auto revision = preview.revision();
  scene.background = Rgbd(0.9, 0.1, 0.1);
  preview.reset(scene, {{33, 21}, Precision::double_, 1});
  CHECK(preview.rgba() == old_picture);
  CHECK(preview.done() == 0);
  REQUIRE(preview.refine(0, 1));
  CHECK(preview.revision() != revision);
  refine_to_the_end(preview);
  CHECK(preview.rgba() != old_picture);
  CHECK(preview.rgba() == rgba_of(rendered<double>(scene, {33, 21}, 1)));

  preview.reset(scene, {{5, 4}, Precision::float_, 1});
  CHECK(preview.size() == ImageSize{5, 4});
  CHECK(preview.rgba() == rgba_of(Film<float>({5, 4})));
  refine_to_the_end(preview);
  CHECK(preview.rgba() == rgba_of(rendered<float>(scene, {5, 4}, 1)));
}

TEST_CASE("a preview of nothing is finished") {
  Preview preview;
  CHECK(preview.finished());
  CHECK_FALSE(preview.refine(1, 1));
  CHECK(preview.rgba().empty());
  CHECK(preview.film<double>().pixels().empty());
  CHECK(preview.size() == ImageSize{0, 0});
}

TEST_CASE("a preview shows what is not a number in magenta") {
  Scene scene;
  scene.background = Rgbd(std::nan(""), 0.5, 0.5);
  Preview preview(scene, {{2, 2}, Precision::double_, 1});
  refine_to_the_end(preview);
  CHECK(preview.rgba() ==
        std::vector<std::uint8_t>{255, 0, 255, 255, 255, 0, 255, 255, 255, 0, 255, 255, 255, 0, 255, 255});
}

TEST_CASE("a heat map of rays is what each pixel's own trace forms, in colours up to the hottest") {
  const Scene scene = busy_scene();
  const ImageSize size{33, 21};
  PreviewSettings settings{size, Precision::double_, 16};
  settings.heat = Heat::rays;
  Preview preview(scene, settings);
  while (preview.refine(1)) {
  }
  const World<double> world(scene);
  const RayGenerator<double> camera(scene, size, size);
  std::vector<double> rays;
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column) {
      const Statistics own =
          trace(world, camera, {column, column + 1, row, row + 1, 0}, [](const Pixel&, const Rgb<double>&) {});
      rays.push_back(static_cast<double>(own.formed(RayKind::primary) + own.formed(RayKind::shadow) +
                                         own.formed(RayKind::reflect) + own.formed(RayKind::refract)));
    }
  const double hottest = *std::max_element(rays.begin(), rays.end());
  CHECK(preview.hottest() == hottest);
  CHECK(hottest > 1);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto colour = heat_colour(rays[i] / hottest);
    for (std::size_t channel = 0; channel < 3; ++channel) REQUIRE(preview.rgba()[4 * i + channel] == colour[channel]);
  }
  // The film is the picture's all the same.
  Preview plain(scene, {size, Precision::double_, 1});
  while (plain.refine(10)) {
  }
  CHECK(preview.film<double>().at(16, 10) == plain.film<double>().at(16, 10));
}

TEST_CASE("a heat map of noise is the standard deviation of each pixel's own samples") {
  const Scene scene = busy_scene();
  const ImageSize size{17, 11};
  PreviewSettings settings{size, Precision::double_, GENERATE(1, 20)};
  settings.heat = Heat::noise;
  Preview preview(scene, settings);
  while (preview.refine(1)) {
  }
  const int samples = std::max(settings.samples, PreviewSettings::fewest_for_noise);
  const World<double> world(scene);
  const RayGenerator<double> camera(scene, size, size, Sampling{samples});
  std::vector<std::vector<double>> greys(preview.film<double>().pixels().size());
  for (int sample = 0; sample < samples; ++sample)
    static_cast<void>(
        trace(world, camera, {0, size.width, 0, size.height, sample}, [&](const Pixel& p, const Rgb<double>& shade) {
          greys[static_cast<std::size_t>(p.row * size.width + p.column)].push_back((shade.x + shade.y + shade.z) / 3);
        }));
  std::vector<double> deviations;
  for (const std::vector<double>& all : greys) {
    REQUIRE(all.size() == static_cast<std::size_t>(samples));
    const double mean = std::accumulate(all.begin(), all.end(), 0.0) / samples;
    double squares = 0;
    for (const double grey : all) squares += (grey - mean) * (grey - mean);
    deviations.push_back(std::sqrt(squares / (samples - 1)));
  }
  // All but a few of the noisiest, which have the last colour.
  std::vector<double> sorted = deviations;
  std::sort(sorted.begin(), sorted.end());
  const double hottest = sorted[static_cast<std::size_t>(0.995 * static_cast<double>(sorted.size() - 1))];
  CHECK(preview.hottest() == Approx(hottest));
  CHECK(hottest > 0);
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const auto colour = heat_colour(deviations[i] / preview.hottest());
    for (std::size_t channel = 0; channel < 3; ++channel)
      REQUIRE(std::abs(preview.rgba()[4 * i + channel] - colour[channel]) <= 1);
  }
}

TEST_CASE("the colours of heat grow lighter all the way") {
  const auto luminance = [](double part) {
    const auto c = heat_colour(part);
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
  };
  for (int i = 1; i <= 64; ++i) CHECK(luminance(i / 64.0) > luminance((i - 1) / 64.0));
  CHECK(heat_colour(-1) == heat_colour(0));
  CHECK(heat_colour(7) == heat_colour(1));
}
