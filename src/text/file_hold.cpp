#include "text/file_hold.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace raywalk {

#if defined(__EMSCRIPTEN__)

// A page has its files to itself: page.js keeps those of other pages away.
std::shared_ptr<const FileHold> FileHold::take(const std::string& /*path*/) {
  return std::shared_ptr<const FileHold>(new FileHold);
}

FileHold::~FileHold() = default;

#else

namespace {

/// Whether the open file still has this name: whoever held it before may have removed it.
bool is_named(int descriptor, const std::string& name) {
  struct stat open{}, named{};
  return ::fstat(descriptor, &open) == 0 && ::stat(name.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

}  // namespace

std::shared_ptr<const FileHold> FileHold::take(const std::string& path) {
  const std::filesystem::path file(path);
  const std::shared_ptr<FileHold> hold(new FileHold);
  hold->lock_ = (file.parent_path() / ("." + file.filename().string() + ".lock")).string();
  for (;;) {
    const int descriptor = ::open(hold->lock_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0) return hold;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      const bool is_held = errno == EWOULDBLOCK;
      ::close(descriptor);
      return is_held ? nullptr : hold;
    }
    if (is_named(descriptor, hold->lock_)) {
      hold->descriptor_ = descriptor;
      return hold;
    }
    ::close(descriptor);
  }
}

FileHold::~FileHold() {
  if (descriptor_ < 0) return;
  ::unlink(lock_.c_str());
  ::close(descriptor_);
}

#endif

}  // namespace raywalk
