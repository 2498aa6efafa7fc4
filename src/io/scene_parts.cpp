#include "io/scene_parts.h"

#include <fmt/format.h>

#include <cmath>

namespace raywalk::detail {

void Triangles::add(Scene& scene, Names& names, const Material& material, const Vec3d& a, const Vec3d& b,
                    const Vec3d& c) {
  if (cross(b - a, c - a) == Vec3d(0.0)) {
    ++left_out_;
    return;
  }
  scene.objects.push_back({names.next("Triangle"), Triangle<double>{a, b, c}, material});
}

void Triangles::warn(WordReader& words) const {
  if (left_out_ > 0)
    words.warn(fmt::format("{} triangle{} without an area {} left out: no ray meets them", left_out_,
                           left_out_ == 1 ? "" : "s", left_out_ == 1 ? "is" : "are"));
}

void check_camera(const Camera& camera, WordReader& words) {
  const Vec3d view = camera.look_at - camera.eye;
  if (!(length(view) >= 1 / scene_keys::most_magnitude))
    return words.fail_item("the camera looks at the point where it stands (expected a point that the eye sees)",
                           "move one of the two points");
  constexpr double least_sine = 1e-9;
  if (!(length(camera.up) > 0) || length(cross(normalize(view), normalize(camera.up))) < least_sine)
    words.fail_item("up is parallel to the view (expected any other direction)",
                    "when looking straight down or up, give up = 0 1 0");
}

void check_image(const ImageSize& image, WordReader& words) {
  constexpr std::int64_t most_pixels = std::int64_t{1} << 28;
  if (std::int64_t{image.width} * image.height > most_pixels)
    words.fail(fmt::format("the image has {} x {} pixels (expected at most {} in all)", image.width, image.height,
                           most_pixels),
               "make it narrower or lower");
}

}  // namespace raywalk::detail
