#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "gui/desktop.h"

namespace raywalk::test {

/// The classic scene in the window, at the first line of the walk.
class ClassicWalk {
 public:
  ClassicWalk() : raywalk(desktop_, {std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml"}) {
    started =
        raywalk.until([](const nlohmann::json& report) { return report["window"]["frames"].get<int>() >= 3; }, 60);
    raywalk.key("t");
    started = started && raywalk.until("mode", "trace");
  }
  void keep_picture(const std::string& name) const {
    desktop_.picture(std::filesystem::path(std::getenv("RAYWALK_BIN")).parent_path() / "window-test" / (name + ".png"));
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return desktop_.folder(); }
  void hand(const std::vector<std::string>& words) const { desktop_.hand(words); }
  /// Waits until a member of one of the report's parts is that.
  bool until(const std::string& part, const std::string& member, const nlohmann::json& value, double seconds = 60) {
    return raywalk.until(
        [&](const nlohmann::json& report) { return report.contains(part) && report[part][member] == value; }, seconds);
  }

 private:
  Desktop desktop_{1280, 800};

 public:
  Visualiser raywalk;
  bool started = false;
};

}  // namespace raywalk::test
