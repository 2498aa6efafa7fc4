#include "inspect/pencil_walk.h"

#include "math/elementary.h"
#include "trace/optics.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

/// How far a mirrored direction in double may be from one that was recorded: of numbers of 24 bits.
constexpr double as_recorded = 1e-5;

/// To the left of a direction in the plan.
Vec3d left_of(const Vec3d& direction) { return {-direction.y, direction.x, 0}; }

const Vec3d up(0, 0, 1);

}  // namespace

std::vector<PencilStage> pencil_of(const World<double>& world, const RayGenerator<double>& camera,
                                   const Timeline& timeline, int ray) {
  const auto record = [&](int index) -> const RayRecord& { return timeline.rays()[static_cast<std::size_t>(index)]; };
  if (timeline.has_width() || timeline.of_radiosity()) return {};
  const PixelRecord& pixel = timeline.pixels()[static_cast<std::size_t>(record(ray).pixel)];
  Statistics uncounted;
  const double time = camera.primary_ray({pixel.column, pixel.row, pixel.sample}, uncounted).time;
  std::vector<PencilStage> stages;
  Departure departure{};
  std::optional<SurfaceHit<double>> left;
  for (const int index : way_of(timeline, ray)) {
    const RayRecord& own = record(index);
    const double size = length(own.direction);
    const bool in_plan = own.origin.z == 0 && own.direction.z == 0 && size > 0;
    const bool follows =
        stages.empty() ? own.kind == RayKind::primary : own.kind == RayKind::reflect || own.kind == RayKind::refract;
    if (!in_plan || !follows || !own.formed || (!stages.empty() && !left)) return {};
    PencilStage stage{};
    stage.ray = index, stage.time = time, stage.origin = own.origin, stage.direction = own.direction / size;
    stage.length = infinity<double>;
    if (!stages.empty()) {
      const PencilStage& before = stages.back();
      const auto* formed = std::get_if<RayFormed>(&timeline.event(own.formed_at - 1).detail);
      const PencilSurface surface = pencil_surface(world.accelerator.primitives(), left->hit.primitive, left->hit.part,
                                                   left->point, time, before.direction);
      stage.curvature = surface.curvature;
      stage.n = before.n;
      PencilSystem bent;
      if (own.kind == RayKind::reflect) {
        stage.reflected = true;
        // Another direction than the mirrored one was drawn from a lobe.
        if (length(stage.direction - reflect(before.direction, surface.normal)) > as_recorded) return {};
        bent = mirrored_by(surface);
      } else {
        if (formed == nullptr || !formed->snell) return {};
        const SnellNumbers& snell = *formed->snell;
        stage.n = snell.n2;
        bent = refracted_by(surface, snell.n1, snell.n2, snell.cos_out);
        stages.back().n = snell.n1;
      }
      stage.start = bent.plan * pencil_transfer(before.length) * before.start;
      stage.start_across = bent.across * pencil_transfer(before.length) * before.start_across;
    }
    stage.focus = focus_of_point(stage.start);
    stage.focus_across = focus_of_point(stage.start_across);
    left = find_surface(world, Ray<double>{stage.origin, stage.direction, departure, time});
    if (left) {
      stage.object = world.object(left->hit.primitive);
      stage.length = left->hit.t;
      departure = {left->hit.primitive, left->hit.part};
    }
    stages.push_back(stage);
  }
  return stages;
}

std::vector<Vec3d> true_neighbour(const World<double>& world, const std::vector<PencilStage>& stages, double angle,
                                  double last_length, ConePlane plane) {
  std::vector<Vec3d> points;
  if (stages.empty()) return points;
  const auto [sin, cos] = portable::sin_cos(angle);
  const Vec3d beside = plane == ConePlane::across ? up : left_of(stages[0].direction);
  Vec3d origin = stages[0].origin, direction = cos * stages[0].direction + sin * beside;
  Departure departure{};
  for (std::size_t i = 0; i < stages.size(); ++i) {
    points.push_back(origin);
    const Ray<double> ray{origin, direction, departure, stages[i].time};
    const auto met = find_surface(world, ray);
    if (i + 1 == stages.size()) {
      points.push_back(origin + std::min(last_length, met ? met->hit.t : last_length) * direction);
      break;
    }
    if (!met || world.object(met->hit.primitive) != stages[i].object) break;
    const PencilStage& next = stages[i + 1];
    const Vec3d normal = dot(met->point.normal, direction) <= 0 ? met->point.normal : -met->point.normal;
    if (next.reflected) {
      direction = reflect(direction, normal);
    } else {
      const auto bent = refract(direction, normal, refraction_at(direction, normal, stages[i].n, next.n));
      if (!bent) break;
      direction = normalize(*bent);
    }
    origin = met->point.position;
    departure = {met->hit.primitive, met->hit.part};
  }
  return points;
}

}  // namespace raywalk
