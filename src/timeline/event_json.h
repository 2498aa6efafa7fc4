#pragma once

#include "timeline/timeline.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace raywalk {

/// An event as a JSON object: `line`, `procedure`, `depth`, `what` (the kind of event: "ray_formed") and that kind's
/// own members. Points and colours are arrays of three; absent values are left out; objects and lights are given by
/// index and by name.
[[nodiscard]] nlohmann::ordered_json event_json(const Scene& scene, const Event& event);

/// The index of the first event in which two walks of one scene differ in any bit; none if they are identical.
[[nodiscard]] std::optional<int> first_difference(const Scene& scene, const Timeline& one, const Timeline& other);

}  // namespace raywalk
