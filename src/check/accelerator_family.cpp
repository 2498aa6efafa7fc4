#include "accel/accelerator.h"
#include "accel/width.h"
#include "check/aim.h"
#include "check/family.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace raywalk::check {

namespace {

/// What a heap holds besides shapes: nothing, a mesh of more triangles, or a few of them placed here and there, each
/// stored or as a copy.
enum class Meshes { none, one, stored, copied };

/// A random mix of shapes of all sizes, some transformed, some coinciding.
template <class T>
Primitives<T> heap(Random& random, bool backwards, Meshes meshes) {
  std::vector<std::pair<Shape<T>, std::optional<ObjectTransform<T>>>> all;
  const int count = random.whole(5, 60);
  const double spread = random.magnitude(0, 2);
  for (int i = 0; i < count; ++i) {
    const Vec3d at = spread * random.in_box();
    const double size = random.magnitude(-1.5, 0.3);
    Shape<T> shape;
    bool moved = false;
    switch (random.whole(0, 6)) {
      case 0:
        shape = ShapeTraits<Sphere<T>>::make(random, size, at);
        break;
      case 1:
        shape = ShapeTraits<Box<T>>::make(random, size, at);
        break;
      case 2:
        shape = ShapeTraits<Disk<T>>::make(random, size, at);
        break;
      case 3:
        shape = ShapeTraits<Cone<T>>::make(random, size, at), moved = true;
        break;
      case 4:
        shape = ShapeTraits<Prism<T>>::make(random, size, at), moved = true;
        break;
      default:
        shape = ShapeTraits<Triangle<T>>::make(random, size, at);
        break;
    }
    std::optional<ObjectTransform<T>> place;
    if (moved) place = object_transform<T>(translation(at) * rotation(random.unit(), random.real(-180, 180)));
    for (int copies = random.whole(0, 19) == 0 ? 2 : 1; copies > 0; --copies) all.emplace_back(shape, place);
  }
  if (backwards) std::reverse(all.begin(), all.end());
  Primitives<T> primitives;
  for (const auto& [shape, place] : all) place ? primitives.add(shape, *place) : primitives.add(shape);
  if (meshes == Meshes::none) return primitives;
  Mesh triangles;
  for (int i = random.whole(70, 140); i > 0; --i) {
    const Triangle<T> one =
        ShapeTraits<Triangle<T>>::make(random, random.magnitude(-1.5, 0.3), spread * random.in_box());
    const auto corner = static_cast<std::int32_t>(triangles.positions.size());
    for (const Vec3<T>& at : {one.a, one.b, one.c}) triangles.positions.push_back(wide(at));
    for (int copies = random.whole(0, 19) == 0 ? 2 : 1; copies > 0; --copies)
      triangles.triangles.push_back({corner, corner + 1, corner + 2});
  }
  if (meshes == Meshes::one) {
    primitives.add(triangles, {}, false);
    return primitives;
  }
  const auto shared = std::make_shared<const Mesh>(std::move(triangles));
  Affine<double> place;
  for (int i = random.whole(2, 6); i > 0; --i) {
    // Some in one place; some shrunk along an axis until they are nearly flat there.
    const Vec3d size(random.magnitude(-2, 1), random.real(0.5, 1), random.coin() ? 1 : -random.magnitude(-8, 0));
    if (random.whole(0, 3) != 0)
      place = translation(spread * random.in_box()) * rotation(random.unit(), random.real(-180, 180)) * scaling(size);
    meshes == Meshes::copied ? primitives.add_copy(shared, place, false) : primitives.add(*shared, place, false);
  }
  return primitives;
}

/// Rays at corners of boxes, in the planes of faces, between primitives: `kind` against no accelerator. With `none`,
/// the same primitives in reverse order. With `copies`, meshes that share a tree against stored ones.
template <class T>
Tally compare(AcceleratorKind kind, bool copies, std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  Tally tally;
  constexpr std::uint64_t rays_a_heap = 1024;
  std::optional<Accelerator<T>> plain, structure;
  const bool permuted = kind == AcceleratorKind::none;
  for (std::uint64_t number = first; number < first + count; ++number) {
    if (!plain || number % rays_a_heap == 0) {
      // Triangles of a mesh always come last: they cannot be permuted.
      const bool mesh = !permuted && number / rays_a_heap % 2 == 1;
      const Meshes meshes = copies ? Meshes::stored : mesh ? Meshes::one : Meshes::none;
      Random again(seed, 50, number / rays_a_heap);
      plain.emplace(heap<T>(again, false, meshes), AcceleratorKind::none);
      again = Random(seed, 50, number / rays_a_heap);
      // Trees over meshes in every quality.
      constexpr std::array qualities{BuildQuality::good, BuildQuality::best, BuildQuality::fast};
      structure.emplace(heap<T>(again, permuted, copies ? Meshes::copied : meshes), kind,
                        BuildOptions{.quality = qualities[number / rays_a_heap / 2 % qualities.size()]});
    }
    Random random(seed, 51, number);
    const Primitives<T>& all = plain->primitives();
    const auto some_point = [&] {
      const Bounds<T> box = all.box(random.whole(0, all.size() - 1));
      Vec3d p;
      for (int axis = 0; axis < 3; ++axis) {
        const double low = static_cast<double>(box.min[axis]), high = static_cast<double>(box.max[axis]);
        const int where = random.whole(0, 3);
        p[axis] = where == 0 ? low : where == 1 ? high : low + random.real(0, 1) * (high - low);
      }
      return p;
    };
    const Vec3d target = some_point();
    Vec3d eye = random.coin() ? some_point() : target + random.magnitude(-1, 4) * random.unit();
    for (int axis = 0; axis < 3; ++axis)
      if (random.whole(0, 3) == 0) eye[axis] = target[axis];
    auto ray = ray_towards<T>(eye, target, random);
    if (!ray || !is_finite(ray->origin)) continue;
    for (int axis = 0; axis < 3; ++axis)
      if (ray->direction[axis] == 0 && random.coin()) ray->direction[axis] = -T(0);
    // Directions have any length, some beyond the range of a float.
    if (random.whole(0, 15) == 0) {
      const int most = sizeof(T) == sizeof(float) ? 30 : 140;
      ray->direction = std::ldexp(T(1), random.whole(-most, most)) * ray->direction;
    }
    // One from a corner of a triangle's box may leave that triangle.
    const int left = random.whole(all.shape_count(), std::max(all.size() - 1, all.shape_count()));
    if (copies && random.whole(0, 7) == 0) ray->departure = {left, 0};
    TestCounts counts;
    const auto expected = plain->closest(*ray, infinity<T>, counts),
               got = structure->closest(*ray, infinity<T>, counts);
    ++tally.rays;
    tally.hits += expected.has_value();
    const bool any = structure->occluded(*ray, infinity<T>, counts);
    bool same = expected.has_value() == got.has_value() && any == expected.has_value();
    // Of primitives at equal t the lowest index wins: in reverse order that is the other one.
    const int last = all.size() - 1;
    if (same && got)
      same = got->t == expected->t &&
             (permuted ? last - got->primitive >= expected->primitive : got->primitive == expected->primitive);
    if (same && got && !permuted) same = got->part == expected->part;
    tally.unequal += !same;
  }
  return tally;
}

/// Bundles of 32 rays that go nearly the same way, through corners and along edges of a mesh, searched together against
/// each by itself and no accelerator.
template <class T>
Tally compare_packets(std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  Tally tally;
  constexpr std::uint64_t bundle = 32, rays_a_heap = 1024;
  std::optional<Accelerator<T>> plain, structure;
  for (std::uint64_t begin = first / bundle * bundle; begin < first + count; begin += bundle) {
    if (!plain || begin % rays_a_heap == 0)
      for (auto* built : {&plain, &structure}) {
        Random again(seed, 52, begin / rays_a_heap);
        built->emplace(heap<T>(again, false, Meshes::one),
                       built == &plain ? AcceleratorKind::none : AcceleratorKind::bvh);
      }
    Random random(seed, 53, begin / bundle);
    const Triangles<T>& triangles = plain->primitives().triangles();
    const auto corner = [&] {
      const Triangle<T> triangle = triangles[random.whole(0, triangles.size() - 1)];
      const double along = random.coin() ? 0 : random.real(0, 1);
      return wide(triangle.a) + along * (wide(triangle.b) - wide(triangle.a));
    };
    const Vec3d middle = corner();
    Vec3d eye = middle + random.magnitude(-1, 3) * random.unit();
    if (random.whole(0, 3) == 0) eye[random.whole(0, 2)] = middle[random.whole(0, 2)];
    const double spread = random.magnitude(-6, 0);
    const bool parallel = random.whole(0, 3) == 0;
    std::vector<std::uint64_t> numbers;
    std::vector<Ray<T>> rays;
    std::vector<T> t_max;
    for (std::uint64_t number = begin; number < begin + bundle; ++number) {
      const Vec3d there = random.whole(0, 3) == 0 ? corner() : middle, off = spread * random.in_box();
      const Vec3d target = there != middle && length(there - middle) < spread ? there : middle + off;
      const auto ray = ray_towards<T>(parallel ? eye + off : eye, target, random);
      if (!ray || !is_finite(ray->origin)) continue;
      numbers.push_back(number);
      rays.push_back(*ray);
      t_max.push_back(random.whole(0, 3) == 0 ? static_cast<T>(random.real(0, 2)) : infinity<T>);
    }
    TestCounts counts;
    std::vector<std::optional<Hit<T>>> hits(rays.size());
    const auto blocked = std::make_unique<bool[]>(rays.size());
    structure->closest(rays, t_max, hits, counts);
    structure->occluded(rays, t_max, {blocked.get(), rays.size()}, counts);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (numbers[i] < first || numbers[i] >= first + count) continue;
      const auto expected = plain->closest(rays[i], t_max[i], counts);
      ++tally.rays;
      tally.hits += expected.has_value();
      const auto same = [&](const std::optional<Hit<T>>& got) {
        return expected && got
                   ? got->t == expected->t && got->primitive == expected->primitive && got->part == expected->part
                   : !expected && !got;
      };
      tally.unequal +=
          !same(hits[i]) || !same(structure->closest(rays[i], t_max[i], counts)) || blocked[i] != expected.has_value();
    }
  }
  return tally;
}

}  // namespace

Family accelerator_family() {
  Family family{"accelerators", "", {}};
  using Run = std::function<Tally(std::uint64_t seed, std::uint64_t first, std::uint64_t count)>;
  const auto both = [&](const std::string& name, const Run& in_float, const Run& in_double) {
    family.lines.push_back({name, "float", in_float, {}});
    family.lines.push_back({name, "double", in_double, {}});
  };
  const auto against_none = [](auto run, AcceleratorKind kind, bool copies) -> Run {
    return [=](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
      return run(kind, copies, seed, first, count);
    };
  };
  for (const AcceleratorKind kind : {AcceleratorKind::bvh, AcceleratorKind::grid, AcceleratorKind::octree,
                                     AcceleratorKind::kdtree, AcceleratorKind::none}) {
    const std::string name(kind == AcceleratorKind::none ? "permuted" : name_of(kind));
    both(name, against_none(compare<float>, kind, false), against_none(compare<double>, kind, false));
  }
  for (const LaneWidth width : lane_widths()) {
    const auto by_width = [width](const Run& run) -> Run {
      return [=](std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
        const ForcedWidth forced(width);
        return run(seed, first, count);
      };
    };
    const std::string lanes = ", by " + std::string(name_of(width));
    both("copies" + lanes, by_width(against_none(compare<float>, AcceleratorKind::bvh, true)),
         by_width(against_none(compare<double>, AcceleratorKind::bvh, true)));
    both("packets" + lanes, by_width(compare_packets<float>), by_width(compare_packets<double>));
  }
  return family;
}

}  // namespace raywalk::check
