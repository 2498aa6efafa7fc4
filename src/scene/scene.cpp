#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace raywalk {

ObjectShape::ObjectShape(const Shape<double>& shape)
    : Kinds(std::visit([](const auto& s) { return Kinds(s); }, shape)) {}

std::string_view shape_name(const ObjectShape& shape) {
  return std::visit([](const auto& s) { return shape_name(s); }, shape);
}

Bounds<double> bounds(const MeshShape& shape) { return shape.mesh ? bounds(*shape.mesh) : Bounds<double>{}; }

Bounds<double> bounds(const Instance& shape) { return shape.content ? shape.content->box : Bounds<double>{}; }

Bounds<double> bounds(const ObjectShape& shape) {
  return std::visit([](const auto& s) { return bounds(s); }, shape);
}

double entries_of(const std::vector<Object>& objects) {
  double entries = 0;
  for (const Object& object : objects) {
    entries += 1;
    if (const auto* mesh = std::get_if<MeshShape>(&object.shape); mesh && mesh->mesh)
      entries += static_cast<double>(mesh->mesh->triangles.size());
    if (const auto* instance = std::get_if<Instance>(&object.shape); instance && instance->content)
      entries += instance->content->entries;
  }
  return entries;
}

namespace {

/// Whether each edge belongs to two triangles, in the two directions. Vertices in one place count as one.
bool is_closed(const Mesh& mesh) {
  std::map<std::tuple<double, double, double>, std::size_t> places;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;  ///< how often one way more than the other
  const auto place = [&](std::int32_t vertex) {
    const auto& at = mesh.positions[static_cast<std::size_t>(vertex)];
    return places.try_emplace({at.x, at.y, at.z}, places.size()).first->second;
  };
  for (const auto& corners : mesh.triangles) {
    const std::size_t at[] = {place(corners[0]), place(corners[1]), place(corners[2])};
    for (int i = 0; i < 3; ++i) {
      const std::size_t from = at[i], to = at[(i + 1) % 3];
      if (from != to) edges[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

struct Encloses {
  template <class Other>
  bool operator()(const Other& /*shape*/) const {
    return true;
  }
  bool operator()(const Disk<double>& /*flat*/) const { return false; }
  bool operator()(const Polygon<double>& /*flat*/) const { return false; }
  bool operator()(const Triangle<double>& /*flat*/) const { return false; }
  bool operator()(const MeshShape& shape) const { return !shape.mesh || is_closed(*shape.mesh); }
  template <QuadricKind Kind>
  bool operator()(const Quadric<double, Kind>& quadric) const {
    Quadric<double, Kind> whole = quadric;
    whole.z_min = -std::numeric_limits<double>::infinity(), whole.z_max = -whole.z_min;
    const Bounds<double> cut = bounds(quadric), all = bounds(whole);
    return quadric.capped || (cut.min.z == all.min.z && cut.max.z == all.max.z);
  }
};

/// About how far light goes through a body on a straight line: the mean chord of its box, 4 V / S (Cauchy). It is also
/// the mean length of the crooked paths of scattered light from surface to surface, however much it scatters (S. Blanco
/// and R. Fournier, "An invariance property of diffusive random walks", Europhysics Letters 61, 2003).
double mean_chord(const Object& object) {
  const Bounds<double> box = image_of(affine_of(object.transform), bounds(object.shape));
  if (box.empty()) return 0;
  if (!box.bounded()) return infinity<double>;
  const Vec3d size = box.max - box.min;
  return 2 / (1 / size.x + 1 / size.y + 1 / size.z);
}

}  // namespace

std::string why_no_walk_inside(const Object& object) {
  const Material& material = object.material;
  if (!material.scatters_inside() || std::holds_alternative<Instance>(object.shape)) return {};
  const std::string shape(shape_name(object.shape));
  if (!std::visit(Encloses{}, object.shape))
    return "light is scattered inside, but this " + shape + " encloses nothing (expected a closed shape)";
  const double chord = mean_chord(object);
  double most = 0;  // how often a path scatters until it is out or absorbed, on average
  for (int c = 0; c < 3; ++c)
    if (material.scattering[c] > 0)
      most = std::max(most, material.scattering[c] * std::min(chord, 1 / material.absorption[c]));
  if (most == infinity<double>)
    return "light is scattered inside without loss, but this " + shape +
           " has no end: paths might never leave it (expected an absorption above 0, or a bounded shape)";
  constexpr double patience = 1e5;
  if (most > patience)
    return fmt::format(
        "light is scattered inside so often that a path would turn about {:.0e} times before it leaves this {} or is "
        "absorbed (expected at most {:.0e} times: less scattering, more absorption, or a smaller body)",
        most, shape, patience);
  return {};
}

Scene::Scene() = default;
Scene::Scene(const Scene&) = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(const Scene&) = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;
bool operator==(const Scene&, const Scene&) = default;

GroupContent::GroupContent(Group from) : group(std::move(from)), entries(entries_of(group.objects)), nesting(1) {
  for (const Object& object : group.objects) {
    box.include(image_of(affine_of(object.transform), bounds(object.shape)));
    if (const auto* instance = std::get_if<Instance>(&object.shape); instance && instance->content)
      nesting = std::max(nesting, instance->content->nesting + 1);
  }
}

namespace {

void collect(const std::vector<Object>& objects, std::set<const GroupContent*>& groups,
             std::vector<MaterialUse>& uses) {
  for (const Object& object : objects) {
    if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      if (instance->content && groups.insert(instance->content.get()).second)
        collect(instance->content->group.objects, groups, uses);
      continue;
    }
    uses.push_back({&object, &object.material});
    const auto* mesh = std::get_if<MeshShape>(&object.shape);
    if (mesh != nullptr && mesh->file_materials && mesh->materials)
      for (const Material& material : *mesh->materials) uses.push_back({&object, &material});
  }
}

const Object* first_moving_object(const std::vector<Object>& objects, double open, double close,
                                  std::set<const GroupContent*>& groups) {
  for (const Object& object : objects) {
    if (moves_between(object.motion, open, close)) return &object;
    const auto* instance = std::get_if<Instance>(&object.shape);
    if (!instance || !instance->content || !groups.insert(instance->content.get()).second) continue;
    if (const Object* inner = first_moving_object(instance->content->group.objects, open, close, groups)) return inner;
  }
  return nullptr;
}

}  // namespace

const Object* first_moving_object(const Scene& scene) {
  std::set<const GroupContent*> groups;
  return first_moving_object(scene.objects, scene.camera.shutter_open, scene.camera.shutter_close, groups);
}

std::vector<MaterialUse> material_uses(const Scene& scene) {
  std::vector<MaterialUse> uses;
  std::set<const GroupContent*> groups;
  collect(scene.objects, groups, uses);
  return uses;
}

}  // namespace raywalk
