// The walk through PATH TRACING: what the timeline and the messages make of its events.

#include "io/scene_file.h"
#include "timeline/message.h"
#include "timeline/recorder.h"

#include <set>

#include "messages.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

/// A room that glows faintly, with a matte ball, a mirror, glass, something black and something shiny; a lamp, a spot.
Scene room() {
  Scene scene;
  scene.background = Rgbd(0.1, 0.2, 0.3);
  scene.camera.eye = {-4, 0, 0};
  scene.camera.screen = {1, 1.4, 61};
  scene.render.integrator = Integrator::path;
  Material matte, mirror, glass, black, shiny, glow;
  matte.diffuse = Rgbd(0.8);
  mirror.diffuse = black.diffuse = glass.diffuse = glow.diffuse = shiny.diffuse = Rgbd(0.0);
  mirror.reflection = Rgbd(0.9);
  glass.transmission = Rgbd(0.95);
  glass.dielectric = true;
  shiny.specular = Rgbd(0.9);
  shiny.shininess = 5;
  glow.emission = Rgbd(2.0);
  glow.diffuse = Rgbd(0.2);
  scene.objects = {
      {"Matte", Sphere<double>{{0, 1.6, 0}, 0.7}, matte},    {"Mirror", Sphere<double>{{0.5, 0, 0}, 0.7}, mirror},
      {"Glass", Sphere<double>{{0, -1.5, 0}, 0.7}, glass},   {"Coal", Sphere<double>{{-1, -2.2, 0}, 0.3}, black},
      {"Shiny", Sphere<double>{{-1, 2.2, 0}, 0.4}, shiny},   {"Glow", Sphere<double>{{-1.5, 0.8, 0}, 0.4}, glow},
      {"Wall", Box<double>{{2, -4, -3}, {2.5, 4, 3}}, matte}};
  scene.lights = {{"Lamp", Rgbd(0.5), PointLight{{-2, -2, 2}, {}}},
                  {"Spot", Rgbd(0.5), SpotLight{{-3, 0, 2}, {0, 1.6, 0}, 20, 10, {}}}};
  return scene;
}

/// The same with the wall all around: no path gets out.
Scene closed(Scene scene) {
  scene.objects.back().shape = Box<double>{{-6, -4, -3}, {4, 4, 3}};
  return scene;
}

}  // namespace

TEST_CASE("FOLLOW PATH is one call that returns what the pixel gets") {
  const Timeline timeline = record_strip(room());
  REQUIRE(timeline.of_paths());
  REQUIRE(timeline.pixels().size() == 61);
  REQUIRE(timeline.frames().size() == 61);
  for (const FrameRecord& frame : timeline.frames()) {
    const PixelRecord& pixel =
        timeline.pixels()[static_cast<std::size_t>(timeline.rays()[static_cast<std::size_t>(frame.ray)].pixel)];
    CHECK(timeline.event(frame.called_at - 1).line == Line::follow_path);
    CHECK(frame.returned_at == pixel.done_at - 1);
    CHECK(length(frame.returned - pixel.shade) <= 1e-12 * (1 + length(pixel.shade)));
    for (int at = frame.called_at; at < frame.returned_at; ++at) REQUIRE(timeline.stack(at).size() == 1);
    CHECK(timeline.stack(frame.returned_at).empty());
  }
  CHECK_FALSE(record_strip([] {
                Scene scene = room();
                scene.render.integrator = Integrator::whitted;
                return scene;
              }())
                  .of_paths());
}

TEST_CASE("the rays of a path are a chain, with shadow rays beside it") {
  const Timeline timeline = record_strip(closed(room()));
  int longest = 0;
  for (int i = 0; i < static_cast<int>(timeline.rays().size()); ++i) {
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(i)];
    if (ray.kind == RayKind::primary) continue;
    REQUIRE(ray.parent >= 0);
    const RayRecord& parent = timeline.rays()[static_cast<std::size_t>(ray.parent)];
    CHECK(parent.kind != RayKind::shadow);
    CHECK(parent.ending == Ending::hit);
    CHECK(length(ray.origin - parent.end) <= 1e-9);
    if (ray.kind != RayKind::shadow && ray.formed) longest = std::max(longest, ray.depth);
    // A line that is not about a shadow ray speaks of the ray that the path has come by.
    const int at = ray.formed_at;
    if (timeline.event(at - 1).line == Line::form_next_ray) CHECK(timeline.current_ray(at) == i);
  }
  CHECK(longest > 4);
}

TEST_CASE("every message of a path is reached, and names what the event says") {
  std::set<std::string_view> found;
  for (const int longest : {0, 2, 20}) {
    Scene scene = room();
    if (longest > 0) scene.render.path_length = longest;
    if (longest == 20) scene = closed(scene);
    const Timeline timeline = record_strip(scene);
    for (int position = 1; position <= timeline.steps(); ++position) {
      const Message message = describe(scene, timeline, position);
      found.insert(message.id);
      const Event& event = *timeline.just_run(position);
      const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(std::max(timeline.current_ray(position), 0))];
      const auto name_at = [&](const RayRecord& of) { return scene.objects[static_cast<std::size_t>(of.object)].name; };
      if (std::holds_alternative<EmissionAdded>(event.detail) || std::holds_alternative<DirectionChosen>(event.detail))
        CHECK(std::get<std::string>(message.arguments.at(0).value) == name_at(ray));
      if (message.id == "walk.next_formed" || message.id == "walk.shadow_formed")
        CHECK(std::get<std::string>(message.arguments.at(0).value) ==
              name_at(timeline.rays()[static_cast<std::size_t>(ray.parent)]));
    }
  }
  for (const std::string_view id : test::path_messages) {
    INFO(id);
    CHECK(found.count(id) == 1);
  }
  CHECK(found.count("walk.path_length") == 1);
}

TEST_CASE("of a rough mirror it is said that a small one reflects") {
  const auto document = read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/metals.toml");
  REQUIRE(document.has_value());
  const Scene& scene = document->scene;
  const Timeline timeline = record_strip(scene);
  int rough = 0, smooth = 0;
  for (int position = 1; position <= timeline.steps(); ++position) {
    const Message message = describe(scene, timeline, position);
    const auto is = [&](std::string_view id) { return message.id == id; };
    if (!is("walk.direction_mirror") && !is("walk.direction_small_mirror")) continue;
    const auto& name = std::get<std::string>(message.arguments.at(0).value);
    const auto of = std::find_if(scene.objects.begin(), scene.objects.end(),
                                 [&](const Object& object) { return object.name == name; });
    REQUIRE(of != scene.objects.end());
    CHECK(of->material.is_rough() == !is("walk.direction_mirror"));
    (is("walk.direction_mirror") ? smooth : rough) += 1;
  }
  CHECK(rough > 0);
  CHECK(smooth > 0);
}

TEST_CASE("of rough glass and of what is matt and rough it is said by what light goes on") {
  const auto document = read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/metals.toml");
  REQUIRE(document.has_value());
  Scene scene = document->scene;
  Material glass, dust;
  glass.diffuse = Rgbd(0.0), glass.transmission = Rgbd(1.0);
  glass.dielectric = true, glass.roughness = 1;
  dust.diffuse_roughness = 1;
  for (Object& each : scene.objects) each.material = each.name == "Rough Gold" ? dust : glass;
  for (const auto& [integrator, wanted] :
       {std::pair(Integrator::path,
                  std::set<std::string_view>{"walk.direction_small_facet", "walk.direction_rough_matt"}),
        std::pair(Integrator::distributed,
                  std::set<std::string_view>{"walk.refract_formed_facet", "walk.refract_formed_facets",
                                             "walk.reflect_wrong_side", "walk.refract_wrong_side"}),
        std::pair(Integrator::photons, std::set<std::string_view>{"walk.photon_small_facet"})}) {
    scene.render.integrator = integrator;
    const Timeline timeline = record_strip(scene, {Precision::double_, {8}});
    std::set<std::string_view> found;
    for (int position = 1; position <= timeline.steps(); ++position)
      found.insert(describe(scene, timeline, position).id);
    for (const std::string_view id : wanted) {
      INFO(id);
      CHECK(found.count(id) == 1);
    }
    for (const std::string_view not_said :
         {"walk.direction_transparent", "walk.refract_formed_in", "walk.photon_passed", "walk.reflect_threshold"})
      CHECK(found.count(not_said) == 0);
  }
}

TEST_CASE("every message about a sky is reached") {
  const auto document = read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/gold.toml");
  REQUIRE(document.has_value());
  std::set<std::string_view> found;
  for (const Vec3d& up : {Vec3d(0, 0, 1), Vec3d(0, 1, 0)}) {
    Scene scene = document->scene;
    scene.sky->up = up;
    const Timeline timeline = record_strip(scene, {Precision::double_, {8}});
    for (int position = 1; position <= timeline.steps(); ++position)
      found.insert(describe(scene, timeline, position).id);
  }
  for (const std::string_view id : test::sky_messages) {
    INFO(id);
    CHECK(found.count(id) == 1);
  }
}

TEST_CASE("every message about a body that scatters light is reached, and names the body") {
  Scene scene = room();
  scene.render.path_length = 0;
  Material milk;
  milk.diffuse = milk.specular = Rgbd(0.0);
  milk.transmission = Rgbd(1.0);
  milk.ior = 1;
  milk.scattering = Rgbd(4.0);
  scene.objects.push_back({"Milk", Sphere<double>{{-1, 0, 0}, 0.8}, milk});
  std::set<std::string_view> found;
  const Timeline timeline = record_strip(scene);
  for (int position = 1; position <= timeline.steps(); ++position) {
    const Message message = describe(scene, timeline, position);
    found.insert(message.id);
    if (message.id == "walk.direction_scattered") CHECK(std::get<std::string>(message.arguments.at(0).value) == "Milk");
    if (message.id != "walk.scattered_inside") continue;
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(position))];
    CHECK(ray.ending == Ending::scattered);
    CHECK(scene.objects[static_cast<std::size_t>(ray.object)].name == "Milk");
    CHECK(length(ray.end - Vec3d(-1, 0, 0)) <= 0.8 + 1e-9);
  }
  for (const std::string_view id : test::scattering_messages) {
    INFO(id);
    CHECK(found.count(id) == 1);
  }
}

TEST_CASE("by the dipole, light comes out of the body that it went into, on its surface, and both are said") {
  Scene scene;
  scene.background = Rgbd(0.5);
  scene.camera.eye = {-4, 0, 0};
  scene.camera.screen = {1, 0.6, 9};
  scene.render.integrator = Integrator::path;
  scene.render.subsurface = Subsurface::dipole;
  Material milk;
  milk.diffuse = milk.specular = Rgbd(0.0);
  milk.transmission = Rgbd(1.0);
  milk.ior = 1;
  milk.scattering = Rgbd(9.0);
  milk.absorption = Rgbd(0.3);
  scene.objects.push_back({"Milk", Sphere<double>{{-1, 0, 0}, 0.8}, milk});
  std::set<std::string_view> found;
  const Timeline timeline = record_strip(scene);
  for (int position = 1; position <= timeline.steps(); ++position) {
    const Message message = describe(scene, timeline, position);
    found.insert(message.id);
    if (message.id == "walk.direction_leaves") CHECK(std::get<std::string>(message.arguments.at(0).value) == "Milk");
    CHECK(message.id != "walk.scattered_inside");
    if (message.id != "walk.left_by_dipole") continue;
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(position))];
    CHECK(scene.objects[static_cast<std::size_t>(ray.object)].name == "Milk");
    CHECK(length(ray.end - Vec3d(-1, 0, 0)) == Approx(0.8));
    // As it is drawn: from where light went in straight to where it comes out.
    CHECK(length(ray.origin - Vec3d(-1, 0, 0)) == Approx(0.8));
    CHECK(length(normalize(ray.end - ray.origin) - ray.direction) < 1e-6);
    CHECK(std::get<double>(message.arguments.at(2).value) == Approx(length(ray.end - ray.origin)));
  }
  for (const std::string_view id : test::dipole_messages) {
    INFO(id);
    CHECK(found.count(id) == 1);
  }
}

TEST_CASE("a hit is named to the triangle of a mesh and the member of a group") {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  MeshShape sheet;
  sheet.mesh = mesh;
  Scene scene;
  scene.camera.eye = {-4, 0, 0};
  scene.camera.screen = {1, 2.2, 3};
  const auto pair = std::make_shared<const GroupContent>(
      Group{"pair", {{"Ball", Sphere<double>{{0, 2.9, 0}, 0.8}, {}}, {"Sheet", sheet, {}}}});
  scene.objects = {{"Twins", Instance{"pair", pair}, {}}, {"Panel", sheet, {}}};
  scene.objects[1].transform = {TransformStep{Translate{{0, -3.3, 0.5}}}};
  const auto met = [&](int cell) {
    const Timeline timeline = record_cell(scene, cell);
    for (int position = 1; position <= timeline.steps(); ++position) {
      const Message message = describe(scene, timeline, position);
      if (message.id == "walk.found_hit") return std::get<HitObject>(message.arguments.at(1).value);
    }
    return HitObject{};
  };
  CHECK(met(0) == HitObject{"Twins", "Ball"});
  CHECK(met(2) == HitObject{"Panel", "", 0});
  scene.objects[1].transform = {TransformStep{Translate{{0, -3.3, -0.5}}}};
  CHECK(met(2) == HitObject{"Panel", "", 1});
  scene.objects[0].transform = {TransformStep{Translate{{0, 0.3, -0.7}}}};
  CHECK(met(1) == HitObject{"Twins", "Sheet", 1});
  // What hides a light is the body itself only where it is the same member.
  Material glass;
  glass.transmission = Rgbd(1.0);
  const auto two = std::make_shared<const GroupContent>(
      Group{"two", {{"Big", Sphere<double>{{0, 0, 0}, 1}, glass}, {"Small", Sphere<double>{{-2.5, 1.5, 0}, 0.3}, {}}}});
  scene.objects = {{"Two", Instance{"two", two}, {}}};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{-4, 3, 0}, {}}}};
  const Timeline timeline = record_cell(scene, 1);
  int hidden = 0, inside = 0;
  for (int position = 1; position <= timeline.steps(); ++position) {
    const Message message = describe(scene, timeline, position);
    const auto names = [&](const HitObject& named) {
      return std::get<HitObject>(message.arguments.at(1).value) == named ? 1 : 0;
    };
    if (message.id == "walk.light_blocked") hidden += names({"Two", "Small"});
    if (message.id == "walk.left_through_surface") inside += names({"Two", "Big"});
    if (message.id == "walk.light_blocked_by_itself") CHECK(names({"Two", "Big"}) == 1);
  }
  CHECK(hidden > 0);
  CHECK(inside > 0);
  // What is an object by itself needs no more words.
  scene.objects = {{"Twin", Sphere<double>{{0, 0, 0}, 1}, {}}};
  CHECK(met(1) == HitObject{"Twin"});
}
