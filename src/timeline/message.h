#pragma once
// What a step did, independent of language: an id and its arguments. `view` puts it into words.

#include "scene/scene.h"
#include "timeline/timeline.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

/// A fraction, 0..1.
struct Fraction {
  double value;
  friend bool operator==(const Fraction&, const Fraction&) = default;
};

/// What a ray met: an object, with the group member or the triangle if it is a group or a mesh.
struct HitObject {
  std::string object, member{};  ///< names; no member: empty
  int triangle = -1;             ///< from 0; none: -1
  friend bool operator==(const HitObject&, const HitObject&) = default;
};

/// The value of {name} in the text. A string is a name from the scene.
struct Argument {
  std::string_view name;
  std::variant<int, double, Rgbd, Fraction, RayKind, std::string, HitObject> value;
};

/// The id of a text, "walk.found_hit", with its arguments.
struct Message {
  std::string_view id;
  std::vector<Argument> arguments;
};

/// What the line that has just run at `position` did. `timeline` was recorded from `scene`; 0 <= position <= steps().
[[nodiscard]] Message describe(const Scene& scene, const Timeline& timeline, int position);

}  // namespace raywalk
