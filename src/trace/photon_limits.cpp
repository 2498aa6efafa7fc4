#include "trace/photon_limits.h"

#include "trace/emitters.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace raywalk {

namespace {

/// What photons leave of a primitive that emits: null for all, else what is to be said of it.
const char* loss_of(const World<float>& world, const Emitters<float>& emitters, int id) {
  const Primitives<float>& primitives = world.accelerator.primitives();
  if (primitives.moves(id)) return "is seen to shine, but lights nothing: no photons leave what moves";
  const Shape<float> shape = primitives.shape(id);
  if (std::holds_alternative<Triangle<float>>(shape)) return nullptr;  // be it one without an area
  const auto* prism = std::get_if<Prism<float>>(&shape);
  const int last = prism != nullptr ? std::max(prism->top(), prism->bottom()) : 0;  // the last to be sampled, if at all
  bool some = false;
  for (const auto& each : emitters.all()) {
    if (each.primitive != id) continue;
    if (each.part >= last) return nullptr;
    some = true;
  }
  return some ? "is seen to shine, but does not light all that it should: photons leave round spheres, disks, boxes, "
                "and "
                "faces without dents or holes only"
              : "is seen to shine, but lights nothing: photons leave round spheres, disks, boxes, and faces without "
                "dents or holes only";
}

bool shines_from_afar(const World<float>& world) {
  return world.sky || !is_black(world.background) ||
         std::any_of(world.lights.begin(), world.lights.end(), [](const auto& light) { return light.is_distant; });
}

}  // namespace

std::vector<std::string> photon_losses(const Scene& scene) {
  if (scene.render.integrator != Integrator::photons) return {};
  const World<float> world(scene, AcceleratorKind::none);
  const Emitters<float> emitters(world);
  const Primitives<float>& primitives = world.accelerator.primitives();
  const bool from_afar = shines_from_afar(world);
  std::vector<std::string> losses;
  std::vector<std::pair<int, bool>> told;  // of which object, and whether of its emission
  const auto tell = [&](int id, bool of_emission, const char* what) {
    const std::pair<int, bool> each{world.object(id), of_emission};
    if (std::find(told.begin(), told.end(), each) != told.end()) return;
    told.push_back(each);
    losses.push_back("\"" + scene.objects[static_cast<std::size_t>(each.first)].name + "\" " + what);
  };
  for (int id = 0; id < primitives.own_size(); ++id) {
    const auto& surface = world.surface(id);
    if (!is_black(surface.emission))
      if (const char* loss = loss_of(world, emitters, id)) tell(id, true, loss);
    if (from_afar && !is_black(surface.diffuse) && !primitives.box(id).bounded())
      tell(id, false,
           "gives other surfaces too little light: it is endless, and photons from afar fly to what has an end");
  }
  return losses;
}

}  // namespace raywalk
