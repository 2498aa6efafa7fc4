#pragma once

#include <filesystem>
#include <string>

namespace raywalk {

/// A new file in a folder that vanishes with the program, however that ends, unless it is given a name. On Linux it has
/// none until then, where the file system allows that. Elsewhere it is called .raywalk-HOST-PROCESS-N.tmp; what a
/// killed program left of that kind is cleared by the next one that writes into the folder on the same host. Folders
/// may be shared by the machines of a cluster: what others have under way is left alone.
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
  /// Becomes the file of this name, in the same folder, in place of what was there; closes it.
  [[nodiscard]] int take_name(const std::string& name);
  void discard();

 private:
  [[nodiscard]] int find_name(int (*take)(int, const char*));
  void forget_name();

  std::filesystem::path folder_;
  std::string name_;  ///< empty while it has none
  int descriptor_ = -1;
};

/// Removes what has a name. For a signal handler that ends the program: calls nothing that it may not.
void remove_temporary_files() noexcept;

}  // namespace raywalk
