#pragma once
// What is said of parts, whether of beams or of cones, and what pencils say by the same means.

#include "timeline/message.h"

#include <optional>
#include <string>

namespace raywalk {

/// Of the line that has just run, at a position of a recording. Those who say more derive from it.
class PartWords {
 protected:
  using Told = std::optional<Message>;

  PartWords(const Scene& scene, const Timeline& timeline, int position)
      : scene_(scene), timeline_(timeline), position_(position) {}

  [[nodiscard]] const Event& event() const { return *timeline_.just_run(position_); }
  [[nodiscard]] const RayRecord& ray(int index) const { return timeline_.rays()[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const RayRecord& current() const { return ray(timeline_.current_ray(position_)); }
  /// The part that the line is about.
  [[nodiscard]] const RayRecord& part() const { return ray(timeline_.part_of(timeline_.current_ray(position_))); }
  /// That a mirrored or bent one, the current ray, comes from.
  [[nodiscard]] const RayRecord& part_above() const { return ray(current().parent); }
  [[nodiscard]] const PixelRecord& pixel() const {
    return timeline_.pixels()[static_cast<std::size_t>(timeline_.current_pixel(position_))];
  }
  [[nodiscard]] int depth() const {
    return timeline_.frames()[static_cast<std::size_t>(timeline_.current_frame(position_))].depth;
  }
  [[nodiscard]] std::string object(int index) const {
    return index < 0 ? std::string() : scene_.objects[static_cast<std::size_t>(index)].name;
  }
  [[nodiscard]] std::string seen() const { return object(part().object); }
  [[nodiscard]] std::string light() const { return scene_.lights[static_cast<std::size_t>(current().light)].name; }
  /// How much of a light with an extent is seen from a part.
  [[nodiscard]] Message uncovered(const Found& found) const {
    const double share = max_component(found.transmittance);
    if (found.ending == Ending::blocked)
      return {"walk.light_covered_by", {{"light", light()}, {"object", object(found.object)}}};
    if (share >= 1) return {"walk.light_uncovered", {{"light", light()}}};
    return {"walk.light_partly", {{"light", light()}, {"share", share}}};
  }

  /// As of other pseudocodes.
  template <class Detail>
  [[nodiscard]] Told describe(const Event& /*event*/, const Detail& /*detail*/) const {
    return std::nullopt;
  }
  [[nodiscard]] Told describe(const Event& /*event*/, const PartShaded& shaded) const {
    if (part().object < 0) return Message{"walk.part_background", {{"colour", shaded.total}}};
    return Message{"walk.part_shaded", {{"object", seen()}, {"colour", shaded.total}}};
  }

  const Scene& scene_;
  const Timeline& timeline_;
  int position_;
};

}  // namespace raywalk
