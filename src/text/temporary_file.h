#pragma once

#include <filesystem>
#include <string>

namespace raywalk {

/// A new file in a folder that disappears with the program, however that ends, unless it is given a name. On Linux it
/// has no name until then, if the file system supports that. Elsewhere it is called .raywalk-HOST-PROCESS-N.tmp; files
/// left by a killed program are removed by the next one that writes into the folder on the same host. Folders may be
/// shared by the machines of a cluster: files of other hosts are left alone.
class TemporaryFile {
 public:
  TemporaryFile() = default;
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// 0, or the errno of what failed; so too below.
  [[nodiscard]] int open(const std::filesystem::path& folder);
  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Becomes the file of this name, in the same folder, replacing any old one; closes it.
  [[nodiscard]] int take_name(const std::string& name);
  void discard();

 private:
  [[nodiscard]] int find_name(int (*take)(int, const char*));
  void forget_name();

  std::filesystem::path folder_;
  std::string name_;  ///< empty while it has none
  int descriptor_ = -1;
};

/// Removes the named ones. For a signal handler that ends the program: async-signal-safe.
void remove_temporary_files() noexcept;

}  // namespace raywalk
