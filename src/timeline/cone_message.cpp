#include "timeline/cone_message.h"

#include "timeline/part_words.h"

#include <string>

namespace raywalk {

namespace {

class ConeDescriber : PartWords {
 public:
  ConeDescriber(const Scene& scene, const Timeline& timeline, int position) : PartWords(scene, timeline, position) {}

  [[nodiscard]] std::optional<Message> message() const {
    return std::visit([&](const auto& detail) { return describe(event(), detail); }, event().detail);
  }

 private:
  using PartWords::describe;

  [[nodiscard]] Told describe(const Event& event, const BeamFormed& formed) const {
    if (formed.parent >= 0) {
      const std::string from = object(part_above().object);
      if (event.line == Line::form_reflected_cone && formed.spread < 0)
        return Message{"walk.reflected_cone_converges",
                       {{"object", from}, {"radius", formed.radius}, {"spread", -formed.spread}}};
      if (event.line == Line::form_reflected_cone)
        return Message{"walk.reflected_cone_spreads",
                       {{"object", from}, {"radius", formed.radius}, {"spread", formed.spread}}};
      if (formed.spread < 0)
        return Message{"walk.refracted_cone_converges",
                       {{"object", from}, {"radius", formed.radius}, {"spread", -formed.spread}}};
      return Message{"walk.refracted_cone_spreads",
                     {{"object", from}, {"radius", formed.radius}, {"spread", formed.spread}}};
    }
    if (timeline_.of_strip()) return Message{"walk.cone_formed", {{"cell", pixel().column}}};
    return Message{"walk.image_cone_formed", {{"column", pixel().column}, {"row", pixel().row}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const RayFormed& /*shadow*/) const {
    return Message{"walk.shadow_cone_formed", {{"object", seen()}, {"light", light()}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const RayNotFormed& stub) const {
    if (stub.kind != RayKind::beam) return std::nullopt;
    if (stub.why == Ending::depth) return Message{"walk.cone_depth", {{"depth", depth()}}};
    return Message{
        "walk.cone_threshold",
        {{"share", Fraction{max_component(stub.throughput)}}, {"threshold", Fraction{scene_.limits.threshold}}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const Found& found) const { return uncovered(found); }

  [[nodiscard]] Told describe(const Event& /*event*/, const BeamCut& cut) const {
    const auto count = static_cast<int>(cut.pieces.size());
    if (count > 1) return Message{"walk.cone_shared", {{"count", count}}};
    const int only = cut.pieces.front().object;
    if (only < 0) return Message{"walk.cone_sees_nothing", {}};
    return Message{"walk.cone_whole", {{"object", object(only)}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const ShadeCalled& called) const {
    return Message{"walk.cone_called", {{"depth", called.depth}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const PartBegun& begun) const {
    const int number = begun.number + 1;
    if (begun.sees_nothing)
      return Message{"walk.share_left", {{"number", number}, {"count", begun.count}, {"share", begun.coverage}}};
    return Message{"walk.share_sees",
                   {{"number", number}, {"count", begun.count}, {"object", seen()}, {"share", begun.coverage}}};
  }

  [[nodiscard]] Told describe(const Event& event, const Decided& decided) const {
    const bool mirror = event.line == Line::cone_if_reflective;
    if (part().object < 0)
      return Message{mirror ? "walk.part_background_no_mirror" : "walk.part_background_no_ray", {}};
    if (decided.why) return Message{"walk.totally_reflected", {{"object", seen()}}};
    if (!decided.holds) return Message{mirror ? "walk.cone_no_mirror" : "walk.cone_no_glass", {{"object", seen()}}};
    return Message{mirror ? "walk.cone_mirror" : "walk.cone_glass", {{"object", seen()}, {"weight", decided.weight}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const PartAdded& added) const {
    return Message{added.last ? "walk.last_share_added" : "walk.share_added",
                   {{"colour", added.shade}, {"share", added.share}, {"sum", added.mean}}};
  }
};

}  // namespace

std::optional<Message> cone_message(const Scene& scene, const Timeline& timeline, int position) {
  return ConeDescriber(scene, timeline, position).message();
}

}  // namespace raywalk
