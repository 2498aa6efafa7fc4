#pragma once
// A scene made ready for tracing, once for all who ask: the walk and the picture of one scene are of one world.

#include "scene/scene.h"
#include "trace/world.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace raywalk {

/// The worlds of one scene. Its objects, lights and groups are the same each time it is asked; what else a world is
/// made from may differ. To be used by one thread at a time; the worlds themselves by any number.
class Worlds {
 public:
  /// As World<T>(scene, kind, fault, stop); the one made for such a scene before, if it is among the last few asked
  /// for.
  template <class T>
  [[nodiscard]] std::shared_ptr<const World<T>> of(const Scene& scene,
                                                   AcceleratorKind kind = AcceleratorKind::automatic,
                                                   std::optional<Fault> fault = std::nullopt, const Stop& stop = {});

 private:
  struct Made {
    Scene shell;  ///< what of a scene, but for its lists, a world is made from
    AcceleratorKind kind;
    std::optional<Fault> fault;
    std::variant<std::shared_ptr<const World<float>>, std::shared_ptr<const World<double>>> world;
  };
  std::vector<Made> made_;  ///< the one asked for last comes first
};

extern template std::shared_ptr<const World<float>> Worlds::of(const Scene&, AcceleratorKind, std::optional<Fault>,
                                                               const Stop&);
extern template std::shared_ptr<const World<double>> Worlds::of(const Scene&, AcceleratorKind, std::optional<Fault>,
                                                                const Stop&);

}  // namespace raywalk
