#pragma once
// Text in SVG and HTML.

#include <string>
#include <string_view>

namespace raywalk {

/// Text with &, <, > and double quotes as entities.
[[nodiscard]] std::string escaped(std::string_view text);
/// The same with powers: what follows the ^ of "N^-1/2" (digits, -, /, N) is put between `open` and `close`.
[[nodiscard]] std::string escaped_with_powers(std::string_view text, std::string_view open, std::string_view close);

}  // namespace raywalk
