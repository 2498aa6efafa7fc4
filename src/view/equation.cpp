#include "view/equation.h"

#include "view/update_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace raywalk {

namespace {

using Kind = EquationRow::Kind;

double degrees(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi; }

double angle_between(const Vec3d& u, const Vec3d& v) {
  const double sizes = length(u) * length(v);
  return sizes > 0 ? degrees(dot(u, v) / sizes) : 0;
}

/// Writes the rows of one event. A row's numbers go through number(), so that what is shown is what is kept.
class Writer {
 public:
  explicit Writer(const State& state) : state_(state), timeline_(*state.timeline) {}

  [[nodiscard]] EquationPanel panel() {
    const Event* event = timeline_.just_run(state_.position);
    if (event == nullptr) return {};
    event_ = event;
    panel_.title = pseudocode_of(event->line).text;
    std::visit([&](const auto& detail) { write(detail); }, event->detail);
    return std::move(panel_);
  }

 private:
  // ---- Rows

  /// One row under way: text and numbers in turn.
  class Row {
   public:
    explicit Row(Kind kind) { row_.kind = kind; }
    Row& operator<<(std::string_view text) {
      row_.text += text;
      return *this;
    }
    Row& operator<<(double value) {
      row_.text += equation_number(value);
      row_.values.push_back(value);
      return *this;
    }
    /// Of a scene in the plan two components say it all.
    Row& operator<<(const Vec3d& v) {
      *this << "(" << v.x << ", " << v.y;
      if (v.z != 0) *this << ", " << v.z;
      return *this << ")";
    }
    [[nodiscard]] EquationRow take() { return std::move(row_); }

   private:
    EquationRow row_;
  };
  template <class... Parts>
  void row(Kind kind, const Parts&... parts) {
    Row row(kind);
    static_cast<void>((row << ... << parts));
    panel_.rows.push_back(row.take());
  }
  void light(Kind kind, std::string_view name, const Rgbd& colour) {
    Row row(kind);
    row << name << " ";
    if (colour.x == colour.y && colour.y == colour.z)
      row << colour.x;
    else
      row << "(" << colour.x << ", " << colour.y << ", " << colour.z << ")";
    panel_.rows.push_back(row.take());
    panel_.rows.back().light = colour;
  }

  // ---- What the rows speak of

  [[nodiscard]] const Scene& scene() const { return state_.scene(); }
  [[nodiscard]] const RayRecord& ray(int index) const { return timeline_.rays()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const RayRecord& current() const { return ray(timeline_.current_ray(state_.position)); }
  [[nodiscard]] const RayRecord* parent() const { return current().parent < 0 ? nullptr : &ray(current().parent); }
  /// The normal of the surface where `ray` ended, on the side that it came from.
  static Vec3d facing(const RayRecord& ray) { return dot(ray.normal, ray.direction) > 0 ? -ray.normal : ray.normal; }
  [[nodiscard]] std::string light_name(int light) const {
    return light < 0 ? std::string() : scene().lights[static_cast<std::size_t>(light)].name;
  }

  void line(std::string_view origin, const Vec3d& from, std::string_view direction, const Vec3d& along) {
    row(Kind::formula, "P(t) = ", origin, " + t ", direction);
    row(Kind::numbers, origin, " = ", from);
    row(Kind::numbers, direction, " = ", along);
  }

  // ---- Events

  void write(const PixelBegun& begun) {
    if (timeline_.of_strip())
      row(Kind::numbers, "pixel ", static_cast<double>(begun.column), " of ",
          static_cast<double>(scene().camera.screen.cells));
    else
      row(Kind::numbers, "pixel ", static_cast<double>(begun.column), ", ", static_cast<double>(begun.row));
  }

  void write(const RayFormed& formed) {
    switch (formed.kind) {
      case RayKind::primary:
        line("EYE", formed.origin, "D", formed.direction);
        return row(Kind::note, "D has length 1, so t is the distance from EYE");
      case RayKind::shadow:
        return shadow(formed);
      case RayKind::reflect:
        if (event_->line == Line::form_next_ray) return line("P", formed.origin, "D", formed.direction);
        return reflect(formed);
      case RayKind::refract:
        if (event_->line == Line::form_next_ray) return line("P", formed.origin, "D", formed.direction);
        return refract(formed);
    }
  }

  void shadow(const RayFormed& formed) {
    line("P", formed.origin, "L", formed.direction);
    if (formed.light_at_end) row(Kind::note, light_name(formed.light), " stands at t = ", 1.0);
    if (parent() == nullptr) return;
    const Vec3d normal = facing(*parent());
    row(Kind::formula, "cos θ = N·L / |L|");
    row(Kind::numbers, "N = ", normal, ", |L| = ", length(formed.direction));
    row(Kind::numbers, "θ = ", angle_between(normal, formed.direction), "°");
  }

  void reflect(const RayFormed& formed) {
    if (parent() == nullptr) return;
    const Vec3d normal = facing(*parent()), in = parent()->direction;
    row(Kind::formula, "R = D − 2 (N·D) N");
    row(Kind::numbers, "D = ", in);
    row(Kind::numbers, "N = ", normal, ", N·D = ", dot(normal, in));
    row(Kind::numbers, "R = ", formed.direction);
    row(Kind::note, "as far from the normal as it came: ", angle_between(normal, formed.direction), "°");
  }

  void refract(const RayFormed& formed) {
    if (!formed.snell) return line("P", formed.origin, "T", formed.direction);
    const SnellNumbers& s = *formed.snell;
    row(Kind::formula, "n₁ sin θ₁ = n₂ sin θ₂");
    row(Kind::numbers, s.n1, " · sin ", degrees(s.cos_in), "° = ", s.n2, " · sin ", degrees(s.cos_out), "°");
    row(Kind::note, s.n2 > s.n1   ? "slower beyond: towards the normal"
                    : s.n2 < s.n1 ? "faster beyond: away from the normal"
                                  : "as fast beyond: straight on");
    row(Kind::formula, "Fresnel: the part that is reflected here");
    row(Kind::numbers, "F = ", s.fresnel);
    row(Kind::numbers, "T = ", formed.direction);
  }

  void write(const RayNotFormed& stub) {
    switch (stub.why) {
      case Ending::depth: {
        const double deepest = scene().limits.depth;
        row(Kind::formula, "DEPTH + 1 ≤ limit?");
        row(Kind::numbers, static_cast<double>(event_->depth), " + ", 1.0, " > ", deepest);
        return row(Kind::note, "no ray is formed");
      }
      case Ending::threshold:
        row(Kind::formula, "share of the pixel ≥ threshold?");
        row(Kind::numbers, max_component(stub.share), " < ", scene().limits.threshold);
        return row(Kind::note, "no ray is formed");
      case Ending::facing_away: {
        row(Kind::formula, "N·L > 0?");
        if (parent() != nullptr)
          row(Kind::numbers, "θ = ", angle_between(facing(*parent()), stub.direction), "° ≥ ", 90.0, "°");
        return row(Kind::note, "the light stands behind the surface");
      }
      case Ending::outside_cone:
        return row(Kind::note, "the spot does not shine this way");
      case Ending::path_length:
      case Ending::total_internal_reflection:
      case Ending::hit:
      case Ending::missed:
      case Ending::blocked:
      case Ending::reached_light:
        return;
    }
  }

  void write(const Found& found) {
    const bool shadow = current().kind == RayKind::shadow;
    if (found.object < 0)
      return row(Kind::note, shadow ? "no surface between the point and the light" : "no surface has a t above 0");
    std::visit([&](const auto& numbers) { solve(numbers, found.t); }, found.numbers);
    row(Kind::formula, shadow ? "P = P₀ + t L" : "P = O + t D");
    row(Kind::numbers, "P = ", found.point, ", t = ", found.t);
    if (shadow) return row(Kind::note, "before the light: it is blocked");
    row(Kind::numbers, "N = ", found.normal, ", θ = ", angle_between(facing(current()), -current().direction), "°");
  }

  void solve(const std::monostate& /*none*/, double /*t*/) {}
  void solve(const QuadraticNumbers& q, double t) {
    row(Kind::formula, "a t² + b t + c = 0");
    row(Kind::numbers, "a = ", q.a, ", b = ", q.b, ", c = ", q.c);
    row(Kind::numbers, "b² − 4 a c = ", q.discriminant);
    if (!(q.discriminant >= 0)) return;
    row(Kind::formula, "t = (−b ± √(b² − 4 a c)) / 2 a");
    row(Kind::numbers, "t₀ = ", q.t0, ", t₁ = ", q.t1);
    const auto is = [&](double root) { return std::abs(t - root) <= 1e-9 * std::max(std::abs(t), std::abs(root)); };
    if (is(q.t0)) return row(Kind::note, "t₀: the nearer one, and ahead");
    if (is(q.t1))
      row(Kind::note, q.t0 < -1e-9 ? "t₁: the other one lies behind" : "t₁: at the other one the ray began");
  }
  void solve(const PlaneNumbers& p, double /*t*/) {
    if (!std::isfinite(p.numerator)) return;
    row(Kind::formula, "t = N·(A − O) / N·D");
    row(Kind::numbers, "t = ", p.numerator, " / ", p.denominator);
  }

  void write(const Decided& decided) {
    const bool transparent = event_->line == Line::if_transparent;
    if (event_->line != Line::if_reflective && !transparent) return row(Kind::note, decided.holds ? "yes" : "no");
    light(Kind::term, transparent ? "kt′ =" : "kr′ =", decided.weight);
    if (!decided.why) return row(Kind::note, decided.holds ? "above 0: yes" : "0: no");
    // Nothing gets out: Snell's law asks for a sine above 1.
    const RayRecord& shaded =
        ray(timeline_.frames()[static_cast<std::size_t>(timeline_.current_frame(state_.position))].ray);
    const double angle = angle_between(facing(shaded), -shaded.direction);
    const bool leaves = dot(shaded.normal, shaded.direction) > 0;
    const double index = shaded.object >= 0 ? scene().objects[static_cast<std::size_t>(shaded.object)].material.ior : 1;
    row(Kind::formula, "sin θ₂ = n₁ sin θ₁ / n₂");
    row(Kind::numbers, leaves ? index : 1.0, " · sin ", angle, "° / ", leaves ? 1.0 : index, " > ", 1.0);
    row(Kind::note, "no such angle: total internal reflection");
  }

  void write(const ShadeCalled& called) {
    if (called.missed) return light(Kind::total, "background =", called.background);
    row(Kind::numbers, "DEPTH = ", static_cast<double>(called.depth));
  }

  void write(const ShadeComputed& sum) {
    light(Kind::term, "ambient", sum.ambient);
    if (sum.emission != Rgbd(0.0)) light(Kind::term, "+ emission", sum.emission);
    for (const LightTerm& term : sum.lights) {
      light(Kind::term, "+ " + light_name(term.light) + ", diffuse", term.diffuse);
      if (term.specular != Rgbd(0.0)) light(Kind::term, "+ " + light_name(term.light) + ", highlight", term.specular);
    }
    if (sum.reflect != Rgbd(0.0)) light(Kind::term, "+ kr′ · REFLSHADE", sum.reflect);
    if (sum.refract != Rgbd(0.0)) light(Kind::term, "+ kt′ · REFRSHADE", sum.refract);
    if (sum.passed != Rgbd(1.0)) light(Kind::note, "all that times what the way through leaves:", sum.passed);
    light(Kind::total, "= RTNSHADE", sum.total);
  }

  void write(const PixelPut& put) { light(Kind::total, "final =", put.shade); }

  // ---- Path tracing

  void write(const BackgroundAdded& added) { light(Kind::total, "+ background", added.added); }
  void write(const EmissionAdded& emission) {
    light(Kind::term, "emission", emission.emission);
    if (emission.emission == Rgbd(0.0)) return;
    weighted(emission.direction_density, emission.light_density, emission.weight);
    light(Kind::total, "+ weight · share · emission =", emission.added);
  }
  void write(const LightAdded& added) {
    weighted(added.direction_density, added.light_density, added.weight);
    light(Kind::total, "+", added.added);
  }
  void weighted(double by_direction, double by_light, double weight) {
    row(Kind::numbers, "p(direction) = ", by_direction, ", p(light) = ", by_light);
    row(Kind::numbers, "weight = ", weight);
  }
  void write(const DirectionChosen& chosen) {
    if (chosen.absorbed) return row(Kind::note, "absorbed: none");
    row(Kind::numbers, "D = ", chosen.direction);
    if (chosen.density > 0) row(Kind::numbers, "p(D) = ", chosen.density);
    light(Kind::term, "share that is left =", chosen.share);
  }
  void write(const SurvivalDecided& decided) {
    if (decided.survival < 1) row(Kind::numbers, "goes on with probability ", decided.survival);
    row(Kind::note, decided.survives ? "yes" : "no");
  }

  const State& state_;
  const Timeline& timeline_;
  const Event* event_ = nullptr;
  EquationPanel panel_;
};

}  // namespace

std::string equation_number(double value) { return value == 0 ? "0" : fmt::format("{:.4g}", value); }

EquationPanel equation_panel(const State& state) { return Writer(state).panel(); }

HitNotes hit_notes(const State& state) {
  const Timeline& timeline = *state.timeline;
  const int index = timeline.current_ray(state.position);
  if (index < 0) return {};
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(index)];
  if (!ray.formed || ray.found_at > state.position || ray.object < 0) return {};
  const auto& found = std::get<Found>(timeline.event(ray.found_at - 1).detail);
  HitNotes notes{"t = " + equation_number(found.t), {}};
  if (ray.ending != Ending::hit) return notes;
  const double cosine = std::abs(dot(ray.normal, ray.direction)) / std::max(length(ray.direction), 1e-300);
  notes.angle = "θ = " + fmt::format("{:.1f}", degrees(cosine)) + "°";
  return notes;
}

}  // namespace raywalk
