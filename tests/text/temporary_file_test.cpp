#include "text/temporary_file.h"

#include "text/file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;
namespace fs = std::filesystem;

namespace {

std::string own_host() {
  std::array<char, 65> name{};
  REQUIRE(::gethostname(name.data(), name.size() - 1) == 0);
  return name.data();
}

/// The id of a process that is over.
pid_t dead_process() {
  const pid_t id = ::fork();
  if (id == 0) ::_exit(0);
  ::waitpid(id, nullptr, 0);
  return id;
}

void touch(const std::string& path) { std::ofstream(path) << "half"; }

}  // namespace

TEST_CASE("a temporary file takes its name or is gone") {
  const TemporaryFolder folder;
  {
    TemporaryFile file;
    REQUIRE(file.open(folder.path()) == 0);
    REQUIRE(::write(file.descriptor(), "new", 3) == 3);
  }
  CHECK(folder.entries() == 0);
  touch(folder.file("a"));
  TemporaryFile file, other;
  REQUIRE(file.open(folder.path()) == 0);
  REQUIRE(other.open(folder.path()) == 0);
  REQUIRE(::write(file.descriptor(), "new", 3) == 3);
  CHECK(file.take_name(folder.file("a")) == 0);
  CHECK_FALSE(file.is_open());
  CHECK(contents(folder.file("a")) == "new");
  CHECK(other.take_name(folder.file("b")) == 0);
  CHECK(folder.entries() == 2);
}

TEST_CASE("a killed program leaves nothing half-written") {
  const TemporaryFolder folder;
  touch(folder.file("a"));
  for (const int signal : {SIGKILL, SIGTERM, SIGHUP, SIGQUIT}) {
    std::array<int, 2> begun{};
    REQUIRE(::pipe(begun.data()) == 0);
    const pid_t id = ::fork();
    if (id == 0) {
      std::signal(signal, SIG_DFL);
      FileWriter file;
      const bool good = file.open(folder.file("a")) && file.write(std::string(1 << 20, 'x'));
      if (::write(begun[1], good ? "y" : "n", 1) != 1) ::_exit(1);
      for (;;) ::pause();
    }
    char answer = 0;
    REQUIRE(::read(begun[0], &answer, 1) == 1);
    CHECK(answer == 'y');
    ::kill(id, signal);
    ::waitpid(id, nullptr, 0);
    ::close(begun[0]);
    ::close(begun[1]);
    // Where files must have names, the next program that writes here clears what is left.
    REQUIRE(write_file_atomically(folder.file("b"), "x"));
    CHECK(folder.entries() == 2);
    CHECK(contents(folder.file("a")) == "half");
  }
}

TEST_CASE("what dead processes of this host left is cleared, and nothing else") {
  const TemporaryFolder folder;
  const std::string host = ".raywalk-" + own_host() + "-", dead = std::to_string(dead_process());
  const std::string left = folder.file(host + dead + "-0.tmp"), left_too = folder.file(host + dead + "-12.tmp");
  touch(left);
  touch(left_too);
  const std::string locked = folder.file(host + dead + "-1.tmp");  // as of a process that is out of sight
  touch(locked);
  const int holder = ::open(locked.c_str(), O_RDONLY);
  REQUIRE(::flock(holder, LOCK_EX) == 0);
  const std::string others[] = {host + std::to_string(::getppid()) + "-0.tmp",
                                ".raywalk-another.host-" + dead + "-0.tmp",
                                ".raywalk-" + own_host() + "x-" + dead + "-0.tmp",
                                host + dead + "-0.tmp.toml",
                                host + dead + ".tmp",
                                host + "-0.tmp",
                                host + "x" + dead + "-0.tmp",
                                ".raywalk-" + dead + "-0.tmp",
                                "mine-" + dead + "-0.tmp"};
  for (const std::string& name : others) touch(folder.file(name));
  REQUIRE(write_file_atomically(folder.file("a"), "x"));
  CHECK_FALSE(fs::exists(left));
  CHECK_FALSE(fs::exists(left_too));
  CHECK(fs::exists(locked));
  for (const std::string& name : others) {
    CAPTURE(name);
    CHECK(fs::exists(folder.file(name)));
  }
  ::close(holder);
}
