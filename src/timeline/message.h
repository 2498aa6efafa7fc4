#pragma once
// What a step did, without language: an id and its arguments. `view` puts it into words.

#include "scene/scene.h"
#include "timeline/timeline.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

/// A part of the whole, 0..1.
struct Share {
  double value;
  friend bool operator==(const Share&, const Share&) = default;
};

/// What a ray met: an object, or more exactly a member of the group or a triangle of the mesh that it is.
struct Met {
  std::string object, member{};  ///< names; no member: empty
  int triangle = -1;             ///< from 0; none: -1
  friend bool operator==(const Met&, const Met&) = default;
};

/// What stands in the text for {name}. The name of a thing is a string as it stands in the scene.
struct Argument {
  std::string_view name;
  std::variant<int, double, Rgbd, Share, RayKind, std::string, Met> value;
};

/// The id of a text, "walk.found_hit", with what is to be filled in.
struct Message {
  std::string_view id;
  std::vector<Argument> arguments;
};

/// What the line that has just run at `position` did. `timeline` was recorded from `scene`; 0 <= position <= steps().
[[nodiscard]] Message describe(const Scene& scene, const Timeline& timeline, int position);

}  // namespace raywalk
