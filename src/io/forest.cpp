#include "io/forest.h"

#include "io/mesh_file.h"
#include "io/scene_file.h"
#include "math/random.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>

namespace raywalk {

namespace {

/// Turns the mesh's upward axis to z.
std::vector<TransformStep> upright(UpAxis up) {
  if (up == UpAxis::x) return {TransformStep{Rotate{{0, 1, 0}, -90}}};
  if (up == UpAxis::y) return {TransformStep{Rotate{{1, 0, 0}, 90}}};
  return {};
}

Material plain(const Rgbd& colour) {
  Material material;
  material.ambient = material.diffuse = colour;
  return material;
}

}  // namespace

std::optional<Error> why_no_forest(const GenerateOptions& options, const std::string& path) {
  constexpr int most = 100'000;
  if (scene_format_of(path) != SceneFormat::toml)
    return Error{path, 0, 0, "a forest is not written as that (expected .toml)", "no other format has instances"};
  if (options.mesh.empty())
    return Error{path, 0, 0, "a forest of what? (expected --mesh FILE)",
                 "raywalk generate mesh --count 2000 -o ball.ply makes one"};
  if (options.count > most)
    return Error{path, 0, 0,
                 fmt::format("{} copies are too many for a .toml (expected at most {})", options.count, most),
                 "put several into one mesh first"};
  return std::nullopt;
}

Result<void> write_forest(const GenerateOptions& options, const std::string& path) {
  auto read = read_mesh(options.mesh);
  if (!read) return tl::unexpected(read.error());
  SceneDocument document;
  document.path = options.mesh;  // from whose folder it is named
  Scene& scene = document.scene;
  MeshShape shape;
  shape.file = std::filesystem::path(options.mesh).filename().string();
  shape.mesh = read->mesh, shape.materials = read->materials;
  Object tree{"Tree", shape, plain({0.55, 0.5, 0.4})};
  tree.transform = upright(options.up);
  const Bounds<double> box = image_of(affine_of(tree.transform), bounds(tree.shape));
  if (box.empty())
    return tl::unexpected(Error{options.mesh, 0, 0, "the mesh has no triangles (expected at least one)", ""});
  // On the floor, about its axis, one unit wide.
  const Vec3d size = box.max - box.min, middle = (box.min + box.max) / 2.0;
  const double width = std::max({size.x, size.y, size.z / 2});
  tree.transform.push_back({Translate{-Vec3d(middle.x, middle.y, box.min.z)}});
  tree.transform.push_back({Scale{Vec3d(1 / width)}});
  scene.groups = {{"tree", {tree}}};
  const auto content = std::make_shared<const GroupContent>(scene.groups.front());

  const int side = static_cast<int>(std::ceil(std::sqrt(options.count)));
  constexpr double apart = 1.6;
  const double reach = apart * side / 2, height = size.z / width;
  const auto draw = [&](int copy, std::uint32_t dimension) {
    return random_unit<double>({options.seed, copy, 0, 0, 0, 0, dimension});
  };
  for (int i = 0; i < options.count; ++i) {
    Object copy{fmt::format("Tree {}", i + 1), Instance{"tree", content}, {}};
    const double across = apart * (i % side + 0.5 * (draw(i, 0) - 0.5) + 0.5) - reach,
                 along = apart * (i / side + 0.5 * (draw(i, 1) - 0.5) + 0.5) - reach;
    copy.transform = {
        {Rotate{{0, 0, 1}, 360 * draw(i, 2)}}, {Scale{Vec3d(0.7 + 0.4 * draw(i, 3))}}, {Translate{{across, along, 0}}}};
    scene.objects.push_back(std::move(copy));
  }
  scene.objects.push_back({"Floor", Plane<double>{Vec3d(0.0), {0, 0, 1}}, plain({0.35, 0.45, 0.3})});
  scene.lights = {{"Sun", Rgbd(0.8), DirectionalLight{{-1, -2, 3}}}};
  scene.title = fmt::format("{} copies of {}, seed {}", options.count, shape.file, options.seed);
  scene.background = {0.55, 0.7, 0.9}, scene.ambient = Rgbd(0.3);
  scene.camera.eye = {-0.55 * reach, -reach - 3, 2 * height + 0.12 * reach};
  scene.camera.look_at = {0, -reach + 0.5 * reach, 0.3 * height};
  scene.image = {512, 384};
  return write_scene(document, path);
}

}  // namespace raywalk
