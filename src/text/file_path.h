#pragma once
// Where a path leads to.

#include "text/error.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

/// The same file by a path that leads to it from every working folder, such as a later session's.
[[nodiscard]] std::string absolute_path(const std::string& path);
/// The path that a person means who types or pastes these words: without blanks around them and the quotes that shells
/// and file managers put, of a file:// address its path, with `home` for a ~ in front (empty: it stands for itself).
[[nodiscard]] std::string path_meant(std::string_view words, const std::string& home);
/// The ending of a file's name in small letters, ".png"; empty if it has none.
[[nodiscard]] std::string ending_of(const std::string& path);

}  // namespace raywalk

namespace raywalk::detail {

/// The file that `path` leads to through all symbolic links, even if that file does not exist yet.
[[nodiscard]] Result<std::filesystem::path> follow_links(const std::string& path);
/// The folder of the file of this name.
[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path& file);

/// The descriptor of this process that a path names, itself or through links, as /dev/stdout does: what is open already
/// is appended to, not replaced.
[[nodiscard]] std::optional<int> descriptor_named(std::filesystem::path path);
/// Fails if it is not open for writing.
[[nodiscard]] Result<void> check_descriptor(const std::string& path, int descriptor);

}  // namespace raywalk::detail
