#pragma once

#include "io/error.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace raywalk {

/// The bytes of a file. Refuses more than `most_bytes`, and whatever is no file: a pipe could keep the program waiting
/// for ever.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t most_bytes);

/// Writes a file piece by piece, all or nothing: into a new file beside it, which takes its name only when `commit` is
/// called. The rules are those of write_file_atomically.
class FileWriter {
 public:
  FileWriter() = default;
  ~FileWriter();  ///< without a commit: as if nothing had been written (what is no regular file keeps what it got)
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  [[nodiscard]] Result<void> open(const std::string& path);
  [[nodiscard]] Result<void> write(std::string_view bytes);
  [[nodiscard]] Result<void> commit();

 private:
  [[nodiscard]] tl::unexpected<Error> give_up(int error_number);

  std::string path_, target_, new_name_;  ///< as the user named it; after all links; empty when written directly
  int descriptor_ = -1;
  bool exists_ = false;
  unsigned old_mode_ = 0, old_user_ = 0, old_group_ = 0;
};

/// Writes `bytes` as the file `path`, all or nothing: into a new file beside it, which then takes its name. Whatever
/// fails or kills the program, the old file stays whole. A symbolic link keeps pointing at its file, which is what is
/// replaced; permissions (and the owner, where allowed) are kept. What is no regular file (/dev/stdout, a pipe) is
/// written directly. A file that is write-protected is not replaced.
[[nodiscard]] Result<void> write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace raywalk
