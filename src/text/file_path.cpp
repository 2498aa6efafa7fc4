#include "text/file_path.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <utility>

namespace raywalk {

namespace fs = std::filesystem;

std::string ending_of(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

std::string absolute_path(const std::string& path) {
  std::error_code failed;
  const fs::path whole = fs::absolute(path, failed);
  if (path.empty() || failed) return path;
  // Behind a link to a folder, ".." leads elsewhere than the words say.
  fs::path plain = whole.lexically_normal();
  return (fs::equivalent(whole.parent_path(), plain.parent_path(), failed) ? plain : whole).string();
}

namespace {

/// The path of a file:// address on this machine, or file:/; nothing if it is none.
std::optional<std::string> path_of_address(std::string_view address) {
  constexpr std::string_view scheme = "file:", host = "//", own_host = "localhost";
  if (!address.starts_with(scheme)) return std::nullopt;
  address.remove_prefix(scheme.size());
  if (address.starts_with(host)) {
    address.remove_prefix(host.size());
    if (address.starts_with(own_host)) address.remove_prefix(own_host.size());
  }
  if (!address.starts_with('/')) return std::nullopt;
  std::string path;
  for (std::size_t i = 0; i < address.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = address.data() + i + 1;
    if (address[i] == '%' && i + 2 < address.size()) {
      const auto [end, error] = std::from_chars(digits, digits + 2, byte, 16);
      if (error == std::errc() && end == digits + 2 && byte != 0) {
        path += static_cast<char>(byte);
        i += 2;
        continue;
      }
    }
    path += address[i];
  }
  return path;
}

}  // namespace

std::string path_meant(std::string_view words, const std::string& home) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = std::min(words.find_first_not_of(blanks), words.size());
  words.remove_prefix(first);
  words = words.substr(0, words.find_last_not_of(blanks) + 1);
  for (const char quote : {'"', '\''})
    if (words.size() > 2 && words.front() == quote && words.back() == quote) {
      words = words.substr(1, words.size() - 2);
      break;
    }
  if (const auto path = path_of_address(words)) return *path;
  const bool begins_at_home = !home.empty() && (words == "~" || words.starts_with("~/"));
  return begins_at_home ? home + std::string(words.substr(1)) : std::string(words);
}

}  // namespace raywalk

namespace raywalk::detail {

namespace fs = std::filesystem;

namespace {

/// One link of `path` on, which is a symbolic link.
fs::path after_link(const fs::path& path, std::error_code& failed) {
  const fs::path next = fs::read_symlink(path, failed);
  return next.is_absolute() ? next : path.parent_path() / next;
}

constexpr int max_links = 40;  // as Linux itself

tl::unexpected<Error> cannot_follow(const std::string& path, int error_number, std::string hint) {
  return tl::unexpected(Error{path, 0, 0, "cannot follow the link: " + system_message(error_number), std::move(hint)});
}

}  // namespace

Result<fs::path> follow_links(const std::string& path) {
  fs::path target = path;
  for (int i = 0; i < max_links; ++i) {
    std::error_code error;
    if (!fs::is_symlink(target, error)) return target;
    target = after_link(target, error);
    if (error) return cannot_follow(path, error.value(), "check where the link points");
  }
  return cannot_follow(path, ELOOP, "the symbolic links lead in a circle");
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

std::optional<int> descriptor_named(fs::path path) {
  constexpr std::array<std::string_view, 3> standard{"/dev/stdin", "/dev/stdout", "/dev/stderr"};
  for (int i = 0; i < max_links; ++i) {
    std::string_view word = path.native();
    for (std::size_t number = 0; number < standard.size(); ++number)
      if (word == standard[number]) return static_cast<int>(number);
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
      if (!word.starts_with(folder)) continue;
      word.remove_prefix(folder.size());
      int number = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
      if (error == std::errc() && end == word.data() + word.size()) return number;
    }
    std::error_code failed;
    if (!fs::is_symlink(path, failed)) break;
    path = after_link(path, failed);
  }
  return std::nullopt;
}

Result<void> check_descriptor(const std::string& path, int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags >= 0 && (flags & O_ACCMODE) != O_RDONLY) return {};
  constexpr std::array<std::string_view, 3> names{"standard input", "standard output", "standard error"};
  const std::string name = descriptor >= 0 && descriptor < static_cast<int>(names.size())
                               ? std::string(names[static_cast<std::size_t>(descriptor)])
                               : "descriptor " + std::to_string(descriptor);
  return tl::unexpected(Error{path, 0, 0, "cannot write: " + name + " is closed, or open for reading only",
                              "redirect it to a file or a pipe, or name a file"});
}

}  // namespace raywalk::detail
