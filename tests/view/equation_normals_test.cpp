// The live equation speaks of the normal that the tracer shaded with: whatever it shows of one agrees with the light.
#include "fixtures.h"
#include "lesson/expression.h"
#include "lesson/play.h"
#include "view/walk/equation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// How often each thing was there to be looked at.
struct Seen {
  int sums = 0, mirrored = 0, behind = 0, behind_itself = 0, leaned = 0;
};

const EquationRow* row_from(const EquationPanel& panel, std::string_view beginning) {
  for (const EquationRow& row : panel.rows)
    if (row.kind == EquationRow::Kind::numbers && row.text.starts_with(beginning)) return &row;
  return nullptr;
}
bool says(const EquationPanel& panel, const char* id) {
  return std::ranges::any_of(panel.rows, [&](const EquationRow& row) { return row.text == text(id, in_english); });
}

/// The first `size` numbers of a row; in the plan the third is left out.
Vec3d vector_of(const EquationRow& row, std::size_t size) {
  REQUIRE((size == 2 || size == 3));
  REQUIRE(row.values.size() >= size);
  return {row.values[0], row.values[1], size == 3 ? row.values[2] : 0};
}

/// kd L of a light without an extent at a distance, where the surface has one kd and is matt or smooth.
std::optional<Rgbd> diffuse_at_right_angles(const Scene& scene, const RayRecord& shadow, int object) {
  const Object& its = scene.objects[static_cast<std::size_t>(object)];
  const Material& m = its.material;
  const auto* mesh = std::get_if<MeshShape>(&its.shape);
  if (std::holds_alternative<Instance>(its.shape) || (mesh != nullptr && mesh->materials)) return {};
  if (m.checker || m.texture || m.has_mapped_parameters() || m.is_rough_diffuse()) return {};
  const Light& light = scene.lights[static_cast<std::size_t>(shadow.light)];
  const Rgbd whole = shadow.transmittance * light.strength * m.diffuse;
  if (std::holds_alternative<DirectionalLight>(light.kind)) return whole;
  const auto* point = std::get_if<PointLight>(&light.kind);
  if (point == nullptr) return {};
  const double r = length(shadow.direction);
  return whole / (point->attenuation.constant + r * (point->attenuation.linear + r * point->attenuation.quadratic));
}

void check_behind(const EquationPanel& panel, Seen& seen) {
  const EquationRow* angle = row_from(panel, "θ = ");
  REQUIRE(angle != nullptr);
  const bool itself = says(panel, "equation.light_behind_itself");
  CHECK(itself != says(panel, "equation.light_behind"));
  CHECK((angle->values[0] < 90 - 1e-6) == itself);
  CHECK((angle->text.find("≥") != std::string::npos) == !itself);
  if (itself) {
    const EquationRow* own = row_from(panel, "θ′ = ");
    REQUIRE(own != nullptr);
    CHECK(own->values[0] >= 90 - 1e-6);
  }
  (itself ? seen.behind_itself : seen.behind) += 1;
}

void check_mirrored(const EquationPanel& panel, Seen& seen) {
  const EquationRow *in = row_from(panel, "D = "), *out = row_from(panel, "R = ");
  const EquationRow* by = row_from(panel, "N = ") != nullptr ? row_from(panel, "N = ") : row_from(panel, "H = ");
  REQUIRE((in != nullptr && out != nullptr && by != nullptr));
  const Vec3d D = vector_of(*in, in->values.size()), N = vector_of(*by, by->values.size() - 1);
  CHECK(std::abs(by->values.back() - dot(N, D)) < 1e-9);
  CHECK(length(D - 2 * dot(N, D) * N - vector_of(*out, out->values.size())) < 1e-9);
  ++seen.mirrored;
}

/// What a lesson's formulas call normal and incidence is what a mirror's ray goes by.
void check_facts(const Scene& scene, const Timeline& timeline, int position) {
  const auto walk = std::make_shared<LessonWalk>();
  walk->document.scene = scene;
  walk->timeline = timeline;
  PlayedLesson played;
  played.steps.push_back({nullptr, walk, position, position, {}});
  const auto number = [&](const char* formula) {
    const Outcome value = value_at(played, 0, position, Expression::parse(formula).value());
    REQUIRE(value);
    return std::get<double>(*value);
  };
  CHECK(number("angle(direction, parent.normal)") == Approx(number("parent.incidence")).margin(1e-5));
}

/// All positions of what is walked.
void check_walk(State& state, Seen& seen) {
  const Scene& scene = state.scene();
  const Timeline& timeline = *state.walk.timeline;
  for (const RayRecord& ray : timeline.rays())
    if (ray.ending == Ending::total_internal_reflection) {
      const RayRecord& shaded = timeline.rays()[static_cast<std::size_t>(ray.parent)];
      CHECK(std::abs(dot(ray.direction, shaded.shaded.shading)) < 1e-9);
    }
  bool leaned = false;
  std::map<std::pair<int, int>, double> angles;  // by shaded ray and shadow ray's light: as the panel shows them
  std::map<std::pair<int, int>, int> shadows;
  for (int position = 1; position <= timeline.steps(); ++position) {
    state.walk.position = position;
    const Event& event = timeline.event(position - 1);
    const auto* formed = std::get_if<RayFormed>(&event.detail);
    const auto* stub = std::get_if<RayNotFormed>(&event.detail);
    const auto* found = std::get_if<Found>(&event.detail);
    const auto* sum = std::get_if<ShadeComputed>(&event.detail);
    if (formed == nullptr && stub == nullptr && found == nullptr && sum == nullptr) continue;
    const EquationPanel panel = equation_panel(state);
    const int index = timeline.current_ray(position);
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(index)];
    CAPTURE(position, panel.title);
    if (stub != nullptr && stub->why == Ending::facing_away && length(stub->direction) > 0) check_behind(panel, seen);
    if (formed != nullptr && without_pencil(event.line) == Line::form_reflect_ray) {
      check_mirrored(panel, seen);
      if (leaned) check_facts(scene, timeline, position);
    }
    if (formed != nullptr && formed->kind == RayKind::shadow && formed->light >= 0) {
      const EquationRow* angle = row_from(panel, "θ = ");
      REQUIRE(angle != nullptr);
      angles[{ray.parent, formed->light}] = angle->values[0];
      shadows[{ray.parent, formed->light}] = index;
    }
    if (found != nullptr && found->ending == Ending::hit) {
      const EquationRow* normal = row_from(panel, "N = ");
      REQUIRE(normal != nullptr);
      const Vec3d N = vector_of(*normal, normal->values.size() - 1);
      const double cosine = std::cos(normal->values.back() * std::numbers::pi / 180);
      CHECK(std::abs(cosine + dot(N, ray.direction)) < 1e-9);
      const bool fixed = scene.objects[static_cast<std::size_t>(ray.object)].material.normal == ShadingNormal::fixed;
      if (!fixed) CHECK(cosine > -1e-9);
      CHECK(says(panel, "equation.normal_turned") == (dot(N, found->normal) < 0));
      leaned = says(panel, "equation.normal_leaned");
      seen.leaned += leaned ? 1 : 0;
    }
    if (sum == nullptr) continue;
    const int shaded = timeline.frames()[static_cast<std::size_t>(timeline.current_frame(position))].ray;
    const int object = timeline.rays()[static_cast<std::size_t>(shaded)].object;
    for (const LightTerm& term : sum->lights) {
      const auto angle = angles.find({shaded, term.light});
      if (angle == angles.end()) continue;
      const RayRecord& shadow = timeline.rays()[static_cast<std::size_t>(shadows.at({shaded, term.light}))];
      const auto whole = diffuse_at_right_angles(scene, shadow, object);
      if (!whole) continue;
      const double cosine = std::max(std::cos(angle->second * std::numbers::pi / 180), 0.0);
      INFO("theta " << angle->second);
      for (int i = 0; i < 3; ++i)
        CHECK(term.diffuse[i] == Approx((*whole)[i] * cosine).epsilon(1e-6).margin(1e-7 * (*whole)[i]));
      seen.sums += (*whole)[0] > 0 ? 1 : 0;
    }
  }
}

/// Pixels in even distances all over the picture; none of the row in its middle, which is the strip.
void check_pixels(const Scene& scene, int columns, int rows, Seen& seen) {
  State state = state_of(scene);
  update(state, action::SetMode{Mode::trace});
  const ImageSize size{2 * columns + 1, 4 * rows + 1};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const action::WalkPixel pixel{2 * column + 1, 4 * row + (row < rows / 2 ? 1 : 3), size};
      update(state, pixel);
      REQUIRE(state.walk.pixel);
      CAPTURE(pixel.column, pixel.row);
      check_walk(state, seen);
    }
}

Scene lit(const Vec3d& lamp) {
  Scene scene;
  scene.camera.eye = Vec3d(-7, 0, 0);
  scene.camera.look_at = Vec3d(0.0);
  scene.camera.screen = Screen{2.5, 1.4, 5};
  scene.lights.push_back({"Lamp", Rgbd(1.0), PointLight{lamp, {}}});
  return scene;
}

/// An octahedron whose normals are those of the ball around it: far from those of its faces.
Object coarse_ball() {
  Mesh mesh;
  for (const double side : {1.5, -1.5})
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d corner(0.0);
      corner[axis] = side;
      mesh.positions.push_back(corner);
      mesh.normals.push_back(normalize(corner));
    }
  for (int x = 0; x < 6; x += 3)
    for (int y = 1; y < 6; y += 3)
      for (int z = 2; z < 6; z += 3) {
        const bool mirrored = (x / 3 + y / 3 + z / 3) % 2 == 1;
        mesh.triangles.push_back(mirrored ? Mesh::Corners{x, z, y} : Mesh::Corners{x, y, z});
      }
  MeshShape shape;
  shape.mesh = std::make_shared<const Mesh>(std::move(mesh));
  Object ball{"Ball", shape, {}};
  ball.material.diffuse = Rgbd(0.5);
  ball.material.reflection = Rgbd(0.5);
  return ball;
}

Object wall(const Vec3d& front) {
  Object object{"Wall", Plane<double>{Vec3d(0.0), front}, {}};
  object.material.diffuse = Rgbd(0.8);
  object.material.normal = ShadingNormal::fixed;
  return object;
}

}  // namespace

TEST_CASE("in every shipped scene the angles that the equation shows are those that the light falls at") {
  Seen seen;
  for (const std::string& path : shipped_scenes()) {
    INFO(path);
    Scene scene = read_document(path).scene;
    scene.render.integrator = Integrator::whitted;
    scene.render.samples = 1;
    scene.limits.depth = std::min(scene.limits.depth, 4);
    check_pixels(scene, 6, 4, seen);
  }
  CHECK(seen.sums > 100);
  CHECK(seen.mirrored > 60);
  CHECK(seen.behind > 50);
}

TEST_CASE("where interpolated normals are far from the surface's own, the equation shows those that were shaded with") {
  for (const Integrator integrator : {Integrator::whitted, Integrator::pencils, Integrator::path}) {
    Seen seen;
    Scene scene = lit({-2, 6, 0.5});
    scene.objects.push_back(coarse_ball());
    scene.render.integrator = integrator;
    INFO(name_of(integrator));
    check_pixels(scene, 16, 16, seen);
    CHECK(seen.leaned > 0);
    CHECK(seen.behind_itself > 0);
    CHECK(seen.behind > 0);
    if (integrator == Integrator::path) continue;
    CHECK(seen.sums > 0);
    CHECK(seen.mirrored > 0);
  }
}

TEST_CASE("a fixed normal is shown as it is, from both sides and for lights on both") {
  for (const double front : {-1.0, 1.0})
    for (const double lamp : {-2.0, 3.0}) {
      Scene scene = lit({lamp, 3, 0});
      scene.objects.push_back(wall({front, 0, 0}));
      scene.render.integrator = Integrator::whitted;
      State state = state_of(scene);
      update(state, action::SetMode{Mode::trace});
      CAPTURE(front, lamp);
      Seen seen;
      check_walk(state, seen);
      const bool before = front * lamp > 0;
      CHECK(seen.sums == (before ? 5 : 0));
      CHECK(seen.behind == (before ? 0 : 5));
      CHECK(seen.behind_itself + seen.leaned == 0);
      state.walk.position = position_after<Found>(*state.walk.timeline);
      const EquationPanel panel = equation_panel(state);
      const EquationRow* normal = row_from(panel, "N = ");
      REQUIRE(normal != nullptr);
      CHECK(normal->values[0] == front);
      CHECK((normal->values.back() > 90) == (front > 0));
      // As the plan does: the angle beside the hit, and the arrow.
      CHECK(hit_notes(state).angle == "θ = " + fmt::format("{:.1f}", normal->values.back()) + "°");
      const RayRecord& ray = state.walk.timeline->rays()[0];
      CHECK(ray.outward_shading_normal() == Vec3d(front, 0, 0));
    }
}
