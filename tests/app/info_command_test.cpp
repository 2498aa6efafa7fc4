#include "app/info_command.h"
#include "view/cost/cost.h"

#include "accel/accelerator.h"
#include "app/process.h"
#include "io/key_reference.h"
#include "scene/effects.h"

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("info says what a scene holds and why it is planar or not") {
  Scene scene;
  scene.title = "Two and one";
  scene.camera.eye = {-5, 0, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.image = {63, 41};
  scene.objects = {{"A", Sphere<double>{{0, 0, 0}, 1}, {}},
                   {"Ground", Plane<double>{{0, 0, -1}, {0, 0, 1}}, {}},
                   {"B", Sphere<double>{{3, 0, 0}, 1}, {}}};
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{0, 1, 0}}}};
  const std::string text = info_text(scene, "two.toml");
  CHECK(text.starts_with("two.toml\n"));
  CHECK_THAT(text, contains("Two and one") && contains("yes: the strip is the middle row of the image"));
  CHECK_THAT(text, contains("2 spheres, 1 plane\n") && contains("1 directional light\n"));
  CHECK_THAT(text, contains("63 x 41 pixels") && contains("21 cells, each the middle one of 3 pixels"));

  scene.camera.eye.z = 1;
  scene.image.height = 40;
  scene.objects.clear();
  scene.lights.clear();
  const std::string other = info_text(scene, "two.toml");
  CHECK_THAT(other, contains("no: the eye does not lie in z = 0") && contains("they are no pixels of this image"));
  CHECK_THAT(other, contains("none\n") && !contains("2 spheres"));
  scene.image = {21, 21};
  CHECK_THAT(info_text(scene, ""), contains("the pixels of the image's middle row"));
}

TEST_CASE("info counts shapes as one says it") {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const MeshShape shape{"", true, true, std::make_shared<const Mesh>(mesh), {}};
  for (const char* name : {"A", "B"}) {
    scene.objects.push_back({name + std::string("m"), shape, {}});
    scene.objects.push_back({name + std::string("b"), Box<double>{{0, 0, 0}, {1, 1, 1}}, {}});
    scene.objects.push_back({name + std::string("h"), HyperboloidTwoSheets<double>{}, {}});
  }
  scene.objects.push_back({"One", HyperboloidOneSheet<double>{}, {}});
  CHECK_THAT(info_text(scene, ""),
             contains("2 meshes, 2 boxes, 2 hyperboloids of two sheets, 1 hyperboloid of one sheet\n"));
}

TEST_CASE("info names every effect and why it is used or not") {
  const Folder folder;
  const Outcome outcome = folder.run({"info", "classic"});
  CHECK(outcome.exit_code == 0);
  for (int i = 0; i < effect_count; ++i)
    CHECK_THAT(outcome.out, contains("\n  " + std::string(name_of(static_cast<Effect>(i))) + " "));
  for (const AcceleratorKind kind : values_of<AcceleratorKind>)
    if (kind != AcceleratorKind::automatic)
      CHECK_THAT(outcome.out, contains("\n  " + std::string(name_of(kind)) + " "));
  CHECK_THAT(outcome.out, contains("structures over 4 primitives; bvh is chosen"));
  CHECK_THAT(outcome.out, contains("used: Transparent Sphere transmits") && contains("none: nothing moves"));
}

TEST_CASE("info --keys prints the reference of all keys, or of those asked for") {
  const Folder folder;
  const Outcome all = folder.run({"info", "--keys"});
  CHECK(all.exit_code == 0);
  CHECK(all.out == reference_text(key_tables()));
  const Outcome sphere = folder.run({"info", "--keys", "sphere"});
  CHECK_THAT(sphere.out, contains("[[light]] of type \"sphere\"\n") && contains("[[object]] of type \"sphere\"\n") &&
                             !contains("[camera]"));
  const Outcome misspelt = folder.run({"info", "--keys", "sphre"});
  CHECK(misspelt.exit_code == 2);
  CHECK_THAT(misspelt.err, contains("no keys of \"sphre\"") && contains("did you mean sphere?"));
  CHECK(folder.run({"info", "classic", "--keys"}).exit_code == 2);
}

TEST_CASE("where nothing shines, info does not speak of the kinds of lights") {
  const auto penumbra = [](const Scene& scene) { return effects_of(scene)[Effect::penumbra]; };
  Scene scene;
  scene.objects = {{"Lamp", Sphere<double>{{0, 0, 2}, 1}, {}}, {"Ball", Sphere<double>{{0, 0, -2}, 1}, {}}};
  CHECK(penumbra(scene).why == "none: no light shines");
  scene.objects[0].material.emission = Rgbd(1.0);
  for (const Integrator integrator : {Integrator::automatic, Integrator::path}) {
    scene.render.integrator = integrator;
    CHECK_FALSE(penumbra(scene).used);
    CHECK(penumbra(scene).why == "none: no light shines; what Lamp emits is indirect light, which only paths follow");
  }
  scene.lights = {{"Off", Rgbd(0.0), SphereLight{{0, 0, 5}, 1, 1, {}}}};
  CHECK_THAT(penumbra(scene).why, contains("no light shines; what Lamp emits"));
  scene.lights = {{"Sun", Rgbd(1.0), DirectionalLight{{0, 0, 1}}}};
  CHECK(penumbra(scene).why == "none: every light is a point or a direction");

  const Folder folder;
  CHECK_THAT(folder.run({"info", "cornell"}).out, contains("  penumbra        none: no light shines; what Lamp emits"));
}

TEST_CASE("info takes the options of a render that decide which effects it has") {
  const Folder folder;
  const auto info = [&](std::vector<std::string> words, const std::string& scene = "distributed") {
    words.insert(words.begin(), {"info", scene});
    const Outcome outcome = folder.run(words);
    CHECK(outcome.exit_code == 0);
    return outcome.out;
  };
  const std::string own = info({});
  CHECK_THAT(own, contains("render            distributed, as what it holds calls for, 16 samples a pixel"));
  CHECK_THAT(own, contains("used: the camera has a lens") && contains("used: 16 samples"));
  CHECK_THAT(info({"--integrator", "whitted"}), contains("render            whitted, 16 samples a pixel") &&
                                                    contains("none: whitted takes the lens as a pinhole"));
  CHECK_THAT(info({"--spp", "3"}), contains(", 3 samples a pixel") && contains("used: 3 samples are taken"));
  CHECK_THAT(info({"--integrator", "whitted", "--light-grid", "5"}), contains("used: Lamp is a grid of 5 x 5 points"));
  CHECK_THAT(info({}, "cornell"), contains("used: Floor sends on") && !contains("a path"));
  CHECK_THAT(info({"--path-length", "1"}, "cornell"),
             contains(", at most 1 ray a path\n") && contains("none: paths end at what is seen"));
}

TEST_CASE("info --cost says what each effect takes, and what all would") {
  const Folder folder;
  const Outcome outcome = folder.run({"info", "whitted", "--cost"});
  CHECK(outcome.exit_code == 0);
  for (const char* word : {"cost of each effect", "of rays", "of time", "reflection", "shadow rays", "all together",
                           "regardless", "times the rays", "4 x 4 shadow rays"})
    CHECK_THAT(outcome.out, contains(word));
  CHECK_THAT(folder.run({"info", "whitted"}).out, !contains("cost of each effect"));
}
