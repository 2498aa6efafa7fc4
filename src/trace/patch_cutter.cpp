#include "trace/patch_cutter.h"

#include "math/elementary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raywalk {

namespace {

/// What the `cut` of each shape, beside its `intersect`, is handed to cut it with.
class Cutter {
 public:
  Cutter(const World<double>& world, const CutSettings& settings)
      : world_(world), size_(settings.size), least_sides_(settings.least_sides), most_(settings.most) {}

  void begin(int primitive) {
    primitive_ = primitive;
    const ObjectTransform<double>* transform = world_.accelerator.primitives().transform_of(primitive);
    map_ = transform ? transform->to_world : Affine<double>{};
    mirrored_ = map_.determinant() < 0;
  }
  [[nodiscard]] bool too_many() const { return static_cast<int>(patches_.size()) > most_; }
  [[nodiscard]] std::vector<Patch> take() { return std::move(patches_); }

  /// A flat piece with these corners in object space, counter-clockwise from outside; twice the same one makes a
  /// triangle of it.
  void cell(int part, const std::array<Vec3d, 4>& corners) {
    Patch patch;
    patch.part = part, patch.primitive = primitive_;
    patch.corners = 0;
    for (const Vec3d& each : corners) {
      const Vec3d corner = map_.point(each);
      if (patch.corners > 0 && corner == patch.corner[static_cast<std::size_t>(patch.corners - 1)]) continue;
      if (patch.corners > 0 && corner == patch.corner[0]) continue;
      patch.corner[static_cast<std::size_t>(patch.corners++)] = corner;
    }
    if (patch.corners < 3 || too_many()) return;
    if (mirrored_) std::reverse(patch.corner.begin(), patch.corner.begin() + patch.corners);
    const Vec3d area = area_vector_of(patch.outline());
    patch.area = length(area);
    if (!(patch.area > 0)) return;
    patch.normal = area / patch.area;
    for (const Vec3d& corner : patch.outline()) patch.centre += corner / static_cast<double>(patch.corners);
    patches_.push_back(patch);
  }

  /// Four corners, cut into rows and columns.
  void quad(int part, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    const int columns = pieces(std::max(world_length(b - a), world_length(c - d)));
    const int rows = pieces(std::max(world_length(d - a), world_length(c - b)));
    const auto at = [&](int i, int j) {
      const double u = i / static_cast<double>(columns), v = j / static_cast<double>(rows);
      const Vec3d low = i == columns ? b : a + u * (b - a), high = i == columns ? c : d + u * (c - d);
      return j == rows ? high : low + v * (high - low);
    };
    for (int j = 0; j < rows && !too_many(); ++j)
      for (int i = 0; i < columns; ++i) cell(part, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }

  void triangle(int part, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const int n = pieces(std::max({world_length(b - a), world_length(c - b), world_length(a - c)}));
    const auto at = [&](int i, int j) {
      if (i == n) return b;
      if (j == n) return c;
      return a + i / static_cast<double>(n) * (b - a) + j / static_cast<double>(n) * (c - a);
    };
    for (int j = 0; j < n && !too_many(); ++j)
      for (int i = 0; i + j < n; ++i) {
        cell(part, {at(i, j), at(i + 1, j), at(i, j + 1), at(i, j)});
        if (i + j + 1 < n) cell(part, {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)});
      }
  }

  /// Any polygon, with holes (the even-odd rule): first into trapezoids between the heights of its corners.
  /// `right`, `up`: two perpendicular unit vectors in its plane, from which it is seen counter-clockwise.
  void polygon(int part, const std::vector<std::vector<Vec3d>>& loops, const Vec3d& right, const Vec3d& up) {
    struct Line {
      Vec2d a, b;  ///< a lower than b
      [[nodiscard]] double x_at(double y) const {
        return y == a.y ? a.x : y == b.y ? b.x : a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      }
    };
    const Vec3d origin = loops[0][0];
    const auto flat = [&](const Vec3d& p) { return Vec2d(dot(p - origin, right), dot(p - origin, up)); };
    std::vector<Line> lines;
    std::vector<double> heights;
    for (const auto& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d a = flat(loop[i]), b = flat(loop[(i + 1) % loop.size()]);
        heights.push_back(a.y);
        if (a.y != b.y) lines.push_back(a.y < b.y ? Line{a, b} : Line{b, a});
      }
    std::sort(heights.begin(), heights.end());
    const double whole = heights.back() - heights.front();
    for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
      const double low = heights[k], high = heights[k + 1], middle = 0.5 * (low + high);
      if (!(high - low > 1e-12 * whole)) continue;
      std::vector<Line> across;
      for (const Line& line : lines)
        if (line.a.y <= middle && middle < line.b.y) across.push_back(line);
      std::sort(across.begin(), across.end(),
                [&](const Line& l, const Line& r) { return l.x_at(middle) < r.x_at(middle); });
      const auto place = [&](double x, double y) { return origin + x * right + y * up; };
      for (std::size_t i = 0; i + 1 < across.size(); i += 2)
        quad(part, place(across[i].x_at(low), low), place(across[i + 1].x_at(low), low),
             place(across[i + 1].x_at(high), high), place(across[i].x_at(high), high));
    }
  }

  /// What a profile sweeps about the vertical through `middle`: circles of these radii at these heights, from below
  /// up, scaled by rx and ry.
  void swept(int part, const std::vector<Vec2d>& profile, double rx, double ry, const Vec3d& middle = Vec3d(0.0)) {
    double widest = 0;
    for (const Vec2d& at : profile) widest = std::max(widest, at.x);
    const int around = sides(widest * std::max(rx, ry));
    const auto at = [&](std::size_t k, int i) { return middle + round(profile[k], i, around, rx, ry); };
    for (std::size_t k = 0; k + 1 < profile.size() && !too_many(); ++k)
      for (int i = 0; i < around; ++i) cell(part, {at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i)});
  }
  /// A level disk, seen from above, or from below.
  void lid(int part, double z, double radius, double rx, double ry, bool above) {
    const int rings = pieces(radius * world_length({std::max(rx, ry), 0, 0}));
    std::vector<Vec2d> profile;
    for (int i = 0; i <= rings; ++i) profile.push_back({radius * (above ? rings - i : i) / rings, z});
    swept(part, profile, rx, ry);
  }

  /// A ball's profile from one angle above the equator to another, pole to pole at most.
  [[nodiscard]] static std::vector<Vec2d> round_profile(int steps, double from, double to, double height) {
    std::vector<Vec2d> profile;
    for (int i = 0; i <= steps; ++i) {
      const double angle = from + (to - from) * i / steps;
      auto [sine, cosine] = portable::sin_cos(angle);
      const double pole = std::numbers::pi / 2;
      if (std::abs(angle) >= pole * (1 - 1e-12)) cosine = 0;
      profile.push_back({cosine, sine * height});
    }
    return profile;
  }

  [[nodiscard]] int pieces(double length) const {
    const double count = std::ceil(length / size_ * (1 - 1e-12));
    return static_cast<int>(std::clamp(count, 1.0, static_cast<double>(most_)));
  }
  [[nodiscard]] int sides(double radius) const {
    const int count = pieces(2 * std::numbers::pi * world_length({radius, 0, 0}));
    return std::max(least_sides_, (count + 3) / 4 * 4);
  }
  [[nodiscard]] int least_sides() const { return least_sides_; }
  [[nodiscard]] double world_length(const Vec3d& v) const { return length(map_.direction(v)); }

 private:
  [[nodiscard]] static Vec3d round(const Vec2d& at, int i, int around, double rx, double ry) {
    if (at.x == 0) return {0, 0, at.y};
    const auto [sine, cosine] = portable::sin_cos(2 * std::numbers::pi * (i % around) / around);
    return {at.x * rx * cosine, at.x * ry * sine, at.y};
  }

  const World<double>& world_;
  double size_;
  int least_sides_, most_, primitive_ = 0;
  Affine<double> map_;
  bool mirrored_ = false;
  std::vector<Patch> patches_;
};

// --- The cut by z = 0

using Loop = std::vector<Vec2d>;

Loop ellipse(Cutter& to, const Vec2d& centre, double rx, double ry) {
  const int around = to.sides(std::max(rx, ry));
  Loop loop;
  for (int i = 0; i < around; ++i) {
    const auto [sine, cosine] = portable::sin_cos(2 * std::numbers::pi * i / around);
    loop.push_back(centre + Vec2d(rx * cosine, ry * sine));
  }
  return loop;
}

Loop cut_by_plane(Cutter& /*to*/, const Box<double>& box) {
  if (box.min.z > 0 || box.max.z < 0) return {};
  return {{box.min.x, box.min.y}, {box.max.x, box.min.y}, {box.max.x, box.max.y}, {box.min.x, box.max.y}};
}
Loop cut_by_plane(Cutter& /*to*/, const Prism<double>& prism) {
  Loop loop = prism.corners;
  if (prism.is_clockwise()) std::reverse(loop.begin(), loop.end());
  return loop;
}
Loop cut_by_plane(Cutter& to, const Sphere<double>& sphere) {
  return sphere.centre.z == 0 ? ellipse(to, Vec2d(sphere.centre), sphere.radius, sphere.radius) : Loop{};
}
template <QuadricKind Kind>
Loop cut_by_plane(Cutter& to, const Quadric<double, Kind>& quadric) {
  constexpr bool round =
      Kind == QuadricKind::ellipsoid || Kind == QuadricKind::cylinder || Kind == QuadricKind::hyperboloid_one_sheet;
  if (!round || quadric.z_min > 0 || quadric.z_max < 0) return {};
  return ellipse(to, {0, 0}, quadric.radii.x, quadric.radii.y);
}
template <class S>
Loop cut_by_plane(Cutter& /*to*/, const S& /*clear of the plan*/) {
  return {};
}

}  // namespace

double extent_of(const World<double>& world) {
  const Primitives<double>& primitives = world.accelerator.primitives();
  Bounds<double> all;
  for (int id = 0; id < primitives.size(); ++id) {
    const Bounds<double> box = primitives.box(id);
    const auto finite = [](const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    if (finite(box.min) && finite(box.max)) all.include(box);
  }
  if (all.empty()) return 1;
  const Vec3d sides = all.max - all.min;
  const double largest = std::max({sides.x, sides.y, sides.z});
  return largest > 0 ? largest : 1;
}

CutScene cut_into_patches(const World<double>& world, const CutSettings& settings, const Stop& stop) {
  const Primitives<double>& primitives = world.accelerator.primitives();
  const bool flat = settings.flat;
  Cutter cutter(world, settings);
  CutScene result;
  for (int id = 0; id < primitives.size() && !cutter.too_many(); ++id) {
    if (id % 1024 == 0) stop.check();
    cutter.begin(id);
    const Shape<double> shape = primitives.shape(id);
    result.closed.push_back(has_inside(shape));
    if (!flat) {
      cut(cutter, shape);
      continue;
    }
    const Loop loop = std::visit([&](const auto& s) { return cut_by_plane(cutter, s); }, shape);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2d a = loop[i], b = loop[(i + 1) % loop.size()];
      const int count = cutter.pieces(cutter.world_length({b - a, 0}));
      const auto at = [&](int k, double z) {
        const Vec2d p = k == count ? b : a + k / static_cast<double>(count) * (b - a);
        return Vec3d(p, z);
      };
      for (int k = 0; k < count; ++k)
        cutter.cell(static_cast<int>(i), {at(k, -1), at(k + 1, -1), at(k + 1, 1), at(k, 1)});
    }
  }
  result.closed.resize(static_cast<std::size_t>(primitives.size()), false);
  result.patches = cutter.take();
  for (Patch& patch : result.patches) {
    patch.object = world.object(patch.primitive);
    if (!flat) continue;
    // Whatever the map makes of z: in a flat world all is as high.
    for (Vec3d& corner : patch.corner) corner.z = corner.z < 0 ? -1 : 1;
    patch.area = length(Vec2d(patch.corner[1] - patch.corner[0]));
    patch.centre.z = 0;
  }
  return result;
}

}  // namespace raywalk
