// A screen that nobody sees (Xvfb), the real program on it, and a hand to move the mouse and press keys (xdotool).
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gui/folder.h"
#include "support/catch.h"

namespace raywalk::test {

// A program that was started; ended at the end.
class Child {
 public:
  // With these variables added to the environment. `err`: file for what it says on standard error.
  Child(const std::vector<std::string>& words, const std::vector<std::pair<std::string, std::string>>& environment,
        const std::filesystem::path& err, int inherited = -1);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  [[nodiscard]] pid_t id() const { return id_; }
  // Its exit code once it has ended, 128 + the signal's number when a signal ended it; nothing after `seconds`.
  std::optional<int> wait(double seconds);

 private:
  pid_t id_ = -1;
  std::optional<int> exit_code_;
};

class Desktop {
 public:
  // Why there can be none on this machine; empty when there can.
  static std::string missing();

  Desktop(int width, int height);
  Desktop(const Desktop&) = delete;
  Desktop& operator=(const Desktop&) = delete;

  [[nodiscard]] const std::string& display() const { return display_; }
  // Calls xdotool and waits for it.
  void hand(const std::vector<std::string>& words) const;
  // Writes what is on the screen as a PNG.
  void picture(const std::filesystem::path& path) const;
  // A folder that is gone at the end.
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  Folder folder_;
  std::string display_;
  std::optional<Child> server_;
};

// raywalk in its window.
class Visualiser {
 public:
  Visualiser(const Desktop& desktop, const std::vector<std::string>& arguments);

  // What the program last reported of itself.
  [[nodiscard]] const nlohmann::json& report() const { return report_; }
  // Waits until what it reports is as wanted; false when it is not within `seconds`.
  bool until(const std::function<bool(const nlohmann::json&)>& wanted, double seconds = 30);
  // Waits until this member is that.
  bool until(const std::string& member, const nlohmann::json& value);

  void move_to(double x, double y) const;
  void click(const std::string& item);
  // From one place of the window to another, in a few moves.
  void drag(double x, double y, double to_x, double to_y);
  void key(const std::string& name) const;
  // Into the field that has the keyboard, or is about to have it.
  void type(const std::string& text);
  // The same in place of what stands there.
  void retype(const std::string& text);
  // [x, y] of the middle of an item.
  [[nodiscard]] std::pair<double, double> place(const std::string& item) const;

  std::optional<int> wait(double seconds = 30) { return program_.wait(seconds); }
  [[nodiscard]] pid_t id() const { return program_.id(); }
  [[nodiscard]] std::string said() const;
  // Processor time that it has taken so far, seconds.
  [[nodiscard]] double processor_time() const;

 private:
  const Desktop& desktop_;
  std::filesystem::path report_path_, err_;
  Child program_;
  nlohmann::json report_;
};

// At the beginning of a test: passes over it where there can be no desktop.
#define NEEDS_A_DESKTOP                                                                     \
  if (const std::string missing = Desktop::missing(); !missing.empty()) {                   \
    RAYWALK_SKIP("the window was not tried: " << missing << " (apt install xvfb xdotool)"); \
  }

}  // namespace raywalk::test
