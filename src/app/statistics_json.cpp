#include "app/statistics_json.h"

#include "app/names.h"

#include <nlohmann/json.hpp>

namespace raywalk {

std::string statistics_json(const Rendering& rendering, const RenderReport& report) {
  using Json = nlohmann::ordered_json;
  const Statistics& statistics = rendering.statistics;
  Json json;
  json["version"] = RAYWALK_VERSION;
  json["scene"] = report.scene;
  json["image"] = {{"path", report.image},
                   {"width", report.size.width},
                   {"height", report.size.height},
                   {"samples", report.sampling.per_pixel},
                   {"corner_samples", report.sampling.corners},
                   {"seed", report.sampling.seed},
                   {"integrator", name_of(report.choices.integrator)},
                   {"sampler", name_of(report.choices.sampler)},
                   {"tolerance", report.choices.tolerance},
                   {"depth", report.limits.depth},
                   {"threshold", report.limits.threshold},
                   {"precision", name_of(report.precision)},
                   {"numerics", name_of(report.choices.numerics)}};
  for (int i = 0; i < ray_kind_count; ++i) {
    const auto kind = static_cast<RayKind>(i);
    json["rays"][std::string(name_of(kind))] = statistics.formed(kind);
  }
  for (int i = 0; i < ending_count; ++i) {
    const auto ending = static_cast<Ending>(i);
    json["ended"][std::string(name_of(ending))] = statistics.ends(ending);
  }
  json["tests"] = {{"nodes", statistics.tests.nodes},
                   {"primitives", statistics.tests.primitives},
                   {"exactly_decided", statistics.tests.exactly_decided}};
  json["random_draws"] = statistics.random_draws();
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    if (statistics.drawn(effect) > 0) json["draws"][std::string(name_of(effect))] = statistics.drawn(effect);
  }
  json["not_finite"] = statistics.not_finite;
  json["not_finite_pixels"] = rendering.not_finite_pixels;
  json["accelerator"] = {{"name", name_of(rendering.accelerator)},
                         {"nodes", rendering.structure.nodes},
                         {"references", rendering.structure.references},
                         {"depth", rendering.structure.depth},
                         {"expected_cost", rendering.structure.expected_cost},
                         {"bytes", rendering.structure.bytes}};
  json["seconds"] = {{"load", report.load_seconds},
                     {"build", rendering.build_seconds},
                     {"trace", rendering.trace_seconds},
                     {"write", report.write_seconds}};
  json["threads"] = rendering.threads;
  json["busy_seconds"] = rendering.busy_seconds;
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    const EffectUse& use = rendering.effects[effect];
    json["effects"][std::string(name_of(effect))] = {{"used", use.used}, {"why", use.why}};
  }
  // A path need not be UTF-8; invalid bytes become the replacement character.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace raywalk
