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

TEST_CASE("a direction may have any length but 0") {
  const auto normal_of = [](const std::string& normal) {
    const auto document = parse_scene(
        "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n[[object]]\nname = \"F\"\ntype = \"plane\"\npoint = [0, "
        "0]\n"
        "normal = " +
            normal + "\n",
        "a.toml");
    INFO(normal << " " << (document ? "" : document.error().text()));
    REQUIRE(document);
    CHECK(format_scene(document->scene, document->text) == document->text);
    return std::get<Plane<double>>(document->scene.objects[0].shape).normal;
  };
  CHECK(normal_of("[0, 0, 5]") == Vec3d(0, 0, 5));
  CHECK(normal_of("[0, 0, 1e-14]") == Vec3d(0, 0, 1e-14));
  for (const char* up : {"[0, 0, 9e-16]", "[0, 0, 1e-200]", "[0, 0, 1e-300]", "[0, 0, 5e-324]"}) {
    const Vec3d normal = normal_of(up);
    CHECK((normal.x == 0 && normal.y == 0));
    CHECK((normal.z >= 1 && normal.z < 2));
  }
  CHECK(length(normalize(normal_of("[3e-200, -4e-200]")) - Vec3d(0.6, -0.8, 0)) < 1e-15);
}
