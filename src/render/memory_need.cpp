#include "render/memory_need.h"

#include "accel/build_record.h"
#include "accel/mesh_copies.h"
#include "accel/primitives.h"
#include "scene/copied_meshes.h"
#include "trace/photon_map.h"
#include "trace/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace raywalk {

namespace {

/// The size of a scene with all instances expanded; they share their surfaces, and some the triangles of their meshes.
struct Census {
  double shapes = 0, placed = 0, triangles = 0, vertices = 0, surfaces = 0, copies = 0, copied = 0, shared = 0;

  Census& operator+=(const Census& more) {
    shapes += more.shapes;
    placed += more.placed;
    triangles += more.triangles;
    vertices += more.vertices;
    surfaces += more.surfaces;
    copies += more.copies;
    copied += more.copied;
    shared += more.shared;
    return *this;
  }
};

class Counter {
 public:
  explicit Counter(const Scene& scene) : copied_(scene), shares_(copied_.share()) {}

  Census count(const std::vector<Object>& objects, bool mapped, bool moves) {
    Census census;
    for (const Object& object : objects)
      census += count(object, mapped || !object.transform.empty(), moves || !object.motion.empty());
    return census;
  }

 private:
  Census count(const Object& object, bool mapped, bool moves) {
    if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      if (!instance->content) return {};
      const auto [entry, is_new] = known_.try_emplace({instance->content.get(), mapped, moves});
      if (is_new) entry->second = count(instance->content->group.objects, mapped, moves);
      Census census = entry->second;
      if (!is_new) census.surfaces = census.shared = 0;
      return census;
    }
    if (const auto* mesh = std::get_if<MeshShape>(&object.shape)) {
      if (!mesh->mesh) return {};
      const auto triangles = static_cast<double>(mesh->mesh->triangles.size());
      if (shares_ && copied_.has(object, moves))
        return {.surfaces = 1, .copies = 1, .copied = triangles, .shared = triangles};
      return {.triangles = triangles, .vertices = static_cast<double>(mesh->mesh->positions.size()), .surfaces = 1};
    }
    return {.shapes = 1, .placed = mapped ? 1.0 : 0.0, .surfaces = 1};
  }

  CopiedMeshes copied_;
  bool shares_;  ///< copies share their triangles
  std::map<std::tuple<const GroupContent*, bool, bool>, Census> known_;
};

/// Bytes of a structure for each primitive in double, and what building it takes meanwhile: measured on 400,000
/// scattered spheres and as many triangles of a closed surface. In float it is two thirds.
struct PerPrimitive {
  double shape, triangle;
};
PerPrimitive per_primitive(AcceleratorKind kind) {
  switch (kind) {
    case AcceleratorKind::automatic:  // for numbers that matter
    case AcceleratorKind::bvh:
      return {150, 170};
    case AcceleratorKind::none:
      return {0, 0};
    case AcceleratorKind::spheres:
    case AcceleratorKind::ellipsoids:
    case AcceleratorKind::boxes:
      return {150, 150};
    case AcceleratorKind::grid:
      return {30, 30};
    case AcceleratorKind::octree:
      return {150, 800};
    case AcceleratorKind::kdtree:
      return {500, 1200};
  }
  return {0, 0};
}

template <class T>
MemoryNeed needed(const Scene& scene, const RenderSettings& settings) {
  // Growing vectors are half as large again on average.
  constexpr double growing = 1.5;
  constexpr double share = sizeof(T) == sizeof(double) ? 1 : 2.0 / 3;
  // Per primitive: its object, its surface, its leaf and its kind.
  constexpr double known = growing * (4 + 4 + 12 + 1 + 1);
  const Census census = Counter(scene).count(scene.objects, false, false);
  const PerPrimitive structure = per_primitive(settings.accelerator);
  // Found by its material while the lists are filled.
  constexpr double surface = growing * sizeof(typename World<T>::Surface) + 64;
  const double shapes = census.shapes * (growing * sizeof(Shape<T>) + known + share * structure.shape) +
                        census.placed * growing * (sizeof(ObjectTransform<T>) + 4) + census.surfaces * surface;
  // Where space is split, up to half of them are listed twice (accel/binary_tree.cpp).
  const double listed = settings.build == BuildQuality::best ? 1.5 : 1;
  const double triangles = census.triangles * (sizeof(Mesh::Corners) + known + share * listed * structure.triangle) +
                           census.vertices * 2 * sizeof(Vec3<T>);  // positions and normals
  // Each in its list, in the tree over all, with the map there and back, and what it is; then a tree for each mesh.
  constexpr double of_copy = growing * (sizeof(MeshCopy) + sizeof(CopyPlace) + 64) + 150;
  const bool knows_copies =
      settings.accelerator == AcceleratorKind::automatic || settings.accelerator == AcceleratorKind::bvh;
  const double copies =
      census.copies * of_copy + share * listed * structure.triangle * (knows_copies ? census.shared : census.copied);
  const ImageSize size = settings.size.value_or(scene.image);
  // The mean of each pixel, and the floats of its file.
  const double pixels = static_cast<double>(size.width) * size.height,
               picture = pixels * (sizeof(Rgb<T>) + sizeof(Rgb<float>));
  // Each is stored three times on average, and twice while the tree is built.
  const double photons = scene.render.integrator == Integrator::photons
                             ? static_cast<double>(scene.render.photons.count) * (6 * sizeof(Photon) + 16)
                             : 0;
  const double most = std::max({shapes, triangles, copies, picture, photons});
  const auto with_structure = [&](double count, const char* what) {
    return fmt::format(
        "a scene of {:.0f} {}, with its {}", count, what,
        settings.accelerator == AcceleratorKind::automatic ? "structure" : name_of(settings.accelerator));
  };
  const double all = shapes + triangles + copies + picture + photons;
  if (most == photons && photons > 0)
    return {fmt::format("a map of {} photons", scene.render.photons.count), all,
            "send fewer photons: with photons = { progressive = true } every sample sends that many again"};
  if (most == picture)
    return {fmt::format("a picture of {} x {} pixels", size.width, size.height), all, "choose a smaller --size"};
  return {most == shapes   ? with_structure(census.shapes, "shapes")
          : most == copies ? with_structure(census.copies, "copies of meshes")
                           : with_structure(census.triangles, "triangles"),
          all, "use fewer instances or coarser meshes, or --precision float"};
}

}  // namespace

MemoryNeed memory_needed(const Scene& scene, const RenderSettings& settings) {
  return settings.precision == Precision::float_ ? needed<float>(scene, settings) : needed<double>(scene, settings);
}

}  // namespace raywalk
