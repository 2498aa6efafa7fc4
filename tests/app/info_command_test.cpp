#include "app/info_command.h"

#include "accel/accelerator.h"
#include "app/process.h"
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

TEST_CASE("info names every effect and why it is used or not") {
  const Folder folder;
  const Outcome outcome = folder.run({"info", "classic"});
  CHECK(outcome.exit_code == 0);
  for (int i = 0; i < effect_count; ++i)
    CHECK_THAT(outcome.out, contains("\n  " + std::string(effect_name(static_cast<Effect>(i))) + " "));
  for (const AcceleratorKind kind : all_accelerators)
    if (kind != AcceleratorKind::automatic)
      CHECK_THAT(outcome.out, contains("\n  " + std::string(accelerator_name(kind)) + " "));
  CHECK_THAT(outcome.out, contains("structures over 4 primitives; bvh is chosen"));
  CHECK_THAT(outcome.out, contains("used: Transparent Sphere transmits") && contains("none: nothing moves"));
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
