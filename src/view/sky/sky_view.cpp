#include "trace/sky_light.h"
#include "view/plan/painter.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/state.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace raywalk {

void SkyRoom::follow(State& state, const Before& /*before*/) {
  SkyRoom& room = state.sky;
  const Scene& scene = state.scene();
  if (room.of == scene.sky && room.below == scene.background) return;
  room.of = scene.sky;
  room.below = scene.background;
  room.light = scene.sky ? std::make_shared<const SkyLight>(*scene.sky, scene.background) : nullptr;
}

namespace {

std::shared_ptr<const SkyLight> light_of(const State& state) {
  const Scene& scene = state.scene();
  if (state.sky.of == scene.sky && state.sky.below == scene.background) return state.sky.light;
  return std::make_shared<const SkyLight>(*scene.sky, scene.background);
}

/// A rounded frame about the middle of the pane, (x / a)^4 + (y / b)^4 = 1, as large as fits. Seen from there, each of
/// its points lies in the direction that it stands for.
struct Ring {
  Vec2d middle;
  double a, b;  ///< half axes in pixels

  /// A point, from the middle and with y up: also the direction in the plan that leads there. `turn`: 0..1.
  [[nodiscard]] Vec2d along(double turn) const {
    const double angle = 2 * std::numbers::pi * turn;
    return towards({a * std::cos(angle), b * std::sin(angle)});
  }
  /// `inwards`: pixels from the ring.
  [[nodiscard]] Vec2d at(const Vec2d& along, double inwards) const {
    const Vec2d point = along * (1 - inwards / length(along));
    return {middle.x + point.x, middle.y - point.y};
  }
  /// In a direction of the plan, not 0.
  [[nodiscard]] Vec2d towards(const Vec2d& direction) const {
    const double x = direction.x * direction.x / (a * a), y = direction.y * direction.y / (b * b);
    return direction * (1 / std::sqrt(std::sqrt(x * x + y * y)));
  }
};

/// The ring with the curve inside.
struct SeenSky {
  struct Seen {
    Vec2d along;
    double pdf;
  };
  static constexpr int count = 180;
  Ring ring;
  double width, tallest;  ///< pixels, of the ring and of the curve
  std::shared_ptr<const SkyLight> light;
  std::vector<Seen> directions;  ///< between from(i) and from(i + 1)
  double most = 0;               ///< of the pdf
  bool is_sampled = false;       ///< with the curve

  [[nodiscard]] Vec2d from(int i) const { return ring.along(static_cast<double>(i) / count); }
  [[nodiscard]] Vec2d at_curve(int i) const {
    const Seen& one = directions[static_cast<std::size_t>((i + count) % count)];
    return ring.at(one.along, width + one.pdf / most * tallest);
  }
};

/// None without a sky, or in a pane that is too small.
std::optional<SeenSky> seen_sky(const Painter& painter) {
  if (!painter.scene().sky) return std::nullopt;
  const double unit = painter.sizes.unit, margin = 4 * unit, width = 9 * unit;
  // Lower in a small pane, where the scene needs the room.
  const double tallest =
      std::min(sky_depth * unit - margin - width, 0.05 * std::min(painter.viewport.width, painter.viewport.height));
  const Ring ring{{painter.viewport.width / 2, painter.viewport.height / 2},
                  painter.viewport.width / 2 - margin,
                  painter.viewport.height / 2 - margin};
  if (!(ring.a > 4 * tallest && ring.b > 4 * tallest)) return std::nullopt;
  SeenSky sky{ring, width, tallest, light_of(painter.state), {}};
  for (int i = 0; i < SeenSky::count; ++i) {
    const Vec2d along = ring.along((i + 0.5) / SeenSky::count);
    sky.directions.push_back({along, sky.light->pdf(Vec3d(along, 0))});
    sky.most = std::max(sky.most, sky.directions.back().pdf);
  }
  sky.is_sampled = integrator_of(*walked_scene(painter.state)) == Integrator::path && sky.most > 0;
  return sky;
}

/// Where on the ring the current ray met the sky, if it did, as seen in the plan.
std::optional<Vec2d> place_met(const Painter& painter, const SeenSky& sky) {
  const Timeline& timeline = *painter.state.walk.timeline;
  const int current = timeline.current_ray(painter.state.walk.position);
  if (painter.state.walk.mode == Mode::move || current < 0) return std::nullopt;
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(current)];
  const bool leaves = ray.formed && ray.endless && ray.object < 0 && ray.found_at <= painter.state.walk.position;
  const Vec2d flat(ray.direction.x, ray.direction.y);
  if (!leaves || !(length(flat) > 1e-9 * length(ray.direction))) return std::nullopt;
  return sky.ring.towards(flat);
}

/// A frame around a stretch of the ring: its middle lies in this direction.
PolygonItem ring_mark(const SeenSky& sky, const Vec2d& along) {
  const double half = 0.9 * sky.width, beyond = 0.3 * sky.width;
  const double turn = half / length(along);
  PolygonItem frame;
  for (const auto& [side, inwards] : {std::pair{-turn, sky.width + beyond}, std::pair{-turn, -beyond},
                                      std::pair{turn, -beyond}, std::pair{turn, sky.width + beyond}})
    frame.points.push_back(sky.ring.at(sky.ring.towards(turned(along, Vec2d(0.0), side)), inwards));
  return frame;
}

}  // namespace

void SkyRoom::keep_free_in_plan(Painter& painter) {
  const std::optional<SeenSky> sky = seen_sky(painter);
  if (!sky) return;
  const int count = SeenSky::count;
  constexpr int together = 3;
  for (int i = 0; i < count; i += together) {
    std::vector<Vec2d> around;
    for (int k = i; k <= i + together; ++k) {
      around.push_back(sky->ring.at(sky->from(k), 0));
      around.push_back(sky->ring.at(sky->from(k), sky->width));
    }
    if (sky->is_sampled)
      for (int k = i - 1; k <= i + together; ++k) around.push_back(sky->at_curve(k));
    PixelRect box{around.front(), around.front()};
    for (const Vec2d& at : around)
      box = {{std::min(box.min.x, at.x), std::min(box.min.y, at.y)},
             {std::max(box.max.x, at.x), std::max(box.max.y, at.y)}};
    painter.kept_free.push_back(box);
  }
  for (int i = 0; i < count; ++i)
    painter.frame.push_back(sky->is_sampled ? sky->at_curve(i) : sky->ring.at(sky->from(i), sky->width));
  if (const auto along = place_met(painter, *sky))
    painter.keep_free(ring_mark(*sky, *along).points.front(), 1.2 * sky->width);
}

void SkyRoom::draw_in_plan(Painter& painter) {
  const std::optional<SeenSky> sky = seen_sky(painter);
  if (!sky) return;
  const double unit = painter.sizes.unit;
  const Ring& ring = sky->ring;
  const int count = SeenSky::count;
  for (int i = 0; i < count; ++i) {
    const Vec2d from = sky->from(i), to = sky->from(i + 1);
    const Vec3d along(sky->directions[static_cast<std::size_t>(i)].along, 0);
    painter.add(PolygonItem{{ring.at(from, 0), ring.at(to, 0), ring.at(to, sky->width), ring.at(from, sky->width)},
                            display_colour(sky->light->radiance(along), painter.scene().encoding),
                            std::nullopt});
  }
  for (const double inwards : {0.0, sky->width}) {
    PolylineItem border{{}, painter.stroke(painter.colours.grid)};
    for (int i = 0; i <= count; ++i) border.points.push_back(ring.at(sky->from(i), inwards));
    painter.add(border);
  }
  if (sky->is_sampled) {
    PolylineItem chance{{}, painter.stroke(painter.colours.dim_text, 1.3)};
    for (int i = 0; i <= count; ++i) chance.points.push_back(sky->at_curve(i));
    painter.add(chance);
  }
  if (const auto along = place_met(painter, *sky)) {
    PolygonItem mark = ring_mark(*sky, *along);
    mark.stroke = painter.stroke(painter.colours.next, 2);
    painter.add(std::move(mark));
  }
  // Inside of the ring and of the curve: in the middle of an edge, else nearer to a corner.
  std::vector<Vec2d> places;
  const double inwards = ring.b - sky->width - sky->tallest - 12 * unit;
  for (const double deeper : {0.0, 8.0, 16.0, 32.0, 48.0, 64.0})
    for (const double part : {0.0, 0.2, 0.35})
      for (const double side : {-1.0, 1.0})
        for (const double across : {-part, part})
          places.push_back(ring.middle + Vec2d(across * ring.a, side * (inwards - (60 * part + deeper) * unit)));
  const bool of_paths = integrator_of(*walked_scene(painter.state)) == Integrator::path;
  const auto said = [&](std::string_view id) {
    return painter.note_off_bodies(places, std::string(text(id, painter.state.appearance.language)));
  };
  if (!place_met(painter, *sky) || !said("plan.sky_met")) said("plan.sky");
  if (of_paths) said("plan.sky_curve");
}

}  // namespace raywalk
