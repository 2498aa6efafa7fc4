#pragma once

#include <memory>
#include <string>

namespace raywalk {

/// Says to other processes that a file is in use, until this is gone or the process is, however that ends: a lock on
/// a hidden file beside it, for the file itself may be replaced meanwhile.
class FileHold {
 public:
  /// Null if it is held already. Where nothing can be locked, as in a folder that is read-only, everybody gets one.
  [[nodiscard]] static std::shared_ptr<const FileHold> take(const std::string& path);
  ~FileHold();
  FileHold(const FileHold&) = delete;
  FileHold& operator=(const FileHold&) = delete;

 private:
  FileHold() = default;

  std::string lock_;     ///< path of the hidden file
  int descriptor_ = -1;  ///< -1: nothing is locked
};

}  // namespace raywalk
