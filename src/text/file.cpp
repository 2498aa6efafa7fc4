#include "text/file.h"

#include "text/file_path.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

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

/// `replaces`: something that there was would have been lost.
std::string hint_for_writing(int error_number, bool replaces) {
  const std::string whole = replaces ? "; the old file is unchanged" : "";
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "make room on the disk or write elsewhere" + whole;
    case EFBIG:
      return "the file would be larger than this system allows; write something smaller" + whole;
    case ENOENT:  // the folder exists, as in /proc
      return "no file can be made in this folder; choose another";
    case ENOTDIR:
    case EEXIST:
      return "a file stands where the path has a folder; check the path";
    case EACCES:
    case EPERM:
      return "choose a folder that you may write to" + whole;
    case EROFS:
      return "this disk is read-only; choose another" + whole;
    case ENAMETOOLONG:
      return "choose a shorter name";
    case ELOOP:
      return "its symbolic links lead in a circle";
    default:
      return "check the path, or write elsewhere" + whole;
  }
}

std::string hint_for_reading(const std::string& path, int error_number) {
  std::error_code failed;
  switch (error_number) {
    case ENOENT:
      if (std::filesystem::is_symlink(path, failed)) return "it is a symbolic link to a file that does not exist";
      return path == "-" ? "nothing is read from standard input; put it into a file"
                         : "there is no such file; check the path";
    case ENOTDIR:
      return "a file stands where the path has a folder; check the path";
    case ELOOP:
      return "its symbolic links lead in a circle";
    case ENAMETOOLONG:
      return "no file has so long a name; check the path";
    case EACCES:
    case EPERM:
      return "check the permissions of the file and of its folders";
    default:
      return "check the disk that it lies on";
  }
}

/// The kind of what is not a regular file; "" for a file.
std::string_view what_else(mode_t mode) {
  if (S_ISREG(mode)) return "";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISSOCK(mode) ? "a socket" : "a device";
}

Result<void> check_folder(const std::string& path, const std::filesystem::path& folder) {
  struct stat status{};
  const int error = ::stat(folder.c_str(), &status) == 0 ? 0 : errno;
  if (error == 0 && S_ISDIR(status.st_mode)) return {};
  if (error == 0) return tl::unexpected(cannot("write", path, ENOTDIR, hint_for_writing(ENOTDIR, false)));
  if (error == ENOENT)
    return tl::unexpected(Error{path, 0, 0, "cannot write: there is no folder " + folder.string(),
                                "make the folder first, or check the path"});
  return tl::unexpected(cannot("write", path, error, hint_for_writing(error, false)));
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

/// Gives a new file the owner and the group of the old one, where that is allowed, and returns which of its permissions
/// it may have then: none that were meant for another owner or group.
mode_t take_owner(int descriptor, uid_t user, gid_t group, mode_t mode) {
  if (::fchown(descriptor, user, group) == 0) return mode;  // the superuser, or the owner within his groups
  mode &= ~static_cast<mode_t>(S_ISUID);
  if (::fchown(descriptor, static_cast<uid_t>(-1), group) == 0) return mode;
  const mode_t of_all = (mode & S_IRWXO) << 3;  // as bits of a group
  return mode & ~(S_ISGID | (S_IRWXG & ~of_all));
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::size_t max_bytes) {
  if (path.empty()) return tl::unexpected(Error{"", 0, 0, "cannot read: the file name is empty", "give a file name"});
  // Checked before opening: opening a pipe waits for its writer, and opening a device may have effects.
  struct stat status{};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (const std::string_view what = exists ? what_else(status.st_mode) : ""; !what.empty())
    return tl::unexpected(
        Error{path, 0, 0, "this is " + std::string(what) + " (expected a file)",
              S_ISDIR(status.st_mode) ? "name a file inside it" : "put what it holds into a file first"});
  // If a pipe has taken its place meanwhile, opening does not block either.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) return tl::unexpected(cannot("read", path, errno, hint_for_reading(path, errno)));
  std::string bytes;
  constexpr std::size_t chunk = std::size_t{1} << 16;
  for (;;) {
    const std::size_t have = bytes.size();
    bytes.resize(have + chunk);
    ssize_t got = ::read(file.number(), bytes.data() + have, chunk);
    while (got < 0 && errno == EINTR) got = ::read(file.number(), bytes.data() + have, chunk);
    if (got < 0) return tl::unexpected(cannot("read", path, errno, hint_for_reading(path, errno)));
    bytes.resize(have + static_cast<std::size_t>(got));
    if (got == 0) {
      detail::note_read(path);
      return bytes;
    }
    if (bytes.size() > max_bytes)
      return tl::unexpected(
          Error{path, 0, 0, "the file is too large (expected at most " + std::to_string(max_bytes >> 20) + " MiB)",
                "is this the right file?"});
  }
}

FileWriter::~FileWriter() {
  if (direct_ >= 0) ::close(direct_);
}

tl::unexpected<Error> FileWriter::give_up(int error_number) {
  if (direct_ >= 0) ::close(direct_);
  direct_ = -1;
  new_file_.discard();
  return tl::unexpected(
      cannot("write", path_, error_number, hint_for_writing(error_number, !is_empty_ && is_regular_)));
}

Result<void> FileWriter::find_target(const std::string& path) {
  path_ = path;
  if (path.empty()) return tl::unexpected(Error{"", 0, 0, "cannot write: the file name is empty", "give a file name"});
  const std::optional<int> descriptor = detail::descriptor_named(path);
  if (descriptor)
    if (auto open = detail::check_descriptor(path, *descriptor); !open) return open;
  struct stat old{};
  exists_ = ::stat(path.c_str(), &old) == 0;
  if (!exists_ && errno != ENOENT && errno != ENOTDIR) return give_up(errno);
  is_regular_ = !exists_ || (S_ISREG(old.st_mode) && !descriptor);
  is_empty_ = !exists_ || old.st_size == 0;
  target_ = path;
  // The links of what is open already may lead to no path at all, as a pipe's.
  if (is_regular_) {
    const auto target = detail::follow_links(path);
    if (!target) return tl::unexpected(target.error());
    target_ = target->string();
  }
  if (exists_ && S_ISDIR(old.st_mode))
    return tl::unexpected(
        Error{path, 0, 0, "cannot write: this is a folder (expected a file name)", "add a file name to the path"});
  if (exists_ && ::access(target_.c_str(), W_OK) != 0)
    return tl::unexpected(cannot("write", path, errno,
                                 errno == EROFS ? hint_for_writing(errno, !is_empty_ && is_regular_)
                                                : "the file is write-protected; choose another name"));
  if (!exists_)
    if (auto there = check_folder(path, detail::folder_of(target_)); !there) return there;
  old_mode_ = old.st_mode & 07777;
  old_user_ = old.st_uid;
  old_group_ = old.st_gid;
  return {};
}

Result<void> FileWriter::open(const std::string& path) {
  if (auto noted = detail::note_written(path); !noted) return noted;
  if (auto found = find_target(path); !found) return found;
  if (is_regular_) {
    if (const int error = new_file_.open(detail::folder_of(target_))) return give_up(error);
  } else {
    direct_ = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (direct_ < 0) return give_up(errno);
  }
  return {};
}

Result<void> FileWriter::write(std::string_view bytes) {
  if (const int error = write_all(is_regular_ ? new_file_.descriptor() : direct_, bytes)) return give_up(error);
  return {};
}

Result<void> FileWriter::write_zeros(std::size_t count) {
  if (is_regular_) {
    const off_t end = ::lseek(new_file_.descriptor(), static_cast<off_t>(count), SEEK_CUR);
    if (end < 0 || ::ftruncate(new_file_.descriptor(), end) != 0) return give_up(errno);
    return {};
  }
  const std::string zeros(std::min(count, std::size_t{1} << 16), '\0');
  for (; count > 0; count -= std::min(count, zeros.size()))
    if (auto written = write(std::string_view(zeros).substr(0, count)); !written) return written;
  return {};
}

Result<void> FileWriter::commit() {
  if (!is_regular_) {
    const int descriptor = std::exchange(direct_, -1);
    if (::close(descriptor) != 0) return give_up(errno);
    return {};
  }
  const int descriptor = new_file_.descriptor();
  if (exists_) {
    // The owner first: changing it clears the set-user-ID bits.
    const mode_t mode = take_owner(descriptor, old_user_, old_group_, old_mode_);
    if (::fchmod(descriptor, mode) != 0) return give_up(errno);
  }
  // Without this, a system crash soon after could leave an empty file of this name.
  if (::fsync(descriptor) != 0 && errno != EINVAL) return give_up(errno);
  if (const int error = new_file_.take_name(target_)) return give_up(error);
  const Descriptor folder(::open(detail::folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) ::fsync(folder.number());
  return {};
}

Result<void> claim_output(const std::string& path, OutputUse use) {
  FileWriter attempt;
  if (auto found = attempt.find_target(path); !found) return found;
  if (attempt.is_regular_)
    if (const int error = attempt.new_file_.open(detail::folder_of(attempt.target_))) return attempt.give_up(error);
  return detail::note_claim(path, use);
}

Result<void> make_folder(const std::string& path) {
  std::error_code failed;
  std::filesystem::create_directories(path, failed);
  if (!failed) return {};
  return tl::unexpected(cannot("make this folder", path, failed.value(), hint_for_writing(failed.value(), false)));
}

Result<bool> make_new_file(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.is_open()) return true;
  if (errno == EEXIST) return false;
  return tl::unexpected(cannot("write", path, errno, hint_for_writing(errno, false)));
}

Result<std::string> set_aside(const std::string& path) {
  constexpr int most = 99;
  for (int i = 1; i <= most; ++i) {
    const std::string kept = path + ".damaged" + (i == 1 ? std::string() : "-" + std::to_string(i));
    std::error_code failed;
    if (std::filesystem::exists(std::filesystem::symlink_status(kept, failed))) continue;
    std::filesystem::rename(path, kept, failed);
    if (failed) return tl::unexpected(cannot("rename", path, failed.value(), hint_for_writing(failed.value(), false)));
    return kept;
  }
  return tl::unexpected(cannot("rename", path, EEXIST, "remove what was kept of it before"));
}

Result<void> write_file_atomically(const std::string& path, std::string_view bytes) {
  FileWriter file;
  if (const auto opened = file.open(path); !opened) return opened;
  if (const auto written = file.write(bytes); !written) return written;
  return file.commit();
}

}  // namespace raywalk
