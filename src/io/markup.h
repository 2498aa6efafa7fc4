#pragma once
// Text in SVG and HTML.

#include <string>
#include <string_view>

namespace raywalk {

/// Text with &, <, > and double quotes as entities.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace raywalk
