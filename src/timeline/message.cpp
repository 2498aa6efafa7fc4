#include "timeline/message.h"

#include "math/elementary.h"
#include "math/overloaded.h"
#include "scene/effects.h"
#include "timeline/beam_message.h"
#include "timeline/cone_message.h"
#include "timeline/pencil_message.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raywalk {

namespace {

double degrees_of(double cosine) {
  const double sine = std::sqrt(std::max((1 - cosine) * (1 + cosine), 0.0));
  return portable::atan2(sine, cosine) * 180 / std::numbers::pi;
}

/// Describes the line that leads to one position.
class Describer {
 public:
  Describer(const Scene& scene, const Timeline& timeline, int position)
      : scene_(scene), timeline_(timeline), position_(position) {}

  [[nodiscard]] Message message() const {
    const Event* event = timeline_.just_run(position_);
    if (event == nullptr) return {"walk.start", {}};
    if (timeline_.of_beams())
      if (auto message = beam_message(scene_, timeline_, position_)) return std::move(*message);
    if (timeline_.of_cones())
      if (auto message = cone_message(scene_, timeline_, position_)) return std::move(*message);
    if (timeline_.of_pencils())
      if (auto message = pencil_message(scene_, timeline_, position_)) return std::move(*message);
    return std::visit([&](const auto& detail) { return describe(*event, detail); }, event->detail);
  }

 private:
  [[nodiscard]] const RayRecord& ray(int index) const { return timeline_.rays()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const RayRecord& current() const { return ray(timeline_.current_ray(position_)); }
  [[nodiscard]] const FrameRecord& frame(int index) const {
    return timeline_.frames()[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] std::string object(int index) const {
    return index < 0 ? std::string() : scene_.objects[static_cast<std::size_t>(index)].name;
  }
  [[nodiscard]] std::string light(int index) const {
    return index < 0 ? std::string() : scene_.lights[static_cast<std::size_t>(index)].name;
  }
  /// The ray whose hit the executing SHADE shades: not the one that came back last.
  [[nodiscard]] const RayRecord& shaded_ray() const { return ray(frame(timeline_.current_frame(position_)).ray); }
  /// Whether it hit the surface from outside: against its outward normal.
  [[nodiscard]] bool came_from_outside() const { return dot(shaded_ray().normal, shaded_ray().direction) < 0; }
  /// The object whose surface the executing SHADE shades, or at which FOLLOW PATH stands.
  [[nodiscard]] int shaded_index() const {
    if (timeline_.has_width()) return ray(timeline_.part_of(timeline_.current_ray(position_))).object;
    if (!timeline_.of_paths()) return shaded_ray().object;
    const RayRecord& at = current();
    const bool leaves = at.kind == RayKind::shadow || at.formed_at == position_;
    return leaves && at.parent >= 0 ? ray(at.parent).object : at.object;
  }
  [[nodiscard]] std::string shaded() const { return object(shaded_index()); }
  /// The material there.
  [[nodiscard]] Material shaded_material() const {
    const int index = shaded_index();
    return index < 0 ? Material{} : scene_.objects[static_cast<std::size_t>(index)].material;
  }
  /// Whether the current ray met the body that the ray before it had left: of a group, the same one.
  [[nodiscard]] bool met_itself(const Found& found) const {
    if (current().parent < 0) return false;
    const RayRecord& before = ray(current().parent);
    const Event* event = timeline_.just_run(before.found_at);
    const auto* left = event != nullptr ? std::get_if<Found>(&event->detail) : nullptr;
    return before.object == found.object && (left == nullptr || left->member == found.member);
  }

  /// Whether a refract ray was turned by a small facet: no smooth surface turns it so.
  [[nodiscard]] bool by_facet(const RayFormed& formed) const {
    const int index = shaded_index();
    return index >= 0 && scene_.objects[static_cast<std::size_t>(index)].material.is_rough_glass() &&
           draws_random(integrator_of(scene_, scene_.render.samples)) && formed.snell->n1 != formed.snell->n2;
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PixelBegun& begun) const {
    if (begun.sample > 0) return {"walk.sample_begun", {{"sample", begun.sample + 1}}};
    if (!timeline_.of_strip()) return {"walk.image_pixel_begun", {{"column", begun.column}, {"row", begun.row}}};
    return {"walk.pixel_begun", {{"cell", begun.column}, {"last", scene_.camera.screen.cells - 1}}};
  }

  [[nodiscard]] Message describe(const Event& event, const RayFormed& formed) const {
    if (event.line == Line::form_next_ray || event.line == Line::gather_form_next_ray)
      return {"walk.next_formed",
              {{"object", shaded()}, {"ray", formed.kind}, {"share", Fraction{max_component(formed.throughput)}}}};
    switch (formed.kind) {
      case RayKind::primary: {
        const PixelRecord& pixel = timeline_.pixels()[static_cast<std::size_t>(timeline_.current_pixel(position_))];
        if (!timeline_.of_strip()) return {"walk.image_primary_formed", {{"column", pixel.column}, {"row", pixel.row}}};
        return {"walk.primary_formed", {{"cell", pixel.column}}};
      }
      case RayKind::shadow:
        if (formed.light == light_of_sky) return {"walk.sky_aimed_at", {{"object", shaded()}}};
        if (formed.light < 0) return {"walk.object_aimed_at", {{"object", shaded()}}};
        return {"walk.shadow_formed", {{"object", shaded()}, {"light", light(formed.light)}}};
      case RayKind::reflect:
        return {"walk.reflect_formed", {{"object", shaded()}, {"share", Fraction{max_component(formed.throughput)}}}};
      case RayKind::refract: {
        // Of rough glass light may have met several facets, which turned it together.
        if (!formed.snell) return {"walk.refract_formed_facets", {{"object", shaded()}}};
        const SnellNumbers snell = *formed.snell;
        const bool goes_in = came_from_outside();
        const double in = degrees_of(snell.cos_in), out = degrees_of(snell.cos_out);
        if (by_facet(formed))
          return {"walk.refract_formed_facet", {{"object", shaded()}, {"angle_in", in}, {"angle_out", out}}};
        if ((goes_in ? snell.n1 : snell.n2) != 1)
          return {"walk.refract_formed_within",
                  {{"object", shaded()},
                   {"angle_in", in},
                   {"angle_out", out},
                   {"index_in", snell.n1},
                   {"index_out", snell.n2}}};
        return {goes_in ? "walk.refract_formed_in" : "walk.refract_formed_out",
                {{"object", shaded()}, {"angle_in", in}, {"angle_out", out}}};
      }
      case RayKind::photon:
        if (event.line == Line::photon_form_next_ray)
          return {"walk.photon_next", {{"object", shaded()}, {"power", max_component(formed.throughput)}}};
        if (formed.light == light_of_sky)
          return {"walk.photon_from_sky", {{"power", max_component(formed.throughput)}}};
        if (formed.light < 0) return {"walk.photon_from_object", {{"power", max_component(formed.throughput)}}};
        return {middle_of(scene_.lights[static_cast<std::size_t>(formed.light)]) ? "walk.photon_emitted"
                                                                                 : "walk.photon_emitted_far",
                {{"light", light(formed.light)}, {"power", max_component(formed.throughput)}}};
      case RayKind::beam:
        break;  // told by beam_message and cone_message
    }
    return {};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const RayNotFormed& stub) const {
    const bool reflect = stub.kind == RayKind::reflect;
    switch (stub.why) {
      case Ending::facing_away:
        if (stub.light == light_of_sky) return {"walk.sky_not_aimed_at", {{"object", shaded()}}};
        if (stub.light < 0) return {"walk.object_not_aimed_at", {{"object", shaded()}}};
        return {"walk.shadow_facing_away", {{"object", shaded()}, {"light", light(stub.light)}}};
      case Ending::outside_cone:
        return {"walk.shadow_outside_cone", {{"object", shaded()}, {"light", light(stub.light)}}};
      case Ending::depth: {
        const int deepest = frame(timeline_.current_frame(position_)).depth;
        return {reflect ? "walk.reflect_depth" : "walk.refract_depth", {{"depth", deepest}}};
      }
      case Ending::threshold:
        return {
            reflect ? "walk.reflect_threshold" : "walk.refract_threshold",
            {{"share", Fraction{max_component(stub.throughput)}}, {"threshold", Fraction{scene_.limits.threshold}}}};
      case Ending::wrong_side:
        return {reflect ? "walk.reflect_wrong_side" : "walk.refract_wrong_side", {{"object", shaded()}}};
      case Ending::path_length:
        return {"walk.path_length", {{"ray", stub.kind}}};
      case Ending::total_internal_reflection:
        return {"walk.totally_reflected", {{"object", shaded()}}};
      case Ending::hit:
      case Ending::missed:
      case Ending::blocked:
      case Ending::reached_light:
      case Ending::scattered:
        break;  // these rays are formed
    }
    return {};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const Found& found) const {
    const RayRecord& record = current();
    const HitObject met{object(found.object), found.member, found.triangle};
    switch (found.ending) {
      case Ending::hit: {
        const bool from_inside = dot(found.normal, record.direction) > 0 && met_itself(found);
        return {from_inside ? "walk.left_through_surface" : "walk.found_hit",
                {{"ray", record.kind}, {"object", met}, {"distance", length(found.point - record.origin)}}};
      }
      case Ending::scattered:
        return {std::holds_alternative<DipoleNumbers>(found.numbers) ? "walk.left_by_dipole" : "walk.scattered_inside",
                {{"ray", record.kind}, {"object", met}, {"distance", length(found.point - record.origin)}}};
      case Ending::missed:
        if (const auto* sky = std::get_if<SkyNumbers>(&found.numbers))
          return {sky->elevation < 0 ? "walk.found_sky_below" : "walk.found_sky",
                  {{"ray", record.kind},
                   {"elevation", std::abs(sky->elevation)},
                   {"azimuth", sky->azimuth},
                   {"colour", sky->radiance}}};
        if (record.kind == RayKind::photon) return {"walk.photon_left", {}};
        return {"walk.found_missed", {{"ray", record.kind}}};
      case Ending::blocked: {
        if (record.light == light_of_sky) return {"walk.sky_hidden", {{"object", met}}};
        if (record.light < 0) return {"walk.object_hidden", {{"object", met}}};
        return {met_itself(found) ? "walk.light_blocked_by_itself" : "walk.light_blocked",
                {{"light", light(record.light)}, {"object", met}}};
      }
      case Ending::reached_light:
        if (const auto* sky = std::get_if<SkyNumbers>(&found.numbers))
          return {sky->elevation < 0 ? "walk.sky_seen_below" : "walk.sky_seen",
                  {{"elevation", std::abs(sky->elevation)}, {"azimuth", sky->azimuth}, {"colour", sky->radiance}}};
        if (record.light < 0) return {"walk.object_seen", {{"object", met}}};
        if (found.transmittance == Rgbd(1.0)) return {"walk.light_reached", {{"light", light(record.light)}}};
        if (const Rgbd& share = found.transmittance; share.x != share.y || share.y != share.z)
          return {"walk.light_filtered", {{"light", light(record.light)}, {"share", share}}};
        return {"walk.light_filtered", {{"light", light(record.light)}, {"share", Fraction{found.transmittance.x}}}};
      case Ending::depth:
      case Ending::threshold:
      case Ending::total_internal_reflection:
      case Ending::path_length:
      case Ending::facing_away:
      case Ending::outside_cone:
      case Ending::wrong_side:
        break;  // these rays are not formed
    }
    return {};
  }

  [[nodiscard]] Message describe(const Event& event, const Decided& decided) const {
    const Line line = without_pencil(event.line);
    if (line == Line::if_intersect_something) {
      if (!decided.holds) return {"walk.intersected_nothing", {}};
      return {"walk.intersected", {{"object", object(current().object)}}};
    }
    if (line == Line::if_reflective) {
      if (!decided.holds) return {"walk.not_reflective", {{"object", shaded()}}};
      // Under total internal reflection kt goes to kr.
      const Material& material = scene_.objects[static_cast<std::size_t>(current().object)].material;
      const Rgbd above = decided.weight - material.reflection, missing = above - material.transmission;
      constexpr double rounding = 1e-6;  // of a recording in float
      const bool totally =
          material.transmits() && std::abs(missing.x) + std::abs(missing.y) + std::abs(missing.z) < rounding;
      if (!totally) return {"walk.reflective", {{"object", shaded()}, {"weight", decided.weight}}};
      return {came_from_outside() ? "walk.reflective_totally_in" : "walk.reflective_totally",
              {{"object", shaded()}, {"weight", decided.weight}}};
    }
    if (line == Line::if_transparent) {
      if (decided.why == Ending::total_internal_reflection)
        return {came_from_outside() ? "walk.totally_reflected_in" : "walk.totally_reflected", {{"object", shaded()}}};
      if (!decided.holds) return {"walk.not_transparent", {{"object", shaded()}}};
      return {"walk.transparent", {{"object", shaded()}, {"weight", decided.weight}}};
    }
    if (event.line == Line::follow_path) return {"walk.path_called", {}};
    if (event.line == Line::follow_photon) return {"walk.photon_called", {}};
    if (event.line == Line::gather_light) return {"walk.gather_called", {}};
    if (event.line == Line::while_photon)
      return decided.holds ? Message{"walk.photon_goes_on", {{"power", max_component(decided.weight)}}}
                           : Message{"walk.photon_over", {}};
    if (event.line == Line::if_diffuse)
      return {decided.holds ? "walk.photon_diffuse" : "walk.photon_not_diffuse",
              {{"object", object(current().object)}}};
    if (event.line == Line::gather_while_ray) {
      if (decided.holds) return {"walk.gather_goes_on", {{"ray", current().kind}}};
      return {"walk.gather_over", {{"colour", frame(timeline_.current_frame(position_)).returned}}};
    }
    if (event.line == Line::while_ray) {
      if (decided.holds) return {"walk.path_goes_on", {{"ray", current().kind}}};
      return {"walk.path_over", {{"colour", frame(timeline_.current_frame(position_)).returned}}};
    }
    if (event.line == Line::if_intersect_nothing || event.line == Line::gather_if_intersect_nothing) {
      if (decided.holds) return {"walk.path_met_nothing", {}};
      return {"walk.path_met", {{"object", object(current().object)}}};
    }
    return {};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const ShadeCalled& called) const {
    const RayRecord& record = current();
    if (called.missed) return {"walk.shade_missed", {{"ray", record.kind}, {"colour", called.background}}};
    // The lines of shadow rays run once per light: without lights, the walk skips them.
    const std::string_view id = scene_.lights.empty() ? "walk.shade_called_unlit" : "walk.shade_called";
    return {id, {{"depth", called.depth}, {"object", object(record.object)}, {"ray", record.kind}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const ShadeComputed& computed) const {
    const FrameRecord& own = frame(timeline_.current_frame(position_));
    if (own.parent < 0) return {"walk.rtnshade_to_main", {{"object", shaded()}, {"colour", computed.total}}};
    return {"walk.rtnshade_to_caller",
            {{"object", shaded()},
             {"colour", computed.total},
             {"ray", ray(own.ray).kind},
             {"depth", frame(own.parent).depth}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PixelPut& put) const {
    if (put.sample > 0) {
      const PixelRecord& pixel = timeline_.pixels()[static_cast<std::size_t>(timeline_.current_pixel(position_))];
      return {"walk.sample_put", {{"sample", put.sample + 1}, {"colour", put.shade}, {"mean", pixel.mean}}};
    }
    if (!timeline_.of_strip())
      return {"walk.image_pixel_put", {{"column", put.column}, {"row", put.row}, {"colour", put.shade}}};
    return {"walk.pixel_put", {{"cell", put.column}, {"colour", put.shade}}};
  }

  [[nodiscard]] Message describe(const Event& event, const BackgroundAdded& background) const {
    if (event.line == Line::gather_add_background && background.weight == 0) return {"walk.background_counted", {}};
    if (background.weight > nearly_all) return {"walk.background_added", {{"colour", background.added}}};
    return {"walk.background_weighted", {{"weight", Fraction{background.weight}}, {"colour", background.added}}};
  }

  [[nodiscard]] Message describe(const Event& event, const EmissionAdded& emission) const {
    if (is_black(emission.emission)) return {"walk.emits_nothing", {{"object", shaded()}}};
    if (event.line == Line::gather_add_emission && emission.weight == 0)
      return {"walk.emission_counted", {{"object", shaded()}}};
    if (emission.weight > nearly_all)
      return {"walk.emission_added", {{"object", shaded()}, {"colour", emission.added}}};
    return {"walk.emission_weighted",
            {{"object", shaded()}, {"weight", Fraction{emission.weight}}, {"colour", emission.added}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const LightAdded& added) const {
    const std::string name = added.light >= 0 ? light(added.light) : object(added.object);
    if (is_black(added.added)) return {"walk.light_adds_nothing", {}};
    if (added.light == light_of_sky && added.weight > nearly_all) return {"walk.sky_added", {{"colour", added.added}}};
    if (added.light == light_of_sky)
      return {"walk.sky_added_weighted", {{"weight", Fraction{added.weight}}, {"colour", added.added}}};
    if (added.weight > nearly_all) return {"walk.light_added", {{"light", name}, {"colour", added.added}}};
    return {"walk.light_added_weighted",
            {{"light", name}, {"weight", Fraction{added.weight}}, {"colour", added.added}}};
  }

  [[nodiscard]] Message describe(const Event& event, const DirectionChosen& chosen) const {
    if (event.line == Line::photon_choose_direction) {
      if (chosen.absorbed) return {"walk.photon_no_direction", {{"object", shaded()}}};
      return {photon_by_lobe(chosen.lobe, shaded_material()), {{"object", shaded()}}};
    }
    if (event.line == Line::gather_choose_direction && chosen.absorbed)
      return {"walk.gather_no_direction", {{"object", shaded()}}};
    if (chosen.absorbed) return {"walk.direction_none", {{"object", shaded()}}};
    const bool by_dipole = chosen.lobe == Lobe::diffuse && current().ending == Ending::scattered;
    return {by_dipole ? "walk.direction_leaves"
                      : by_lobe(chosen.lobe, shaded_material(), event.line == Line::choose_direction),
            {{"object", shaded()}, {"share", Fraction{max_component(chosen.throughput)}}}};
  }
  static std::string_view photon_by_lobe(Lobe lobe, const Material& material) {
    switch (lobe) {
      case Lobe::diffuse:
        return "walk.photon_diffused";
      case Lobe::highlight:
        return "walk.photon_in_highlight";
      case Lobe::mirror:
        return material.is_rough() ? "walk.photon_small_mirror" : "walk.photon_mirrored";
      case Lobe::transparent:
        return material.is_rough_glass() ? "walk.photon_small_facet" : "walk.photon_passed";
      case Lobe::phase:
        break;
    }
    return {};
  }
  static std::string_view by_lobe(Lobe lobe, const Material& material, bool by_path) {
    switch (lobe) {
      case Lobe::diffuse:
        return by_path && material.is_rough_diffuse() ? "walk.direction_rough_matt" : "walk.direction_diffuse";
      case Lobe::highlight:
        return "walk.direction_highlight";
      case Lobe::mirror:
        return material.is_rough() ? "walk.direction_small_mirror" : "walk.direction_mirror";
      case Lobe::transparent:
        return material.is_rough_glass() ? "walk.direction_small_facet" : "walk.direction_transparent";
      case Lobe::phase:
        return "walk.direction_scattered";
    }
    return {};
  }

  [[nodiscard]] Message describe(const Event& event, const SurvivalDecided& decided) const {
    if (event.line == Line::if_photon_survives) {
      if (decided.survives) return {"walk.photon_survives", {{"probability", Fraction{decided.survival}}}};
      return {decided.why ? "walk.photon_lost_roulette" : "walk.photon_absorbed", {{"object", shaded()}}};
    }
    if (event.line == Line::gather_if_path_survives && !decided.survives && !decided.why)
      return {"walk.gather_ends", {}};
    if (decided.why == Ending::path_length)
      return {"walk.path_too_long", {{"count", scene_.render.path_length.value_or(0)}}};
    if (decided.why == Ending::threshold)
      return {"walk.path_lost_roulette", {{"share", Fraction{max_component(current().throughput)}}}};
    if (!decided.survives) return {"walk.path_absorbed", {{"object", shaded()}}};
    if (decided.survival == 1) return {"walk.path_survives", {}};
    return {"walk.path_survives_roulette", {{"probability", Fraction{decided.survival}}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PhotonBegun& begun) const {
    if (begun.others > 0) return {"walk.photons_others", {{"count", begun.others}}};
    return {"walk.photon_begun", {{"number", begun.photon + 1}, {"count", begun.count}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PhotonStored& stored) const {
    switch (stored.history) {
      case PhotonHistory::direct:
        return {stored.kept ? "walk.photon_stored_direct" : "walk.photon_not_kept", {{"object", shaded()}}};
      case PhotonHistory::caustic:
        return {"walk.photon_stored_caustic", {{"object", shaded()}, {"power", max_component(stored.power)}}};
      case PhotonHistory::indirect:
        return {"walk.photon_stored", {{"object", shaded()}, {"power", max_component(stored.power)}}};
    }
    return {};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PhotonsFound& found) const {
    const bool caustic = found.caustic.count > 0, other = found.other.count > 0;
    if (!caustic && !other) return {"walk.no_photons", {{"object", shaded()}}};
    if (!caustic)
      return {found.other.at_limit ? "walk.photons_within" : "walk.photons_found",
              {{"count", found.other.count}, {"radius", found.other.radius}}};
    if (!other)
      return {found.caustic.at_limit ? "walk.caustic_within" : "walk.caustic_found",
              {{"count", found.caustic.count}, {"radius", found.caustic.radius}}};
    return {found.other.at_limit || found.caustic.at_limit ? "walk.both_within" : "walk.both_found",
            {{"count", found.other.count},
             {"radius", found.other.radius},
             {"caustic", found.caustic.count},
             {"caustic_radius", found.caustic.radius}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PhotonsAdded& photons) const {
    if (is_black(photons.added)) return {"walk.photons_add_nothing", {}};
    return {"walk.photons_added", {{"colour", photons.added}, {"object", shaded()}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PatchesMade& made) const {
    if (!made.lights) return {made.flat ? "walk.edges_cut" : "walk.patches_cut", {{"count", made.count}}};
    if (is_black(made.unshot)) return {"walk.patches_dark", {}};
    return {"walk.patches_lit", {{"colour", made.unshot}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const UnshotLight& light) const {
    if (light.holds) return {"walk.unshot_light", {{"share", Fraction{light.share}}}};
    return {"walk.unshot_rest", {{"shots", light.shots}, {"share", Fraction{light.share}}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PatchTaken& taken) const {
    return {"walk.patch_taken", {{"object", object(taken.object)}, {"share", Fraction{taken.share}}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PatchShot& shot) const {
    if (shot.others > 0) return {"walk.shots_others", {{"count", shot.others}, {"share", Fraction{shot.share}}}};
    return {shot.lights ? "walk.patch_shot" : "walk.patch_shoots",
            {{"object", object(shot.object)}, {"share", Fraction{shot.share}}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PatchInFront& front) const {
    return {"walk.patch_in_front", {{"object", object(front.object)}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const FormFactorFound& found) const {
    if (found.visible == 0) return {"walk.factor_blocked", {{"object", object(found.object)}}};
    return {found.visible < 1 ? "walk.factor_partly" : "walk.factor_found",
            {{"object", object(found.object)},
             {"factor", found.factor},
             {"difference", found.crossed - found.uncrossed},
             {"length", found.length},
             {"share", Fraction{found.visible}}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const LightArrived& arrived) const {
    if (is_black(arrived.arrived)) return {"walk.no_light_arrives", {{"object", object(arrived.object)}}};
    if (is_black(arrived.reflectance))
      return {"walk.light_absorbed", {{"object", object(arrived.object)}, {"colour", arrived.arrived}}};
    return {"walk.light_arrives",
            {{"object", object(arrived.object)},
             {"colour", arrived.arrived},
             {"share", Fraction{max_component(arrived.reflectance)}}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const PatchEmptied& emptied) const {
    return {"walk.patch_emptied", {{"object", object(emptied.object)}, {"share", Fraction{emptied.share}}}};
  }

  [[nodiscard]] Message describe(const Event& /*event*/, const LightLookedUp& looked) const {
    const int met = current().object;
    if (met < 0) return {"walk.looked_up_nothing", {{"colour", looked.shade}}};
    if (looked.patch < 0) return {"walk.looked_up_dark", {{"object", object(met)}, {"colour", looked.shade}}};
    return {"walk.looked_up", {{"object", object(met)}, {"irradiance", looked.irradiance}, {"colour", looked.shade}}};
  }
  // Told by beam_message, cone_message and pencil_message.
  [[nodiscard]] Message describe(const Event& /*event*/, const BeamFormed& /*formed*/) const { return {}; }
  [[nodiscard]] Message describe(const Event& /*event*/, const BeamCut& /*cut*/) const { return {}; }
  [[nodiscard]] Message describe(const Event& /*event*/, const PartBegun& /*begun*/) const { return {}; }
  [[nodiscard]] Message describe(const Event& /*event*/, const PartShaded& /*shaded*/) const { return {}; }
  [[nodiscard]] Message describe(const Event& /*event*/, const PartAdded& /*added*/) const { return {}; }
  [[nodiscard]] Message describe(const Event& /*event*/, const PencilChanged& /*changed*/) const { return {}; }

  static constexpr double nearly_all = 0.995;  ///< a weight that reads as 100%
  const Scene& scene_;
  const Timeline& timeline_;
  int position_;
};

}  // namespace

Message describe(const Scene& scene, const Timeline& timeline, int position) {
  return Describer(scene, timeline, position).message();
}

}  // namespace raywalk
