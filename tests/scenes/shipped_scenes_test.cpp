// The scenes that come with Raywalk: what they must show between them.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "io/scene_file.h"
#include "render/render.h"
#include "scene/scene.h"
#include "support/catch.h"
#include "timeline/recorder.h"

using namespace raywalk;
using raywalk::test::contains;

namespace {

const std::set<std::string> planar_scenes{
    "classic",        "glass", "mirrors",     "shadows",  "antialiasing", "depth_of_field",
    "everything",     "gloss", "motion_blur", "penumbra", "translucency", "many_circles",
    "glass_in_water", "gold",  "caustic",     "beams",    "milk",         "filters",
    "metals",         "cones", "flat_glass",  "pencils"};

/// Every scene of the folder, by name without ending.
std::map<std::string, SceneDocument> shipped_scenes() {
  std::map<std::string, SceneDocument> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(RAYWALK_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    auto document = read_scene(entry.path().string());
    INFO((document ? "" : document.error().text()));
    REQUIRE(document);
    scenes.emplace(entry.path().stem().string(), *document);
  }
  return scenes;
}

std::set<Ending> endings_of(const Timeline& timeline) {
  std::set<Ending> endings;
  for (const RayRecord& ray : timeline.rays()) endings.insert(ray.ending);
  for (int i = 0; i < timeline.steps(); ++i)
    if (const auto* decided = std::get_if<Decided>(&timeline.event(i).detail); decided && decided->why)
      endings.insert(*decided->why);
  return endings;
}

/// The deepest SHADE of each pixel's tree.
int deepest(const Timeline& timeline) {
  int depth = 0;
  for (const FrameRecord& frame : timeline.frames()) depth = std::max(depth, frame.depth);
  return depth;
}

}  // namespace

TEST_CASE("every shipped scene is read, has a title and a line about it, and is saved as it stands") {
  const auto scenes = shipped_scenes();
  for (const std::string& name : planar_scenes) CHECK(scenes.count(name) == 1);
  CHECK(scenes.count("whitted") == 1);
  for (const auto& [name, document] : scenes) {
    INFO(name);
    CHECK(!document.scene.title.empty());
    CHECK(!document.scene.description.empty());
    CHECK(document.scene.description.find('\n') == std::string::npos);
    CHECK(format_scene(document.scene, document.text) == document.text);
    // Only the numbers that are another program's give off more light than they get.
    CHECK(document.warnings.empty() == (name != "whitted" && name != "distributed"));
  }
}

TEST_CASE("the planar scenes are planar, and their cells are pixels of their picture") {
  for (const auto& [name, document] : shipped_scenes()) {
    INFO(name);
    const Scene& scene = document.scene;
    if (planar_scenes.count(name) > 0) CHECK(why_not_planar(scene) == "");
    if (!is_planar(scene)) continue;
    const int columns_a_cell = scene.image.width / scene.camera.screen.cells;
    CHECK(scene.image.width == columns_a_cell * scene.camera.screen.cells);
    CHECK(columns_a_cell % 2 == 1);
    CHECK(scene.image.height % 2 == 1);
  }
}

TEST_CASE("the classic scene has the classic's four objects, and a floor below the plan") {
  const Scene scene = shipped_scenes().at("classic").scene;
  REQUIRE(scene.lights.size() == 1);
  CHECK(scene.lights[0].name == "Light Source");
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  CHECK(names == std::vector<std::string>{"Solid Sphere", "Transparent Sphere", "Polygon", "Floor"});
  const auto& floor = std::get<Plane<double>>(scene.objects[3].shape);
  CHECK(floor.point.z < 0);
  CHECK(scene.camera.screen.cells == 21);
  CHECK(scene.camera.look_at.x > scene.camera.eye.x);
  CHECK(scene.camera.look_at.y == scene.camera.eye.y);
  CHECK(scene.limits.depth == 5);
}

TEST_CASE("the classic strip meets everything: each object, a miss, shadow and a tree with two bounces") {
  const Scene scene = shipped_scenes().at("classic").scene;
  const Timeline timeline = record_strip(scene);
  std::set<int> seen;
  int blocked = 0, filled = 0;
  for (const RayRecord& ray : timeline.rays()) {
    if (ray.kind == RayKind::primary) seen.insert(ray.ending == Ending::hit ? ray.object : -1);
    if (ray.ending == Ending::blocked) ++blocked;
  }
  CHECK(seen == std::set<int>{-1, 0, 1, 2});
  CHECK(blocked > 0);
  CHECK(deepest(timeline) >= 3);
  for (const PixelRecord& pixel : timeline.pixels()) filled += !is_black(pixel.shade);
  CHECK(filled == 21);
  // The first cells are a gentle beginning: one that misses, one with a single bounce.
  const auto cell = [&](int i) { return timeline.rays_of_pixel(i); };
  CHECK(cell(0).last - cell(0).first == 1);
  CHECK(cell(1).last - cell(1).first == 3);
}

TEST_CASE("between them the planar scenes reach every line, both ways of every condition, and every ending") {
  std::set<Line> lines;
  std::set<Ending> endings;
  std::map<Line, std::set<bool>> decisions;
  for (const auto& [name, document] : shipped_scenes()) {
    if (!is_planar(document.scene)) continue;
    const Timeline timeline = record_strip(document.scene);
    if (timeline.of_paths() || timeline.has_width()) continue;  // procedures of their own
    for (int i = 0; i < timeline.steps(); ++i) {
      const Event& event = timeline.event(i);
      lines.insert(event.line);
      if (const auto* decided = std::get_if<Decided>(&event.detail)) decisions[event.line].insert(decided->holds);
    }
    endings.merge(endings_of(timeline));
  }
  CHECK(static_cast<int>(lines.size()) == line_count);
  for (const auto& [line, answers] : decisions) {
    INFO(pseudocode_of(line).text);
    CHECK(answers.size() == 2);
  }
  CHECK(endings == std::set<Ending>{Ending::hit, Ending::missed, Ending::blocked, Ending::reached_light, Ending::depth,
                                    Ending::threshold, Ending::total_internal_reflection, Ending::facing_away,
                                    Ending::outside_cone});
}

TEST_CASE("each scene shows what it is about") {
  const auto scenes = shipped_scenes();
  const auto endings = [&](const std::string& name) { return endings_of(record_strip(scenes.at(name).scene)); };
  CHECK(endings("mirrors").count(Ending::depth) == 1);
  CHECK(endings("mirrors").count(Ending::threshold) == 1);
  CHECK(endings("glass").count(Ending::total_internal_reflection) == 1);
  CHECK(endings("shadows").count(Ending::blocked) == 1);
  CHECK(endings("shadows").count(Ending::facing_away) == 1);

  // The prism: low cells get out of its slanted face, higher ones do not.
  const Scene& glass = scenes.at("glass").scene;
  const Timeline timeline = record_strip(glass);
  std::vector<bool> gets_out;
  for (int cell = 2; cell <= 8; ++cell) {
    const auto range = timeline.rays_of_pixel(cell);
    int inside = -1;
    bool out = false;
    for (int i = range.first; i < range.last; ++i) {
      const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(i)];
      if (ray.kind != RayKind::refract || !ray.formed) continue;  // total reflection leaves a stub
      if (inside < 0)
        inside = i;
      else
        out = out || ray.parent == inside;
    }
    gets_out.push_back(out);
  }
  CHECK(gets_out == std::vector<bool>{false, false, false, false, false, true, true});

  // Glass in water: rays go between each two.
  std::set<std::pair<double, double>> crossed;
  const Timeline water = record_strip(scenes.at("glass_in_water").scene);
  for (int i = 0; i < water.steps(); ++i)
    if (const auto* formed = std::get_if<RayFormed>(&water.event(i).detail); formed != nullptr && formed->snell)
      crossed.emplace(formed->snell->n1, formed->snell->n2);
  for (const auto& pair : {std::pair(1.0, 1.33), std::pair(1.33, 1.5), std::pair(1.5, 1.33), std::pair(1.33, 1.0),
                           std::pair(1.33, 1.31), std::pair(1.31, 1.0)})
    CHECK(crossed.count(pair) == 1);

  // Filtered light: some shadow ray arrives weakened.
  int weakened = 0;
  const Timeline shadows = record_strip(scenes.at("shadows").scene);
  for (const RayRecord& ray : shadows.rays())
    weakened += ray.ending == Ending::reached_light && ray.transmittance != Rgbd(1.0);
  CHECK(weakened > 0);
}

TEST_CASE("every shipped scene renders to finite colours, none of them a single one") {
  for (const auto& [name, document] : shipped_scenes()) {
    INFO(name);
    RenderSettings settings;
    settings.size = ImageSize{63, 45};
    const auto rendering = render(document.scene, settings);
    REQUIRE(rendering);
    CHECK(rendering->not_finite_pixels == 0);
    const Image image = rendering->image();
    std::set<float> greens;
    for (const Rgb<float>& pixel : image.pixels) greens.insert(pixel.y);
    CHECK(greens.size() > 100);
  }
}

TEST_CASE("the scenes of distributed effects call for them") {
  const auto scenes = shipped_scenes();
  const auto used = [&](const std::string& name, Effect effect) {
    const Scene& scene = scenes.at(name).scene;
    return effects_of(scene, scene.render.samples).used(effect);
  };
  using enum Effect;
  for (const auto& [name, effect] : std::map<std::string, Effect>{{"gloss", gloss},
                                                                  {"translucency", translucency},
                                                                  {"penumbra", penumbra},
                                                                  {"depth_of_field", depth_of_field},
                                                                  {"motion_blur", motion_blur},
                                                                  {"antialiasing", antialiasing}}) {
    INFO(name);
    CHECK(used(name, effect));
    CHECK(used("everything", effect));
    // And for none of the others but antialiasing, so that its picture shows what it does.
    for (const Effect other : {gloss, translucency, penumbra, depth_of_field, motion_blur})
      if (other != effect) CHECK_FALSE(used(name, other));
  }
  CHECK(used("distributed", penumbra));
  CHECK(used("distributed", depth_of_field));
}
