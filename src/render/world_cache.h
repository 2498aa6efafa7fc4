#pragma once
// A cache of worlds, so that the walk and the picture of one scene share a world.

#include "scene/scene.h"
#include "trace/world.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace raywalk {

/// The worlds of one scene. Its objects, lights and groups must be the same in every call; everything else may differ.
/// For one thread at a time; the worlds themselves may be shared.
class WorldCache {
 public:
  /// World<T>(scene, kind, fault, stop), or the cached one if it is among the last few.
  template <class T>
  [[nodiscard]] std::shared_ptr<const World<T>> of(const Scene& scene,
                                                   AcceleratorKind kind = AcceleratorKind::automatic,
                                                   std::optional<Fault> fault = std::nullopt, const Stop& stop = {});

 private:
  struct CachedWorld {
    Scene shell;  ///< the parts of the scene that a world depends on, without its lists
    AcceleratorKind kind;
    std::optional<Fault> fault;
    std::variant<std::shared_ptr<const World<float>>, std::shared_ptr<const World<double>>> world;
  };
  std::vector<CachedWorld> cached_;  ///< most recently used first
};

extern template std::shared_ptr<const World<float>> WorldCache::of(const Scene&, AcceleratorKind, std::optional<Fault>,
                                                                   const Stop&);
extern template std::shared_ptr<const World<double>> WorldCache::of(const Scene&, AcceleratorKind, std::optional<Fault>,
                                                                    const Stop&);

}  // namespace raywalk
