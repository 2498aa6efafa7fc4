// What robust numerics cost against naive ones: single shapes under many rays, and whole scenes, both with every
// effect's code in the loop. numerics.sh counts the instructions and prints the table.
//
//   benchmark_numerics SHAPE|SCENE.toml robust|naive [COUNT|WIDTHxHEIGHT]
//   benchmark_numerics SHAPE|SCENE.toml ratio [COUNT|WIDTHxHEIGHT]     robust seconds over naive ones
//   benchmark_numerics                                                 the names of all shapes

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../support/one_of_each.h"
#include "io/scene_file.h"
#include "shape/naive.h"
#include "trace/kernel.h"
#include "trace/tracer.h"

using namespace raywalk;

namespace {

/// Something that can be traced either way.
struct Work {
  virtual ~Work() = default;
  [[nodiscard]] virtual double robust() const = 0;  ///< a sum, so that nothing is computed for nothing
  [[nodiscard]] virtual double naive() const = 0;
};

/// From a sphere about the shape to points in and near it: about half of them hit.
class Rays {
 public:
  explicit Rays(int count) {
    for (int i = 0; i < count; ++i) {
      const Vec3d from = 3.0 * normalize(Vec3d(next(), next(), next())), to(next(), next(), next());
      rays_.push_back({from, normalize(to - from)});
    }
  }
  [[nodiscard]] auto begin() const { return rays_.begin(); }
  [[nodiscard]] auto end() const { return rays_.end(); }

 private:
  double next() {  // -1 to 1
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(static_cast<std::int64_t>(state_)) * 0x1p-63;
  }
  std::uint64_t state_ = 1;
  std::vector<Ray<double>> rays_;
};

template <class S>
struct ShapeWork final : Work {
  ShapeWork(S a_shape, int count) : shape(std::move(a_shape)), rays(count) {}
  [[nodiscard]] double robust() const override { return sum<Ray<double>>(); }
  [[nodiscard]] double naive() const override { return sum<NaiveRay<double>>(); }
  template <class AnyRay>
  [[nodiscard]] double sum() const {
    double all = 0;
    for (const Ray<double>& ray : rays)
      if (const auto crossing = intersect(shape, AnyRay{ray}, infinity<double>)) all += crossing->t;
    return all;
  }
  S shape;
  Rays rays;
};

struct SceneWork final : Work {
  SceneWork(const Scene& scene, ImageSize the_size) : size(the_size), world(scene), camera(scene, size, size) {}
  [[nodiscard]] double robust() const override { return sum<Numerics::robust>(); }
  [[nodiscard]] double naive() const override { return sum<Numerics::naive>(); }
  template <Numerics Arithmetic>
  [[nodiscard]] double sum() const {
    double all = 0;
    NoObserver nobody;
    Tracer<Policy<double, NoObserver, all_hit_effects, Arithmetic>> tracer(world, camera, nobody);
    tracer.main_algorithm(PixelBlock{0, size.width, 0, size.height},
                          [&](const Pixel&, const Rgbd& shade) { all += shade.x + shade.y + shade.z; });
    return all;
  }
  ImageSize size;
  World<double> world;
  RayGenerator<double> camera;
};

std::unique_ptr<Work> work_of(const std::string& name, const std::string& amount) {
  for (const Shape<double>& any : test::one_of_each())
    if (shape_name(any) == name)
      return std::visit(
          [&]<class S>(const S& shape) -> std::unique_ptr<Work> {
            return std::make_unique<ShapeWork<S>>(shape, amount.empty() ? 100000 : std::stoi(amount));
          },
          any);
  ImageSize size{200, 150};
  if (!amount.empty() && std::sscanf(amount.c_str(), "%dx%d", &size.width, &size.height) != 2) return nullptr;
  const auto document = read_scene(name);
  if (!document) {
    std::fprintf(stderr, "%s\n", document.error().text().c_str());
    return nullptr;
  }
  return std::make_unique<SceneWork>(document->scene, size);
}

}  // namespace

// What is counted: a name of its own for callgrind's --toggle-collect.
extern "C" __attribute__((noinline)) double raywalk_trace_phase(const Work& work, bool naive) {
  return naive ? work.naive() : work.robust();
}

int main(int argc, char** argv) {
  if (argc == 1) {
    for (const Shape<double>& any : test::one_of_each()) std::printf("%s\n", std::string(shape_name(any)).c_str());
    return 0;
  }
  const std::string how = argc > 2 ? argv[2] : "";
  const auto work = work_of(argv[1], argc > 3 ? argv[3] : "");
  if (!work || (how != "robust" && how != "naive" && how != "ratio")) {
    std::fputs("usage: benchmark_numerics SHAPE|SCENE.toml robust|naive|ratio [COUNT|WIDTHxHEIGHT]\n", stderr);
    return 2;
  }
  if (how != "ratio") {
    std::printf("%.17g\n", raywalk_trace_phase(*work, how == "naive"));
    return 0;
  }
  // In turns, so that a busy machine slows both; the median of the ratios.
  std::array<double, 9> ratios;
  for (double& ratio : ratios) {
    const auto seconds = [&](bool naive) {
      const auto begin = std::chrono::steady_clock::now();
      static_cast<void>(raywalk_trace_phase(*work, naive));
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const double robust = seconds(false);
    ratio = robust / seconds(true);
  }
  std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
  std::printf("%.3f\n", ratios[ratios.size() / 2]);
  return 0;
}
