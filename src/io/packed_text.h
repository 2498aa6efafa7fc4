#pragma once
// Text in the letters that an address may hold unescaped: A-Z, a-z, 0-9, - and _.

#include "text/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace raywalk {

/// Deflated (RFC 1951), knowing beforehand what scenes are mostly made of, then base64url (RFC 4648) without padding.
/// The same text always gives the same letters. Empty for an empty text.
[[nodiscard]] std::string pack_text(std::string_view text);

/// The text of these letters, which may come from anybody: fails if pack_text cannot have written them, or if the text
/// is longer than `most`, which is all that it takes of memory.
[[nodiscard]] Result<std::string> unpack_text(std::string_view letters, std::size_t most);

}  // namespace raywalk
