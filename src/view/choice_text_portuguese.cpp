// What one chooses from, in Portuguese. Names of methods (bvh, kd-tree, Whitted, Sobol) stay as they are.

#include "view/choice_text.h"

namespace raywalk {

std::string_view portuguese(AcceleratorKind kind) {
  switch (kind) {
    case AcceleratorKind::automatic:
      return "automático";
    case AcceleratorKind::none:
      return "nenhum";
    case AcceleratorKind::spheres:
      return "esferas";
    case AcceleratorKind::ellipsoids:
      return "elipsoides";
    case AcceleratorKind::boxes:
      return "caixas";
    case AcceleratorKind::bvh:
      return "bvh";
    case AcceleratorKind::grid:
      return "grade";
    case AcceleratorKind::octree:
      return "octree";
    case AcceleratorKind::kdtree:
      return "kdtree";
  }
  return {};
}

std::string_view portuguese(Integrator integrator) {
  switch (integrator) {
    case Integrator::automatic:
      return "automático";
    case Integrator::cast:
      return "lançamento";
    case Integrator::whitted:
      return "whitted";
    case Integrator::distributed:
      return "distribuído";
    case Integrator::path:
      return "caminhos";
  }
  return {};
}

std::string_view portuguese(Sampler sampler) {
  switch (sampler) {
    case Sampler::random:
      return "aleatório";
    case Sampler::jittered:
      return "jittered";
    case Sampler::sobol:
      return "sobol";
  }
  return {};
}

std::string_view portuguese(Numerics numerics) {
  switch (numerics) {
    case Numerics::robust:
      return "robusta";
    case Numerics::naive:
      return "ingênua";
  }
  return {};
}

std::string_view portuguese(Effect effect) {
  switch (effect) {
    case Effect::shadows:
      return "sombras";
    case Effect::reflection:
      return "reflexão";
    case Effect::refraction:
      return "refração";
    case Effect::gloss:
      return "brilho difuso";
    case Effect::translucency:
      return "translucidez";
    case Effect::penumbra:
      return "penumbra";
    case Effect::depth_of_field:
      return "profundidade de campo";
    case Effect::motion_blur:
      return "borrão de movimento";
    case Effect::antialiasing:
      return "antialiasing";
    case Effect::indirect_light:
      return "luz indireta";
    case Effect::textures:
      return "texturas";
  }
  return {};
}

}  // namespace raywalk
