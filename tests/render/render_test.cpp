// Invariants 2 and 3 of CONTRIBUTING.md: neither an observer nor threads, tile order or accelerator change a bit.
#include "render/render.h"
#include "render/scenes.h"
#include "trace/scene_kernel.h"

#include <algorithm>
#include <limits>
#include <random>
#include <thread>

#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Counts, and looks at what it is told as any observer would.
class CountingObserver : public Observer {
 public:
  void record(Event&& event) override {
    const Event taken = std::move(event);
    if (std::holds_alternative<PixelPut>(taken.detail)) ++pixels;
    ++events;
  }
  std::size_t events = 0, pixels = 0;
};

template <class T>
struct Watched {
  Film<T> film;
  Statistics statistics;
  CountingObserver observer;
};

template <class T>
Watched<T> render_watched(const Scene& scene, ImageSize size, const Sampling& sampling) {
  const World<T> world(scene);
  const SceneKernel<T> kernel(scene, world);
  const RayGenerator<T> camera(scene, size, size, sampling);
  Watched<T> result{Film<T>(size), {}, {}};
  PixelBlock block{0, size.width, 0, size.height};
  for (block.sample = 0; block.sample < sampling.per_pixel; ++block.sample)
    result.statistics += kernel.watched(camera, block, result.observer, [&](const Pixel& p, const Rgb<T>& shade) {
      result.film.add(p.column, p.row, p.sample, shade);
    });
  return result;
}

constexpr ImageSize small{105, 61};

}  // namespace

TEMPLATE_TEST_CASE("watching changes no pixel and no count, in any planar scene", "", float, double) {
  for (const NamedScene& named : planar_scenes()) {
    INFO(named.name);
    for (const int samples : {1, 3}) {
      CAPTURE(samples);
      RenderSettings settings{small, Sampling{samples, 7}, precision_of<TestType>()};
      settings.shadow_cache = false;  // what it saves depends on the order of the pixels
      const auto plain = render(named.scene, settings).value();
      const auto watched = render_watched<TestType>(named.scene, small, settings.sampling);
      CHECK(pixels_that_differ(plain.film_of<TestType>(), watched.film) == 0);
      CHECK(text_of(plain.statistics) == text_of(watched.statistics));
      CHECK(watched.observer.pixels == static_cast<std::size_t>(small.width * small.height * samples));
      CHECK(watched.observer.events >= 5 * watched.observer.pixels);
    }
  }
}

TEMPLATE_TEST_CASE("the comparison of watched and unwatched can fail", "", float, double) {
  Scene scene = busy_scene();
  const auto watched = render_watched<TestType>(scene, small, {});
  scene.limits.depth -= 1;
  RenderSettings settings{small, {}, precision_of<TestType>()};
  const auto shallower = render(scene, settings).value();
  CHECK(pixels_that_differ(shallower.film_of<TestType>(), watched.film) > 0);
  CHECK(text_of(shallower.statistics) != text_of(watched.statistics));
}

TEMPLATE_TEST_CASE("neither threads nor the order of tiles change a bit", "", float, double) {
  std::size_t number = 0;
  for (const NamedScene& named : planar_scenes()) {
    INFO(named.name);
    for (const int samples : {1, 3}) {
      if (left_out(number++, 5)) continue;
      CAPTURE(samples);
      RenderSettings settings{small, Sampling{samples, 3}, precision_of<TestType>()};
      settings.threads = 1;
      const auto one = render(named.scene, settings).value();
      CHECK(one.threads == 1);
      const auto check_same = [&] {
        const auto other = render(named.scene, settings).value();
        CHECK(pixels_that_differ(one.film_of<TestType>(), other.film_of<TestType>()) == 0);
        CHECK(text_of(one.statistics) == text_of(other.statistics));
      };
      settings.threads = 2;
      settings.reorder_tiles = [](std::vector<int>& tiles) { std::reverse(tiles.begin(), tiles.end()); };
      check_same();
      settings.threads = 8;
      settings.reorder_tiles = {};
      check_same();
      settings.reorder_tiles = [](std::vector<int>& tiles) {
        std::shuffle(tiles.begin(), tiles.end(), std::minstd_rand(8));
      };
      check_same();
    }
  }
}

TEST_CASE("the comparison of renders can fail, and leaving out a tile is seen") {
  const Scene scene = busy_scene();
  RenderSettings settings{small, Sampling{3, 3}};
  const auto one = render(scene, settings).value();
  RenderSettings other_seed = settings;
  other_seed.sampling.seed = 4;
  CHECK(pixels_that_differ(one.film_of<double>(), render(scene, other_seed).value().film_of<double>()) > 0);
  RenderSettings twice_the_first = settings;
  twice_the_first.threads = 1;  // else two threads would write to one tile
  twice_the_first.reorder_tiles = [](std::vector<int>& tiles) { tiles.back() = tiles.front(); };
  CHECK(pixels_that_differ(one.film_of<double>(), render(scene, twice_the_first).value().film_of<double>()) > 0);
}

TEMPLATE_TEST_CASE("no accelerator changes a bit of the picture", "", float, double) {
  for (const NamedScene& named : planar_scenes()) {
    INFO(named.name);
    RenderSettings settings{small, {}, precision_of<TestType>()};
    settings.accelerator = AcceleratorKind::none;
    const auto brute_force = render(named.scene, settings).value();
    CHECK(brute_force.accelerator == AcceleratorKind::none);
    for (const AcceleratorKind kind :
         {AcceleratorKind::spheres, AcceleratorKind::ellipsoids, AcceleratorKind::boxes, AcceleratorKind::bvh,
          AcceleratorKind::grid, AcceleratorKind::octree, AcceleratorKind::kdtree}) {
      INFO(name_of(kind));
      settings.accelerator = kind;
      const auto other = render(named.scene, settings).value();
      CHECK(other.accelerator == kind);
      CHECK(pixels_that_differ(brute_force.film_of<TestType>(), other.film_of<TestType>()) == 0);
      CHECK(brute_force.statistics.rays == other.statistics.rays);
      CHECK(brute_force.statistics.ended == other.statistics.ended);
    }
  }
}

TEST_CASE("the shadow cache is used with any structure but a list, unless it is said, and saves nodes only") {
  Scene scene = planar_scenes().front().scene;
  const auto run = [&](AcceleratorKind kind, std::optional<bool> cached) {
    RenderSettings settings{small};
    settings.accelerator = kind;
    settings.shadow_cache = cached;
    return render(scene, settings).value();
  };
  const auto tests = [](const Rendering& rendering) {
    return std::pair{rendering.statistics.tests.nodes, rendering.statistics.tests.primitives};
  };
  for (const AcceleratorKind kind : {AcceleratorKind::none, AcceleratorKind::bvh}) {
    const Rendering left_out = run(kind, std::nullopt), on = run(kind, true), off = run(kind, false);
    CHECK(tests(on) != tests(off));  // some shadow ray is blocked twice by the same
    CHECK(tests(left_out) == tests(kind == AcceleratorKind::none ? off : on));
    CHECK(pixels_that_differ(on.film_of<double>(), off.film_of<double>()) == 0);
    CHECK(on.statistics.rays == off.statistics.rays);
    CHECK(on.statistics.ended == off.statistics.ended);
  }
}

TEST_CASE("the rays formed are those that ended, and unused effects draw nothing") {
  for (const NamedScene& named : planar_scenes()) {
    INFO(named.name);
    if (traits_of(named.scene.render.integrator).has_width) continue;  // its cones are no rays
    const auto one = render(named.scene, {small}).value();
    const Statistics& s = one.statistics;
    std::uint64_t formed = 0;
    for (const std::uint64_t count : s.rays) formed += count;
    CHECK(formed == s.ends(Ending::hit) + s.ends(Ending::missed) + s.ends(Ending::scattered) + s.ends(Ending::blocked) +
                        s.ends(Ending::reached_light));
    CHECK(s.formed(RayKind::primary) == static_cast<std::uint64_t>(small.width * small.height));
    CHECK(s.formed(RayKind::shadow) == s.ends(Ending::blocked) + s.ends(Ending::reached_light));
    for (int i = 0; i < effect_count; ++i)
      if (!one.effects.used(static_cast<Effect>(i))) CHECK(s.draws[static_cast<std::size_t>(i)] == 0);
    CHECK(s.not_finite == 0);
    CHECK_FALSE(one.effects.used(Effect::antialiasing));
    const auto three = render(named.scene, {small, Sampling{3}}).value();
    const std::uint64_t draws = draws_random(integrator_of(named.scene, 3)) ? 6 : 0;  // else at fixed places
    CHECK(three.statistics.drawn(Effect::antialiasing) == draws * s.formed(RayKind::primary));
    CHECK(three.effects.used(Effect::antialiasing));
  }
}

TEST_CASE("without a size the scene's own is rendered") {
  Scene scene = busy_scene();
  scene.image = {13, 7};
  const auto rendering = render(scene).value();
  const Image image = rendering.image();
  CHECK(image.width == 13);
  CHECK(image.height == 7);
  CHECK(rendering.film_of<double>().size() == scene.image);
  CHECK(rendering.finished);
  CHECK(rendering.done == 1);
}

TEST_CASE("progress is told in the calling thread and ends at 1") {
  RenderSettings settings{ImageSize{64, 64}, Sampling{200}};
  const auto caller = std::this_thread::get_id();
  std::vector<Progress> told;
  bool elsewhere = false;
  settings.threads = 2;
  settings.progress = [&](const Progress& progress) {
    elsewhere = elsewhere || std::this_thread::get_id() != caller;
    told.push_back(progress);
  };
  REQUIRE(render(busy_scene(), settings).has_value());
  CHECK_FALSE(elsewhere);
  REQUIRE_FALSE(told.empty());
  CHECK(std::is_sorted(told.begin(), told.end(), [](const auto& a, const auto& b) { return a.done < b.done; }));
  CHECK(told.back().done == 1);
  CHECK(told.back().seconds_left == 0);
  for (std::size_t i = 0; i + 1 < told.size(); ++i) CHECK(told[i].done < 1);
}

TEST_CASE("a stopped render returns what is done") {
  const Scene scene = busy_scene();
  RenderSettings settings{ImageSize{128, 96}};
  const auto whole = render(scene, settings).value();
  Stopper stopper;
  settings.stop = Stop(stopper);
  settings.threads = 1;
  int told = 0;
  settings.sampling.per_pixel = 1 << 20;  // it would take hours
  settings.progress = [&](const Progress&) {
    ++told;
    stopper.raised = true;
  };
  const auto part = render(scene, settings).value();
  CHECK(told == 1);
  CHECK_FALSE(part.finished);
  CHECK(part.done > 0);
  CHECK(part.done < 1);
  CHECK(part.statistics.formed(RayKind::primary) ==
        static_cast<std::uint64_t>(std::llround(part.done * 128 * 96 * settings.sampling.per_pixel)));
  // The first tile has samples, the last has none.
  CHECK(part.film_of<double>().at(5, 5) != Rgbd(0.0));
  CHECK(part.film_of<double>().at(127, 95) == Rgbd(0.0));
  CHECK(whole.film_of<double>().at(127, 95) != Rgbd(0.0));
  // What is written of it is the rows with samples.
  const Image image = part.image();
  const ImageRows rows = part.rows();
  CHECK(rows.begun > 0);
  CHECK(rows.begun < 96);
  for (int row = 0; row < 96; ++row) {
    const auto in_image = image.pixels.begin() + 128 * row;
    if (row < rows.begun)
      CHECK(std::equal(in_image, in_image + 128, rows.row(row)));
    else
      CHECK(std::all_of(in_image, in_image + 128, [](const Rgb<float>& pixel) { return is_black(pixel); }));
  }
  CHECK(whole.rows().begun == 96);
}

TEST_CASE("a render stopped before it began has nothing") {
  Stopper stopper;
  stopper.raised = true;
  RenderSettings settings{small};
  settings.stop = Stop(stopper);
  const auto none = render(busy_scene(), settings).value();
  CHECK_FALSE(none.finished);
  CHECK(none.done == 0);
  CHECK(text_of(none.statistics) == text_of({}));
  CHECK(none.film_of<double>().pixels().empty());
}

TEST_CASE("a picture that fits into no memory is refused") {
  constexpr int most = std::numeric_limits<int>::max();
  const auto result = render(busy_scene(), {ImageSize{most, most}});
  REQUIRE_FALSE(result.has_value());
  CHECK_THAT(result.error().text(), contains("a picture of 2147483647 x 2147483647 pixels would take about") &&
                                        contains("hint: choose a smaller --size"));
}
