#include "scene/copied_meshes.h"

#include <algorithm>

namespace raywalk {

namespace {

bool may_be_shared(const Object& object) {
  const auto* shape = std::get_if<MeshShape>(&object.shape);
  constexpr std::size_t few = 32;  // take no more than a copy does
  if (shape == nullptr || !shape->mesh || shape->mesh->triangles.size() < few) return false;
  const auto opaque = [](const Material& material) { return !material.transmits() && !material.emits(); };
  const bool own_too = !shape->file_materials || !shape->materials || shape->mesh->materials.empty();
  return opaque(object.material) &&
         (own_too || std::all_of(shape->materials->begin(), shape->materials->end(), opaque));
}

}  // namespace

CopiedMeshes::CopiedMeshes(const Scene& scene) {
  for (const auto& [mesh, times] : uses_in(scene.objects)) {
    if (times < 2) continue;
    copied_.emplace(mesh, times);
    triangles_ += times * static_cast<double>(mesh->triangles.size());
    spared_ += (times - 1) * static_cast<double>(mesh->triangles.size()) - times;
  }
}

bool CopiedMeshes::share(double from) const {
  constexpr double most = 0x1p31 - 0x1p28;  // each has a number of its own
  return triangles_ >= from && triangles_ <= most;
}

const CopiedMeshes::Uses& CopiedMeshes::uses_in(const std::vector<Object>& objects) {
  const auto [entry, is_new] = known_.try_emplace(&objects);
  if (!is_new) return entry->second;
  Uses uses;
  for (const Object& object : objects) {
    if (!object.motion.empty()) continue;
    if (const auto* instance = std::get_if<Instance>(&object.shape)) {
      if (!instance->content) continue;
      for (const auto& [mesh, times] : uses_in(instance->content->group.objects)) uses[mesh] += times;
    } else if (may_be_shared(object)) {
      uses[std::get<MeshShape>(object.shape).mesh.get()] += 1;
    }
  }
  return known_[&objects] = std::move(uses);
}

bool CopiedMeshes::has(const Object& object, bool moves) const {
  if (copied_.empty() || moves || !may_be_shared(object)) return false;
  return copied_.count(std::get<MeshShape>(object.shape).mesh.get()) > 0;
}

}  // namespace raywalk
