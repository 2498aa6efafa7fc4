// How the cost of a ray grows with the number of spheres, for each accelerator: a table, and with a second argument a
// plot. Fails where a tree's cost grows faster than log N.
//
//   benchmark_growth [MOST [PLOT.svg]]      MOST spheres: 1000000 when left out

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "accel/accelerator.h"

using namespace raywalk;

namespace {

struct Random {
  std::mt19937_64 engine{1};
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  }
  Vec3d point(double size) {
    const double x = (*this)(-size, size), y = (*this)(-size, size), z = (*this)(-size, size);
    return {x, y, z};
  }
};

// Spheres in a cube, or in 40 small cubes in it. They are as dense for any N, so that a ray has about as many of them
// around it.
Primitives<double> field(int count, bool clustered) {
  Random random;
  std::vector<Vec3d> middles(1, Vec3d(0.0));
  if (clustered) middles.clear();
  for (int i = 0; clustered && i < 40; ++i) middles.push_back(random.point(0.9));
  const double half = clustered ? 0.12 : 1;
  const double spacing = 2 * half * std::pow(static_cast<double>(middles.size()) / count, 1.0 / 3);
  Primitives<double> spheres;
  for (int i = 0; i < count; ++i) {
    const Vec3d at = middles[static_cast<std::size_t>(i) % middles.size()] + random.point(half);
    spheres.add(Sphere<double>{at, 0.25 * spacing});
  }
  return spheres;
}

struct Measure {
  double build, bytes, seconds, tests;  // the last two a ray
};

Measure measure(const Primitives<double>& spheres, AcceleratorKind kind, bool few) {
  const Accelerator<double> accelerator(spheres, kind);
  Random random;
  TestCounts counts;
  const int rays = few ? 200 : 20000;
  std::vector<Ray<double>> all;
  for (int i = 0; i < rays; ++i) {
    const Vec3d from = 3.0 * normalize(random.point(1));
    all.push_back({from, normalize(random.point(1) - from)});
  }
  const auto begin = std::chrono::steady_clock::now();
  for (const Ray<double>& ray : all) static_cast<void>(accelerator.closest(ray, infinity<double>, counts));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const AcceleratorStatistics statistics = accelerator.statistics();
  return {statistics.build_seconds, static_cast<double>(statistics.bytes), seconds / rays,
          static_cast<double>(counts.nodes + counts.primitives) / rays};
}

using Curve = std::vector<std::pair<int, Measure>>;

constexpr int width = 420, height = 320, margin = 50;

// One diagram, N along and nodes + primitives a ray upwards, both in powers of ten.
std::string diagram(const std::map<AcceleratorKind, Curve>& curves, const std::string& title, int left) {
  const auto x = [&](double n) { return left + margin + (std::log10(n) - 2) / 4 * (width - 2 * margin); };
  const auto y = [&](double tests) { return height - margin - std::log10(tests) / 6 * (height - 2 * margin); };
  std::string svg;
  const auto add = [&](const char* format, auto... values) {
    char line[300];
    std::snprintf(line, sizeof line, format, values...);
    svg += line;
  };
  add("<text x='%d' y='25'>%s</text>\n", left + margin, title.c_str());
  for (int power = 0; power <= 6; ++power) {
    add("<path d='M%d %.1fH%d' stroke='#ddd'/>", left + margin, y(std::pow(10, power)), left + width - margin);
    add("<text x='%d' y='%.1f' font-size='11' text-anchor='end'>1e%d</text>\n", left + margin - 5,
        y(std::pow(10, power)) + 4, power);
    if (power >= 2)
      add("<text x='%.1f' y='%d' font-size='11' text-anchor='middle'>1e%d</text>\n", x(std::pow(10, power)),
          height - margin + 16, power);
  }
  const char* colours[] = {"#777", "#777", "#c60", "#a0a", "#08a", "#d22", "#282", "#22c", "#000"};
  for (const auto& [kind, curve] : curves) {
    const char* colour = colours[static_cast<std::size_t>(kind)];
    std::string points;
    for (const auto& [count, m] : curve) points += std::to_string(x(count)) + "," + std::to_string(y(m.tests)) + " ";
    add("<polyline fill='none' stroke-width='2' stroke='%s' points='", colour);
    svg += points + "'/>\n";
    add("<text x='%.1f' y='%.1f' font-size='11' fill='%s'>%s</text>\n", x(curve.back().first) + 4,
        y(curve.back().second.tests), colour, std::string(name_of(kind)).c_str());
  }
  return svg;
}

}  // namespace

int main(int argc, char** argv) {
  const int most = argc > 1 ? std::atoi(argv[1]) : 1000000;
  std::string svg;
  bool logarithmic = true;
  for (const bool clustered : {false, true}) {
    const char* name = clustered ? "clusters" : "uniform field";
    std::printf("%s\n%9s %-10s %10s %10s %12s %14s\n", name, "spheres", "structure", "build s", "MiB", "us a ray",
                "tests a ray");
    std::map<AcceleratorKind, Curve> curves;
    for (int count = 100; count <= most; count *= 10) {
      const Primitives<double> spheres = field(count, clustered);
      for (const AcceleratorKind kind : values_of<AcceleratorKind>) {
        if (kind == AcceleratorKind::automatic) continue;
        const bool is_linear = kind <= AcceleratorKind::boxes;
        if (is_linear && count > 100000) continue;  // they have shown how they grow
        const Measure m = measure(spheres, kind, is_linear && count > 1000);
        curves[kind].emplace_back(count, m);
        std::printf("%9d %-10s %10.3f %10.2f %12.3f %14.1f\n", count, std::string(name_of(kind)).c_str(), m.build,
                    m.bytes / (1 << 20), 1e6 * m.seconds, m.tests);
        std::fflush(stdout);
      }
    }
    for (const AcceleratorKind kind : {AcceleratorKind::bvh, AcceleratorKind::octree, AcceleratorKind::kdtree}) {
      const Curve& curve = curves[kind];
      if (curve.size() < 3) continue;
      // a + b log N grows by the same for each factor of ten. With few spheres rays still miss them all.
      double last = 0, largest = 0;
      std::printf("%s: %s costs more for ten times the spheres by", name, std::string(name_of(kind)).c_str());
      for (std::size_t i = 1; i < curve.size(); ++i) {
        largest = std::max(largest, last);
        last = curve[i].second.tests - curve[i - 1].second.tests;
        std::printf(" %.1f", last);
      }
      std::printf(" tests a ray\n");
      logarithmic = logarithmic && last <= largest;
    }
    svg += diagram(curves, std::string("Nodes and primitives tested a ray, by N: ") + name, clustered ? width : 0);
  }
  if (argc > 2) {
    std::ofstream(argv[2])
        << "<svg xmlns='http://www.w3.org/2000/svg' width='" << 2 * width << "' height='" << height
        << "' font-family='sans-serif' font-size='13'>\n<rect width='100%' height='100%' fill='white'/>\n"
        << svg << "</svg>\n";
  }
  std::printf(logarithmic ? "trees grow no faster than log N\n" : "A TREE GROWS FASTER THAN LOG N\n");
  return logarithmic ? 0 : 1;
}
