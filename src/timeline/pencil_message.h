#pragma once

#include "timeline/message.h"

#include <optional>

namespace raywalk {

/// What a line of PENCIL TRACING did; nothing where it did what the tracer's does.
[[nodiscard]] std::optional<Message> pencil_message(const Scene& scene, const Timeline& timeline, int position);

}  // namespace raywalk
