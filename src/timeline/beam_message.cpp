#include "timeline/beam_message.h"

#include "timeline/part_words.h"

#include <numbers>
#include <string>

namespace raywalk {

namespace {

class BeamDescriber : PartWords {
 public:
  BeamDescriber(const Scene& scene, const Timeline& timeline, int position) : PartWords(scene, timeline, position) {}

  [[nodiscard]] std::optional<Message> message() const {
    return std::visit([&](const auto& detail) { return describe(event(), detail); }, event().detail);
  }

 private:
  using PartWords::describe;

  [[nodiscard]] Told describe(const Event& /*event*/, const BeamFormed& formed) const {
    if (formed.snell) {
      const std::string from = object(part_above().object);
      if (formed.snell->n1 == formed.snell->n2) return Message{"walk.straight_beam_formed", {{"object", from}}};
      return Message{"walk.refracted_beam_formed",
                     {{"object", from}, {"degrees", formed.off * 180 / std::numbers::pi}}};
    }
    if (formed.parent >= 0) return Message{"walk.mirrored_beam_formed", {{"object", object(part_above().object)}}};
    if (timeline_.of_strip()) return Message{"walk.beam_formed", {{"cell", pixel().column}}};
    return Message{"walk.image_beam_formed", {{"column", pixel().column}, {"row", pixel().row}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const RayNotFormed& stub) const {
    if (stub.kind != RayKind::beam) return std::nullopt;
    if (stub.why == Ending::depth) return Message{"walk.beam_depth", {{"depth", depth()}}};
    return Message{
        "walk.beam_threshold",
        {{"share", Fraction{max_component(stub.throughput)}}, {"threshold", Fraction{scene_.limits.threshold}}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const Found& found) const {
    if (current().kind != RayKind::shadow || current().end_radius == 0) return std::nullopt;
    return uncovered(found);
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const BeamCut& cut) const {
    const auto count = static_cast<int>(cut.pieces.size());
    if (count > 1) return Message{"walk.beam_cut", {{"count", count}}};
    const int only = cut.pieces.front().object;
    if (only < 0) return Message{"walk.beam_sees_nothing", {}};
    return Message{"walk.beam_whole", {{"object", object(only)}}};
  }

  [[nodiscard]] Told describe(const Event& event, const ShadeCalled& called) const {
    return Message{event.line == Line::shade_parts            ? "walk.parts_called"
                   : event.line == Line::shade_mirrored_parts ? "walk.mirrored_parts_called"
                                                              : "walk.refracted_parts_called",
                   {{"depth", called.depth}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const PartBegun& begun) const {
    const int number = begun.number + 1;
    if (begun.sees_nothing)
      return Message{"walk.part_sees_nothing",
                     {{"number", number}, {"count", begun.count}, {"coverage", begun.coverage}}};
    return Message{"walk.part_sees",
                   {{"number", number}, {"count", begun.count}, {"object", seen()}, {"coverage", begun.coverage}}};
  }

  [[nodiscard]] Told describe(const Event& event, const Decided& decided) const {
    const bool nothing = part().object < 0;
    if (event.line == Line::if_flat_mirror) {
      if (nothing) return Message{"walk.part_background_no_mirror", {}};
      if (!decided.holds) return Message{"walk.part_no_mirror", {{"object", seen()}}};
      return Message{"walk.part_mirrors", {{"object", seen()}, {"weight", decided.weight}}};
    }
    if (event.line == Line::if_flat_glass) {
      if (nothing) return Message{"walk.part_background_no_glass", {}};
      if (!decided.holds) return Message{"walk.part_no_glass", {{"object", seen()}}};
      return Message{"walk.part_refracts", {{"object", seen()}, {"weight", decided.weight}}};
    }
    if (nothing) return Message{"walk.part_background_no_ray", {}};
    return Message{decided.holds ? "walk.part_sends_rays" : "walk.part_sends_no_rays", {{"object", seen()}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const PartAdded& added) const {
    constexpr double seen = 0.0005;  // of three digits
    if (added.off < seen)
      return Message{added.last ? "walk.last_part_added" : "walk.part_added",
                     {{"colour", added.shade}, {"share", added.share}, {"mean", added.mean}}};
    return Message{added.last ? "walk.last_part_added_off" : "walk.part_added_off",
                   {{"colour", added.shade}, {"share", added.share}, {"off", added.off}, {"mean", added.mean}}};
  }
};

}  // namespace

std::optional<Message> beam_message(const Scene& scene, const Timeline& timeline, int position) {
  return BeamDescriber(scene, timeline, position).message();
}

}  // namespace raywalk
