#pragma once

#include "text/error.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// Whether two paths lead to the same file: through links, as another hard link, or in another case if the file system
/// ignores case. Files need not exist: then, whether they would be the same. Special files (a device, a pipe) never
/// are: nothing in them can be lost.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// Why `path` must not be written: it is one of `files`, which `is` describes, such as "a part of the open scene".
[[nodiscard]] std::optional<Error> why_in_use(const std::string& path, const std::vector<std::string>& files,
                                              std::string_view is);

/// The files of one operation. While it exists, all that read_file reads and FileWriter writes, anywhere in the
/// program, is noted here, and FileWriter refuses to overwrite what was read or written. Each command has one, so that
/// its readers and writers need not know of each other.
class FileLedger {
 public:
  /// What it notes. A reader that the window no longer waits for goes on beside writers that it has nothing to do with.
  enum class Notes { all, reading };
  explicit FileLedger(Notes notes = Notes::all);
  ~FileLedger() { close(); }
  FileLedger(const FileLedger&) = delete;
  FileLedger& operator=(const FileLedger&) = delete;

  /// The files read so far, as they were named, without duplicates.
  [[nodiscard]] std::vector<std::string> files_read() const;
  /// Whether overwriting a file in use was refused: that is wrong usage of the program.
  [[nodiscard]] bool has_refused() const;
  void close();
};

/// How an output is used.
enum class OutputUse {
  once,  ///< written only
  kept,  ///< read back, and rewritten during the work
};

namespace detail {

void note_read(const std::string& path);
/// Notes that `path` will be written, or fails if it must not be.
[[nodiscard]] Result<void> note_claim(const std::string& path, OutputUse use);
[[nodiscard]] Result<void> note_written(const std::string& path);

}  // namespace detail

}  // namespace raywalk
