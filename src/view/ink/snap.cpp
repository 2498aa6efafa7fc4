// Where measuring tools snap to.

#include "view/ink/ink.h"

#include "math/overloaded.h"
#include "view/plan/plan_geometry.h"

#include <cmath>
#include <numbers>

namespace raywalk {

namespace {

/// Visits the rays that are drawn to their ends, or to where these will be seen.
void each_ray(const State& state, const auto& visit) {
  const bool moving = state.walk.mode == Mode::move;
  if (moving && !state.live.shown) return;
  RaysShown shown = rays_shown(state);
  shown.position = position_shown(state);
  const auto rays = state.walk.timeline->rays_at(shown.position);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RayRecord& ray = rays[i];
    if (!ray.formed || ray.beam >= 0 || ray.found_at > shown.position) continue;
    if (moving ? state.legend.shows(ray.kind) : prominence_of(state, shown, static_cast<int>(i)).has_value())
      visit(ray);
  }
}

/// Visits the places that things are measured from.
void each_place(const State& state, const auto& visit) {
  const Scene& scene = state.scene();
  visit(plan(scene.camera.eye));
  const ScreenPlace screen = screen_place(scene.camera);
  visit(screen.first), visit(screen.centre), visit(screen.last);
  for (const Light& light : scene.lights)
    if (const auto middle = middle_of(light)) visit(plan(*middle));
  for (const Object& object : scene.objects)
    if (object.transform.empty())
      std::visit(Overloaded{
                     [&](const Sphere<double>& sphere) { visit(plan(sphere.centre)); },
                     [&](const Prism<double>& prism) {
                       for (const Vec2d& corner : prism.corners) visit(corner);
                     },
                     [](const auto&) {},
                 },
                 object.shape);
  each_ray(state, [&](const RayRecord& ray) {
    visit(plan(ray.origin));
    if (!ray.endless) visit(plan(ray.end));
  });
  for (const InkMark& mark : state.document.contents.ink) {
    InkMark copy = mark;
    for (const Vec2d* place : places_of(copy)) visit(*place);
  }
}

/// Visits the directions of rays and normals at a point, both ways.
void each_direction(const State& state, const Vec2d& vertex, double near, const auto& visit) {
  each_ray(state, [&](const RayRecord& ray) {
    const bool ends = !ray.endless && length(plan(ray.end) - vertex) <= near;
    if (!ends && length(plan(ray.origin) - vertex) > near) return;
    visit(plan(ray.direction)), visit(-plan(ray.direction));
    if (ends && ray.ending == Ending::hit) visit(plan(ray.shaded.shading)), visit(-plan(ray.shaded.shading));
  });
}

}  // namespace

Snapped snapped(const State& state, const InkRoom::Begun* begun, const Vec2d& at, const action::Modifiers& modifiers) {
  const double pixel = 1 / state.plan.camera.pixels_per_unit;
  InkMark mark = begun != nullptr ? begun->mark : InkMark{};
  // The place that the next one is seen from.
  const std::vector<Vec2d*> places = places_of(mark);
  const bool turns = std::holds_alternative<Protractor>(mark.shape);
  const std::optional<Vec2d> pivot = places.empty() ? std::nullopt : std::optional(*places.front());
  if (modifiers.control) {
    const double grid = grid_step(state.plan.camera);
    return {{std::round(at.x / grid) * grid, std::round(at.y / grid) * grid}};
  }
  if (modifiers.shift && pivot) {
    constexpr double fifteen_degrees = std::numbers::pi / 12;
    // The second arm, from the first one.
    const Vec2d first = turns && begun->placed == 2 ? *places[1] - *pivot : Vec2d(1, 0), way = at - *pivot;
    const double zero = std::atan2(first.y, first.x);
    const double angle = zero + std::round((std::atan2(way.y, way.x) - zero) / fifteen_degrees) * fifteen_degrees;
    return {*pivot + dot(way, Vec2d(std::cos(angle), std::sin(angle))) * Vec2d(std::cos(angle), std::sin(angle))};
  }
  const Sizes sizes(state);
  const double reach = (state.appearance.touch ? 2.5 : 1.5) * sizes.reach * pixel;
  Snapped best{rounded(at, 0.1 * pixel)};
  double nearest = reach;
  each_place(state, [&](const Vec2d& place) {
    const double away = length(place - at);
    if (!(away < nearest) || (pivot && place == *pivot)) return;
    nearest = away;
    best = {place, true};
  });
  if (best.onto || !turns || !pivot) return best;
  // Two ends in one place may differ in their last bits, and an offset keeps rays off surfaces.
  each_direction(state, *pivot, 0.5 * pixel, [&](const Vec2d& direction) {
    const double size = length(direction);
    if (!(size > 0)) return;
    const double along = dot(at - *pivot, direction) / size;
    const Vec2d place = *pivot + along / size * direction;
    const double away = length(place - at);
    if (along <= 0 || !(away < nearest)) return;
    nearest = away;
    best = {place, true};
  });
  return best;
}

}  // namespace raywalk
