#pragma once
// The names of the files that a scene states, in one list. Internal to `io`.

#include "scene/scene.h"

#include <variant>

namespace raywalk::detail {

/// Visits the name of each file that a scene needs: the sky's picture, meshes, textures and maps. `AnyScene`: Scene,
/// const or not.
template <class AnyScene, class Visit>
void each_file_name(AnyScene& scene, const Visit& visit) {
  const auto stated = [&](auto& file) {
    if (!file.empty()) visit(file);
  };
  const auto of_objects = [&](auto& objects) {
    for (auto& object : objects) {
      if (auto* mesh = std::get_if<MeshShape>(&object.shape)) stated(mesh->file);
      if (object.material.texture) stated(object.material.texture->file);
      each_map(object.material, [&](auto& map, bool /*colour*/) { stated(map.file); });
    }
  };
  if (scene.sky)
    if (auto* image = std::get_if<ImageSky>(&scene.sky->kind)) stated(image->file);
  of_objects(scene.objects);
  for (auto& group : scene.groups) of_objects(group.objects);
}

}  // namespace raywalk::detail
