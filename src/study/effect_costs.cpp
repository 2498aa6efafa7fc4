#include "study/effect_costs.h"

#include "study/shot.h"
#include "study/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace raywalk::study {

namespace {

/// Calls `change` for every material of the scene's objects, groups and files.
void change_materials(Scene& scene, const std::function<void(Material&)>& change) {
  std::map<std::string, std::shared_ptr<const GroupContent>> changed;
  const auto change_objects = [&](std::vector<Object>& objects) {
    for (Object& object : objects) {
      change(object.material);
      if (auto* mesh = std::get_if<MeshShape>(&object.shape); mesh && mesh->materials) {
        auto materials = std::make_shared<std::vector<Material>>(*mesh->materials);
        for (Material& material : *materials) change(material);
        mesh->materials = std::move(materials);
      }
      // A group stands before those that use it.
      if (auto* instance = std::get_if<Instance>(&object.shape)) instance->content = changed[instance->group];
    }
  };
  for (Group& group : scene.groups) {
    change_objects(group.objects);
    changed[group.name] = std::make_shared<const GroupContent>(group);
  }
  change_objects(scene.objects);
}

/// Shrinks an area light to its centre.
void shrink(Light& light) {
  if (is_area(light)) light.kind = PointLight{*middle_of(light), attenuation_of(light)};
}

/// Gives a light many points; a point light becomes a tiny ball of them.
void grow(Light& light, int grid) {
  static constexpr double tiny = 1e-9;
  std::visit(
      [&](auto& kind) {
        if constexpr (requires { kind.samples; }) kind.samples = std::max(kind.samples, grid);
      },
      light.kind);
  auto* sphere = std::get_if<SphereLight>(&light.kind);
  if (sphere != nullptr && sphere->radius == 0) sphere->radius = tiny;
  if (const auto* point = std::get_if<PointLight>(&light.kind))
    light.kind = SphereLight{point->position, tiny, grid, point->attenuation};
}

Cost median_of(const std::vector<Cost>& costs) {
  Cost middle = costs.front();
  std::vector<double> seconds;
  for (const Cost& cost : costs) seconds.push_back(cost.seconds);
  middle.seconds = median(seconds);
  return middle;
}

}  // namespace

std::optional<Scene> without(const Scene& scene, Effect effect) {
  Scene changed = scene;
  switch (effect) {
    case Effect::shadows:
      return std::nullopt;
    case Effect::reflection:
      change_materials(changed, [](Material& m) { m.reflection = Rgbd(0.0), m.dielectric = false; });
      return changed;
    case Effect::refraction:
      change_materials(changed, [](Material& m) { m.transmission = Rgbd(0.0), m.dielectric = false; });
      return changed;
    case Effect::gloss:
      change_materials(changed, [](Material& m) { m.gloss = 0; });
      return changed;
    case Effect::translucency:
      change_materials(changed, [](Material& m) { m.translucency = 0; });
      return changed;
    case Effect::penumbra:
      for (Light& light : changed.lights) shrink(light);
      return changed;
    case Effect::depth_of_field:
      changed.camera.aperture = 0;
      return changed;
    case Effect::motion_blur:
      changed.camera.shutter_close = changed.camera.shutter_open;
      return changed;
    case Effect::antialiasing:
      changed.render.samples = 1;
      return changed;
    case Effect::indirect_light:
      changed.render.integrator = Integrator::automatic;
      changed.render.radiosity.as_ambient = false;
      return changed;
    case Effect::textures:
      change_materials(changed, [](Material& m) { m.checker.reset(), m.texture.reset(); });
      return changed;
    case Effect::sky:
      changed.sky.reset();
      return changed;
    case Effect::scattering:
      change_materials(changed, [](Material& m) { m.scattering = Rgbd(0.0); });
      return changed;
    case Effect::filtering:
      change_materials(changed, [](Material& m) {
        if (m.checker) m.checker->filter = CheckerFilter::none;
        if (m.texture) m.texture->filter = TextureFilter::none;
      });
      return changed;
    case Effect::microfacets:
      change_materials(changed,
                       [](Material& m) { m.mirror = MirrorKind::ideal, m.roughness = m.diffuse_roughness = 0; });
      return changed;
    case Effect::maps:
      change_materials(changed, [](Material& m) {
        m.maps.clear();
        m.normal_map.reset(), m.bump_map.reset(), m.mask.reset();
      });
      return changed;
  }
  return std::nullopt;
}

Scene with_everything(const Scene& scene, int grid) {
  static constexpr double faint = 1e-9, narrow = 1e-4;  // weight; degrees
  Scene changed = scene;
  changed.render.integrator = Integrator::distributed;
  changed.limits.threshold = 0;
  change_materials(changed, [](Material& m) {
    if (!m.reflects()) m.reflection = Rgbd(faint);
    if (!m.transmits()) {
      m.transmission = Rgbd(faint);
      m.normal = ShadingNormal::facing;
    }
    m.gloss = std::max(m.gloss, narrow);
    m.translucency = std::max(m.translucency, narrow);
  });
  for (Light& light : changed.lights) grow(light, grid);
  changed.render.light_grid.reset();
  Camera& camera = changed.camera;
  camera.aperture = std::max(camera.aperture, faint * camera.focus_distance());
  if (camera.shutter_close == camera.shutter_open) camera.shutter_close += faint;
  if (first_moving_object(changed) == nullptr && !changed.objects.empty())
    changed.objects.front().motion = {{camera.shutter_open, Vec3d(0.0)}, {camera.shutter_close, Vec3d(faint)}};
  return changed;
}

CostSurvey::CostSurvey(const Scene& scene, int samples, int repetitions) {
  blank_.repetitions = repetitions;
  constexpr double fewest = 400;
  blank_.size = shrunk(scene.image, std::max(fewest, static_cast<double>(samples) / scene.render.samples));
  const Effects used = effects_of(scene, scene.render.samples);
  for (const Light& light : scene.lights)
    blank_.everything_grid = std::max(blank_.everything_grid, light_grid_of(scene, light));
  scenes_ = {scene};
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    if (!used.used(effect)) continue;
    if (auto changed = without(scene, effect)) {
      blank_.effects.push_back({effect, {}});
      scenes_.push_back(std::move(*changed));
    }
  }
  if (scene.limits.depth <= deepest_everything) scenes_.push_back(with_everything(scene, blank_.everything_grid));
  costs_.resize(scenes_.size());
}

double CostSurvey::done() const {
  const std::size_t all = (static_cast<std::size_t>(blank_.repetitions) + 1) * scenes_.size();
  return static_cast<double>(next_) / static_cast<double>(all);
}

bool CostSurvey::work(const Stop& stop) {
  if (done() >= 1) return false;
  const std::size_t i = next_ % scenes_.size();
  const bool warms_up = next_ < scenes_.size();
  const Shot shot = shoot(scenes_[i], blank_.size, {scenes_[i].render.samples, 0}, false, std::nullopt, stop);
  if (i == 0) blank_.shadow_rays = shot.shadow_rays;
  if (!warms_up) costs_[i].push_back(shot.cost);
  ++next_;
  return done() < 1;
}

std::optional<SceneCost> CostSurvey::result() const {
  const std::size_t repetitions = costs_.back().size();
  if (repetitions == 0) return std::nullopt;
  SceneCost result = blank_;
  result.repetitions = static_cast<int>(repetitions);
  const auto first = [&](std::size_t i) {
    return std::vector<Cost>(costs_[i].begin(), costs_[i].begin() + static_cast<std::ptrdiff_t>(repetitions));
  };
  const std::vector<Cost> wholes = first(0);
  result.whole = median_of(wholes);
  const std::size_t effects = result.effects.size();
  if (effects + 1 < scenes_.size()) result.everything = median_of(first(effects + 1));
  for (std::size_t i = 0; i < effects; ++i) {
    EffectCost& effect = result.effects[i];
    const std::vector<Cost> rests = first(i + 1);
    const Cost rest = median_of(rests), &whole = result.whole;
    const auto saved = [](std::uint64_t all, std::uint64_t some) { return all > some ? all - some : 0; };
    effect.saved = {saved(whole.rays, rest.rays), saved(whole.nodes, rest.nodes), saved(whole.tests, rest.tests),
                    saved(whole.draws, rest.draws), whole.seconds - rest.seconds};
    effect.rays_share =
        static_cast<double>(effect.saved.rays) / static_cast<double>(std::max<std::uint64_t>(whole.rays, 1));
    std::vector<double> shares;  // of pairs of consecutive runs
    for (std::size_t k = 0; k < repetitions; ++k) shares.push_back(1 - rests[k].seconds / wholes[k].seconds);
    effect.seconds_share = median(shares);
    const Interval reach = median_interval(shares);
    effect.seconds_low = reach.low, effect.seconds_high = reach.high;
  }
  std::stable_sort(result.effects.begin(), result.effects.end(), [](const EffectCost& a, const EffectCost& b) {
    return a.saved.rays != b.saved.rays ? a.saved.rays > b.saved.rays : a.seconds_share > b.seconds_share;
  });
  return result;
}

std::optional<SceneCost> scene_cost(const Scene& scene, int samples, int repetitions,
                                    const std::function<void(double done)>& progress, const Stop& stop) {
  CostSurvey survey(scene, samples, repetitions);
  try {
    do {
      stop.check();
      if (progress) progress(survey.done());
    } while (survey.work(stop));
  } catch (const Stopped&) {
    return std::nullopt;
  }
  if (progress) progress(1);
  return survey.result();
}

}  // namespace raywalk::study
