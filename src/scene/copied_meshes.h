#pragma once

#include "scene/scene.h"

#include <map>

namespace raywalk {

/// The meshes of a scene that instances put into several places, where they neither move, nor transmit or emit light,
/// and have more than a few triangles: such copies may share them.
class CopiedMeshes {
 public:
  explicit CopiedMeshes(const Scene& scene);

  /// Whether an object stands for one of several copies. `moves`: it, or an instance around it, has a motion.
  [[nodiscard]] bool has(const Object& object, bool moves) const;
  /// Whether their triangles are to be shared, given how many of all copies together are worth it.
  [[nodiscard]] bool share(double from = shared_copies) const;
  /// How many objects and triangles less are stored if they are.
  [[nodiscard]] double spared() const { return spared_; }

 private:
  using Uses = std::map<const Mesh*, double>;
  const Uses& uses_in(const std::vector<Object>& objects);

  std::map<const std::vector<Object>*, Uses> known_;  ///< of the scene, and of each group
  Uses copied_;
  double triangles_ = 0, spared_ = 0;  ///< `triangles_`: of all copies
};

}  // namespace raywalk
