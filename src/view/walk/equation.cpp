#include "view/walk/equation.h"

#include "scene/metals.h"
#include "trace/microfacets.h"
#include "trace/optics.h"
#include "view/text/shown.h"
#include "view/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace raywalk {

namespace {

using Kind = EquationRow::Kind;

/// A text between signs and letters, which are independent of language.
struct Word {
  std::string_view id;
};

double angle_between(const Vec3d& u, const Vec3d& v) {
  const double sizes = length(u) * length(v);
  return sizes > 0 ? angle_of_cosine(dot(u, v) / sizes) : 0;
}

/// Writes the rows of one event. A row's numbers go through number(), so that what is shown is what is kept.
class EquationWriter {
 public:
  explicit EquationWriter(const State& state) : state_(state), timeline_(*state.walk.timeline) {}

  [[nodiscard]] EquationPanel panel() {
    const Event* event = timeline_.just_run(state_.walk.position);
    if (event == nullptr) return {};
    event_ = event;
    panel_.title = text(event->line, state_.appearance.code_language());
    std::visit([&](const auto& detail) { write(detail); }, event->detail);
    if (const auto* formed = std::get_if<RayFormed>(&event->detail); formed != nullptr) write_pencil();
    return std::move(panel_);
  }

 private:
  // ---- Rows

  /// The current row: text and numbers in turn.
  class Row {
   public:
    Row(Kind kind, Language language) : language_(language) { row_.kind = kind; }
    Row& operator<<(std::string_view text) {
      row_.text += text;
      return *this;
    }
    Row& operator<<(const Word& word) { return *this << text(word.id, language_); }
    Row& operator<<(double value) {
      row_.text += equation_number(value, language_);
      row_.values.push_back(value);
      return *this;
    }
    /// In a planar scene two components suffice.
    Row& operator<<(const Vec3d& v) {
      const std::string_view between = language_.separator();
      *this << "(" << v.x << between << v.y;
      if (v.z != 0) *this << between << v.z;
      return *this << ")";
    }
    [[nodiscard]] EquationRow take() { return std::move(row_); }

   private:
    Language language_;
    EquationRow row_;
  };
  template <class... Parts>
  void row(Kind kind, const Parts&... parts) {
    Row row(kind, state_.appearance.language);
    static_cast<void>((row << ... << parts));
    panel_.rows.push_back(row.take());
  }
  /// `name`: in one piece or several.
  template <class... Name>
  void light(Kind kind, const Rgbd& colour, const Name&... name) {
    Row row(kind, state_.appearance.language);
    static_cast<void>((row << ... << name));
    row << " ";
    const std::string_view between = state_.appearance.language.separator();
    if (colour.x == colour.y && colour.y == colour.z)
      row << colour.x;
    else
      row << "(" << colour.x << between << colour.y << between << colour.z << ")";
    panel_.rows.push_back(row.take());
    panel_.rows.back().light = colour;
  }

  // ---- What the rows speak of

  [[nodiscard]] const Scene& scene() const { return state_.scene(); }
  [[nodiscard]] const RayRecord& ray(int index) const { return timeline_.rays()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const RayRecord& current() const { return ray(timeline_.current_ray(state_.walk.position)); }
  [[nodiscard]] const RayRecord* parent() const { return current().parent < 0 ? nullptr : &ray(current().parent); }
  /// The normal that the hit of `ray` was shaded with; 0 where it was scattered, without a surface.
  static const Vec3d& shaded_by(const RayRecord& ray) { return ray.shaded.shading; }
  [[nodiscard]] std::string light_name(int light) const {
    return light < 0 ? std::string() : raywalk::light_name(state_, light);
  }

  void line(std::string_view origin, const Vec3d& from, std::string_view direction, const Vec3d& along) {
    row(Kind::formula, "P(t) = ", origin, " + t ", direction);
    row(Kind::numbers, origin, " = ", from);
    row(Kind::numbers, direction, " = ", along);
  }

  // ---- Events

  void write(const PixelBegun& begun) {
    if (timeline_.of_strip())
      row(Kind::numbers, Word{"equation.pixel"}, " ", static_cast<double>(begun.column), " (0 \u2013 ",
          static_cast<double>(scene().camera.screen.cells - 1), ")");
    else
      row(Kind::numbers, Word{"equation.pixel"}, " ", static_cast<double>(begun.column), ", ",
          static_cast<double>(begun.row));
  }

  void write(const RayFormed& formed) {
    switch (formed.kind) {
      case RayKind::primary:
        line(text("object.eye", state_.appearance.language), formed.origin, "D", formed.direction);
        return row(Kind::note, Word{"equation.unit_direction"});
      case RayKind::shadow:
        return shadow(formed);
      case RayKind::reflect:
        if (event_->line == Line::form_next_ray) return line("P", formed.origin, "D", formed.direction);
        return reflect(formed);
      case RayKind::refract:
        if (event_->line == Line::form_next_ray) return line("P", formed.origin, "D", formed.direction);
        return refract(formed);
      case RayKind::photon:
        line("P", formed.origin, "D", formed.direction);
        return light(Kind::numbers, formed.throughput, "Φ = ");
      case RayKind::beam:
        return;
    }
  }

  void shadow(const RayFormed& formed) {
    line("P", formed.origin, "L", formed.direction);
    if (formed.light_at_end) row(Kind::note, light_name(formed.light), " ", Word{"equation.stands_at"}, " t = ", 1.0);
    if (parent() == nullptr || shaded_by(*parent()) == Vec3d(0.0)) return;
    const Vec3d& normal = shaded_by(*parent());
    row(Kind::formula, "cos θ = N·L / |L|");
    row(Kind::numbers, "N = ", normal, state_.appearance.language.separator(), "|L| = ", length(formed.direction));
    row(Kind::numbers, "θ = ", angle_between(normal, formed.direction), "°");
  }

  void reflect(const RayFormed& formed) {
    if (parent() == nullptr) return;
    const Vec3d &normal = shaded_by(*parent()), &in = parent()->direction;
    // Of a rough mirror, the direction is that of a small mirror between both.
    constexpr double rounding = 1e-9;
    const int object = parent()->object;
    const Material* material = object < 0 ? nullptr : &scene().objects[static_cast<std::size_t>(object)].material;
    const bool is_mirrored = length(normalize(raywalk::reflect(in, normal)) - formed.direction) <= rounding;
    const bool drawn = !is_mirrored && material != nullptr && (material->is_glossy() || material->is_rough());
    const Vec3d mirror = drawn ? normalize(formed.direction - in) : normal;
    const std::string_view letter = drawn ? "H" : "N";
    row(Kind::formula, "R = D − 2 (", letter, "·D) ", letter);
    row(Kind::numbers, "D = ", in);
    row(Kind::numbers, letter, " = ", mirror, state_.appearance.language.separator(), letter, "·D = ", dot(mirror, in));
    row(Kind::numbers, "R = ", formed.direction);
    if (drawn)
      row(Kind::note, Word{"equation.small_mirror"});
    else if (is_mirrored)  // by a faulty line it is not
      row(Kind::note, Word{"equation.as_far_from_normal"}, " ", angle_between(normal, formed.direction), "°");
    if (material == nullptr || !material->is_metal()) return;
    const auto [eta, k] = refractive_index(material->mirror);
    row(Kind::formula, Word{"equation.fresnel"});
    row(Kind::numbers, "F = ", Conductor<double>{eta, k}.reflectance(std::clamp(-dot(mirror, in), 0.0, 1.0)));
  }

  void refract(const RayFormed& formed) {
    if (!formed.snell) return line("P", formed.origin, "T", formed.direction);
    const SnellNumbers& s = *formed.snell;
    if (parent() != nullptr && parent()->object >= 0 &&
        scene().objects[static_cast<std::size_t>(parent()->object)].material.is_rough_glass()) {
      // Of rough glass, these are the angles at a small facet, which turns one direction into the other.
      const Vec3d along = normalize(s.n2 * formed.direction - s.n1 * normalize(parent()->direction));
      const Vec3d facet = dot(along, parent()->direction) < 0 ? along : -along;
      constexpr double rounding = 1e-9;
      if (length(facet - shaded_by(*parent())) > rounding) {
        row(Kind::numbers, "H = ", facet);
        row(Kind::note, Word{"equation.small_facet"});
      }
    }
    row(Kind::formula, "n₁ ", Word{"equation.sine"}, " θ₁ = n₂ ", Word{"equation.sine"}, " θ₂");
    row(Kind::numbers, s.n1, " · ", Word{"equation.sine"}, " ", angle_of_cosine(s.cos_in), "° = ", s.n2, " · ",
        Word{"equation.sine"}, " ", angle_of_cosine(s.cos_out), "°");
    row(Kind::note, s.n2 > s.n1   ? Word{"equation.slower_beyond"}
                    : s.n2 < s.n1 ? Word{"equation.faster_beyond"}
                                  : Word{"equation.as_fast_beyond"});
    const int object = parent() == nullptr ? -1 : parent()->object;
    if (object >= 0 && scene().objects[static_cast<std::size_t>(object)].material.dielectric) {
      row(Kind::formula, Word{"equation.fresnel"});
      row(Kind::numbers, "F = ", s.fresnel);
    }
    row(Kind::numbers, "T = ", formed.direction);
  }

  void write(const RayNotFormed& stub) {
    switch (stub.why) {
      case Ending::depth: {
        // The ray that would have formed it is the deepest that may be, whatever limits the depth.
        const double deepest = event_->depth;
        row(Kind::formula, Word{"equation.depth_allowed"});
        row(Kind::numbers, deepest, " + ", 1.0, " > ", deepest);
        return row(Kind::note, Word{"equation.no_ray"});
      }
      case Ending::threshold:
        row(Kind::formula, Word{"equation.share_allowed"});
        row(Kind::numbers, max_component(stub.throughput), " < ", scene().limits.threshold);
        return row(Kind::note, Word{"equation.no_ray"});
      case Ending::facing_away:
        return facing_away(stub.direction);
      case Ending::outside_cone:
        return row(Kind::note, Word{"equation.spot_elsewhere"});
      case Ending::wrong_side:
        return row(Kind::note, Word{"equation.facet_elsewhere"});
      case Ending::path_length:
      case Ending::total_internal_reflection:
      case Ending::hit:
      case Ending::missed:
      case Ending::blocked:
      case Ending::reached_light:
      case Ending::scattered:
        return;
    }
  }

  /// Of no length: none was drawn on the light.
  void facing_away(const Vec3d& to_light) {
    row(Kind::formula, "N·L > 0?");
    if (parent() == nullptr || shaded_by(*parent()) == Vec3d(0.0) || to_light == Vec3d(0.0))
      return row(Kind::note, Word{"equation.light_behind"});
    const Vec3d& normal = shaded_by(*parent());
    const std::optional<Vec3d>& own = parent()->shaded.geometric;
    const double angle = angle_between(normal, to_light);
    const auto behind = [&](std::string_view name, double degrees) {
      row(Kind::numbers, name, " = ", degrees, "° ≥ ", 90.0, "°");
    };
    if (!(dot(normal, to_light) > 0)) {
      behind("θ", angle);
    } else if (own && !(dot(*own, to_light) > 0)) {
      row(Kind::numbers, "θ = ", angle, "° < ", 90.0, "°");
      row(Kind::numbers, "N′ = ", *own);
      behind("θ′", angle_between(*own, to_light));
      return row(Kind::note, Word{"equation.light_behind_itself"});
    } else {  // a faulty line says so, or nothing is scattered that way
      row(Kind::numbers, "θ = ", angle, "°");
    }
    row(Kind::note, Word{"equation.light_behind"});
  }

  void write(const Found& found) {
    const bool shadow = current().kind == RayKind::shadow;
    if (found.object < 0)
      row(Kind::note, !shadow                            ? Word{"equation.nothing_ahead"}
                      : found.transmittance == Rgbd(1.0) ? Word{"equation.nothing_between"}
                                                         : Word{"equation.filters_between"});
    std::visit([&](const auto& numbers) { solve(numbers, found.t); }, found.numbers);
    if (found.object < 0) return;
    const std::string_view between = state_.appearance.language.separator();
    row(Kind::formula, shadow ? "P = P₀ + t L" : "P = O + t D");
    row(Kind::numbers, "P = ", found.point, between, "t = ", found.t);
    if (shadow) return row(Kind::note, Word{"equation.blocked_before"});
    const Vec3d& normal = shaded_by(current());
    if (normal == Vec3d(0.0)) return;
    if (found.ending != Ending::hit) return row(Kind::numbers, "N = ", normal);
    row(Kind::numbers, "N = ", normal, between, "θ = ", angle_between(normal, -current().direction), "°");
    if (dot(normal, found.normal) < 0) row(Kind::note, Word{"equation.normal_turned"});
    if (current().outward_shading_normal() != found.normal) row(Kind::note, Word{"equation.normal_leaned"});
  }

  void solve(const std::monostate& /*none*/, double /*t*/) {}
  void solve(const QuadraticNumbers& q, double t) {
    row(Kind::formula, "a t² + b t + c = 0");
    const std::string_view between = state_.appearance.language.separator();
    row(Kind::numbers, "a = ", q.a, between, "b = ", q.b, between, "c = ", q.c);
    row(Kind::numbers, "b² − 4 a c = ", q.discriminant);
    if (!(q.discriminant >= 0)) return;
    row(Kind::formula, "t = (−b ± √(b² − 4 a c)) / 2 a");
    row(Kind::numbers, "t₀ = ", q.t0, between, "t₁ = ", q.t1);
    const auto is = [&](double root) { return std::abs(t - root) <= 1e-9 * std::max(std::abs(t), std::abs(root)); };
    if (is(q.t0)) return row(Kind::note, Word{"equation.nearer_root"});
    constexpr double nearly_zero = 1e-9;
    if (is(q.t1))
      row(Kind::note, q.t0 < -nearly_zero   ? Word{"equation.other_root_behind"}
                      : q.t0 <= nearly_zero ? Word{"equation.other_root_is_start"}
                                            : Word{"equation.other_root_cut_off"});
  }
  void solve(const PlaneNumbers& p, double /*t*/) {
    if (!std::isfinite(p.numerator)) return;
    row(Kind::formula, "t = N·(A − O) / N·D");
    row(Kind::numbers, "t = ", p.numerator, " / ", p.denominator);
  }

  void solve(const SkyNumbers& sky, double /*t*/) {
    light(Kind::term, sky.radiance, Word{"equation.sky"}, " =");
    row(Kind::numbers, "p(", Word{"equation.sky"}, ") = ", sky.pdf);
  }

  void solve(const DipoleNumbers& dipole, double /*t*/) {
    row(Kind::formula, "Rd(r) = α′ / 4π · Σ z (1 + σ d) exp(−σ d) / d³");
    row(Kind::numbers, "r = ", dipole.distance);
    light(Kind::term, dipole.reflectance, "Rd(r) =");
    light(Kind::term, dipole.total, "Rd =");
  }

  void write(const Decided& decided) {
    const Line line = without_pencil(event_->line);
    const bool transparent = line == Line::if_transparent;
    if (line != Line::if_reflective && !transparent)
      return row(Kind::note, decided.holds ? Word{"equation.yes"} : Word{"equation.no"});
    light(Kind::term, decided.weight, transparent ? "kt′ =" : "kr′ =");
    if (!decided.why) return row(Kind::note, decided.holds ? Word{"equation.above_zero"} : Word{"equation.is_zero"});
    // No transmission: Snell's law requires a sine above 1.
    const RayRecord& shaded =
        ray(timeline_.frames()[static_cast<std::size_t>(timeline_.current_frame(state_.walk.position))].ray);
    const double angle = angle_between(shaded_by(shaded), -shaded.direction);
    row(Kind::formula, Word{"equation.sine"}, " θ₂ = n₁ ", Word{"equation.sine"}, " θ₁ / n₂");
    if (decided.snell)
      row(Kind::numbers, decided.snell->n1, " · ", Word{"equation.sine"}, " ", angle, "° / ", decided.snell->n2, " > ",
          1.0);
    row(Kind::note, Word{"equation.no_such_angle"});
  }

  void write(const ShadeCalled& called) {
    if (called.missed) return light(Kind::total, called.background, Word{"equation.background"}, " =");
    row(Kind::numbers, "DEPTH = ", static_cast<double>(called.depth));
  }

  /// What the surface and the lights bring.
  void terms(const auto& sum) {
    light(Kind::term, sum.ambient, Word{"equation.ambient"});
    if (sum.emission != Rgbd(0.0)) light(Kind::term, sum.emission, "+ ", Word{"equation.emission"});
    for (const LightTerm& term : sum.lights) {
      light(Kind::term, term.diffuse, "+ ", light_name(term.light), ", ", Word{"equation.diffuse"});
      if (term.specular != Rgbd(0.0))
        light(Kind::term, term.specular, "+ ", light_name(term.light), ", ", Word{"equation.highlight"});
    }
  }
  void write(const ShadeComputed& sum) {
    if (sum.irradiance) {
      row(Kind::formula, Word{"equation.ambient"}, " = kd / π · E");
      light(Kind::term, *sum.irradiance, "E =");
    }
    terms(sum);
    if (sum.reflect != Rgbd(0.0)) light(Kind::term, sum.reflect, "+ kr′ · REFLSHADE");
    if (sum.refract != Rgbd(0.0)) light(Kind::term, sum.refract, "+ kt′ · REFRSHADE");
    if (sum.transmittance != Rgbd(1.0)) light(Kind::note, sum.transmittance, Word{"equation.passed"});
    light(Kind::total, sum.total, "= RTNSHADE");
  }

  void write(const PixelPut& put) { light(Kind::total, put.shade, "final ="); }

  // ---- Path tracing

  void write(const BackgroundAdded& background) {
    if (background.light_pdf > 0) weighted(background.direction_pdf, background.light_pdf, background.weight);
    light(Kind::total, background.added, "+ ", Word{"equation.background"});
  }
  void write(const EmissionAdded& emission) {
    light(Kind::term, emission.emission, Word{"equation.emission"});
    if (emission.emission == Rgbd(0.0)) return;
    weighted(emission.direction_pdf, emission.light_pdf, emission.weight);
    light(Kind::total, emission.added, "+ ", Word{"equation.weight"}, " · ", Word{"equation.share"}, " · ",
          Word{"equation.emission"}, " =");
  }
  void write(const LightAdded& added) {
    weighted(added.direction_pdf, added.light_pdf, added.weight);
    light(Kind::total, added.added, "+");
  }
  void weighted(double by_direction, double by_light, double weight) {
    if (by_direction == 0 && by_light == 0) return;  // no choice could have found it
    row(Kind::numbers, "p(", Word{"equation.direction"}, ") = ", by_direction, state_.appearance.language.separator(),
        "p(", Word{"equation.light"}, ") = ", by_light);
    row(Kind::numbers, Word{"equation.weight"}, " = ", weight);
  }
  void write(const DirectionChosen& chosen) {
    if (chosen.absorbed) return row(Kind::note, Word{"equation.absorbed"});
    row(Kind::numbers, "D = ", chosen.direction);
    if (chosen.pdf > 0) row(Kind::numbers, "p(D) = ", chosen.pdf);
    light(Kind::term, chosen.throughput, Word{"equation.share_left"}, " =");
  }
  void write(const SurvivalDecided& decided) {
    if (decided.survival < 1) row(Kind::numbers, Word{"equation.survival"}, " ", decided.survival);
    row(Kind::note, decided.survives ? Word{"equation.yes"} : Word{"equation.no"});
  }

  // ---- Photon mapping

  void write(const PhotonBegun& begun) {
    row(Kind::numbers, static_cast<double>(begun.photon + 1), " ", Word{"equation.of"}, " ",
        static_cast<double>(begun.count));
  }
  void write(const PhotonStored& stored) {
    row(Kind::numbers, "P = ", stored.position);
    row(Kind::numbers, "N = ", stored.normal);
    light(Kind::term, stored.power, "Φ =");
  }
  void write(const PhotonsFound& found) {
    if (found.caustic.radius > 0) circle(found.caustic, Word{"equation.caustic"}, found.flat);
    if (found.other.radius > 0) circle(found.other, Word{"equation.indirect"}, found.flat);
  }
  /// The photon that marks the circle is not among those whose power is added up.
  void circle(const PhotonCircle& of, const Word& name, bool flat) {
    row(Kind::note, name);
    row(Kind::numbers, "n = ", static_cast<double>(of.count), state_.appearance.language.separator(),
        "r = ", of.radius);
    row(Kind::formula, flat ? "E = ΣΦ / 2 r" : "E = ΣΦ / π r²");
    light(Kind::term, of.power, "ΣΦ =");
    light(Kind::term, of.irradiance, "E =");
  }
  void write(const PhotonsAdded& photons) {
    row(Kind::formula, photons.flat ? "kd / 2 · E" : "kd / π · E");
    light(Kind::term, photons.albedo, "kd =");
    light(Kind::term, photons.irradiance, "E =");
    light(Kind::total, photons.added, "+");
  }

  // ---- Radiosity

  void write(const PatchesMade& made) {
    row(Kind::numbers, "n = ", static_cast<double>(made.count));
    if (made.lights) light(Kind::term, made.unshot, made.flat ? "Σ L B =" : "Σ A B =");
  }
  void write(const UnshotLight& unshot) {
    row(Kind::numbers, unshot.share, unshot.share > unshot.tolerance ? " > " : " ≤ ", unshot.tolerance);
    row(Kind::note, unshot.holds ? Word{"equation.yes"} : Word{"equation.no"});
  }
  void write(const PatchTaken& taken) { light(Kind::term, taken.radiosity, "B ="); }
  void write(const PatchShot& /*shot*/) {}
  void write(const PatchInFront& /*front*/) {}
  void write(const FormFactorFound& found) {
    row(Kind::formula, "F = (X − U) / 2 L");
    row(Kind::numbers, "X = ", found.crossed, " ", Word{"equation.crossed"});
    row(Kind::numbers, "U = ", found.uncrossed, " ", Word{"equation.uncrossed"});
    row(Kind::numbers, "X − U = ", found.crossed - found.uncrossed);
    row(Kind::numbers, "L = ", found.length);
    row(Kind::numbers, "F = ", found.factor);
    if (found.visible < 1) row(Kind::numbers, "V = ", found.visible, " ", Word{"equation.visible"});
  }
  void write(const LightArrived& arrived) {
    row(Kind::formula, "ΔE = F V B L / L′");
    light(Kind::term, arrived.arrived, "ΔE =");
    light(Kind::term, arrived.reflectance, "kd =");
    light(Kind::term, arrived.light.unshot, "B =");
  }
  void write(const PatchEmptied& emptied) { light(Kind::total, emptied.light.unshot, "B ="); }
  void write(const LightLookedUp& looked) {
    if (looked.patch >= 0) {
      row(Kind::formula, looked.flat ? "kd / 2 · E + Le" : "kd / π · E + Le");
      light(Kind::term, looked.albedo, "kd =");
      light(Kind::term, looked.irradiance, "E =");
      light(Kind::term, looked.emission, "Le =");
    }
    light(Kind::total, looked.shade, "=");
  }

  // ---- Pencils

  /// While they are shown: where a ray of EYE starts beside the one just formed, y, and how it slopes against it, s.
  void write_pencil() {
    const int ray = timeline_.current_ray(state_.walk.position);
    for (const Pencil& pencil : state_.pencil.pencils) {
      if (pencil.ray != ray) continue;
      const PencilStage& stage = pencil.stages.back();
      row(Kind::formula, "y′ = a y + b s,  s′ = c y + d s");
      matrix(stage.start);
      if (stage.focus && pencil.stages.size() > 1) row(Kind::total, "f = −b / d = ", *stage.focus);
    }
  }

  void matrix(const PencilMatrix& m) {
    row(Kind::numbers, "a = ", m.a, "  b = ", m.b);
    row(Kind::numbers, "c = ", m.c, "  d = ", m.d);
  }
  /// In PENCIL TRACING: in the plan by what it was multiplied, and what it is now.
  void write(const PencilChanged& changed) {
    if (!changed.system) return;
    const bool transfers = event_->line == Line::transfer_pencil;
    const PencilSystem& M = *changed.system;
    const bool in_plan = timeline_.of_strip() && M.is_unmixed();
    const std::string_view by = transfers ? "T" : event_->line == Line::reflect_pencil ? "R" : "S";
    row(Kind::formula, "M′ = ", by, " M");
    if (in_plan) {
      const PencilMatrix step = step_of(changed, event_->line);
      row(Kind::numbers, by, " = [", step.a, "  ", step.b, " ;  ", step.c, "  ", step.d, "]");
    }
    if (transfers)
      row(Kind::numbers, "t = ", changed.along);
    else
      row(Kind::numbers, "1 / r = ", changed.curvature, "  θ = ", angle_of_cosine(changed.cos_in), "°");
    if (in_plan) {
      row(Kind::formula, "y′ = a y + b s,  s′ = c y + d s");
      matrix(M.plan);
      const std::optional<double> focus = focus_of_point(M.plan);
      if (focus && !transfers) row(Kind::total, "f = −b / d = ", *focus);
      return;
    }
    // Of offsets and slopes to the left, and of those up.
    const auto rows = [&](const PencilMatrix& left, const PencilMatrix& right) {
      row(Kind::numbers, left.a, "  ", left.b, "  ", right.a, "  ", right.b);
      row(Kind::numbers, left.c, "  ", left.d, "  ", right.c, "  ", right.d);
    };
    row(Kind::formula, "(y, s, z, q)′ = M (y, s, z, q)");
    rows(M.plan, M.left_from_up);
    rows(M.up_from_left, M.across);
    if (transfers) return;
    for (const std::optional<double>& focus : foci_of_point(M))
      if (focus) row(Kind::total, "f = ", *focus);
  }

  // ---- Beam and cone tracing

  void write(const BeamFormed& formed) {
    if (timeline_.of_cones()) {
      row(Kind::formula, "r(t) = r₀ + s t");
      row(Kind::numbers, "r₀ = ", formed.radius);
      row(Kind::total, "s = ", formed.spread);
      return;
    }
    if (timeline_.is_flat()) row(Kind::formula, "D(x) = D₀ + x (D₁ − D₀)");
    row(Kind::numbers, text("object.eye", state_.appearance.language), formed.parent < 0 ? " = " : "′ = ", formed.apex);
    places(formed.begin, formed.end);
  }
  void places(double begin, double end) {
    if (timeline_.is_flat()) row(Kind::numbers, begin, " ≤ x ≤ ", end);
  }
  void write(const BeamCut& cut) {
    for (const BeamPiece& piece : cut.pieces)
      row(Kind::note, piece.object < 0 ? std::string(text("equation.background", state_.appearance.language))
                                       : object_name(state_, piece.object));
  }
  void write(const PartBegun& begun) {
    if (timeline_.of_cones()) return row(Kind::total, Word{"equation.of_cone"}, " = ", begun.coverage);
    const BeamRecord& part = timeline_.beams()[static_cast<std::size_t>(current().beam)];
    places(part.begin, part.end);
    if (timeline_.is_flat()) row(Kind::formula, Word{"equation.coverage"}, " = x₁ − x₀");
    row(Kind::total, Word{"equation.coverage"}, " = ", begun.coverage);
  }
  void write(const PartShaded& sum) {
    terms(sum);
    light(Kind::total, sum.total, "=");
  }
  void write(const PartAdded& added) {
    light(Kind::term, added.local, Word{"equation.in_the_middle"});
    if (added.reflect != Rgbd(0.0)) light(Kind::term, added.reflect, "+ kr′ · REFLSHADE");
    if (added.refract != Rgbd(0.0)) light(Kind::term, added.refract, "+ kt′ · REFRSHADE");
    light(Kind::term, added.shade, "=");
    row(Kind::numbers, Word{timeline_.of_cones() ? "equation.of_cone" : "equation.of_beam"}, " = ", added.share);
    light(Kind::total, added.mean, added.last ? "RTNSHADE =" : timeline_.of_cones() ? "Σ =" : "m =");
  }

  const State& state_;
  const Timeline& timeline_;
  const Event* event_ = nullptr;
  EquationPanel panel_;
};

}  // namespace

std::string equation_number(double value, Language language) {
  return value == 0 ? "0" : typeset_power(fmt::format("{:.4g}", value), language);
}

double angle_of_cosine(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi; }

EquationPanel equation_panel(const State& state) { return EquationWriter(state).panel(); }

}  // namespace raywalk
