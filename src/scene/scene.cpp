#include "scene/scene.h"

#include <algorithm>
#include <set>

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
