#include "render/worlds.h"

#include <algorithm>

namespace raywalk {

namespace {

/// The walk and the picture may differ in their accelerator; more would only take room.
constexpr std::size_t most_kept = 2;

Scene shell_of(const Scene& scene) {
  Scene shell;
  // Of the camera, not where it stands and looks: turning the view makes no other world.
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
  shell.ambient = scene.ambient;
  return shell;
}

}  // namespace

template <class T>
std::shared_ptr<const World<T>> Worlds::of(const Scene& scene, AcceleratorKind kind, std::optional<Fault> fault,
                                           const Stop& stop) {
  using Pointer = std::shared_ptr<const World<T>>;
  Scene shell = shell_of(scene);
  const auto same = std::find_if(made_.begin(), made_.end(), [&](const Made& made) {
    return made.kind == kind && made.fault == fault && std::holds_alternative<Pointer>(made.world) &&
           made.shell == shell;
  });
  if (same != made_.end()) {
    std::rotate(made_.begin(), same, same + 1);
  } else {
    if (made_.size() == most_kept) made_.pop_back();  // first: large scenes leave no room for one more
    made_.insert(made_.begin(),
                 {std::move(shell), kind, fault, std::make_shared<const World<T>>(scene, kind, fault, stop)});
  }
  return std::get<Pointer>(made_.front().world);
}

template std::shared_ptr<const World<float>> Worlds::of(const Scene&, AcceleratorKind, std::optional<Fault>,
                                                        const Stop&);
template std::shared_ptr<const World<double>> Worlds::of(const Scene&, AcceleratorKind, std::optional<Fault>,
                                                         const Stop&);

}  // namespace raywalk
