#include "io/scene_file.h"

#include "support/catch.h"

using namespace raywalk;

TEST_CASE("the classic scene is read as it stands") {
  const auto document = read_scene(RAYWALK_SOURCE_DIR "/scenes/classic.toml");
  INFO((document ? "" : document.error().text()));
  REQUIRE(document);
  CHECK(document->warnings.empty());
  const Scene& scene = document->scene;
  CHECK(scene.objects.size() == 4);
  CHECK(scene.lights.size() == 1);
  CHECK(scene.camera.screen.width == 2.5);
}
