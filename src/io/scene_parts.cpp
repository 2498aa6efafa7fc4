#include "io/scene_parts.h"

#include "text/memory.h"

#include <fmt/format.h>

#include <algorithm>

namespace raywalk::detail {

void TriangleGatherer::add(Scene& scene, UniqueNames& names, const Material& material,
                           const std::array<MeshCorner, 3>& corners) {
  const Vec3d& a = corners[0].position;
  if (cross(corners[1].position - a, corners[2].position - a) == Vec3d(0.0)) {
    ++left_out_;
    return;
  }
  if (gathered_.triangles.empty() || !(material_ == material)) put(scene, names);
  material_ = material;
  const auto first = static_cast<std::int32_t>(gathered_.positions.size());
  for (const MeshCorner& corner : corners) {
    gathered_.positions.push_back(corner.position);
    gathered_.normals.push_back(corner.normal);
    smooth_ = smooth_ || corner.normal != Vec3d(0.0);
  }
  gathered_.triangles.push_back({first, first + 1, first + 2});
  // Indices have 31 bits.
  constexpr std::size_t most = 500'000'000;
  if (gathered_.triangles.size() == most) put(scene, names);
}

void TriangleGatherer::put(Scene& scene, UniqueNames& names) {
  if (gathered_.triangles.empty()) return;
  if (!smooth_) gathered_.normals.clear();
  if (gathered_.triangles.size() == 1 && !smooth_) {
    const auto& at = gathered_.positions;
    scene.objects.push_back({names.next("Triangle"), Shape<double>(Triangle<double>{at[0], at[1], at[2]}), material_});
  } else {
    gathered_.positions.shrink_to_fit();
    gathered_.triangles.shrink_to_fit();
    MeshShape mesh;
    mesh.smooth = smooth_;
    mesh.mesh = std::make_shared<const Mesh>(std::move(gathered_));
    Object object;
    object.name = names.next("Mesh");
    object.shape = mesh;
    object.material = material_;
    scene.objects.push_back(std::move(object));
  }
  gathered_ = {};
  smooth_ = false;
}

void TriangleGatherer::warn(WordReader& words) const {
  if (left_out_ > 0)
    words.warn(fmt::format("{} triangle{} without an area {} left out: no ray meets them", left_out_,
                           left_out_ == 1 ? "" : "s", left_out_ == 1 ? "is" : "are"));
}

std::optional<Error> make_room(Scene& scene, std::string_view text, const std::string& file,
                               const std::vector<std::string_view>& object_words,
                               const std::vector<std::string_view>& triangle_words) {
  double objects = 0, triangles = 0;
  for (std::size_t line = 0; line < text.size(); line = std::min(text.find('\n', line), text.size() - 1) + 1) {
    const std::size_t begin = text.find_first_not_of(" \t\r", line);
    if (begin == std::string_view::npos) break;
    const std::string_view word =
        text.substr(begin, std::min<std::size_t>(text.find_first_of(" \t\r\n", begin), text.size()) - begin);
    const auto is_one_of = [&](const auto& words) {
      return std::find(words.begin(), words.end(), word) != words.end();
    };
    if (is_one_of(object_words)) objects += 1;
    if (is_one_of(triangle_words)) triangles += 1;
  }
  // With its share of the text, and of what its name and material may hold beside it.
  constexpr double per_object = 1.1 * sizeof(Object);
  // Three corners with normals per triangle, in growing lists.
  constexpr double per_triangle = 1.5 * (3 * 2 * sizeof(Vec3d) + sizeof(Mesh::Corners));
  const MemoryNeed need{triangles > objects ? fmt::format("a scene of {:.0f} triangles", triangles)
                                            : fmt::format("a scene of {:.0f} objects", objects),
                        objects * per_object + triangles * per_triangle,
                        "write fewer of them, or a mesh in a file of its own"};
  if (auto error = why_too_large(need, file)) return error;
  scene.objects.reserve(static_cast<std::size_t>(objects));
  return std::nullopt;
}

void check_camera(const Camera& camera, WordReader& words) {
  if (!looks_somewhere(camera))
    return words.fail_item("the camera looks at the point where it stands (expected a point that the eye sees)",
                           "move one of the two points");
  if (looks_along_up(camera))
    words.fail_item("up is parallel to the view (expected any other direction)",
                    "when looking straight down or up, give up = 0 1 0");
}

void check_image(const ImageSize& image, WordReader& words) {
  if (has_too_many_pixels(image))
    words.fail(fmt::format("the image has {} x {} pixels (expected at most {} in all)", image.width, image.height,
                           max_image_pixels),
               "make it narrower or lower");
}

}  // namespace raywalk::detail
