#include "timeline/pencil_message.h"

#include "math/overloaded.h"

#include <cmath>
#include <string>

namespace raywalk {

namespace {

std::string object_name(const Scene& scene, int index) {
  return index < 0 ? std::string() : scene.objects[static_cast<std::size_t>(index)].name;
}

/// What `changed` made of the matrix. `object`: at which surface, but for a transfer.
Message of_matrix(Line line, const PencilChanged& changed, const std::string& object) {
  if (!changed.system) return {"walk.pencil_lost", {}};
  const PencilMatrix& m = changed.system->plan;
  if (line == Line::transfer_pencil) {
    const std::optional<double> focus = focus_of_point(changed.before.plan);
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
      [&](const PencilChanged& changed) -> Told { return of_matrix(event.line, changed, shaded()); },
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
