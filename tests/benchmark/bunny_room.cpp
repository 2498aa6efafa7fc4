// The race of path tracers: the Stanford bunny in a closed room of 69,642 triangles, by primary rays alone and by
// paths. Prints rays per second, all rays of a kind counted alike; figures are medians of repetitions.
//
//   benchmark_bunny_room [MESH.ply|-] [WIDTHxHEIGHT] [SAMPLES] [THREADS] [REPETITIONS] [IMAGE]
//
// The numbers of the room stand in data/README.md of the shared folder: albedo 0.7, a light of radiance 20 in the
// ceiling, a camera of 50 degrees.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "io/mesh_file.h"
#include "render/render.h"

namespace {

using namespace raywalk;

std::string default_mesh() {
  const char* told = std::getenv("RAYWALK_SHARED_DIR");
  for (const std::string& shared : {std::string(told ? told : ""), std::string(RAYWALK_SOURCE_DIR "/../shared"),
                                    std::string(RAYWALK_SOURCE_DIR "/../../shared")})
    if (!shared.empty() && std::filesystem::exists(shared + "/data/bunny_room.ply"))
      return shared + "/data/bunny_room.ply";
  return "";
}

Scene bunny_room(const MeshFile& file) {
  Scene scene;
  scene.camera.eye = {2.4184, 6.36349, 10.4013};
  scene.camera.look_at = {-1.0816, 3.86349, -0.0987129};
  scene.camera.up = {0, 1, 0};
  scene.camera.fov = FieldOfView{50, FovAxis::y};
  scene.camera.screen.width.reset();
  MeshShape mesh;
  mesh.smooth = false;
  mesh.mesh = file.mesh;
  Object room;
  room.name = "Room";
  room.shape = mesh;
  room.material.diffuse = Rgbd(0.7);
  Object light;
  light.name = "Light";
  light.shape = Polygon<double>{{{-3.7216, 15.8633, -2.73871},
                                 {1.5584, 15.8633, -2.73871},
                                 {1.5584, 15.8633, 2.54129},
                                 {-3.7216, 15.8633, 2.54129}},
                                {}};
  light.material.diffuse = Rgbd(0.0);
  light.material.emission = Rgbd(20.0);
  scene.objects = {room, light};
  scene.render.integrator = Integrator::path;
  scene.render.sampler = Sampler::random;
  return scene;
}

struct Figures {
  double wall, processor, rays;
  Image image;
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Figures once(const Scene& scene, const RenderSettings& settings) {
  const double begin = processor_seconds();
  const auto rendered = render(scene, settings);
  if (!rendered) {
    std::fprintf(stderr, "%s\n", rendered.error().text().c_str());
    std::exit(1);
  }
  double rays = 0;
  for (const std::uint64_t formed : rendered->statistics.rays) rays += static_cast<double>(formed);
  return {rendered->trace_seconds, processor_seconds() - begin, rays, rendered->image()};
}

Figures measure(const Scene& scene, const RenderSettings& settings, int repetitions) {
  // A picture of one pixel takes what it takes to build the accelerator.
  RenderSettings pixel = settings;
  pixel.size = ImageSize{1, 1};
  const double building = once(scene, pixel).processor;
  std::vector<Figures> all;
  for (int i = 0; i < repetitions; ++i) {
    all.push_back(once(scene, settings));
    all.back().processor -= building;
  }
  std::sort(all.begin(), all.end(), [](const Figures& a, const Figures& b) { return a.processor < b.processor; });
  return all[all.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, const char* otherwise) { return std::string(argc > i ? argv[i] : otherwise); };
  const std::string path = argument(1, "-") == "-" ? default_mesh() : argument(1, "");
  ImageSize size{512, 512};
  const std::string wanted = argument(2, "512x512");
  const int samples = std::atoi(argument(3, "4").c_str()), threads = std::atoi(argument(4, "1").c_str());
  const int repetitions = std::atoi(argument(5, "3").c_str());
  if (std::sscanf(wanted.c_str(), "%dx%d", &size.width, &size.height) != 2 || size.width < 1 || size.height < 1 ||
      samples < 1 || threads < 0 || repetitions < 1) {
    std::fputs("usage: benchmark_bunny_room [MESH.ply|-] [WIDTHxHEIGHT] [SAMPLES] [THREADS] [REPETITIONS] [IMAGE]\n",
               stderr);
    return 2;
  }
  if (path.empty()) {
    std::puts(
        "skipped: there is no data/bunny_room.ply in RAYWALK_SHARED_DIR, nor in a folder `shared` beside the source");
    return 0;
  }
  const auto mesh = read_mesh(path);
  if (!mesh) {
    std::fprintf(stderr, "%s\n", mesh.error().text().c_str());
    return 1;
  }
  Scene scene = bunny_room(*mesh);
  std::printf("%zu triangles, %d x %d pixels, %d samples\n", mesh->mesh->triangles.size(), size.width, size.height,
              samples);
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    const char* scalar = precision == Precision::float_ ? "float " : "double";
    RenderSettings settings{size, {samples, 1}, precision};
    settings.threads = threads;
    for (const bool paths : {false, true}) {
      scene.render.path_length = paths ? std::nullopt : std::optional<int>(1);
      const Figures figures = measure(scene, settings, repetitions);
      std::printf("%s %s %6.2f million rays/s, %6.2f per second of processor time (%.2f s, %.1f million rays)\n",
                  scalar, paths ? "paths       " : "primary rays", figures.rays / figures.wall / 1e6,
                  figures.rays / figures.processor / 1e6, figures.wall, figures.rays / 1e6);
      if (paths && argc > 6)
        if (const auto written = write_image(argv[6], figures.image); !written)
          std::fprintf(stderr, "%s\n", written.error().text().c_str());
    }
  }
  return 0;
}
