#include "render/world_cache.h"

#include "trace/bodies.h"

#include <algorithm>

namespace raywalk {

namespace {

/// The walk and the picture may differ in their accelerator; more would waste memory.
constexpr std::size_t max_kept = 2;

Scene shell_of(const Scene& scene) {
  Scene shell;
  // The camera without its pose: turning the view needs no other world, unless it takes the eye into a body.
  shell.camera = scene.camera;
  const Camera anywhere;
  shell.camera.eye = anywhere.eye;
  shell.camera.look_at = anywhere.look_at;
  shell.camera.up = anywhere.up;
  shell.camera.fov = anywhere.fov;
  shell.camera.screen = anywhere.screen;
  shell.limits = scene.limits;
  shell.render = scene.render;
  shell.background = scene.background;
  shell.sky = scene.sky;
  shell.ambient = scene.ambient;
  return shell;
}

}  // namespace

template <class T>
std::shared_ptr<const World<T>> WorldCache::of(const Scene& scene, AcceleratorKind kind, std::optional<Fault> fault,
                                               const Stop& stop) {
  using Pointer = std::shared_ptr<const World<T>>;
  Scene shell = shell_of(scene);
  const auto holds_eye_alike = [&](const World<T>& world) {
    return bodies_that_nest(world, scene.camera).around_eye == world.bodies.around_eye;
  };
  const auto same = std::find_if(cached_.begin(), cached_.end(), [&](const CachedWorld& made) {
    return made.kind == kind && made.fault == fault && std::holds_alternative<Pointer>(made.world) &&
           made.shell == shell && holds_eye_alike(*std::get<Pointer>(made.world));
  });
  if (same != cached_.end()) {
    std::rotate(cached_.begin(), same, same + 1);
  } else {
    if (cached_.size() == max_kept) cached_.pop_back();  // first, as large scenes leave no memory for one more
    cached_.insert(cached_.begin(), {std::move(shell), kind, fault,
                                     std::make_shared<const World<T>>(scene, kind, fault, BuildOptions{stop})});
  }
  return std::get<Pointer>(cached_.front().world);
}

template std::shared_ptr<const World<float>> WorldCache::of(const Scene&, AcceleratorKind, std::optional<Fault>,
                                                            const Stop&);
template std::shared_ptr<const World<double>> WorldCache::of(const Scene&, AcceleratorKind, std::optional<Fault>,
                                                             const Stop&);

}  // namespace raywalk
