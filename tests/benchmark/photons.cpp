// Photons: what a map of a million costs to build and to hold; a caustic to a given error against paths; a STEP where
// a hundred thousand photons lie in the plan. In processor time and one thread, so that a busy machine matters little.
//
//   benchmark_photons [THOUSANDS OF PHOTONS] [SAMPLES OF A REFERENCE]

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>
#include <vector>

#include "io/scene_file.h"
#include "math/random.h"
#include "render/render.h"
#include "trace/photon_map.h"
#include "view/action.h"
#include "view/plan/plan_view.h"
#include "view/state.h"

namespace {

using namespace raywalk;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The most that this process has held so far.
double held_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

bool measure_map(int thousands) {
  const int count = 1000 * thousands;
  const double before = held_mib();
  std::vector<Photon> photons;
  photons.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const auto draw = [&](std::uint32_t dimension) {
      RandomKey key{};
      key.sample = static_cast<std::uint32_t>(i);
      key.dimension = dimension;
      return random_unit<float>(key);
    };
    photons.push_back({{draw(0), draw(1), draw(2)}, {0, 0, 1}, Rgb<float>(1)});
  }
  const double begin = seconds();
  const PhotonMap map(std::move(photons));
  const double built = seconds() - begin, mib = held_mib() - before;
  std::printf("map of %d photons: built in %.2f s, %.0f MiB at most (goal: a million in 1 s and 200 MiB)\n", count,
              built, mib);
  return built <= 1 && mib <= 200 && map.size() == static_cast<std::size_t>(count);
}

Material matt(double albedo) {
  Material material;
  material.diffuse = Rgbd(albedo);
  return material;
}

/// A small disk that glows above a glass ball; the camera looks at the floor below, past the ball.
Scene below_the_ball() {
  Scene scene;
  Material glass = matt(0);
  glass.reflection = Rgbd(0.04), glass.transmission = Rgbd(0.96);
  glass.dielectric = true, glass.ior = 1.5;
  scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matt(0.7)},
                   {"Ball", Sphere<double>{{0, 0, 1.6}, 1}, glass},
                   {"Lamp", Disk<double>{{0, 0, 6}, {0, 0, -1}, 0.05}, matt(0)}};
  scene.objects.back().material.emission = Rgbd(900);
  scene.camera.eye = {-4, 0, 1.2}, scene.camera.look_at = {0, 0, 0}, scene.camera.up = {0, 0, 1};
  scene.camera.fov = FieldOfView{16};
  scene.background = scene.ambient = Rgbd(0.0);
  scene.render.photons.nearest = 40;
  scene.render.photons.radius = 0.1;
  scene.render.photons.count = 200000;
  return scene;
}

struct Picture {
  Image image;
  double seconds;
};
Picture render_by(Integrator integrator, int samples, std::uint64_t seed) {
  Scene scene = below_the_ball();
  scene.render.integrator = integrator;
  RenderSettings settings;
  settings.size = ImageSize{48, 36};
  settings.sampling.per_pixel = samples;
  settings.sampling.seed = seed;
  settings.threads = 1;
  const double begin = seconds();
  auto rendering = render(scene, settings);
  return {rendering.value().image(), seconds() - begin};
}

double rms(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::pow(a.pixels[i].x - b.pixels[i].x, 2);
  return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

/// Paths' error falls with the root of their samples (study, E11), so that their time for the photons' error follows
/// from a few.
bool measure_caustic(int reference_samples) {
  const Picture reference = render_by(Integrator::path, reference_samples, 1);
  std::vector<double> ratios;
  for (std::uint64_t seed = 2; seed < 7; ++seed) {
    const Picture photons = render_by(Integrator::photons, 16, seed);
    const Picture paths = render_by(Integrator::path, 256, seed);
    const double error = rms(photons.image, reference.image), of_paths = rms(paths.image, reference.image);
    const double time = paths.seconds * std::pow(of_paths / error, 2);
    std::printf("  photons %.4f in %.2f s, paths %.4f in %.2f s: to the photons' error in %.1f s\n", error,
                photons.seconds, of_paths, paths.seconds, time);
    ratios.push_back(photons.seconds / time);
  }
  std::sort(ratios.begin(), ratios.end());
  const double ratio = ratios[ratios.size() / 2];
  std::printf("caustic of a glass ball under a small disk: %.3f of the paths' time (median of %zu; goal: 0.1)\n", ratio,
              ratios.size());
  return ratio <= 0.1;
}

bool measure_steps(int thousands) {
  auto document = read_scene(RAYWALK_SOURCE_DIR "/scenes/caustic.toml");
  if (!document) return false;
  document->scene.render.photons.count = 1000 * thousands;
  State state = make_state(std::move(*document), "caustic.toml");
  update(state, action::ResizePlan{{1360, 860}});
  update(state, action::Jump{state.walk.timeline->all_photons_at()});
  const PhotonMaps* maps = state.walk.timeline->photons();
  const std::size_t lying = maps == nullptr ? 0 : maps->caustic.size() + maps->other.size();
  std::vector<double> times;
  while (times.size() < 200 && state.walk.position < state.walk.timeline->steps()) {
    const double begin = seconds();
    update(state, action::Step{});
    const std::size_t items = plan_view(state).size();
    times.push_back(1000 * (seconds() - begin));
    if (items == 0) return false;
  }
  if (times.empty()) return false;
  std::sort(times.begin(), times.end());
  std::printf("%zu photons in the plan: a step in %.1f ms, at most %.1f ms (of %zu; goal: 16 ms)\n", lying,
              times[times.size() / 2], times.back(), times.size());
  return times.back() <= 16;
}

}  // namespace

int main(int argc, char** argv) {
  const int thousands = argc > 1 ? std::atoi(argv[1]) : 1000, samples = argc > 2 ? std::atoi(argv[2]) : 1 << 15;
  if (thousands < 1 || samples < 1) {
    std::fputs("usage: benchmark_photons [THOUSANDS OF PHOTONS] [SAMPLES OF A REFERENCE]\n", stderr);
    return 2;
  }
  const bool map = measure_map(thousands), caustic = measure_caustic(samples), steps = measure_steps(thousands);
  return map && caustic && steps ? 0 : 1;
}
