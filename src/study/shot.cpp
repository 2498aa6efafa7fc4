#include "study/shot.h"

#include "math/random.h"
#include "render/picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk::study {

Shot shoot(const Scene& scene, ImageSize size, Sampling sampling, bool shuffled,
           const std::optional<PathSettings>& paths, const Stop& stop) {
  const World<double> world(scene, AcceleratorKind::automatic, {}, {.stop = stop});
  Picture<double> picture(scene, world, size, size, sampling, 0, paths);
  Statistics statistics;
  const double start = thread_seconds();
  for (int sample = 0; sample < sampling.per_pixel; ++sample) {
    if (shuffled) {
      Sampling other = sampling;
      other.seed = detail::mix(sampling.seed + static_cast<std::uint64_t>(sample) * 7919);
      picture.set_camera(RayGenerator<double>(scene, size, size, other));
    }
    statistics += picture.trace({0, size.width, 0, size.height, sample, 1, 1, stop});
  }
  const double seconds = thread_seconds() - start;
  return {std::move(picture.film()), cost_of(statistics, seconds), statistics.formed(RayKind::shadow)};
}

ImageSize shrunk(ImageSize size, double pixels) {
  const double scale = std::min(1.0, std::sqrt(pixels / (static_cast<double>(size.width) * size.height)));
  return {std::max(1, static_cast<int>(size.width * scale)), std::max(1, static_cast<int>(size.height * scale))};
}

Camera looking_down(double x, double y, double height, double half) {
  Camera camera;
  camera.eye = {x, y, height};
  camera.look_at = {x, y, 0};
  camera.up = {0, 1, 0};
  camera.screen = {1, 2 * half / height, 1};
  return camera;
}

Compared compared(const Film<double>& film, const std::function<double(int column, int row)>& truth) {
  double squares = 0, sum = 0;
  const ImageSize size = film.size();
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column) {
      const double difference = film.at(column, row).x - truth(column, row);
      squares += difference * difference;
      sum += difference;
    }
  const double pixels = static_cast<double>(size.width) * size.height;
  return {std::sqrt(squares / pixels), sum / pixels};
}

double drawn_for(int round, int which) {
  RandomKey key;
  key.seed = seed_of(round);
  key.effect = 0x73747564;  // "stud"
  key.dimension = static_cast<std::uint32_t>(which);
  return random_unit<double>(key);
}

}  // namespace raywalk::study
