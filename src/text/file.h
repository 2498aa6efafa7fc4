#pragma once

#include "text/error.h"
#include "text/file_ledger.h"
#include "text/temporary_file.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace raywalk {

/// The bytes of a file. Refuses more than `max_bytes`, and whatever is not a regular file: a pipe could block the
/// program indefinitely.
[[nodiscard]] Result<std::string> read_file(const std::string& path, std::size_t max_bytes);

/// Writes a file piece by piece, all or nothing: into a new file beside it, which takes its name only when `commit` is
/// called. The rules are those of write_file_atomically.
class FileWriter {
 public:
  FileWriter() = default;
  ~FileWriter();  ///< without a commit: as if nothing had been written (other than to a special file)
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  [[nodiscard]] Result<void> open(const std::string& path);
  [[nodiscard]] Result<void> write(std::string_view bytes);
  /// As many bytes 0, which take neither time nor room where the file system can leave them out.
  [[nodiscard]] Result<void> write_zeros(std::size_t count);
  [[nodiscard]] Result<void> commit();

 private:
  friend Result<void> claim_output(const std::string&, OutputUse);
  [[nodiscard]] tl::unexpected<Error> give_up(int error_number);
  /// Finds where to write, and whether that is possible; special files are not touched.
  [[nodiscard]] Result<void> find_target(const std::string& path);

  std::string path_, target_;  ///< as the user named it; after all links
  TemporaryFile new_file_;     ///< not open when written directly
  int direct_ = -1;            ///< the descriptor of a special file
  bool exists_ = false, is_regular_ = true;
  bool is_empty_ = true;  ///< no byte of an old file is replaced; so too for one just made to keep a name free
  unsigned old_mode_ = 0, old_user_ = 0, old_group_ = 0;
};

/// Announces, before hours of work, that a file will be written; fails if it may not (text/file_ledger.h) or could not
/// be. What shows only when writing, such as a full disk, is not detected. Nothing is touched.
[[nodiscard]] Result<void> claim_output(const std::string& path, OutputUse use = OutputUse::once);

/// Creates a folder and its parents if necessary.
[[nodiscard]] Result<void> make_folder(const std::string& path);

/// Creates an empty file; false if one of this name exists.
[[nodiscard]] Result<bool> make_new_file(const std::string& path);

/// Renames a file that cannot be made sense of, so that it is not replaced and somebody may still mend it: "a.json"
/// into "a.json.damaged", or with a number behind that. Returns its new path.
[[nodiscard]] Result<std::string> set_aside(const std::string& path);

/// Writes `bytes` as the file `path`, all or nothing: into a new file beside it, which then takes its name. Whatever
/// fails or kills the program, the old file stays whole. A symbolic link keeps pointing at its file, which is what is
/// replaced; permissions (owner and group too, where allowed) are kept. Special files (/dev/stdout, a pipe) are written
/// directly. A file that is write-protected is not replaced.
[[nodiscard]] Result<void> write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace raywalk
