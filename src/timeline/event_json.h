#pragma once

#include "scene/scene.h"
#include "trace/event.h"

#include <nlohmann/json_fwd.hpp>

namespace raywalk {

/// All that an event carries, as a JSON object: `line`, `procedure`, `depth`, `what` (the kind of event: "ray_formed")
/// and that kind's own members. Points and colours are arrays of three; what there is none of is left out; objects and
/// lights stand by index and by name.
[[nodiscard]] nlohmann::ordered_json event_json(const Scene& scene, const Event& event);

}  // namespace raywalk
