#include "io/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace raywalk {

namespace {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }
  /// Closes it now. Network file systems report a full disk only here.
  [[nodiscard]] bool close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0;
  }

 private:
  int number_;
};

Error cannot(const char* what, const std::string& path, int error_number, std::string hint) {
  return {path, 0, 0, std::string("cannot ") + what + ": " + system_message(error_number), std::move(hint)};
}

std::string hint_for_writing(int error_number, bool replaces) {
  const std::string whole = replaces ? "; the old file is unchanged" : "";
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "make room on the disk or write elsewhere" + whole;
    case EFBIG:
      return "the file would be larger than this system allows; write something smaller" + whole;
    case ENOENT:
      return "make the folder first, or check the path";
    case EACCES:
    case EPERM:
      return "choose a folder that you may write to" + whole;
    case EROFS:
      return "this disk is read-only; choose another" + whole;
    case ENAMETOOLONG:
      return "choose a shorter name";
    default:
      return "check the path, or write elsewhere" + whole;
  }
}

/// 0, or the errno of what failed.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return errno;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// The file that `path` means after all symbolic links, also when that file does not exist yet.
Result<std::filesystem::path> follow_links(const std::string& path) {
  namespace fs = std::filesystem;
  fs::path target = path;
  constexpr int most_links = 40;  // as Linux itself
  for (int i = 0; i < most_links; ++i) {
    std::error_code error;
    if (fs::symlink_status(target, error).type() != fs::file_type::symlink) return target;
    const fs::path next = fs::read_symlink(target, error);
    if (error) return tl::unexpected(cannot("follow the link", path, error.value(), "check where the link points"));
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return tl::unexpected(cannot("follow the link", path, ELOOP, "the symbolic links lead in a circle"));
}

Result<void> write_directly(const std::string& path, std::string_view bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.is_open()) return tl::unexpected(cannot("write", path, errno, hint_for_writing(errno, false)));
  if (const int error = write_all(file.number(), bytes))
    return tl::unexpected(cannot("write", path, error, hint_for_writing(error, false)));
  if (!file.close()) return tl::unexpected(cannot("write", path, errno, hint_for_writing(errno, false)));
  return {};
}

/// Opens a new file in `folder` under a name that nobody has; the name is put into `name`. -1 and errno on failure.
int open_new_file(const std::filesystem::path& folder, std::string& name) {
  constexpr int most_tries = 1000;
  for (int i = 0; i < most_tries; ++i) {
    name = (folder / (".raywalk-" + std::to_string(::getpid()) + "-" + std::to_string(i) + ".tmp")).string();
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::size_t most_bytes) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open())
    return tl::unexpected(cannot("read", path, errno,
                                 errno == ENOENT ? "there is no such file; check the path" : "check the permissions"));
  struct stat status{};
  if (::fstat(file.number(), &status) == 0 && S_ISDIR(status.st_mode))
    return tl::unexpected(
        Error{path, 0, 0, "this is a folder (expected a file)", "name a file inside it, such as classic.toml"});
  std::string bytes;
  constexpr std::size_t chunk = std::size_t{1} << 16;
  for (;;) {
    const std::size_t have = bytes.size();
    bytes.resize(have + chunk);
    ssize_t got = ::read(file.number(), bytes.data() + have, chunk);
    while (got < 0 && errno == EINTR) got = ::read(file.number(), bytes.data() + have, chunk);
    if (got < 0) return tl::unexpected(cannot("read", path, errno, "check the disk and the permissions"));
    bytes.resize(have + static_cast<std::size_t>(got));
    if (got == 0) return bytes;
    if (bytes.size() > most_bytes)
      return tl::unexpected(
          Error{path, 0, 0, "the file is too large (expected at most " + std::to_string(most_bytes >> 20) + " MiB)",
                "is this the right file?"});
  }
}

Result<void> write_file_atomically(const std::string& path, std::string_view bytes) {
  if (path.empty()) return tl::unexpected(Error{"", 0, 0, "cannot write: the file name is empty", "give a file name"});
  const auto target = follow_links(path);
  if (!target) return tl::unexpected(target.error());
  struct stat old{};
  const bool exists = ::stat(target->c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode))
    return tl::unexpected(
        Error{path, 0, 0, "cannot write: this is a folder (expected a file name)", "add a file name to the path"});
  if (exists && !S_ISREG(old.st_mode)) return write_directly(path, bytes);
  if (exists && ::access(target->c_str(), W_OK) != 0)
    return tl::unexpected(cannot("write", path, errno, "the file is write-protected; choose another name"));

  const std::filesystem::path folder = target->has_parent_path() ? target->parent_path() : ".";
  std::string new_name;
  Descriptor file(open_new_file(folder, new_name));
  if (!file.is_open()) return tl::unexpected(cannot("write", path, errno, hint_for_writing(errno, exists)));
  const auto give_up = [&](int error) {
    ::unlink(new_name.c_str());
    return tl::unexpected(cannot("write", path, error, hint_for_writing(error, exists)));
  };
  if (const int error = write_all(file.number(), bytes)) return give_up(error);
  if (exists) {
    // The owner first: changing it clears the set-user-id bits. Only the superuser may, so failing is no error.
    if (::fchown(file.number(), old.st_uid, old.st_gid) != 0) errno = 0;
    if (::fchmod(file.number(), old.st_mode & 07777) != 0) return give_up(errno);
  }
  // Without this a crash of the machine soon after could leave the name on an empty file.
  if (::fsync(file.number()) != 0 && errno != EINVAL) return give_up(errno);
  if (!file.close()) return give_up(errno);
  if (::rename(new_name.c_str(), target->c_str()) != 0) return give_up(errno);
  const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.is_open()) ::fsync(directory.number());
  return {};
}

}  // namespace raywalk
