// Runs the real program and looks at what it does.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace raywalk::test {

struct Outcome {
  int exit_code = -1;  // 128 + the signal's number when a signal ended it
  std::string out, err;
};

// A program under way.
class Process {
 public:
  // `program` with `arguments`, in `folder`, without a terminal and without a display.
  Process(const std::string& program, const std::vector<std::string>& arguments, const std::filesystem::path& folder);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void send(int signal) const;
  // Whether it has set a handler for `signal`.
  [[nodiscard]] bool catches(int signal) const;
  // Waits until it has set a handler for `signal` and has computed for a while after that.
  void wait_until_busy_and_catching(int signal) const;
  // Waits for its end.
  Outcome wait();

 private:
  int id_ = -1;
  TemporaryFolder said_;
};

// raywalk as it was built, from RAYWALK_BIN; fails the test case when it is not set.
std::string raywalk_program();

// An empty folder, gone at the end.
class Folder {
 public:
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& bytes) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  [[nodiscard]] bool holds(const std::string& name) const { return std::filesystem::exists(path_ / name); }
  // Names in it, sorted.
  [[nodiscard]] std::vector<std::string> names() const;
  // Runs raywalk here.
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const;

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path();
};

}  // namespace raywalk::test
