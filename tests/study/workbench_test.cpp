// Attempts are renders, the reference is the right picture, and the frontier is what nobody beats.
#include "study/workbench.h"

#include "io/scene_file.h"
#include "render/render.h"
#include "study/effect_costs.h"
#include "support/asked.h"
#include "support/catch.h"
#include "support/exploding_room.h"

using namespace raywalk;
using namespace raywalk::study;

namespace {

constexpr ImageSize small{14, 9};

Scene shipped(const std::string& name) {
  auto document = read_scene(RAYWALK_SOURCE_DIR "/scenes/" + name + ".toml");
  REQUIRE(document);
  return document->scene;
}

void finish(Workbench& bench) {
  while (bench.work(1000)) {
  }
}

Attempt attempt(double cost, double error, double done = 1) {
  Attempt one;
  one.cost.rays = static_cast<std::uint64_t>(cost);
  one.error = error;
  one.done = done;
  return one;
}

}  // namespace

TEST_CASE("an attempt is the render of its setup, bit for bit and ray for ray") {
  const Scene scene = shipped("penumbra");
  Setup setup = setup_of(scene);
  setup.samples = 40;
  setup.light_grid = 2;
  setup.sampler = GENERATE(Sampler::random, Sampler::jittered, Sampler::sobol);
  setup.tolerance = GENERATE(0.0, 0.05);
  setup.single_precision = GENERATE(false, true);
  setup.accelerator = AcceleratorKind::grid;
  Workbench bench;
  bench.reset(scene, small, {setup});
  while (bench.attempts()[0].done < 1) bench.work(0);
  RenderSettings settings;
  settings.size = small;
  settings.sampling.per_pixel = setup.samples;
  settings.precision = setup.single_precision ? Precision::float_ : Precision::double_;
  settings.accelerator = setup.accelerator;
  settings.tolerance = setup.tolerance;
  settings.shadow_cache = false;  // as the window says: what one saves depends on the order of the pixels
  const auto rendering = render(under(scene, setup), settings);
  REQUIRE(rendering);
  if (setup.tolerance == 0) {
    CHECK(bench.attempts()[0].cost.nodes == cost_of(rendering->statistics, 0).nodes);
    CHECK(bench.attempts()[0].cost.tests == cost_of(rendering->statistics, 0).tests);
  }
  CHECK(bench.attempts()[0].image.pixels == rendering->image().pixels);
  CHECK(bench.attempts()[0].cost.rays == cost_of(rendering->statistics, 0).rays);
  CHECK(bench.attempts()[0].cost.draws == rendering->statistics.random_draws());
}

TEST_CASE("an attempt that is interrupted again and again becomes the same") {
  const Scene scene = shipped("penumbra");
  Setup setup = setup_of(scene);
  setup.samples = 20;
  setup.light_grid = 2;
  setup.tolerance = GENERATE(0.0, 0.05);
  Workbench at_once, in_parts;
  at_once.reset(scene, small, {setup});
  while (at_once.attempts()[0].done < 1) at_once.work(0);
  in_parts.reset(scene, small, {setup});
  int interrupted = 0;
  for (int checks = 1; in_parts.attempts()[0].done < 1; checks = checks % 40 + 1) {
    test::Asked asked(checks);
    try {
      in_parts.work(0, Stop(asked));
    } catch (const Stopped&) {
      ++interrupted;
    }
  }
  CHECK(interrupted > 20);
  CHECK(in_parts.attempts()[0].image.pixels == at_once.attempts()[0].image.pixels);
  CHECK(in_parts.attempts()[0].cost.rays == at_once.attempts()[0].cost.rays);
  CHECK(in_parts.attempts()[0].cost.draws == at_once.attempts()[0].cost.draws);
}

TEST_CASE("attempts and surveys are stopped inside a pixel whose tree explodes") {
  const Scene scene = test::exploding_room(Integrator::whitted);
  test::Asked asked(1'000'000), asked_too(1'000'000);
  Workbench bench;
  bench.reset(scene, small, {setup_of(scene)});
  CHECK_THROWS_AS(bench.work(1e9, Stop(asked)), Stopped);
  CostSurvey survey(scene, 400, 1);
  CHECK_THROWS_AS(survey.work(Stop(asked_too)), Stopped);
  CHECK(survey.done() == 0);
}

TEST_CASE("a setup changes what it names, and none changes nothing") {
  Scene scene = shipped("penumbra");
  CHECK(under(scene, setup_of(scene)) == scene);
  Setup setup = setup_of(scene);
  setup.samples = 7, setup.sampler = Sampler::sobol, setup.light_grid = 5, setup.depth = 9, setup.threshold = 0.25;
  setup.tolerance = 0.125;
  const Scene changed = under(scene, setup);
  CHECK(setup_of(changed) == setup);
  CHECK(changed.render.light_grid == 5);
  CHECK(changed.limits.depth == 9);
}

TEST_CASE("the error falls with the samples, down to what is left of the reference's own") {
  const Scene scene = shipped("penumbra");
  std::vector<Setup> setups(3, setup_of(scene));
  for (std::size_t i = 0; i < setups.size(); ++i) {
    setups[i].samples = 4 << (2 * i);
    setups[i].sampler = Sampler::random;
  }
  Workbench bench;
  bench.reset(scene, small, setups);
  finish(bench);
  CHECK(bench.reference_samples() == Workbench::samples_a_pass * Workbench::max_passes);
  const auto& attempts = bench.attempts();
  for (std::size_t i = 1; i < attempts.size(); ++i) {
    CHECK(attempts[i].error < 0.75 * attempts[i - 1].error);  // by the law: half
    CHECK(attempts[i].cost.rays > 3 * attempts[i - 1].cost.rays);
  }
  CHECK(bench.floor() > 0);
  CHECK(bench.floor() < attempts.back().error / 4);
  // Another picture of as many samples, drawn by itself, is as far away as the floor says.
  RenderSettings settings;
  settings.size = small;
  settings.sampling = {bench.reference_samples(), 12345};
  Setup other = setup_of(scene);
  other.sampler = Sampler::sobol;
  other.threshold = 0;
  const auto rendering = render(under(scene, other), settings);
  REQUIRE(rendering);
  const Image image = rendering->image();
  double squares = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Rgbd difference = Rgbd(image.pixels[i]) - Rgbd(bench.reference().pixels[i]);
    squares += dot(difference, difference) / 3;
  }
  CHECK(std::sqrt(squares / static_cast<double>(image.pixels.size())) < 2 * bench.floor());
}

TEST_CASE("naive numerics err against a reference that is robust, also where the scene itself is naive") {
  Scene scene = shipped("hard/mirror_corner");
  scene.render.numerics = GENERATE(Numerics::robust, Numerics::naive);
  Setup robust = setup_of(scene), naive = robust;
  robust.numerics = Numerics::robust;
  naive.numerics = Numerics::naive;
  naive.epsilon = 0;
  naive.single_precision = robust.single_precision = true;
  Workbench bench;
  bench.reset(scene, small, {robust, naive});
  while (bench.reference_samples() < 4 * Workbench::samples_a_pass) bench.work(0);
  CHECK(bench.attempts()[1].error > 2 * bench.attempts()[0].error);
}

TEST_CASE("what was tried is not traced again, and a deeper setup wants a deeper reference") {
  const Scene scene = shipped("mirrors");
  Workbench bench;
  CHECK(bench.finished());
  bench.reset(scene, {6, 5}, {});
  CHECK_FALSE(bench.work(0));
  const Setup setup = setup_of(scene);
  bench.try_out(setup);
  bench.try_out(setup);
  REQUIRE(bench.attempts().size() == 1);
  finish(bench);
  CHECK(bench.attempts()[0].error > bench.floor());
  Setup deep = setup;
  deep.depth = setup.depth + 30;
  bench.try_out(deep);
  CHECK(bench.reference_samples() == 0);
  for (const Attempt& attempt : bench.attempts()) CHECK(attempt.error == 0);  // there is nothing to compare with
  finish(bench);
  CHECK(bench.attempts()[0].image.pixels.size() == 30);
  CHECK(bench.attempts()[0].error > 0);
  CHECK(bench.attempts()[1].cost.rays > bench.attempts()[0].cost.rays);
}

TEST_CASE("the frontier holds what nothing beats") {
  const std::vector<Attempt> attempts{attempt(100, 0.5), attempt(200, 0.25),     attempt(150, 0.5), attempt(400, 0.25),
                                      attempt(300, 0.1), attempt(50, 0.01, 0.5), attempt(100, 0.4), attempt(600, 0.2)};
  CHECK(frontier(attempts, CostAxis::rays) == std::vector<int>{6, 1, 4});
  CHECK(frontier({}, CostAxis::rays).empty());
}
