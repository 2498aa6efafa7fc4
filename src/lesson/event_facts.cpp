#include "lesson/facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace raywalk {

namespace {

std::string object_name(const Scene& scene, int index) { return scene.objects[static_cast<std::size_t>(index)].name; }
std::string light_name(const Scene& scene, int index) { return scene.lights[static_cast<std::size_t>(index)].name; }

/// What happened at a position, for the table below.
struct Moment {
  const Scene& scene;
  const Timeline& timeline;
  int position;
  const Event& event;

  template <class Detail>
  [[nodiscard]] const Detail* is() const {
    return std::get_if<Detail>(&event.detail);
  }
  /// The ray that the line is about; null if none.
  [[nodiscard]] const RayRecord* ray() const {
    const int index = timeline.current_ray(position);
    return index < 0 ? nullptr : &timeline.rays()[static_cast<std::size_t>(index)];
  }
};

template <class Numbers>
const Numbers* numbers_of(const Moment& at) {
  const auto* found = at.is<Found>();
  return found != nullptr ? std::get_if<Numbers>(&found->numbers) : nullptr;
}
template <class Numbers, class Member>
Value number(const Moment& at, Member member) {
  const Numbers* numbers = numbers_of<Numbers>(at);
  return numbers != nullptr && std::isfinite(numbers->*member) ? Value(numbers->*member) : Value(Nothing{});
}
const SnellNumbers* snell_of(const Moment& at) {
  const auto* formed = at.is<RayFormed>();
  return formed != nullptr && formed->snell ? &*formed->snell : nullptr;
}
template <class Of>
Value snell(const Moment& at, Of of) {
  const SnellNumbers* numbers = snell_of(at);
  return numbers != nullptr ? Value(of(*numbers)) : Value(Nothing{});
}
template <class Of>
Value shading(const Moment& at, Of of) {
  const auto* computed = at.is<ShadeComputed>();
  return computed != nullptr ? Value(of(*computed)) : Value(Nothing{});
}
/// A member common to the events of formed rays and rays not formed.
template <class Of>
Value spawned(const Moment& at, Of of) {
  if (const auto* formed = at.is<RayFormed>()) return of(*formed);
  if (const auto* stub = at.is<RayNotFormed>()) return of(*stub);
  return Nothing{};
}

Value kind_of(const Moment& at) {
  const Value own = spawned(at, [](const auto& ray) -> Value { return std::string(name_of(ray.kind)); });
  if (!std::holds_alternative<Nothing>(own)) return own;
  const RayRecord* ray = at.ray();
  return ray != nullptr ? Value(std::string(name_of(ray->kind))) : Value(Nothing{});
}

Value ending_of(const Moment& at) {
  if (const auto* found = at.is<Found>()) return std::string(name_of(found->ending));
  if (const auto* stub = at.is<RayNotFormed>()) return std::string(name_of(stub->why));
  if (const auto* decided = at.is<Decided>(); decided != nullptr && decided->why)
    return std::string(name_of(*decided->why));
  return Nothing{};
}

/// Of the patch that a line of radiosity is about.
const int* patch_object_of(const Moment& at) {
  const int* object = nullptr;
  std::visit(
      [&](const auto& detail) {
        using Detail = std::decay_t<decltype(detail)>;
        if constexpr (std::is_same_v<Detail, PatchTaken> || std::is_same_v<Detail, PatchShot> ||
                      std::is_same_v<Detail, PatchInFront> || std::is_same_v<Detail, FormFactorFound> ||
                      std::is_same_v<Detail, LightArrived> || std::is_same_v<Detail, PatchEmptied>)
          object = &detail.object;
      },
      at.event.detail);
  return object;
}

template <class Of>
Value factor(const Moment& at, Of of) {
  const auto* found = at.is<FormFactorFound>();
  return found != nullptr ? Value(of(*found)) : Value(Nothing{});
}

/// Of beam or cone tracing: the part that the line is about; null if none.
const RayRecord* part_of(const Moment& at) {
  const int part = at.timeline.has_width() ? at.timeline.part_of(at.timeline.current_ray(at.position)) : -1;
  return part < 0 ? nullptr : &at.timeline.rays()[static_cast<std::size_t>(part)];
}

/// For a search: what was hit. For a line of SHADE, or its call: what is shaded. For a part of a beam: what it sees.
Value object_of(const Moment& at) {
  if (const int* object = patch_object_of(at)) return object_name(at.scene, *object);
  const auto* found = at.is<Found>();
  if (const RayRecord* part = part_of(at); part != nullptr && found == nullptr)
    return part->object >= 0 ? Value(object_name(at.scene, part->object)) : Value(Nothing{});
  if (found != nullptr) return found->object >= 0 ? Value(object_name(at.scene, found->object)) : Value(Nothing{});
  const int frame = at.timeline.current_frame(at.position);
  const bool called = at.is<ShadeCalled>() != nullptr;
  if (frame < 0 && !called) return Nothing{};
  const int ray =
      called ? at.timeline.current_ray(at.position) : at.timeline.frames()[static_cast<std::size_t>(frame)].ray;
  const int object = at.timeline.rays()[static_cast<std::size_t>(ray)].object;
  return object >= 0 ? Value(object_name(at.scene, object)) : Value(Nothing{});
}

Value light_of(const Moment& at) {
  const Value own = spawned(at, [&](const auto& ray) -> Value {
    return ray.light >= 0 ? Value(light_name(at.scene, ray.light)) : Value(Nothing{});
  });
  if (!std::holds_alternative<Nothing>(own) || at.is<Found>() == nullptr || at.ray() == nullptr) return own;
  return at.ray()->light >= 0 ? Value(light_name(at.scene, at.ray()->light)) : Value(Nothing{});
}

template <class Of>
Value photons(const Moment& at, Of of) {
  const auto* found = at.is<PhotonsFound>();
  return found != nullptr ? Value(of(*found)) : Value(Nothing{});
}

Value pixel_of(const Moment& at, int PixelRecord::* member) {
  const int pixel = at.timeline.current_pixel(at.position);
  return pixel >= 0 ? Value(static_cast<double>(at.timeline.pixels()[static_cast<std::size_t>(pixel)].*member))
                    : Value(Nothing{});
}

Rgbd sum_of(const ShadeComputed& computed, Rgbd LightTerm::* term) {
  Rgbd sum(0.0);
  for (const LightTerm& light : computed.lights) sum += light.*term;
  return sum;
}

struct Fact {
  std::string_view name;
  Value (*of)(const Moment&);
};

constexpr std::array facts{
    Fact{"line", [](const Moment& at) -> Value { return std::string(pseudocode_of(at.event.line).text); }},
    Fact{"depth", [](const Moment& at) -> Value { return static_cast<double>(at.event.depth); }},
    Fact{"called_depth",
         [](const Moment& at) -> Value {
           const auto* called = at.is<ShadeCalled>();
           return called != nullptr ? Value(static_cast<double>(called->depth)) : Value(Nothing{});
         }},
    Fact{"kind", kind_of},
    Fact{"ending", ending_of},
    Fact{"object", object_of},
    Fact{"light", light_of},
    Fact{"cell", [](const Moment& at) { return pixel_of(at, &PixelRecord::column); }},
    Fact{"row", [](const Moment& at) { return pixel_of(at, &PixelRecord::row); }},
    Fact{"sample", [](const Moment& at) { return pixel_of(at, &PixelRecord::sample); }},
    Fact{"formed",
         [](const Moment& at) -> Value {
           if (at.is<RayFormed>() != nullptr) return true;
           return at.is<RayNotFormed>() != nullptr ? Value(false) : Value(Nothing{});
         }},
    Fact{"origin",
         [](const Moment& at) {
           if (const auto* beam = at.is<BeamFormed>()) return Value(beam->apex);
           return spawned(at, [](const auto& ray) -> Value { return ray.origin; });
         }},
    Fact{"direction",
         [](const Moment& at) { return spawned(at, [](const auto& ray) -> Value { return ray.direction; }); }},
    Fact{"share",
         [](const Moment& at) { return spawned(at, [](const auto& ray) -> Value { return ray.throughput; }); }},
    Fact{"t",
         [](const Moment& at) -> Value {
           const auto* found = at.is<Found>();
           return found != nullptr && found->object >= 0 ? Value(found->t) : Value(Nothing{});
         }},
    Fact{"point",
         [](const Moment& at) -> Value {
           const auto* found = at.is<Found>();
           return found != nullptr && found->object >= 0 ? Value(found->point) : Value(Nothing{});
         }},
    Fact{"normal",
         [](const Moment& at) -> Value {
           const auto* found = at.is<Found>();
           return found != nullptr && found->object >= 0 ? Value(found->normal) : Value(Nothing{});
         }},
    Fact{"a", [](const Moment& at) { return number<QuadraticNumbers>(at, &QuadraticNumbers::a); }},
    Fact{"b", [](const Moment& at) { return number<QuadraticNumbers>(at, &QuadraticNumbers::b); }},
    Fact{"c", [](const Moment& at) { return number<QuadraticNumbers>(at, &QuadraticNumbers::c); }},
    Fact{"discriminant",
         [](const Moment& at) { return number<QuadraticNumbers>(at, &QuadraticNumbers::discriminant); }},
    Fact{"t0", [](const Moment& at) { return number<QuadraticNumbers>(at, &QuadraticNumbers::t0); }},
    Fact{"t1", [](const Moment& at) { return number<QuadraticNumbers>(at, &QuadraticNumbers::t1); }},
    Fact{"numerator", [](const Moment& at) { return number<PlaneNumbers>(at, &PlaneNumbers::numerator); }},
    Fact{"denominator", [](const Moment& at) { return number<PlaneNumbers>(at, &PlaneNumbers::denominator); }},
    Fact{"n1", [](const Moment& at) { return snell(at, [](const SnellNumbers& s) { return s.n1; }); }},
    Fact{"n2", [](const Moment& at) { return snell(at, [](const SnellNumbers& s) { return s.n2; }); }},
    Fact{"fresnel", [](const Moment& at) { return snell(at, [](const SnellNumbers& s) { return s.fresnel; }); }},
    Fact{"angle_in",
         [](const Moment& at) {
           return snell(at, [](const SnellNumbers& s) { return std::acos(std::min(s.cos_in, 1.0)) / degree; });
         }},
    Fact{"angle_out",
         [](const Moment& at) {
           return snell(at, [](const SnellNumbers& s) { return std::acos(std::min(s.cos_out, 1.0)) / degree; });
         }},
    Fact{"holds",
         [](const Moment& at) -> Value {
           if (const auto* unshot = at.is<UnshotLight>()) return unshot->holds;
           const auto* decided = at.is<Decided>();
           return decided != nullptr ? Value(decided->holds) : Value(Nothing{});
         }},
    Fact{"weight",
         [](const Moment& at) -> Value {
           const auto* decided = at.is<Decided>();
           return decided != nullptr ? Value(decided->weight) : Value(Nothing{});
         }},
    Fact{"ambient", [](const Moment& at) { return shading(at, [](const ShadeComputed& s) { return s.ambient; }); }},
    Fact{"emission", [](const Moment& at) { return shading(at, [](const ShadeComputed& s) { return s.emission; }); }},
    Fact{"diffuse",
         [](const Moment& at) {
           return shading(at, [](const ShadeComputed& s) { return sum_of(s, &LightTerm::diffuse); });
         }},
    Fact{"specular",
         [](const Moment& at) {
           return shading(at, [](const ShadeComputed& s) { return sum_of(s, &LightTerm::specular); });
         }},
    Fact{"reflected", [](const Moment& at) { return shading(at, [](const ShadeComputed& s) { return s.reflect; }); }},
    Fact{"refracted", [](const Moment& at) { return shading(at, [](const ShadeComputed& s) { return s.refract; }); }},
    Fact{"total", [](const Moment& at) { return shading(at, [](const ShadeComputed& s) { return s.total; }); }},
    Fact{"shade",
         [](const Moment& at) -> Value {
           const auto* put = at.is<PixelPut>();
           return put != nullptr ? Value(put->shade) : Value(Nothing{});
         }},
    Fact{"history",
         [](const Moment& at) -> Value {
           const auto* stored = at.is<PhotonStored>();
           return stored != nullptr ? Value(std::string(name_of(stored->history))) : Value(Nothing{});
         }},
    Fact{"power",
         [](const Moment& at) -> Value {
           const auto* stored = at.is<PhotonStored>();
           return stored != nullptr ? Value(stored->power) : Value(Nothing{});
         }},
    Fact{"survival",
         [](const Moment& at) -> Value {
           const auto* decided = at.is<SurvivalDecided>();
           return decided != nullptr ? Value(decided->survival) : Value(Nothing{});
         }},
    Fact{"coverage",
         [](const Moment& at) -> Value {
           const auto* begun = at.is<PartBegun>();
           return begun != nullptr ? Value(begun->coverage) : Value(Nothing{});
         }},
    Fact{"parts",
         [](const Moment& at) -> Value {
           const auto* cut = at.is<BeamCut>();
           return cut != nullptr ? Value(static_cast<double>(cut->pieces.size())) : Value(Nothing{});
         }},
    Fact{"spread",
         [](const Moment& at) -> Value {
           const auto* cone = at.is<BeamFormed>();
           return cone != nullptr && at.timeline.of_cones() ? Value(cone->spread) : Value(Nothing{});
         }},
    Fact{"part_shade",
         [](const Moment& at) -> Value {
           const auto* added = at.is<PartAdded>();
           return added != nullptr ? Value(added->shade) : Value(Nothing{});
         }},
    Fact{"caustic_inside",
         [](const Moment& at) { return photons(at, [](const PhotonsFound& f) { return 1.0 * f.caustic.count; }); }},
    Fact{"caustic_radius",
         [](const Moment& at) { return photons(at, [](const PhotonsFound& f) { return f.caustic.radius; }); }},
    Fact{"other_inside",
         [](const Moment& at) { return photons(at, [](const PhotonsFound& f) { return 1.0 * f.other.count; }); }},
    Fact{"other_radius",
         [](const Moment& at) { return photons(at, [](const PhotonsFound& f) { return f.other.radius; }); }},
    Fact{"caustic_light",
         [](const Moment& at) { return photons(at, [](const PhotonsFound& f) { return f.caustic.irradiance; }); }},
    Fact{"other_light",
         [](const Moment& at) { return photons(at, [](const PhotonsFound& f) { return f.other.irradiance; }); }},
    Fact{"factor", [](const Moment& at) { return factor(at, [](const FormFactorFound& f) { return f.factor; }); }},
    Fact{"crossed", [](const Moment& at) { return factor(at, [](const FormFactorFound& f) { return f.crossed; }); }},
    Fact{"uncrossed",
         [](const Moment& at) { return factor(at, [](const FormFactorFound& f) { return f.uncrossed; }); }},
    Fact{"visible", [](const Moment& at) { return factor(at, [](const FormFactorFound& f) { return f.visible; }); }},
    Fact{"arrived",
         [](const Moment& at) -> Value {
           const auto* arrived = at.is<LightArrived>();
           return arrived != nullptr ? Value(arrived->arrived) : Value(Nothing{});
         }},
    Fact{"patches",
         [](const Moment& at) -> Value {
           const auto* made = at.is<PatchesMade>();
           return made != nullptr ? Value(1.0 * made->count) : Value(Nothing{});
         }},
    Fact{"shots",
         [](const Moment& at) -> Value {
           const auto* unshot = at.is<UnshotLight>();
           return unshot != nullptr ? Value(1.0 * unshot->shots) : Value(Nothing{});
         }},
    Fact{"unshot",
         [](const Moment& at) -> Value {
           return at.timeline.of_radiosity() ? Value(at.timeline.unshot_at(at.position)) : Value(Nothing{});
         }},
};

}  // namespace

std::optional<Value> event_fact(const Scene& scene, const Timeline& timeline, int position, std::string_view name) {
  const auto fact = std::find_if(facts.begin(), facts.end(), [&](const Fact& each) { return each.name == name; });
  if (fact == facts.end()) return std::nullopt;
  if (position == 0) return Nothing{};
  return fact->of({scene, timeline, position, *timeline.just_run(position)});
}

}  // namespace raywalk
