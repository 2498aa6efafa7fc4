#pragma once

#include "io/error.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// Whether two paths lead to one file: through links, as another hard link, or in another case where the file system
/// does not tell them apart. Files need not exist: then it is asked whether they would be one. What is no regular file
/// (a device, a pipe) is never the same: nothing in it can be lost.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// Why nothing may be written to `path`: it is one of `files`, of which `is` says what they are, such as "a part of the
/// open scene".
[[nodiscard]] std::optional<Error> why_in_use(const std::string& path, const std::vector<std::string>& files,
                                              std::string_view is);

/// The files of one piece of work. While it is open, whatever read_file reads and FileWriter writes, anywhere in the
/// program, is noted here, and FileWriter refuses to write over what was read or written. One lives around each
/// command, so that neither its readers nor its writers have to know of each other.
class FileLedger {
 public:
  FileLedger();
  ~FileLedger() { close(); }
  FileLedger(const FileLedger&) = delete;
  FileLedger& operator=(const FileLedger&) = delete;

  /// What was read so far, as it was named, each name once.
  [[nodiscard]] std::vector<std::string> files_read() const;
  /// Whether something was to be written over what is in use: that is wrong use of the program.
  [[nodiscard]] bool has_refused() const;
  void close();
};

/// What becomes of an output.
enum class OutputUse {
  once,  ///< written, and that is all
  kept,  ///< read back, and written again and again, as the work goes on
};

namespace detail {

void note_read(const std::string& path);
/// Notes that `path` will be written, or is now; or says why it may not be.
[[nodiscard]] Result<void> note_claim(const std::string& path, OutputUse use);
[[nodiscard]] Result<void> note_written(const std::string& path);

}  // namespace detail

}  // namespace raywalk
