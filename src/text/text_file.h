#pragma once
// Reads text files from any editor or system: scenes, text meshes, lessons, scripts.

#include "text/error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

/// The byte order mark (BOM) that some editors put before UTF-8. It is invisible.
inline constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

/// Why a text is in another encoding than UTF-8, by its first bytes; none if it is not.
[[nodiscard]] std::optional<Error> why_not_utf8(std::string_view bytes, const std::string& path);

/// Makes each lone CR in [begin, end) an LF.
void end_lines_with_lf(std::string& bytes, std::size_t begin, std::size_t end);

/// Removes those at the beginning: joined files may begin with several.
void drop_utf8_marks(std::string& bytes);

/// Normalizes the bytes of a text file: UTF-8 without a mark, whose lines end with LF or CR LF. A UTF-8 mark at the
/// beginning is removed, or several, and a lone CR, once a line end, becomes LF; the last line needs no end. Refuses
/// UTF-16 and UTF-32, a byte 0, and a mark at the beginning of a later line, where files were joined: it would
/// invisibly change the line's first word. `path` is for messages.
[[nodiscard]] Result<void> make_plain_text(std::string& bytes, const std::string& path);

/// The normalized text of a file; refuses what read_file refuses, too.
[[nodiscard]] Result<std::string> read_text(const std::string& path, std::size_t max_bytes);

}  // namespace raywalk
