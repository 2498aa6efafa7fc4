#include "gui/desktop.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include "image/image_file.h"
#include "image/srgb.h"
#include "support/catch.h"

namespace raywalk::test {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto pause = std::chrono::milliseconds(20);

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool installed(const std::string& program) {
  std::istringstream folders(std::getenv("PATH") != nullptr ? std::getenv("PATH") : "");
  std::string folder;
  while (std::getline(folders, folder, ':')) {
    if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

std::string raywalk_program() {
  const char* path = std::getenv("RAYWALK_BIN");
  return path != nullptr ? path : "";
}

}  // namespace

Child::Child(const std::vector<std::string>& words, const std::vector<std::pair<std::string, std::string>>& environment,
             const fs::path& err, int inherited) {
  std::vector<std::string> copy = words;
  std::vector<char*> argv;
  for (std::string& word : copy) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::string err_name = err.string();
  id_ = fork();
  REQUIRE(id_ >= 0);
  if (id_ > 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nothing stays behind when the tests are killed
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  const int nothing = open("/dev/null", O_RDWR), file = open(err_name.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (nothing < 0 || file < 0) _exit(126);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  if (inherited >= 0) fcntl(inherited, F_SETFD, 0);
  execvp(argv.front(), argv.data());
  _exit(127);
}

Child::~Child() {
  if (exit_code_) return;
  kill(id_, SIGTERM);
  if (wait(5)) return;
  kill(id_, SIGKILL);
  waitpid(id_, nullptr, 0);
}

std::optional<int> Child::wait(double seconds) {
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (!exit_code_) {
    int status = 0;
    if (waitpid(id_, &status, WNOHANG) == id_) {
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    } else if (Clock::now() > end) {
      return std::nullopt;
    } else {
      std::this_thread::sleep_for(pause);
    }
  }
  return exit_code_;
}

std::string Desktop::missing() {
  for (const char* program : {"Xvfb", "xdotool"}) {
    if (!installed(program)) return std::string(program) + " is not installed";
  }
  if (raywalk_program().empty()) return "RAYWALK_BIN does not say which program to try";
  return {};
}

Desktop::Desktop(int width, int height) {
  int ends[2] = {-1, -1};
  REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
  const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
  // The server picks a number that is free and tells it; the picture of the screen is a file in our folder.
  server_.emplace(std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", size,
                                           "-noreset", "-nolisten", "tcp", "-fbdir", folder().string()},
                  std::vector<std::pair<std::string, std::string>>{}, folder() / "xvfb.err", ends[1]);
  close(ends[1]);
  std::string number;
  char c = 0;
  while (read(ends[0], &c, 1) == 1 && c != '\n') number += c;
  close(ends[0]);
  INFO(bytes_of(folder() / "xvfb.err"));
  REQUIRE_FALSE(number.empty());
  display_ = ":" + number;
}

void Desktop::hand(const std::vector<std::string>& words) const {
  std::vector<std::string> whole{"xdotool"};
  whole.insert(whole.end(), words.begin(), words.end());
  Child child(whole, {{"DISPLAY", display_}}, folder() / "xdotool.err");
  const auto code = child.wait(20);
  INFO(bytes_of(folder() / "xdotool.err"));
  REQUIRE(code == 0);
}

void Desktop::picture(const fs::path& path) const {
  // The format of xwd: a header of 32-bit numbers, the most significant byte first, then a table of colours.
  const std::string dump = bytes_of(folder() / "Xvfb_screen0");
  const auto number = [&](std::size_t i) {
    std::size_t value = 0;
    for (std::size_t byte = 0; byte < 4; ++byte)
      value = value << 8U | static_cast<unsigned char>(dump.at(4 * i + byte));
    return value;
  };
  const std::size_t header = number(0), width = number(4), height = number(5), row_bytes = number(12),
                    colours = number(19);
  REQUIRE(number(11) == 32);  // bits of a pixel: blue, green, red and one that is unused
  const std::size_t pixels = header + 12 * colours;
  REQUIRE(dump.size() >= pixels + height * row_bytes);
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  const auto linear = [](char byte) {
    return static_cast<float>(srgb_decode(static_cast<double>(static_cast<unsigned char>(byte)) / 255));
  };
  for (std::size_t y = 0; y < height; ++y) {
    const char* at = dump.data() + pixels + y * row_bytes;
    for (std::size_t x = 0; x < width; ++x, at += 4)
      image.pixels.emplace_back(linear(at[2]), linear(at[1]), linear(at[0]));
  }
  fs::create_directories(path.parent_path());
  REQUIRE(write_image(path.string(), image).has_value());
}

Visualiser::Visualiser(const Desktop& desktop, const std::vector<std::string>& arguments)
    : desktop_(desktop),
      report_path_(desktop.folder() / "report.json"),
      err_(desktop.folder() / "raywalk.err"),
      program_(
          [&] {
            // Of a program that ran here before.
            fs::remove(report_path_);
            fs::remove(err_);
            std::vector<std::string> words{raywalk_program(), "--report", report_path_.string(), "--state-dir",
                                           (desktop.folder() / "state").string()};
            words.insert(words.end(), arguments.begin(), arguments.end());
            return words;
          }(),
          // What the drivers allocate once and keep is none of ours.
          {{"DISPLAY", desktop.display()},
           {"LC_ALL", "C"},
           {"LIBGL_ALWAYS_SOFTWARE", "1"},
           {"ASAN_OPTIONS", "detect_leaks=0"}},
          err_) {}

bool Visualiser::until(const std::function<bool(const nlohmann::json&)>& wanted, double seconds) {
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  do {
    auto report = nlohmann::json::parse(bytes_of(report_path_), nullptr, false);
    if (report.is_object()) {
      report_ = std::move(report);
      if (wanted(report_)) return true;
    }
    std::this_thread::sleep_for(pause);
  } while (Clock::now() < end);
  return false;
}

bool Visualiser::until(const std::string& member, const nlohmann::json& value) {
  return until([&](const nlohmann::json& report) { return report.contains(member) && report[member] == value; });
}

std::pair<double, double> Visualiser::place(const std::string& item) const {
  INFO("no item is called " << item << "; the program said: " << said());
  REQUIRE(report_.contains("items"));
  REQUIRE(report_["items"].contains(item));
  const auto& r = report_["items"][item];
  return {r[0].get<double>() + r[2].get<double>() / 2, r[1].get<double>() + r[3].get<double>() / 2};
}

void Visualiser::move_to(double x, double y) const {
  desktop_.hand({"mousemove", std::to_string(std::lround(x)), std::to_string(std::lround(y))});
  std::this_thread::sleep_for(std::chrono::milliseconds(120));
}

void Visualiser::click(const std::string& item) {
  // It may be about to appear.
  until([&](const nlohmann::json& report) { return report["items"].contains(item); }, 10);
  const auto [x, y] = place(item);
  move_to(x, y);
  desktop_.hand({"mousedown", "1", "sleep", "0.15", "mouseup", "1", "sleep", "0.15"});
}

void Visualiser::drag(double x, double y, double to_x, double to_y) {
  move_to(x, y);
  desktop_.hand({"mousedown", "1"});
  for (const double part : {0.2, 0.5, 0.8, 1.0}) move_to(x + part * (to_x - x), y + part * (to_y - y));
  desktop_.hand({"sleep", "0.15", "mouseup", "1", "sleep", "0.15"});
}

void Visualiser::key(const std::string& name) const { desktop_.hand({"key", "--delay", "60", name, "sleep", "0.15"}); }

void Visualiser::type(const std::string& text) {
  // Before a slow frame has given it the keyboard, letters would be commands.
  until([](const nlohmann::json& report) { return report["window"]["typing"] == true; }, 20);
  desktop_.hand({"type", "--delay", "40", text});
  desktop_.hand({"sleep", "0.2"});
}

void Visualiser::retype(const std::string& text) {
  until([](const nlohmann::json& report) { return report["window"]["typing"] == true; }, 20);
  key("ctrl+a");
  type(text);
}

std::string Visualiser::said() const { return bytes_of(err_); }

double Visualiser::processor_time() const {
  const std::string stat = bytes_of("/proc/" + std::to_string(id()) + "/stat");
  std::istringstream fields(stat.substr(std::min(stat.rfind(')') + 1, stat.size())));
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace raywalk::test
