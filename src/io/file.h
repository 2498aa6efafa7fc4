#pragma once

#include "io/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace raywalk {

/// The bytes of a file, or of anything else that can be read, such as a pipe. Refuses folders and more than
/// `most_bytes`.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t most_bytes);

/// Writes `bytes` as the file `path`, all or nothing: into a new file beside it, which then takes its name. Whatever
/// fails or kills the program, the old file stays whole. A symbolic link keeps pointing at its file, which is what is
/// replaced; permissions (and the owner, where allowed) are kept. What is no regular file (/dev/stdout, a pipe) is
/// written directly. A file that is write-protected is not replaced.
[[nodiscard]] Result<void> write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace raywalk
