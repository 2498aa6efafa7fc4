#include "app/idle_options.h"

#include "support/catch.h"

using namespace raywalk;

namespace {

// A ball under a lamp, neither of which calls for anything that is drawn.
Scene plain() {
  Scene scene;
  scene.camera.eye = {-5, 0, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.objects = {{"Ball", Sphere<double>{{0, 0, 0}, 1}, {}}};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{0, 5, 0}, {}}}};
  return scene;
}

// The options that are said to do nothing, one after the other.
std::string idle(const RenderOptions& given, const Scene& scene) {
  std::string names;
  for (const std::string& line : idle_options("render", given, scene)) {
    REQUIRE(line.starts_with("raywalk render: note: --"));
    const std::size_t begin = line.find("--"), end = line.find(" has no effect: ");
    REQUIRE(end != std::string::npos);
    names += line.substr(begin, end - begin) + " ";
  }
  return names;
}

}  // namespace

TEST_CASE("nothing is said of options that were not given") {
  Scene scene = plain();
  for (const Integrator integrator :
       {Integrator::automatic, Integrator::cast, Integrator::whitted, Integrator::distributed, Integrator::path}) {
    scene.render.integrator = integrator;
    CHECK(idle({}, scene).empty());
  }
}

TEST_CASE("a tolerance needs more samples than every pixel takes") {
  RenderOptions given;
  given.tolerance = 0.1;
  Scene scene = plain();
  for (const auto& [samples, said] :
       std::vector<std::pair<int, std::string>>{{1, "--tolerance "}, {16, "--tolerance "}, {17, ""}, {64, ""}}) {
    CAPTURE(samples);
    scene.render.samples = samples;
    CHECK(idle(given, scene) == said);
  }
  scene.render.samples = 1;
  given.tolerance = 0;  // asks for all samples, and gets them
  CHECK(idle(given, scene).empty());
}

TEST_CASE("sampler and seed do nothing where nothing is drawn") {
  const std::string both = "--sampler --seed ";
  RenderOptions given;
  given.sampler = Sampler::sobol;
  given.seed = 0;
  Scene scene = plain();
  const auto with = [&](Integrator integrator, int samples) {
    scene.render.integrator = integrator;
    scene.render.samples = samples;
    return idle(given, scene);
  };
  CHECK(with(Integrator::automatic, 1) == both);
  CHECK(with(Integrator::automatic, 4).empty());
  CHECK(with(Integrator::cast, 4) == both);
  CHECK(with(Integrator::whitted, 4) == both);
  CHECK(with(Integrator::distributed, 1) == both);
  CHECK(with(Integrator::distributed, 4).empty());
  CHECK(with(Integrator::path, 1).empty());

  // Whatever else is drawn is drawn for a single sample too.
  const auto draws = [&](const auto& change) {
    scene = plain();
    change();
    CHECK(with(Integrator::automatic, 1).empty());
    CHECK(with(Integrator::whitted, 1) == both);
  };
  draws([&] { scene.camera.aperture = 0.1; });
  draws([&] { scene.lights[0].kind = SphereLight{{0, 5, 0}, 1, 1, {}}; });
  draws([&] {
    scene.objects[0].material.reflection = Rgbd(0.5);
    scene.objects[0].material.gloss = 3;
  });
  draws([&] {
    scene.camera.shutter_close = 1;
    scene.objects[0].motion = {{0, Vec3d(0.0)}, {1, Vec3d(1.0)}};
  });
}

TEST_CASE("a grid of points needs a light with an extent") {
  RenderOptions given;
  given.light_grid = 2;
  Scene scene = plain();
  CHECK(idle(given, scene) == "--light-grid ");
  scene.lights[0].kind = SphereLight{{0, 5, 0}, 1, 1, {}};
  for (const Integrator integrator : {Integrator::automatic, Integrator::whitted}) {
    scene.render.integrator = integrator;
    CHECK(idle(given, scene).empty());
  }
  for (const Integrator integrator : {Integrator::path, Integrator::photons, Integrator::radiosity}) {
    scene.render.integrator = integrator;
    CHECK(idle(given, scene) == "--light-grid ");
  }
}

TEST_CASE("paths have a limit of their own, and all others theirs") {
  RenderOptions given;
  given.depth = 3;
  given.threshold = 0.1;
  given.path_length = 2;
  Scene scene = plain();
  const auto with = [&](Integrator integrator) {
    scene.render.integrator = integrator;
    return idle(given, scene);
  };
  CHECK(with(Integrator::path) == "--depth --threshold ");
  CHECK(with(Integrator::cast) == "--depth --threshold --path-length ");
  CHECK(with(Integrator::whitted) == "--path-length ");
  CHECK(with(Integrator::distributed) == "--path-length ");
  CHECK(with(Integrator::automatic) == "--path-length ");
}

TEST_CASE("beams and cones have numerics of their own, and cones see lights whole") {
  RenderOptions given;
  given.numerics = Numerics::naive;
  given.epsilon = 0.01;
  given.light_grid = 2;
  Scene scene = plain();
  scene.render.numerics = Numerics::naive;
  scene.render.integrator = Integrator::beams;
  CHECK(idle(given, scene) == "--light-grid --numerics --epsilon ");
  scene.lights[0].kind = SphereLight{{0, 5, 0}, 1, 1, {}};
  scene.render.integrator = Integrator::cones;
  CHECK(idle(given, scene) == "--light-grid --numerics --epsilon ");
  scene.render.integrator = Integrator::whitted;
  CHECK(idle(given, scene).empty());
}

TEST_CASE("a drawing takes no samples") {
  RenderOptions given;
  given.samples = 4;
  given.corner_samples = true;
  given.tolerance = 0.1;
  given.threads = 2;
  given.precision = Precision::float_;
  Scene scene = plain();
  scene.render.integrator = Integrator::beams;
  scene.render.samples = 64;
  CHECK(idle(given, scene).empty());
  given.image = "a.SVG";
  CHECK(idle(given, scene) == "--spp --corner-samples --tolerance --threads --precision ");
}

TEST_CASE("an epsilon is for naive numerics, whether the scene or an option chose them") {
  RenderOptions given;
  given.epsilon = 0.01;
  Scene scene = plain();
  CHECK(idle(given, scene) == "--epsilon ");
  scene.render.numerics = Numerics::naive;
  CHECK(idle(given, scene).empty());
}
