#include "timeline/pencil_message.h"

#include "timeline/part_words.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace raywalk {

namespace {

/// Of the matrix in the plan, at a surface of `object` or after a transfer.
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

class PencilDescriber : PartWords {
 public:
  PencilDescriber(const Scene& scene, const Timeline& timeline, int position) : PartWords(scene, timeline, position) {}

  [[nodiscard]] std::optional<Message> message() const {
    return std::visit([&](const auto& detail) { return describe(event(), detail); }, event().detail);
  }

 private:
  using PartWords::describe;

  [[nodiscard]] Told describe(const Event& /*event*/, const RayFormed& formed) const {
    if (formed.kind != RayKind::primary) return std::nullopt;
    if (timeline_.of_strip()) return Message{"walk.pencil_formed", {{"cell", pixel().column}}};
    return Message{"walk.image_pencil_formed", {{"column", pixel().column}, {"row", pixel().row}}};
  }
  /// What has become of the matrix.
  [[nodiscard]] Told describe(const Event& event, const PencilChanged& changed) const {
    if (!changed.system) return Message{"walk.pencil_lost", {}};
    const bool in_plan = timeline_.of_strip() && changed.system->is_unmixed();
    return in_plan ? of_plan(event.line, changed, shaded()) : of_space(event.line, changed, shaded());
  }
  [[nodiscard]] Told describe(const Event& /*event*/, const ShadeCalled& called) const {
    if (called.missed) return Message{"walk.pencil_missed", {{"colour", called.background}}};
    return Message{"walk.pencil_called", {{"depth", called.depth}, {"object", object(current().object)}}};
  }
  [[nodiscard]] Told describe(const Event& /*event*/, const ShadeComputed& computed) const {
    return Message{"walk.pencil_shaded", {{"object", shaded()}, {"colour", computed.total}}};
  }

  [[nodiscard]] std::string shaded() const {
    const int frame = timeline_.current_frame(position_);
    return frame < 0 ? std::string() : object(ray(timeline_.frames()[static_cast<std::size_t>(frame)].ray).object);
  }
};

}  // namespace

std::optional<Message> pencil_message(const Scene& scene, const Timeline& timeline, int position) {
  return PencilDescriber(scene, timeline, position).message();
}

}  // namespace raywalk
