#include "text/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <optional>
#include <string_view>
#include <utility>

namespace raywalk {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view name_begin = ".raywalk-", name_end = ".tmp";

/// This host's name, in letters allowed in file names; "" if it has none.
std::string host_name() {
  std::array<char, 65> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "";
  std::string host = name.data();
  for (char& c : host)
    if (c == '/' || static_cast<unsigned char>(c) <= ' ') c = '_';
  return host;
}

/// ".raywalk-HOST-", with which the names of this host's files begin.
std::string head_of_this_host() { return std::string(name_begin) + host_name() + "-"; }

/// The process that owns this file; nothing if it is not one of this host's files.
std::optional<pid_t> owner_of(std::string_view name, std::string_view host_head) {
  if (!name.starts_with(host_head) || !name.ends_with(name_end)) return std::nullopt;
  name.remove_prefix(host_head.size());
  name.remove_suffix(std::min(name_end.size(), name.size()));
  const auto number = [&name](auto& value) {
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), value);
    name.remove_prefix(static_cast<std::size_t>(end - name.data()));
    return error == std::errc() && value >= 0;
  };
  int process = 0, count = 0;
  if (!number(process) || !name.starts_with('-')) return std::nullopt;
  name.remove_prefix(1);
  if (!number(count) || !name.empty() || process == 0) return std::nullopt;
  return process;
}

/// Removes what dead processes of this host left in `folder`. A process may be alive but invisible, in another
/// container of the same name: then it still holds its lock.
void clear_left_behind(const fs::path& folder) {
  if (host_name().empty()) return;
  const std::string host_head = head_of_this_host();
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    const auto process = owner_of(entry->path().filename().string(), host_head);
    if (!process || ::kill(*process, 0) == 0 || errno != ESRCH) continue;
    const std::string name = entry->path().string();
    const int descriptor = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) continue;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(name.c_str());
    ::close(descriptor);
  }
}

/// A descriptor, or -1 and errno.
int open_nameless([[maybe_unused]] const fs::path& folder) {
#ifdef O_TMPFILE
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  // It gets its name through /proc/self/fd, which some containers lack.
  if (descriptor < 0 || ::access(("/proc/self/fd/" + std::to_string(descriptor)).c_str(), F_OK) == 0) return descriptor;
  ::close(descriptor);
#endif
  return -1;
}

/// Current names of temporary files. There are rarely two at once; those that do not fit here are removed later.
std::array<std::atomic<const char*>, 16> names_in_use{};
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

}  // namespace

void remove_temporary_files() noexcept {
  for (const auto& name : names_in_use)
    if (const char* const path = name.load()) ::unlink(path);
}

TemporaryFile::~TemporaryFile() { discard(); }

void TemporaryFile::discard() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  if (!name_.empty()) ::unlink(name_.c_str());
  forget_name();
}

void TemporaryFile::forget_name() {
  for (auto& name : names_in_use) {
    const char* own = name_.c_str();
    if (name.compare_exchange_strong(own, nullptr)) break;
  }
  name_.clear();
}

/// Tries unused names until `take`, which returns -1 and sets errno on failure, succeeds.
int TemporaryFile::find_name(int (*take)(int descriptor, const char* name)) {
  constexpr int max_tries = 1000;
  const std::string own_head = head_of_this_host() + std::to_string(::getpid()) + "-";
  for (int i = 0; i < max_tries; ++i) {
    const std::string name = (folder_ / (own_head + std::to_string(i) + std::string(name_end))).string();
    const int taken = take(descriptor_, name.c_str());
    if (taken < 0 && errno == EEXIST) continue;
    if (taken < 0) return errno;
    name_ = name;
    for (auto& free : names_in_use) {
      const char* none = nullptr;
      if (free.compare_exchange_strong(none, name_.c_str())) break;
    }
    if (descriptor_ < 0) descriptor_ = taken;
    return 0;
  }
  return EEXIST;
}

int TemporaryFile::open(const fs::path& folder) {
  discard();
  folder_ = folder;
  clear_left_behind(folder);
  descriptor_ = open_nameless(folder);
  if (descriptor_ >= 0) return 0;
  const int error =
      find_name([](int, const char* name) { return ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
  if (error == 0) static_cast<void>(::flock(descriptor_, LOCK_EX | LOCK_NB));  // as clear_left_behind expects it
  return error;
}

int TemporaryFile::take_name(const std::string& name) {
  const auto give_up = [this](int error) {
    discard();
    return error;
  };
  // A link cannot replace a file, so it briefly has its own name.
  if (name_.empty()) {
    const int error = find_name([](int descriptor, const char* own) {
      const std::string open_file = "/proc/self/fd/" + std::to_string(descriptor);
      return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, own, AT_SYMLINK_FOLLOW);
    });
    if (error != 0) return give_up(error);
  }
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) return give_up(errno);  // network file systems report a full disk only here
  if (::rename(name_.c_str(), name.c_str()) != 0) return give_up(errno);
  forget_name();
  return 0;
}

}  // namespace raywalk
