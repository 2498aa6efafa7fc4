#pragma once

#include "timeline/message.h"

#include <optional>

namespace raywalk {

/// What a line of CONE TRACING did; nothing where it did what those of other pseudocodes do.
[[nodiscard]] std::optional<Message> cone_message(const Scene& scene, const Timeline& timeline, int position);

}  // namespace raywalk
