// A tetrahedron as letters: # where a ray meets it, and + where it is lit.
#include <raywalk/accel.h>

#include <cstdio>
#include <vector>

using namespace raywalk::accel;

int main() {
  const std::vector<float> positions{-1, -1, -1, 1, 1, -1, 1, -1, 1, -1, 1, 1};
  const std::vector<std::uint32_t> indices{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
  const auto built = TriangleSet<float>::build(positions, indices);
  if (const auto* failure = std::get_if<BuildFailure>(&built)) {
    std::fprintf(stderr, "%s\n", words_for(failure->problem));
    return 1;
  }
  const auto& triangles = std::get<TriangleSet<float>>(built);
  for (int row = 0; row < 11; ++row) {
    for (int column = 0; column < 22; ++column) {
      const RayQuery<float> ray{{(column - 10.5F) / 9, (5 - row) / 4.5F, -5}, {0, 0, 1}};
      const auto hit = triangles.closest(ray);
      if (!hit) {
        std::putchar('.');
        continue;
      }
      const RayQuery<float> shadow{{ray.origin[0], ray.origin[1], -5 + hit->t}, {-3, 2, -4}, 1, hit->triangle};
      std::putchar(triangles.any(shadow) ? '#' : '+');
    }
    std::putchar('\n');
  }
}
