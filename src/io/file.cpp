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

/// What a path leads to that is no file; "" for a file.
std::string_view what_else(mode_t mode) {
  if (S_ISREG(mode)) return "";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISSOCK(mode) ? "a socket" : "a device";
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
  // Asked before it is opened: to open a pipe waits for its writer, and to open a device may move it.
  struct stat status{};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (const std::string_view what = exists ? what_else(status.st_mode) : ""; !what.empty())
    return tl::unexpected(Error{path, 0, 0, "this is " + std::string(what) + " (expected a file)",
                                S_ISDIR(status.st_mode) ? "name a file inside it, such as classic.toml"
                                                        : "put what it holds into a file first"});
  // Should a pipe have taken its place by now, nothing waits for that one either.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open())
    return tl::unexpected(cannot("read", path, errno,
                                 errno == ENOENT ? "there is no such file; check the path" : "check the permissions"));
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

FileWriter::~FileWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!new_name_.empty()) ::unlink(new_name_.c_str());
}

tl::unexpected<Error> FileWriter::give_up(int error_number) {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  const bool replaces = exists_ && !new_name_.empty();
  if (!new_name_.empty()) ::unlink(new_name_.c_str());
  new_name_.clear();
  return tl::unexpected(cannot("write", path_, error_number, hint_for_writing(error_number, replaces)));
}

Result<void> FileWriter::open(const std::string& path) {
  path_ = path;
  if (path.empty()) return tl::unexpected(Error{"", 0, 0, "cannot write: the file name is empty", "give a file name"});
  const auto target = follow_links(path);
  if (!target) return tl::unexpected(target.error());
  target_ = target->string();
  struct stat old{};
  exists_ = ::stat(target_.c_str(), &old) == 0;
  if (exists_ && S_ISDIR(old.st_mode))
    return tl::unexpected(
        Error{path, 0, 0, "cannot write: this is a folder (expected a file name)", "add a file name to the path"});
  if (exists_ && !S_ISREG(old.st_mode)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) return give_up(errno);
    return {};
  }
  if (exists_ && ::access(target_.c_str(), W_OK) != 0)
    return tl::unexpected(cannot("write", path, errno, "the file is write-protected; choose another name"));
  old_mode_ = old.st_mode & 07777;
  old_user_ = old.st_uid;
  old_group_ = old.st_gid;
  const std::filesystem::path folder = target->has_parent_path() ? target->parent_path() : std::filesystem::path(".");
  std::string new_name;
  descriptor_ = open_new_file(folder, new_name);
  if (descriptor_ < 0) return tl::unexpected(cannot("write", path, errno, hint_for_writing(errno, exists_)));
  new_name_ = new_name;
  return {};
}

Result<void> FileWriter::write(std::string_view bytes) {
  if (const int error = write_all(descriptor_, bytes)) return give_up(error);
  return {};
}

Result<void> FileWriter::commit() {
  const auto close_now = [this] {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    return ::close(descriptor) == 0;  // network file systems report a full disk only here
  };
  if (new_name_.empty()) {
    if (!close_now()) return give_up(errno);
    return {};
  }
  if (exists_) {
    // The owner first: changing it clears the set-user-id bits. Only the superuser may, so failing is no error.
    if (::fchown(descriptor_, old_user_, old_group_) != 0) errno = 0;
    if (::fchmod(descriptor_, old_mode_) != 0) return give_up(errno);
  }
  // Without this a crash of the machine soon after could leave the name on an empty file.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) return give_up(errno);
  if (!close_now()) return give_up(errno);
  if (::rename(new_name_.c_str(), target_.c_str()) != 0) return give_up(errno);
  new_name_.clear();
  const std::filesystem::path folder = std::filesystem::path(target_).parent_path();
  const Descriptor directory(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.is_open()) ::fsync(directory.number());
  return {};
}

Result<void> write_file_atomically(const std::string& path, std::string_view bytes) {
  FileWriter file;
  if (const auto opened = file.open(path); !opened) return opened;
  if (const auto written = file.write(bytes); !written) return written;
  return file.commit();
}

}  // namespace raywalk
