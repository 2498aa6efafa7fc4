#include "timeline/event_json.h"

#include "trace/pseudocode.h"

#include <nlohmann/json.hpp>

namespace raywalk {

namespace {

using Json = nlohmann::ordered_json;

Json triple(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// Adds the members of one event's detail. One overload per kind: a kind without one does not compile.
class EventWriter {
 public:
  EventWriter(const Scene& scene, Json& to) : scene_(scene), to_(to) {}

  void operator()(const PixelBegun& begun) const {
    to_["what"] = "pixel_begun";
    pixel(begun.column, begun.row, begun.sample);
  }

  void operator()(const RayFormed& formed) const {
    to_["what"] = "ray_formed";
    to_["ray"] = formed.ray;
    spawned(formed.kind, formed.parent, formed.origin, formed.direction, formed.throughput);
    light(formed.light);
    if (formed.light_sample > 0) to_["light_sample"] = formed.light_sample;
    if (formed.snell) snell(*formed.snell);
    if (formed.radius != 0 || formed.end_radius != 0)
      to_["radius"] = formed.radius, to_["end_radius"] = formed.end_radius;
  }

  void operator()(const RayNotFormed& stub) const {
    to_["what"] = "ray_not_formed";
    to_["why"] = name_of(stub.why);
    spawned(stub.kind, stub.parent, stub.origin, stub.direction, stub.throughput);
    light(stub.light);
    if (stub.light_sample > 0) to_["light_sample"] = stub.light_sample;
  }

  void operator()(const Found& found) const {
    to_["what"] = "found";
    to_["ray"] = found.ray;
    to_["ending"] = name_of(found.ending);
    if (found.object >= 0) {
      to_["t"] = found.t;
      object(found.object);
      to_["part"] = found.part;
      if (found.triangle >= 0) to_["triangle"] = found.triangle;
      if (!found.member.empty()) to_["member"] = found.member;
      to_["point"] = triple(found.point);
      to_["normal"] = triple(found.normal);
    }
    if (found.transmittance != Rgbd(1.0)) to_["passed"] = triple(found.transmittance);
    std::visit([this](const auto& numbers) { add(numbers); }, found.numbers);
  }

  void operator()(const Decided& decided) const {
    to_["what"] = "decided";
    to_["holds"] = decided.holds;
    to_["weight"] = triple(decided.weight);
    if (decided.why) to_["why"] = name_of(*decided.why);
    if (decided.snell) snell(*decided.snell);
  }

  void operator()(const ShadeCalled& called) const {
    to_["what"] = "shade_called";
    to_["ray"] = called.ray;
    to_["missed"] = called.missed;
    to_["called_depth"] = called.depth;
    if (called.missed) to_["background"] = triple(called.background);
  }

  void operator()(const ShadeComputed& computed) const {
    to_["what"] = "shade_computed";
    to_["ambient"] = triple(computed.ambient);
    to_["emission"] = triple(computed.emission);
    lights(computed.lights);
    to_["reflect"] = triple(computed.reflect);
    to_["refract"] = triple(computed.refract);
    if (computed.transmittance != Rgbd(1.0)) to_["passed"] = triple(computed.transmittance);
    if (computed.irradiance) to_["irradiance"] = triple(*computed.irradiance);
    to_["total"] = triple(computed.total);
  }

  void operator()(const PixelPut& put) const {
    to_["what"] = "pixel_put";
    pixel(put.column, put.row, put.sample);
    to_["shade"] = triple(put.shade);
  }

  void operator()(const BackgroundAdded& background) const {
    to_["what"] = "background_added";
    to_["ray"] = background.ray;
    if (background.light_pdf > 0) to_["background"] = triple(background.background);
    if (background.light_pdf > 0) return weighted(background);
    to_["added"] = triple(background.added);
  }

  void operator()(const EmissionAdded& emission) const {
    to_["what"] = "emission_added";
    to_["ray"] = emission.ray;
    to_["emission"] = triple(emission.emission);
    weighted(emission);
  }

  void operator()(const LightAdded& added) const {
    to_["what"] = "light_added";
    light(added.light);
    if (added.object >= 0) object(added.object);
    weighted(added);
  }

  void operator()(const DirectionChosen& chosen) const {
    to_["what"] = "direction_chosen";
    to_["absorbed"] = chosen.absorbed;
    if (chosen.absorbed) return;
    to_["lobe"] = name_of(chosen.lobe);
    to_["direction"] = triple(chosen.direction);
    to_["density"] = chosen.pdf;
    to_["share"] = triple(chosen.throughput);
  }

  void operator()(const SurvivalDecided& decided) const {
    to_["what"] = "survival_decided";
    to_["survives"] = decided.survives;
    to_["survival"] = decided.survival;
    if (decided.why) to_["why"] = name_of(*decided.why);
  }

  void operator()(const PhotonBegun& begun) const {
    to_["what"] = "photon_begun";
    to_["photon"] = begun.photon;
    to_["count"] = begun.count;
    if (begun.others > 0) to_["others"] = begun.others;
  }

  void operator()(const PhotonStored& stored) const {
    to_["what"] = "photon_stored";
    to_["ray"] = stored.ray;
    to_["position"] = triple(stored.position);
    to_["normal"] = triple(stored.normal);
    to_["power"] = triple(stored.power);
    to_["history"] = name_of(stored.history);
    to_["kept"] = stored.kept;
  }

  void operator()(const PhotonsFound& found) const {
    to_["what"] = "photons_found";
    to_["ray"] = found.ray;
    to_["position"] = triple(found.position);
    to_["normal"] = triple(found.normal);
    to_["flat"] = found.flat;
    circle("caustic", found.caustic);
    circle("other", found.other);
  }

  void operator()(const PhotonsAdded& photons) const {
    to_["what"] = "photons_added";
    to_["ray"] = photons.ray;
    to_["irradiance"] = triple(photons.irradiance);
    to_["albedo"] = triple(photons.albedo);
    to_["added"] = triple(photons.added);
  }

  void operator()(const PatchesMade& made) const {
    to_["what"] = "patches_made";
    to_["count"] = made.count;
    to_["flat"] = made.flat;
    if (made.lights) to_["unshot"] = triple(made.unshot);
  }

  void operator()(const UnshotLight& light) const {
    to_["what"] = "unshot_light";
    to_["holds"] = light.holds;
    to_["shots"] = light.shots;
    to_["unshot_share"] = light.share;
    to_["tolerance"] = light.tolerance;
  }

  void operator()(const PatchTaken& taken) const {
    to_["what"] = "patch_taken";
    patch(taken.patch, taken.object);
    to_["radiosity"] = triple(taken.radiosity);
    to_["share_of_unshot"] = taken.share;
  }

  void operator()(const PatchShot& shot) const {
    to_["what"] = "patch_shot";
    patch(shot.patch, shot.object);
    if (shot.others > 0) to_["others"] = shot.others;
    to_["unshot_share"] = shot.share;
    if (!shot.lights) return;
    to_["lights"] = Json::array();
    for (const PatchLight& each : *shot.lights) to_["lights"].push_back(light_of(each));
  }

  void operator()(const PatchInFront& front) const {
    to_["what"] = "patch_in_front";
    patch(front.patch, front.object);
  }

  void operator()(const FormFactorFound& found) const {
    to_["what"] = "form_factor_found";
    to_["from"] = found.from;
    patch(found.to, found.object);
    to_["crossed"] = found.crossed;
    to_["uncrossed"] = found.uncrossed;
    to_["length"] = found.length;
    to_["factor"] = found.factor;
    to_["visible"] = found.visible;
  }

  void operator()(const LightArrived& arrived) const {
    to_["what"] = "light_arrived";
    patch(arrived.patch, arrived.object);
    to_["arrived"] = triple(arrived.arrived);
    to_["reflectance"] = triple(arrived.reflectance);
    to_["light"] = light_of(arrived.light);
  }

  void operator()(const PatchEmptied& emptied) const {
    to_["what"] = "patch_emptied";
    patch(emptied.patch, emptied.object);
    to_["light"] = light_of(emptied.light);
    to_["unshot_share"] = emptied.share;
  }

  void operator()(const LightLookedUp& looked) const {
    to_["what"] = "light_looked_up";
    to_["ray"] = looked.ray;
    if (looked.patch >= 0) to_["patch"] = looked.patch;
    to_["irradiance"] = triple(looked.irradiance);
    to_["albedo"] = triple(looked.albedo);
    to_["emission"] = triple(looked.emission);
    to_["shade"] = triple(looked.shade);
  }

  void operator()(const BeamFormed& formed) const {
    to_["what"] = "beam_formed";
    to_["ray"] = formed.ray;
    if (formed.parent >= 0) to_["parent"] = formed.parent;
    to_["apex"] = triple(formed.apex);
    to_["begin"] = formed.begin;
    to_["end"] = formed.end;
    if (formed.radius != 0 || formed.spread != 0) to_["radius"] = formed.radius, to_["spread"] = formed.spread;
    if (formed.snell) to_["n1"] = formed.snell->n1, to_["n2"] = formed.snell->n2, to_["off"] = formed.off;
    to_["share"] = triple(formed.throughput);
  }

  void operator()(const BeamCut& cut) const {
    to_["what"] = "beam_cut";
    to_["ray"] = cut.ray;
    for (const BeamPiece& piece : cut.pieces) {
      Json part{{"ray", piece.ray}, {"begin", piece.begin}, {"end", piece.end}, {"coverage", piece.coverage}};
      if (piece.object >= 0) EventWriter(scene_, part).object(piece.object);
      part["origin"] = triple(piece.origin);
      if (piece.object >= 0) part["point"] = triple(piece.point), part["normal"] = triple(piece.normal);
      to_["parts"].push_back(std::move(part));
    }
  }

  void operator()(const PartBegun& begun) const {
    to_["what"] = "part_begun";
    to_["ray"] = begun.ray;
    to_["number"] = begun.number;
    to_["count"] = begun.count;
    to_["coverage"] = begun.coverage;
  }

  void operator()(const PartShaded& shaded) const {
    to_["what"] = "part_shaded";
    to_["ray"] = shaded.ray;
    to_["ambient"] = triple(shaded.ambient);
    to_["emission"] = triple(shaded.emission);
    lights(shaded.lights);
    to_["total"] = triple(shaded.total);
  }

  void operator()(const PartAdded& added) const {
    to_["what"] = "part_added";
    to_["ray"] = added.ray;
    to_["local"] = triple(added.local);
    to_["reflect"] = triple(added.reflect);
    to_["refract"] = triple(added.refract);
    to_["shade"] = triple(added.shade);
    to_["of_beam"] = added.share;
    to_["mean"] = triple(added.mean);
    if (added.off > 0) to_["off"] = added.off;
  }

  void operator()(const PencilChanged& changed) const {
    to_["what"] = "pencil_changed";
    to_["ray"] = changed.ray;
    if (!changed.system) return;
    if (changed.along != 0) to_["along"] = changed.along;
    if (changed.curvature != 0) to_["curvature"] = changed.curvature;
    if (changed.snell) snell(*changed.snell);
    const PencilSystem& M = *changed.system;
    if (M.is_unmixed()) {
      to_["matrix"] = matrix(M.plan);
      to_["matrix_across"] = matrix(M.across);
      if (const auto focus = focus_of_point(M.plan)) to_["focus"] = *focus;
    } else {
      // By left and up: offset and slope of each.
      to_["matrix"] = {{M.plan.a, M.plan.b, M.left_from_up.a, M.left_from_up.b},
                       {M.plan.c, M.plan.d, M.left_from_up.c, M.left_from_up.d},
                       {M.up_from_left.a, M.up_from_left.b, M.across.a, M.across.b},
                       {M.up_from_left.c, M.up_from_left.d, M.across.c, M.across.d}};
      to_["foci"] = Json::array();
      for (const std::optional<double>& focus : foci_of_point(M)) to_["foci"].push_back(focus ? Json(*focus) : Json());
    }
  }

 private:
  [[nodiscard]] static Json matrix(const PencilMatrix& m) { return {{m.a, m.b}, {m.c, m.d}}; }
  [[nodiscard]] static Json light_of(const PatchLight& light) {
    return {{"irradiance", triple(light.irradiance)}, {"unshot", triple(light.unshot)}};
  }
  void patch(int index, int of) const {
    to_["patch"] = index;
    object(of);
  }
  void lights(const std::vector<LightTerm>& terms) const {
    to_["lights"] = Json::array();
    for (const LightTerm& term : terms) {
      Json json = {{"light", term.light}, {"diffuse", triple(term.diffuse)}, {"specular", triple(term.specular)}};
      to_["lights"].push_back(std::move(json));
    }
  }
  void circle(std::string_view name, const PhotonCircle& of) const {
    to_[std::string(name)] = {
        {"radius", of.radius}, {"count", of.count}, {"power", triple(of.power)}, {"irradiance", triple(of.irradiance)}};
  }
  template <class Added>
  void weighted(const Added& added) const {
    to_["direction_density"] = added.direction_pdf;
    to_["light_density"] = added.light_pdf;
    to_["weight"] = added.weight;
    to_["added"] = triple(added.added);
  }
  void snell(const SnellNumbers& s) const {
    to_["snell"] = {{"n1", s.n1}, {"n2", s.n2}, {"cos_in", s.cos_in}, {"cos_out", s.cos_out}, {"fresnel", s.fresnel}};
  }
  void pixel(int column, int row, int sample) const {
    to_["column"] = column;
    to_["row"] = row;
    to_["sample"] = sample;
  }
  void spawned(RayKind kind, int parent, const Vec3d& origin, const Vec3d& direction, const Rgbd& throughput) const {
    to_["kind"] = name_of(kind);
    if (parent >= 0) to_["parent"] = parent;
    to_["origin"] = triple(origin);
    to_["direction"] = triple(direction);
    to_["share"] = triple(throughput);
  }
  void object(int index) const {
    to_["object"] = index;
    to_["object_name"] = scene_.objects[static_cast<std::size_t>(index)].name;
  }
  void light(int index) const {
    if (index < 0) return;
    to_["light"] = index;
    to_["light_name"] = scene_.lights[static_cast<std::size_t>(index)].name;
  }
  void add(std::monostate /*none*/) const {}
  void add(const QuadraticNumbers& q) const {
    to_["quadratic"] = {{"a", q.a},   {"b", q.b},  {"c", q.c}, {"discriminant", q.discriminant},
                        {"t0", q.t0}, {"t1", q.t1}};
  }
  void add(const SkyNumbers& s) const {
    to_["sky"] = {{"elevation", s.elevation}, {"azimuth", s.azimuth}, {"density", s.pdf}};
    to_["sky"]["radiance"] = triple(s.radiance);
  }
  void add(const DipoleNumbers& d) const {
    to_["dipole"]["distance"] = d.distance;
    to_["dipole"]["reflectance"] = triple(d.reflectance);
    to_["dipole"]["total"] = triple(d.total);
  }
  void add(const PlaneNumbers& p) const { to_["plane"] = {{"numerator", p.numerator}, {"denominator", p.denominator}}; }

  const Scene& scene_;
  Json& to_;
};

}  // namespace

Json event_json(const Scene& scene, const Event& event) {
  const PseudocodeLine& line = pseudocode_of(event.line);
  Json json{{"line", line.text}, {"procedure", name_of(line.procedure)}, {"depth", event.depth}};
  std::visit(EventWriter(scene, json), event.detail);
  return json;
}

std::optional<int> first_difference(const Scene& scene, const Timeline& one, const Timeline& other) {
  // As text, which tells numbers to the last bit and all NaNs alike.
  const auto told = [&](const Timeline& of, int i) {
    return event_json(scene, of.event(i)).dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  const int both = std::min(one.steps(), other.steps());
  for (int i = 0; i < both; ++i)
    if (told(one, i) != told(other, i)) return i;
  return one.steps() == other.steps() ? std::nullopt : std::optional(both);
}

}  // namespace raywalk
