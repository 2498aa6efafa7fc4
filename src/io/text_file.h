#pragma once
// The one way in which text comes in, whatever editor or system wrote it: scenes, meshes of text, lessons, scripts.

#include "io/error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

/// The byte order mark (BOM) that some editors put before UTF-8. Nobody sees it.
inline constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

/// Why a text is in another encoding than ours, by its first bytes; none where it is not.
[[nodiscard]] std::optional<Error> why_not_utf8(std::string_view bytes, const std::string& path);

/// Makes each lone CR in [begin, end) an LF.
void end_lines_with_lf(std::string& bytes, std::size_t begin, std::size_t end);

/// Makes the bytes of a text file what all readers expect: UTF-8 without a mark, whose lines end with LF or CR LF. A
/// mark of UTF-8 at the beginning is taken away, and a lone CR, which ended lines once, becomes LF; a last line needs
/// no end. Refuses, by name, UTF-16 and UTF-32, and a mark at the beginning of a later line, where files were joined:
/// unseen, it would make another word of the line's first. `path` is for messages.
[[nodiscard]] Result<void> make_plain_text(std::string& bytes, const std::string& path);

/// The text of a file, made plain; what read_file refuses is refused here too.
[[nodiscard]] Result<std::string> read_text(const std::string& path, std::size_t most_bytes);

}  // namespace raywalk
