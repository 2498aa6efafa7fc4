#include "app/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "support/catch.h"

namespace raywalk::test {

namespace fs = std::filesystem;

Process::Process(const std::string& program, const std::vector<std::string>& arguments, const fs::path& folder) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::string where = folder.string(), out = said_.file("out"), err = said_.file("err");
  // Closed by exec: until then the child still is a copy of this program, with the test framework's signal handlers.
  std::array<int, 2> begun{};
  REQUIRE(pipe2(begun.data(), O_CLOEXEC) == 0);
  id_ = fork();
  REQUIRE(id_ >= 0);
  if (id_ > 0) {
    close(begun[1]);
    char byte = 0;
    while (::read(begun[0], &byte, 1) < 0 && errno == EINTR) {
    }
    close(begun[0]);
    return;
  }
  const auto redirect = [](int descriptor, const char* path, int flags) {
    const int file = open(path, flags, 0600);
    if (file < 0 || dup2(file, descriptor) < 0) _exit(126);
  };
  redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  redirect(STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  redirect(STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
  constexpr unsigned max_seconds = 120;
  alarm(max_seconds);  // whatever hangs is ended, also when the tests themselves are
  if (chdir(where.c_str()) != 0) _exit(126);
  execv(argv.front(), argv.data());
  _exit(127);
}

Process::~Process() {
  if (id_ > 0) {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
}

void Process::send(int signal) const { REQUIRE(kill(id_, signal) == 0); }

bool Process::catches(int signal) const {
  std::istringstream status(contents("/proc/" + std::to_string(id_) + "/status"));
  std::string word;
  while (status >> word)
    if (word == "SigCgt:" && status >> word) return (std::stoull(word, nullptr, 16) >> (signal - 1) & 1U) == 1;
  return false;
}

void Process::wait_until_busy_and_catching(int signal) const {
  // Field 14 of `stat`: ticks spent in the program itself.
  const auto ticks = [&] {
    const std::string stat = contents("/proc/" + std::to_string(id_) + "/stat");
    std::istringstream fields(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
    std::string field;
    for (int i = 3; i <= 14; ++i) fields >> field;
    return std::stol(field);
  };
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); };
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  const auto in_time = [&] { return std::chrono::steady_clock::now() < give_up; };
  while (!catches(signal) && in_time()) pause();
  REQUIRE(catches(signal));
  const long enough = ticks() + sysconf(_SC_CLK_TCK) / 3;
  while (ticks() < enough && in_time()) pause();
  REQUIRE(ticks() >= enough);
}

Outcome Process::wait() {
  int status = 0;
  REQUIRE(waitpid(id_, &status, 0) == id_);
  id_ = -1;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, contents(said_.file("out")), contents(said_.file("err"))};
}

std::string raywalk_program() {
  const char* path = std::getenv("RAYWALK_BIN");
  INFO("RAYWALK_BIN must name the program under test; ctest sets it");
  REQUIRE(path != nullptr);
  REQUIRE(fs::exists(path));
  return path;
}

void Folder::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(path_ / name, std::ios::binary) << bytes;
}

std::string Folder::read(const std::string& name) const { return contents(*this / name); }

std::vector<std::string> Folder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

Outcome Folder::run(const std::vector<std::string>& arguments) const {
  Process process(raywalk_program(), arguments, path_);
  return process.wait();
}

}  // namespace raywalk::test
