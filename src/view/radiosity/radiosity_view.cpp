#include "trace/patches.h"
#include "view/plan/painter.h"
#include "view/state.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace raywalk {

namespace {

/// A patch on the screen.
struct Strip {
  Vec2d a, b, out;  ///< ends, and the unit direction that its light goes to
  [[nodiscard]] Vec2d middle() const { return 0.5 * (a + b); }
};

Strip strip_of(const Painter& painter, const Patch& patch) {
  const Edge edge = patch.edge();
  Strip strip{painter.pixels(edge.a), painter.pixels(edge.b), {0, 0}};
  // The screen's y runs down.
  strip.out = Vec2d(patch.normal.x, -patch.normal.y);
  return strip;
}

class PatchPainter {
 public:
  /// `first`: the light before the first shot, by which bars are measured.
  PatchPainter(Painter& painter, const Patches& patches, std::vector<PatchLight> lights,
               const std::vector<PatchLight>& first)
      : painter_(painter), patches_(patches), lights_(std::move(lights)) {
    for (int i = 0; i < static_cast<int>(first.size()); ++i) most_ = std::max(most_, power(i, first));
  }

  /// As the eye would see it: the radiance that leaves the patch.
  void draw_patch(int i) {
    const Patch& patch = patches_[i];
    const Strip strip = strip_of(painter_, patch);
    const double unit = painter_.sizes.unit, depth = 5 * unit;
    Rgbd radiance(0.0);
    if (!lights_.empty()) {
      const PatchLight& light = lights_[static_cast<std::size_t>(i)];
      radiance = (patch.emission + patch.reflectance * light.irradiance) / patches_.cosines();
    }
    painter_.add(LineItem{.from = strip.a + 0.5 * depth * strip.out,
                          .to = strip.b + 0.5 * depth * strip.out,
                          .stroke = {display_colour(radiance, painter_.scene().encoding), depth}});
    // Where one ends and the next begins.
    for (const Vec2d& end : {strip.a, strip.b})
      painter_.add(LineItem{
          .from = end, .to = end + 1.6 * depth * strip.out, .stroke = painter_.stroke(painter_.colours.dim_text)});
  }

  /// As long as the root of its power: a shot takes it away.
  void draw_unshot(int i) {
    if (!(power(i) > 0)) return;
    const Strip strip = strip_of(painter_, patches_[i]);
    const double unit = painter_.sizes.unit, base = 7 * unit, longest = 38 * unit;
    const double tall = longest * std::min(std::sqrt(power(i) / most_), 1.0);
    if (tall < 0.5) return;
    const Vec2d from = strip.middle() + base * strip.out;
    const Vec2d to = from + tall * strip.out;
    painter_.add(LineItem{.from = from, .to = to, .stroke = {painter_.colours.light, 5 * unit}});
    // Names keep off those that are seen from afar.
    if (tall < base) return;
    const Vec2d half(4 * unit);
    painter_.unnamed.push_back({Vec2d(std::min(from.x, to.x), std::min(from.y, to.y)) - half,
                                Vec2d(std::max(from.x, to.x), std::max(from.y, to.y)) + half});
  }

  void draw_shooter(int i) { draw_ringed(i, 7); }
  /// The one whose light arrives, or is asked for: ringed with dashes.
  void draw_receiver(int i) { draw_ringed(i, 10, {{4, 3}, 2}); }

  void draw_strings(const FormFactorFound& found) {
    const auto string = [&](const Vec2d& from, const Vec2d& to, Colour colour, DashPattern dash, double width) {
      LineItem line{.from = painter_.pixels(from), .to = painter_.pixels(to), .stroke = painter_.stroke(colour, width)};
      line.stroke.dash = painter_.scaled(dash);
      painter_.add_clipped(line);
    };
    const double faint = found.visible > 0 ? 1 : 0.4;
    const Colour crossed =
        mix(painter_.colours.plan, ray_style(painter_.state.appearance.theme, RayKind::reflect).colour, faint);
    const Colour beside =
        mix(painter_.colours.plan, ray_style(painter_.state.appearance.theme, RayKind::refract).colour, faint);
    constexpr DashPattern dashes{{7, 5}, 2};
    string(found.from_a, found.to_b, beside, dashes, 1.8);
    string(found.from_b, found.to_a, beside, dashes, 1.8);
    string(found.from_a, found.to_a, crossed, {}, 2);
    string(found.from_b, found.to_b, crossed, {}, 2);
  }

  [[nodiscard]] int count() const { return patches_.size(); }

 private:
  void draw_ringed(int i, double radius, const DashPattern& dash = {}) {
    const Strip strip = strip_of(painter_, patches_[i]);
    const double unit = painter_.sizes.unit;
    painter_.add(LineItem{.from = strip.a, .to = strip.b, .stroke = {painter_.colours.selected, 5 * unit}});
    Stroke stroke = painter_.stroke(painter_.colours.selected, 2);
    stroke.dash = painter_.scaled(dash);
    painter_.add(CircleItem{strip.middle() + 4 * unit * strip.out, radius * unit, std::nullopt, stroke});
  }
  [[nodiscard]] double power(int i) const { return power(i, lights_); }
  [[nodiscard]] double power(int i, const std::vector<PatchLight>& lights) const {
    if (lights.empty()) return 0;
    const Rgbd& unshot = lights[static_cast<std::size_t>(i)].unshot;
    return patches_[i].area * (unshot.x + unshot.y + unshot.z);
  }

  Painter& painter_;
  const Patches& patches_;
  std::vector<PatchLight> lights_;
  double most_ = 0;
};

/// The patch that shoots at this position, or is about to; -1: none.
int shooter_at(const Timeline& timeline, int position) {
  for (int at = position; at > 0; --at) {
    const EventDetail& detail = timeline.event(at - 1).detail;
    if (const auto* taken = std::get_if<PatchTaken>(&detail)) return taken->patch;
    if (const auto* shot = std::get_if<PatchShot>(&detail)) return shot->others > 0 ? -1 : shot->patch;
    const bool within = std::holds_alternative<PatchInFront>(detail) ||
                        std::holds_alternative<FormFactorFound>(detail) ||
                        std::holds_alternative<LightArrived>(detail) || std::holds_alternative<PatchEmptied>(detail);
    if (!within) return -1;
  }
  return -1;
}

/// The patch that the line just run speaks of as the receiver; -1: none.
int receiver_at(const Timeline& timeline, int position) {
  const EventDetail& detail = timeline.event(position - 1).detail;
  if (const auto* in_front = std::get_if<PatchInFront>(&detail)) return in_front->patch;
  if (const auto* found = std::get_if<FormFactorFound>(&detail)) return found->to;
  if (const auto* arrived = std::get_if<LightArrived>(&detail)) return arrived->patch;
  return -1;
}

}  // namespace

void RadiosityRoom::draw_in_plan(Painter& painter) {
  const Timeline& timeline = *painter.state.walk.timeline;
  if (!timeline.of_radiosity() || !timeline.is_flat() || timeline.patches() == nullptr) return;
  const int position = painter.state.walk.position;
  if (position > 0) {
    PatchPainter patches(painter, *timeline.patches(), timeline.lights_at(position), timeline.lights_at(2));
    for (int i = 0; i < patches.count(); ++i) patches.draw_patch(i);
    for (int i = 0; i < patches.count(); ++i) patches.draw_unshot(i);
    if (const int shooter = shooter_at(timeline, position); shooter >= 0) patches.draw_shooter(shooter);
    if (const int receiver = receiver_at(timeline, position); receiver >= 0) patches.draw_receiver(receiver);
    // The strings stay while what arrives is added.
    for (int back = 0; back < 2 && position - back > 0; ++back)
      if (const auto* found = std::get_if<FormFactorFound>(&timeline.event(position - 1 - back).detail))
        patches.draw_strings(*found);
  }
  const double margin = 16 * painter.sizes.unit;
  painter.note({{painter.viewport.width / 2, painter.viewport.height - margin}, {painter.viewport.width / 2, margin}},
               fill("plan.flat_patches", painter.state.appearance.language,
                    {{"share", percent_text(timeline.unshot_at(position), painter.state.appearance.language)}}));
}

}  // namespace raywalk
