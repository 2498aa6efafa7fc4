#include "trace/beam_scene.h"

#include "math/elementary.h"
#include "trace/patch_cutter.h"

#include <limits>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>

namespace raywalk {

namespace {

/// Of what stands for a circle.
constexpr int sides_of_circle = 64;

template <class S>
constexpr bool is_flat_kind = std::is_same_v<S, Box<double>> || std::is_same_v<S, Prism<double>> ||
                              std::is_same_v<S, Polygon<double>> || std::is_same_v<S, Triangle<double>>;

/// Of what is one flat face, but for its edge.
std::optional<BeamFace> whole_face_of(const Shape<double>& shape, const Affine<double>& to_world) {
  const auto* plane = std::get_if<Plane<double>>(&shape);
  const auto* disk = std::get_if<Disk<double>>(&shape);
  if (plane == nullptr && disk == nullptr) return std::nullopt;
  const PlaneAxes<double> axes = plane_axes(normalize(plane ? plane->normal : disk->normal));
  BeamFace face;
  face.plane.normal = normalize(cross(to_world.direction(axes.u), to_world.direction(axes.v)));
  face.plane.offset = dot(face.plane.normal, to_world.point(plane ? plane->point : disk->centre));
  for (int i = 0; disk != nullptr && i < sides_of_circle; ++i) {
    const auto [sine, cosine] = portable::sin_cos(2 * std::numbers::pi * i / sides_of_circle);
    face.outline.push_back(to_world.point(disk->centre + disk->radius * (cosine * axes.u + sine * axes.v)));
  }
  return face;
}

}  // namespace

BeamFaces beam_faces_of(const Scene& scene, const Stop& stop) {
  const World<double> world(scene, AcceleratorKind::none, std::nullopt, BuildOptions{stop});
  const Primitives<double>& primitives = world.accelerator.primitives();
  std::vector<BeamFace> faces;
  for (Patch& patch :
       cut_into_patches(world, {.most = std::numeric_limits<int>::max(), .least_sides = sides_of_circle}, stop)
           .patches) {
    const Shape<double> shape = primitives.shape(patch.primitive);
    if (std::holds_alternative<Disk<double>>(shape)) continue;
    BeamFace face{{patch.corner.begin(), patch.corner.begin() + patch.corners},
                  {patch.normal, dot(patch.normal, patch.centre)}};
    face.primitive = patch.primitive, face.part = patch.part, face.object = patch.object;
    face.is_flat = std::visit([](const auto& s) { return is_flat_kind<std::decay_t<decltype(s)>>; }, shape);
    faces.push_back(std::move(face));
  }
  for (int id = 0; id < primitives.shape_count(); ++id) {
    const ObjectTransform<double>* transform = primitives.transform_of(id);
    std::optional<BeamFace> face =
        whole_face_of(primitives.shape(id), transform ? transform->to_world : Affine<double>{});
    if (!face) continue;
    face->primitive = id, face->object = world.object(id);
    faces.push_back(std::move(*face));
  }
  return BeamFaces(std::move(faces), stop);
}

}  // namespace raywalk
