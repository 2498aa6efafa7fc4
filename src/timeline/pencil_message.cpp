#include "timeline/pencil_message.h"

#include "math/overloaded.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace raywalk {

namespace {

std::string object_name(const Scene& scene, int index) {
  return index < 0 ? std::string() : scene.objects[static_cast<std::size_t>(index)].name;
}

/// In the plan.
Message of_plan(Line line, const PencilChanged& changed, const std::string& object) {
  const PencilMatrix& m = changed.system->plan;
  if (line == Line::transfer_pencil) {
    const std::optional<double> focus = focus_of_point(pencil_transfer(-changed.along) * m);
    if (focus && *focus > 0 && *focus < changed.along)
      return {"walk.pencil_folded",
              {{"length", changed.along}, {"a", m.a}, {"b", m.b}, {"c", m.c}, {"d", m.d}, {"focus", *focus}}};
    return {"walk.pencil_transferred",
            {{"length", changed.along}, {"a", m.a}, {"b", m.b}, {"c", m.c}, {"d", m.d}, {"away", std::abs(m.b)}}};
  }
  const std::optional<double> focus = focus_of_point(m);
  if (!focus) return {"walk.pencil_parallel", {{"object", object}, {"a", m.a}, {"b", m.b}, {"c", m.c}, {"d", m.d}}};
  if (*focus > 0)
    return {"walk.pencil_meets",
            {{"object", object}, {"a", m.a}, {"b", m.b}, {"c", m.c}, {"d", m.d}, {"focus", *focus}}};
  return {"walk.pencil_spreads",
          {{"object", object}, {"a", m.a}, {"b", m.b}, {"c", m.c}, {"d", m.d}, {"focus", -*focus}}};
}

/// By how much of an ellipse's axes a circle's may differ, of rounding.
constexpr double alike = 1e-6;

/// In space, where rays meet on two lines.
Message of_space(Line line, const PencilChanged& changed, const std::string& object) {
  const bool transfers = line == Line::transfer_pencil;
  const PencilSystem& M = *changed.system;
  std::vector<double> before, behind;  // the distances of the foci, from where the ray starts
  for (const std::optional<double>& focus : foci_of_point(transfers ? transferred(-changed.along) * M : M))
    if (focus) (*focus > 0 ? before : behind).push_back(std::abs(*focus));
  std::sort(before.begin(), before.end());
  std::sort(behind.begin(), behind.end());
  if (transfers) {
    const Vec2d axes = ellipse_from_point(M);
    if (!before.empty() && before.front() < changed.along)
      return {"walk.space_pencil_folded",
              {{"length", changed.along}, {"long", axes.x}, {"short", axes.y}, {"focus", before.front()}}};
    if (axes.x - axes.y <= alike * axes.x)
      return {"walk.space_pencil_round", {{"length", changed.along}, {"away", axes.x}}};
    return {"walk.space_pencil_transferred", {{"length", changed.along}, {"long", axes.x}, {"short", axes.y}}};
  }
  if (before.size() == 2)
    return {"walk.space_pencil_meets", {{"object", object}, {"focus", before.front()}, {"second", before.back()}}};
  if (!before.empty()) return {"walk.space_pencil_half_meets", {{"object", object}, {"focus", before.front()}}};
  if (!behind.empty()) return {"walk.space_pencil_spreads", {{"object", object}, {"focus", behind.front()}}};
  return {"walk.space_pencil_parallel", {{"object", object}}};
}

/// What `changed` made of the matrix. `object`: at which surface, but for a transfer.
Message of_matrix(const Timeline& timeline, Line line, const PencilChanged& changed, const std::string& object) {
  if (!changed.system) return {"walk.pencil_lost", {}};
  return timeline.of_strip() && changed.system->is_unmixed() ? of_plan(line, changed, object)
                                                             : of_space(line, changed, object);
}

}  // namespace

std::optional<Message> pencil_message(const Scene& scene, const Timeline& timeline, int position) {
  using Told = std::optional<Message>;
  const Event& event = *timeline.just_run(position);
  const auto ray = [&](int index) -> const RayRecord& { return timeline.rays()[static_cast<std::size_t>(index)]; };
  const auto shaded = [&] {
    const int frame = timeline.current_frame(position);
    return frame < 0 ? std::string()
                     : object_name(scene, ray(timeline.frames()[static_cast<std::size_t>(frame)].ray).object);
  };
  const auto tell = Overloaded{
      [&](const RayFormed& formed) -> Told {
        if (formed.kind != RayKind::primary) return std::nullopt;
        const PixelRecord& pixel = timeline.pixels()[static_cast<std::size_t>(timeline.current_pixel(position))];
        if (timeline.of_strip()) return Message{"walk.pencil_formed", {{"cell", pixel.column}}};
        return Message{"walk.image_pencil_formed", {{"column", pixel.column}, {"row", pixel.row}}};
      },
      [&](const PencilChanged& changed) -> Told { return of_matrix(timeline, event.line, changed, shaded()); },
      [&](const ShadeCalled& called) -> Told {
        if (called.missed) return Message{"walk.pencil_missed", {{"colour", called.background}}};
        const int met = ray(timeline.current_ray(position)).object;
        return Message{"walk.pencil_called", {{"depth", called.depth}, {"object", object_name(scene, met)}}};
      },
      [&](const ShadeComputed& computed) -> Told {
        return Message{"walk.pencil_shaded", {{"object", shaded()}, {"colour", computed.total}}};
      },
      [](const auto& /*as of the tracer*/) -> Told { return std::nullopt; }};
  return std::visit(tell, event.detail);
}

}  // namespace raywalk
