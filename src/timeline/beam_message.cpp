#include "timeline/beam_message.h"

#include <string>

namespace raywalk {

namespace {

class BeamDescriber {
 public:
  BeamDescriber(const Scene& scene, const Timeline& timeline, int position)
      : scene_(scene), timeline_(timeline), position_(position) {}

  [[nodiscard]] std::optional<Message> message() const {
    const Event& event = *timeline_.just_run(position_);
    return std::visit([&](const auto& detail) { return describe(event, detail); }, event.detail);
  }

 private:
  using Told = std::optional<Message>;

  [[nodiscard]] const RayRecord& ray(int index) const { return timeline_.rays()[static_cast<std::size_t>(index)]; }
  /// The part that the line is about.
  [[nodiscard]] const RayRecord& part() const { return ray(timeline_.part_of(timeline_.current_ray(position_))); }
  [[nodiscard]] std::string object(int index) const {
    return index < 0 ? std::string() : scene_.objects[static_cast<std::size_t>(index)].name;
  }
  [[nodiscard]] std::string seen() const { return object(part().object); }

  /// As of other pseudocodes.
  template <class Detail>
  [[nodiscard]] Told describe(const Event& /*event*/, const Detail& /*detail*/) const {
    return std::nullopt;
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const BeamFormed& formed) const {
    if (formed.parent >= 0) return Message{"walk.mirrored_beam_formed", {{"object", object(ray(part_above()).object)}}};
    const PixelRecord& pixel = timeline_.pixels()[static_cast<std::size_t>(timeline_.current_pixel(position_))];
    return Message{"walk.beam_formed", {{"cell", pixel.column}}};
  }
  /// That a mirrored beam, the current ray, comes from.
  [[nodiscard]] int part_above() const { return ray(timeline_.current_ray(position_)).parent; }

  [[nodiscard]] Told describe(const Event& /*event*/, const RayNotFormed& stub) const {
    if (stub.kind != RayKind::beam) return std::nullopt;
    if (stub.why == Ending::depth) {
      const int frame = timeline_.current_frame(position_);
      return Message{"walk.beam_depth", {{"depth", timeline_.frames()[static_cast<std::size_t>(frame)].depth}}};
    }
    return Message{
        "walk.beam_threshold",
        {{"share", Fraction{max_component(stub.throughput)}}, {"threshold", Fraction{scene_.limits.threshold}}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const BeamCut& cut) const {
    const auto count = static_cast<int>(cut.pieces.size());
    if (count > 1) return Message{"walk.beam_cut", {{"count", count}}};
    const int only = cut.pieces.front().object;
    if (only < 0) return Message{"walk.beam_sees_nothing", {}};
    return Message{"walk.beam_whole", {{"object", object(only)}}};
  }

  [[nodiscard]] Told describe(const Event& event, const ShadeCalled& called) const {
    return Message{event.line == Line::shade_parts ? "walk.parts_called" : "walk.mirrored_parts_called",
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

  [[nodiscard]] Told describe(const Event& /*event*/, const PartShaded& shaded) const {
    if (part().object < 0) return Message{"walk.part_background", {{"colour", shaded.total}}};
    return Message{"walk.part_shaded", {{"object", seen()}, {"colour", shaded.total}}};
  }

  [[nodiscard]] Told describe(const Event& event, const Decided& decided) const {
    const bool nothing = part().object < 0;
    if (event.line == Line::if_flat_mirror) {
      if (nothing) return Message{"walk.part_background_no_mirror", {}};
      if (!decided.holds) return Message{"walk.part_no_mirror", {{"object", seen()}}};
      return Message{"walk.part_mirrors", {{"object", seen()}, {"weight", decided.weight}}};
    }
    if (nothing) return Message{"walk.part_background_no_ray", {}};
    return Message{decided.holds ? "walk.part_sends_rays" : "walk.part_sends_no_rays", {{"object", seen()}}};
  }

  [[nodiscard]] Told describe(const Event& /*event*/, const PartAdded& added) const {
    return Message{added.last ? "walk.last_part_added" : "walk.part_added",
                   {{"colour", added.shade}, {"share", added.share}, {"mean", added.mean}}};
  }

  const Scene& scene_;
  const Timeline& timeline_;
  int position_;
};

}  // namespace

std::optional<Message> beam_message(const Scene& scene, const Timeline& timeline, int position) {
  return BeamDescriber(scene, timeline, position).message();
}

}  // namespace raywalk
