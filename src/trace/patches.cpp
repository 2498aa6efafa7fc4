#include "trace/patches.h"

#include "trace/patch_cutter.h"
#include "trace/surface_vertex.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raywalk {

namespace {

/// Rounding does not lift out of a plane what lies in it.
constexpr double nothing = 1e-9;

/// Calls use(object, shape) with each shape of an object, those of a group too.
template <class Use>
void for_each_shape(const Object& object, const Use& use) {
  if (const auto* instance = std::get_if<Instance>(&object.shape)) {
    if (instance->content)
      for (const Object& inner : instance->content->group.objects) for_each_shape(inner, use);
    return;
  }
  use(object);
}

bool is_endless(const Object& object) {
  const Bounds<double> box = bounds(object.shape);
  const auto finite = [](const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  return !box.empty() && !(finite(box.min) && finite(box.max));
}

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

Patch other_side(const Patch& front) {
  Patch back = front;
  std::reverse(back.corner.begin(), back.corner.begin() + back.corners);
  back.normal = -front.normal;
  back.inner = true;
  return back;
}

bool is_round(const Shape<double>& shape) {
  return std::visit([](const auto& its) { return requires { its.radius; } || requires { its.radii; }; }, shape);
}

/// How much larger each primitive is than its patches together, by cutting it more finely: those of round ones are
/// inscribed.
std::vector<double> bulges_of(const World<double>& world, const CutScene& cut, CutSettings settings, const Stop& stop) {
  const auto areas_of = [&](const CutScene& each) {
    std::vector<double> areas(each.closed.size(), 0);
    for (const Patch& patch : each.patches) areas[static_cast<std::size_t>(patch.primitive)] += patch.area;
    return areas;
  };
  settings.size /= 4, settings.least_sides *= 8, settings.most *= 64;
  const std::vector<double> own = areas_of(cut);
  std::vector<double> bulges = areas_of(cut_into_patches(world, settings, stop));
  for (std::size_t id = 0; id < bulges.size(); ++id) {
    bulges[id] /= own[id];
    if (!(bulges[id] > 1 + nothing)) bulges[id] = 1;
  }
  return bulges;
}

}  // namespace

bool in_front(const Patch& of, const Vec3d& point) {
  const Vec3d offset = point - of.centre;
  return dot(offset, of.normal) > nothing * length(offset);
}

std::array<double, 4> mean_value_weights(const Patch& patch, const Vec3d& point) {
  std::array<double, 4> weights{};
  const auto count = static_cast<std::size_t>(patch.corners);
  std::array<Vec3d, 4> to;
  std::array<double, 4> reach{};
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d offset = patch.corner[i] - point;
    to[i] = offset - dot(offset, patch.normal) * patch.normal;
    reach[i] = length(to[i]);
  }
  const double size = std::sqrt(patch.area);
  for (std::size_t i = 0; i < count; ++i)
    if (reach[i] <= nothing * size) {
      weights[i] = 1;
      return weights;
    }
  std::array<double, 4> half{};  // tan of half the angle to the next corner
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const double sine = dot(cross(to[i], to[next]), patch.normal), cosine = dot(to[i], to[next]);
    const double both = reach[i] * reach[next];
    if (sine <= nothing * both) {
      if (cosine < 0) {  // on this edge
        weights = {};
        weights[i] = reach[next] / (reach[i] + reach[next]);
        weights[next] = 1 - weights[i];
        return weights;
      }
      half[i] = 0;
      continue;
    }
    half[i] = (both - cosine) / sine;
  }
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += weights[i] = (half[(i + count - 1) % count] + half[i]) / reach[i];
  for (double& weight : weights) weight /= sum;
  return weights;
}

double inside_by(const Patch& patch, const Vec3d& point) {
  double least = infinity<double>;
  for (int i = 0; i < patch.corners; ++i) {
    const Vec3d &a = patch.corner[static_cast<std::size_t>(i)],
                &b = patch.corner[static_cast<std::size_t>((i + 1) % patch.corners)];
    const Vec3d inward = normalize(cross(patch.normal, b - a));
    least = std::min(least, dot(point - a, inward));
  }
  return least;
}

std::optional<Error> why_no_patches(const Scene& scene, const Stop& stop) {
  std::optional<Error> error;
  for (const Object& top : scene.objects)
    for_each_shape(top, [&](const Object& object) {
      if (error) return;
      const std::string of = object.name == top.name ? "" : ", in " + quoted(top.name);
      if (is_endless(object))
        error = Error{"", 0, 0,
                      "radiosity cannot cut " + quoted(object.name) + of + (of.empty() ? "" : ",") +
                          " into patches: it is endless",
                      "a flat_polygon or a box as large as what is seen of it has an end"};
      else if (!object.motion.empty() || !top.motion.empty())
        error = Error{"", 0, 0, "radiosity cannot light " + quoted(object.name) + of + ": it moves",
                      "leave out its motion, or use --integrator path"};
    });
  if (error) return error;
  const World<double> world(scene, AcceleratorKind::none, std::nullopt, BuildOptions{stop});
  const double size = scene.render.radiosity.patch.value_or(Patches::share_of_extent * extent_of(world));
  if (static_cast<int>(cut_into_patches(world, {.size = size}, stop).patches.size()) > Patches::most)
    error = Error{
        "", 0, 0,
        "radiosity would cut this scene into more than " + std::to_string(Patches::most) +
            " patches, whose form factors take too much memory",
        "choose larger ones, such as radiosity = { patch = " + fmt::format("{:.3g}", 2 * size) + " } in [render]"};
  return error;
}

std::vector<std::string> patch_losses(const Scene& scene) {
  std::vector<std::string> losses;
  for (const Object& top : scene.objects)
    for_each_shape(top, [&](const Object& object) {
      const Material& material = object.material;
      const bool mirrors = !is_black(material.reflection), passes = material.transmits();
      if (mirrors || passes)
        losses.push_back(quoted(object.name) + " absorbs the light that it would " +
                         (passes ? mirrors ? "reflect and let through" : "let through" : "reflect") +
                         ": radiosity knows matt surfaces only");
      else if (!is_black(material.specular))
        losses.push_back(quoted(object.name) + " shows no highlights: radiosity knows matt surfaces only");
      if (material.is_rough_diffuse())
        losses.push_back(quoted(object.name) + " is lit as if it were smooth: radiosity knows Lambert's surfaces only");
      if (material.has_bent_normals())
        losses.push_back(quoted(object.name) +
                         " is lit as if it had no relief: the light of a patch is that of its plane");
    });
  if (scene.sky || !is_black(scene.background))
    losses.emplace_back(
        "what lies around the scene is seen, but lights nothing: radiosity has patches on surfaces only");
  return losses;
}

Patches::Patches(const Scene& scene, const PatchSettings& settings, const Stop& stop) : flat_(settings.flat) {
  world_.emplace(scene, AcceleratorKind::none, std::nullopt, BuildOptions{stop});
  const World<double>& world = *world_;
  const double size = std::isinf(settings.size) ? share_of_extent * extent_of(world) : settings.size;
  const CutSettings how{.size = size, .most = most, .flat = flat_};
  CutScene cut = cut_into_patches(world, how, stop);
  if (static_cast<int>(cut.patches.size()) > most) {
    too_many_ = true;
    return;
  }
  const Primitives<double>& primitives = world.accelerator.primitives();
  Primitives<double> pieces;
  for (std::size_t i = 0; i < cut.patches.size(); ++i) {
    Patch& patch = cut.patches[i];
    const World<double>::Surface& surface = world.surface(patch.primitive);
    patch.face = static_cast<int>(i);
    const auto [emission, reflectance] = mean_colours(patch, surface);
    patch.emission = cosines() * emission;
    patch.reflectance = reflectance;
    Polygon<double> polygon;
    polygon.outline.assign(patch.corner.begin(), patch.corner.begin() + patch.corners);
    pieces.add(Shape<double>(std::move(polygon)));
  }
  occluders_.emplace(std::move(pieces), AcceleratorKind::automatic, BuildOptions{stop});

  // What shines, for the insides of closed bodies.
  struct Source {
    Vec3d place;
    int primitive;
  };
  std::vector<Source> sources{{scene.camera.eye, -1}};
  bool from_afar = false;
  for (const World<double>::Light& light : world.lights) {
    if (light.is_distant) from_afar = true;
    if (!light.is_distant) sources.push_back({light.place, -1});
  }
  for (const Patch& patch : cut.patches)
    if (!is_black(patch.emission)) sources.push_back({patch.centre, patch.primitive});
  std::vector<bool> lit_inside(cut.closed.size(), true);
  for (std::size_t id = 0; id < cut.closed.size(); ++id) {
    if (!cut.closed[id]) continue;
    const Bounds<double> box = primitives.box(static_cast<int>(id));
    lit_inside[id] = std::any_of(sources.begin(), sources.end(), [&](const Source& source) {
      if (source.primitive == static_cast<int>(id)) return false;
      for (int axis = 0; axis < (flat_ ? 2 : 3); ++axis)
        if (!(box.min[axis] < source.place[axis] && source.place[axis] < box.max[axis])) return false;
      return true;
    });
  }
  const auto faces_something = [&](const Patch& side) {
    if (from_afar) return true;
    for (const World<double>::Light& light : world.lights)
      if (in_front(side, light.place + light.reach * side.normal)) return true;  // the farthest part of its extent
    for (const Patch& other : cut.patches)
      for (const Vec3d& corner : other.outline())
        if (in_front(side, corner)) return true;
    return false;
  };
  const bool any_round = std::any_of(cut.patches.begin(), cut.patches.end(), [&](const Patch& patch) {
    return !is_black(patch.emission) && is_round(primitives.shape(patch.primitive));
  });
  const std::vector<double> bulges =
      any_round ? bulges_of(world, cut, how, stop) : std::vector<double>(cut.closed.size(), 1);
  for (Patch& front : cut.patches) {
    stop.check();
    const auto id = static_cast<std::size_t>(front.primitive);
    Patch back = other_side(front);
    // What glows sends as much as if its patches did not lie within it; but into its inside, which they close as it
    // does.
    front.emission *= bulges[id];
    if (!cut.closed[id]) back.emission *= bulges[id];
    if (faces_something(front)) patches_.push_back(front);
    if (lit_inside[id] && faces_something(back)) patches_.push_back(back);
  }
  find_neighbours();
}

/// What a patch emits and reflects, averaged over it: with its light is sent what its pattern has on average.
Patches::Colours Patches::mean_colours(const Patch& patch, const World<double>::Surface& surface) const {
  const SurfaceMaps<double>* maps = world_->maps(surface);
  if (maps == nullptr && !surface.checker && !surface.texture) return {surface.emission, surface.diffuse};
  const Primitives<double>& primitives = world_->accelerator.primitives();
  // Spread evenly, but not in rows, which a pattern may be in step with: M. Roberts' sequence for two dimensions.
  constexpr int points = 1024;
  constexpr double right = 0.7548776662466927, up = 0.5698402909980532;
  Colours sum{Rgbd(0.0), Rgbd(0.0)};
  for (int k = 0; k < points; ++k) {
    const double u = 0.5 + k * right, v = 0.5 + k * up;
    const SurfacePoint<double> at{point_on(patch, u - std::floor(u), v - std::floor(v)), patch.normal};
    SurfaceValues<double> its = surface;
    if (maps != nullptr) {
      auto mixture = maps->at(primitives.uv_at(patch.primitive, at, patch.part));
      apply_pattern(mixture.first.diffuse, surface, primitives, patch.primitive, at, patch.part);
      its = maps->mixed(mixture);
    } else {
      apply_pattern(its.diffuse, surface, primitives, patch.primitive, at, patch.part);
    }
    sum.emission += its.emission, sum.reflectance += its.diffuse;
  }
  return {sum.emission / static_cast<double>(points), sum.reflectance / static_cast<double>(points)};
}

PatchGrid::PatchGrid(const std::vector<Patch>& patches, const std::vector<int>& of) {
  const auto box_of = [&](int i) {
    Bounds<double> box;
    for (const Vec3d& corner : patches[static_cast<std::size_t>(i)].outline()) box.include(corner);
    return box;
  };
  for (const int i : of) {
    const Bounds<double> box = box_of(i);
    const Vec3d sides = box.max - box.min;
    cell_ = std::max({cell_, sides.x, sides.y, sides.z});
  }
  const Vec3d around(1e-3 * cell_);
  for (const int i : of) {
    const Bounds<double> box = box_of(i);
    const Cell low = cell_of(box.min - around), high = cell_of(box.max + around);
    for (auto x = low[0]; x <= high[0]; ++x)
      for (auto y = low[1]; y <= high[1]; ++y)
        for (auto z = low[2]; z <= high[2]; ++z) cells_[{x, y, z}].push_back(i);
  }
}

PatchGrid::Cell PatchGrid::cell_of(const Vec3d& point) const {
  const auto along = [&](double at) { return static_cast<std::int64_t>(std::floor(at / cell_)); };
  return {along(point.x), along(point.y), along(point.z)};
}

const std::vector<int>& PatchGrid::near(const Vec3d& point) const {
  static const std::vector<int> none;
  if (cells_.empty()) return none;
  const auto found = cells_.find(cell_of(point));
  return found == cells_.end() ? none : found->second;
}

/// Which patches meet at each corner: of the same primitive, on the same side, and turned by less than about a right
/// angle's half.
void Patches::find_neighbours() {
  constexpr double smooth = 0.8;  // cosine
  int primitives = 0;
  for (const Patch& patch : patches_) primitives = std::max(primitives, patch.primitive + 1);
  by_primitive_.resize(static_cast<std::size_t>(primitives));
  for (int i = 0; i < size(); ++i) by_primitive_[static_cast<std::size_t>((*this)[i].primitive)].push_back(i);
  grids_.reserve(by_primitive_.size());
  for (const std::vector<int>& same : by_primitive_) grids_.emplace_back(patches_, same);
  about_.resize(patches_.size());
  for (const std::vector<int>& same : by_primitive_)
    for (const int i : same) {
      const Patch& patch = (*this)[i];
      const double near = 1e-6 * std::sqrt(patch.area);
      for (int c = 0; c < patch.corners; ++c) {
        const Vec3d& corner = patch.corner[static_cast<std::size_t>(c)];
        for (const int j : grids_[static_cast<std::size_t>(patch.primitive)].near(corner)) {
          const Patch& other = (*this)[j];
          if (!(dot(patch.normal, other.normal) > smooth)) continue;
          if (std::abs(dot(corner - other.centre, other.normal)) > near || inside_by(other, corner) < -near) continue;
          about_[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)].push_back(j);
        }
      }
    }
}

double Patches::cosines() const { return flat_ ? 2 : std::numbers::pi; }

bool Patches::face_each_other(int a, int b) const {
  const auto some_in_front = [](const Patch& of, const Patch& other) {
    const auto outline = other.outline();
    return std::any_of(outline.begin(), outline.end(), [&](const Vec3d& corner) { return in_front(of, corner); });
  };
  const Patch &one = (*this)[a], &other = (*this)[b];
  return one.face != other.face && some_in_front(one, other) && some_in_front(other, one);
}

bool Patches::is_in_flat_surface(int patch) const {
  for (const std::vector<int>& corner : about_[static_cast<std::size_t>(patch)])
    for (const int each : corner)
      if (!(dot((*this)[each].normal, (*this)[patch].normal) > 1 - nothing)) return false;
  return true;
}

Patches::Place Patches::place_of(int primitive, const Vec3d& position, const Vec3d& normal) const {
  Place place;
  if (primitive >= static_cast<int>(by_primitive_.size())) return place;
  double best = -infinity<double>;
  const auto take_best_of = [&](const std::vector<int>& some) {
    best = -infinity<double>;
    for (const int i : some) {
      const Patch& patch = (*this)[i];
      const double turned = dot(patch.normal, normal);
      if (!(turned > 0.3)) continue;
      // On the other faces of the body it would lie far off.
      const double off = std::abs(dot(position - patch.centre, patch.normal));
      const double inside = std::min(inside_by(patch, position), 0.0) - off - (1 - turned) * std::sqrt(patch.area);
      if (inside > best) best = inside, place.patch = i;
    }
  };
  const PatchGrid& grid = grids_[static_cast<std::size_t>(primitive)];
  take_best_of(grid.near(position));
  // Of a flat surface it lies in one of these. A curved one bulges out of its patches, and all of them are asked.
  if (!(best > -nothing * grid.cell())) take_best_of(by_primitive_[static_cast<std::size_t>(primitive)]);
  if (place.patch < 0) return place;
  const Patch& patch = (*this)[place.patch];
  if (flat_) {
    const Vec2d a(patch.corner[0]), along = Vec2d(patch.corner[1]) - a;
    const double t = std::clamp(dot(Vec2d(position) - a, along) / dot(along, along), 0.0, 1.0);
    place.weights = {1 - t, t, 0, 0};
    return place;
  }
  // A curved surface bulges out of its patches: the nearest point of the patch counts.
  Vec3d on = position;
  const double depth = inside_by(patch, on);
  if (depth < 0)
    on = patch.centre +
         (on - patch.centre) * (inside_by(patch, patch.centre) / (inside_by(patch, patch.centre) - depth));
  place.weights = mean_value_weights(patch, on);
  place.point = on;
  return place;
}

}  // namespace raywalk
