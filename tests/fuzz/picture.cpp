// Read, then trace: whatever scene libFuzzer's bytes make, its picture of 16 x 16 pixels has no pixel that is not a
// number or infinite, in either precision, by the tracer and by paths.

#include "io/scene_file.h"
#include "render/render.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

using namespace raywalk;

namespace {

/// What would only take long: many rays a pixel, many bodies, many photons and patches.
void keep_small(Scene& scene) {
  scene.render.samples = std::min(scene.render.samples, 2);
  scene.render.light_grid = 1;
  scene.render.path_length = std::min(scene.render.path_length.value_or(6), 6);
  scene.render.photons.count = std::min(scene.render.photons.count, 300);
  scene.render.radiosity.patch = 1e12;  // surfaces whole, but where shadows cut them
  scene.render.radiosity.shots = std::min(scene.render.radiosity.shots, 2);
  scene.limits.depth = std::min(scene.limits.depth, 4);
}

void require_finite(const Rendering& rendering, const char* what) {
  if (rendering.statistics.not_finite == 0) return;
  std::fprintf(stderr, "%llu pixels are no numbers (%s)\n",
               static_cast<unsigned long long>(rendering.statistics.not_finite), what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto document = parse_scene({reinterpret_cast<const char*>(data), size}, "fuzzed");
  if (!document) return 0;
  Scene& scene = document->scene;
  constexpr double max_bodies = 400;
  if (entries_of(scene.objects) > max_bodies || scene.lights.size() > 8) return 0;
  keep_small(scene);
  RenderSettings settings;
  settings.size = ImageSize{16, 16};
  settings.threads = 1;
  settings.sampling.per_pixel = scene.render.samples;
  for (const Precision precision : {Precision::double_, Precision::float_}) {
    settings.precision = precision;
    const auto rendering = render(scene, settings);
    if (rendering) require_finite(*rendering, precision == Precision::double_ ? "double" : "float");
  }
  scene.render.integrator = Integrator::path;
  settings.precision = Precision::double_;
  const auto paths = render(scene, settings);
  if (paths) require_finite(*paths, "paths");
  return 0;
}
