#include "trace/beam_scene.h"

#include "trace/patch_cutter.h"

#include <type_traits>
#include <utility>

namespace raywalk {

namespace {

/// Of what stands for a circle.
constexpr int sides_of_circle = 64;

template <class S>
constexpr bool is_flat_kind =
    std::is_same_v<S, Box<double>> || std::is_same_v<S, Prism<double>> || std::is_same_v<S, Polygon<double>> ||
    std::is_same_v<S, Triangle<double>> || std::is_same_v<S, Disk<double>> || std::is_same_v<S, Plane<double>>;

}  // namespace

BeamFaces beam_faces_of(const Scene& scene, const Stop& stop) {
  const World<double> world(scene, AcceleratorKind::none, std::nullopt, BuildOptions{stop});
  const Primitives<double>& primitives = world.accelerator.primitives();
  const CutSettings settings{.most = std::numeric_limits<int>::max(), .least_sides = sides_of_circle};
  std::vector<BeamFace> faces;
  for (const Patch& patch : cut_into_patches(world, settings, stop).patches) {
    BeamFace face{patch.corner, patch.corners, {patch.normal, dot(patch.normal, patch.centre)}};
    face.primitive = patch.primitive, face.part = patch.part, face.object = patch.object;
    face.is_flat = std::visit([](const auto& s) { return is_flat_kind<std::decay_t<decltype(s)>>; },
                              primitives.shape(patch.primitive));
    faces.push_back(face);
  }
  for (int id = 0; id < primitives.shape_count(); ++id) {
    const Shape<double> shape = primitives.shape(id);
    const auto* plane = std::get_if<Plane<double>>(&shape);
    if (plane == nullptr) continue;
    const PlaneAxes<double> axes = plane_axes(normalize(plane->normal));
    const ObjectTransform<double>* transform = primitives.transform_of(id);
    const Affine<double> map = transform ? transform->to_world : Affine<double>{};
    BeamFace face;
    face.plane.normal = normalize(cross(map.direction(axes.u), map.direction(axes.v)));
    face.plane.offset = dot(face.plane.normal, map.point(plane->point));
    face.primitive = id, face.object = world.object(id);
    faces.push_back(face);
  }
  return BeamFaces(std::move(faces), stop);
}

}  // namespace raywalk
