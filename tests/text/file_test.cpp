#include "text/file.h"
#include "text/file_hold.h"
#include "text/file_path.h"
#include "text/text_file.h"

#include <fcntl.h>
#include <grp.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <thread>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;
namespace fs = std::filesystem;

namespace {

mode_t permissions(const std::string& path) {
  struct stat status{};
  return ::stat(path.c_str(), &status) == 0 ? status.st_mode & 07777 : 0;
}

/// Files may not grow beyond `bytes`: the disk is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit old_{};
  void (*handler_)(int);
};

}  // namespace

TEST_CASE("a file of marks is read in no time") {
  std::string marks;
  for (int i = 0; i < 1'000'000; ++i) marks += utf8_mark;
  marks += "a = 1\n" + std::string(utf8_mark.substr(0, 2));
  REQUIRE(make_plain_text(marks, "a.toml"));
  CHECK(marks == "a = 1\n" + std::string(utf8_mark.substr(0, 2)));
}

TEST_CASE("a file is written and read back, bytes of every kind") {
  const TemporaryFolder folder;
  std::string bytes(300'000, 'x');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 37);
  REQUIRE(write_file_atomically(folder.file("a"), bytes));
  const auto back = read_file(folder.file("a"), bytes.size());
  REQUIRE(back);
  CHECK(*back == bytes);
  CHECK(folder.entries() == 1);
  // Replacing leaves nothing behind either, and what was longer is gone.
  REQUIRE(write_file_atomically(folder.file("a"), "short"));
  CHECK(contents(folder.file("a")) == "short");
  CHECK(folder.entries() == 1);
}

TEST_CASE("what is set aside keeps its bytes, and what was set aside before") {
  const TemporaryFolder folder;
  for (const char* bytes : {"one", "two"}) {
    REQUIRE(write_file_atomically(folder.file("a"), bytes));
    const auto kept = set_aside(folder.file("a"));
    REQUIRE(kept);
    CHECK(contents(*kept) == bytes);
    CHECK_FALSE(std::filesystem::exists(folder.file("a")));
  }
  CHECK(contents(folder.file("a.damaged")) == "one");
  CHECK(contents(folder.file("a.damaged-2")) == "two");
  const auto none = set_aside(folder.file("a"));
  REQUIRE_FALSE(none);
  CHECK(none.error().file == folder.file("a"));
}

TEST_CASE("a new file gets the permissions that the umask leaves, an old one keeps its own") {
  const TemporaryFolder folder;
  const mode_t old_mask = ::umask(027);
  REQUIRE(write_file_atomically(folder.file("new"), "x"));
  ::umask(old_mask);
  CHECK(permissions(folder.file("new")) == 0640);
  REQUIRE(::chmod(folder.file("new").c_str(), 0600) == 0);
  REQUIRE(write_file_atomically(folder.file("new"), "y"));
  CHECK(permissions(folder.file("new")) == 0600);
  CHECK(contents(folder.file("new")) == "y");
}

TEST_CASE("who may write a file of somebody else keeps its group, or gives its rights to no other") {
  if (::geteuid() != 0) RAYWALK_SKIP("only the superuser can make files of others");
  const TemporaryFolder folder;
  REQUIRE(::chmod(folder.path().c_str(), 0777) == 0);
  constexpr uid_t writer = 54321;
  constexpr gid_t shared = 54322, own = 54323;
  const auto overwritten = [&](mode_t mode, bool belongs) {
    const std::string path = folder.file("shared");
    put(path, "old");
    REQUIRE(::chown(path.c_str(), 0, shared) == 0);
    REQUIRE(::chmod(path.c_str(), mode) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
      const bool is_writer = ::setgroups(belongs ? 1 : 0, &shared) == 0 && ::setgid(own) == 0 && ::setuid(writer) == 0;
      ::_exit(is_writer && write_file_atomically(path, "new") ? 0 : 1);
    }
    int status = 1;
    ::waitpid(child, &status, 0);
    CHECK(status == 0);
    CHECK(contents(path) == "new");
    struct stat now{};
    ::stat(path.c_str(), &now);
    CHECK(now.st_uid == writer);
    CHECK(now.st_gid == (belongs ? shared : own));
    ::unlink(path.c_str());
    return now.st_mode & 07777;
  };
  CHECK(overwritten(0664, true) == 0664);
  CHECK(overwritten(06676, true) == 02676);
  CHECK(overwritten(06676, false) == 0666);
}

TEST_CASE("links keep pointing, and what they point to is replaced") {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("inner"));
  put(folder.file("inner/real"), "old");
  fs::create_symlink("inner/real", folder.file("link"));
  fs::create_symlink("link", folder.file("second"));
  REQUIRE(write_file_atomically(folder.file("second"), "new"));
  CHECK(fs::is_symlink(folder.file("second")));
  CHECK(fs::is_symlink(folder.file("link")));
  CHECK(contents(folder.file("inner/real")) == "new");

  fs::create_symlink("inner/later", folder.file("dangling"));
  REQUIRE(write_file_atomically(folder.file("dangling"), "made"));
  CHECK(contents(folder.file("inner/later")) == "made");

  fs::create_symlink("circle", folder.file("circle"));
  const auto circle = write_file_atomically(folder.file("circle"), "x");
  REQUIRE(!circle);
  CHECK_THAT(circle.error().hint, contains("circle"));
}

TEST_CASE("a full disk leaves the old file whole and nothing half-written") {
  const TemporaryFolder folder;
  put(folder.file("picture"), "the old picture");
  tl::expected<void, Error> written;
  tl::expected<void, Error> made;
  {
    const FullDisk full(1000);
    written = write_file_atomically(folder.file("picture"), std::string(5000, 'x'));
    made = write_file_atomically(folder.file("another"), std::string(5000, 'x'));
  }
  REQUIRE(!written);
  CHECK(written.error().file == folder.file("picture"));
  CHECK_THAT(written.error().message, contains("cannot write: "));
  CHECK_THAT(written.error().hint, contains("the old file is unchanged"));
  CHECK(contents(folder.file("picture")) == "the old picture");
  REQUIRE(!made);
  CHECK(made.error().hint.find("old file") == std::string::npos);
  CHECK(folder.entries() == 1);
}

TEST_CASE("no old file is spoken of where one was only made to keep its name") {
  const TemporaryFolder folder;
  REQUIRE(make_new_file(folder.file("o.partial.png")).value());
  tl::expected<void, Error> written;
  {
    const FullDisk full(1000);
    written = write_file_atomically(folder.file("o.partial.png"), std::string(5000, 'x'));
  }
  REQUIRE(!written);
  CHECK_THAT(written.error().hint, !contains("old file"));
}

TEST_CASE("a descriptor that is closed or only read from is named") {
  const auto refusal = [](const std::string& path) {
    const auto claimed = claim_output(path), written = write_file_atomically(path, "x");
    INFO(path);
    REQUIRE(!claimed);
    REQUIRE(!written);
    CHECK(claimed.error().text() == written.error().text());
    return written.error().text();
  };
  const TemporaryFolder folder;
  put(folder.file("read"), "what is read");
  const int reading = ::open(folder.file("read").c_str(), O_RDONLY | O_CLOEXEC);
  const std::string number = std::to_string(reading);
  fs::create_symlink("/dev/fd/" + number, folder.file("link"));
  for (const std::string& path : {"/dev/fd/" + number, "/proc/self/fd/" + number, folder.file("link")})
    CHECK_THAT(refusal(path), contains("descriptor " + number + " is closed, or open for reading only"));
  ::close(reading);
  CHECK_THAT(refusal("/dev/fd/" + number), contains("descriptor " + number + " is closed"));
  CHECK(contents(folder.file("read")) == "what is read");
  const int kept = ::dup(STDOUT_FILENO);
  ::close(STDOUT_FILENO);
  const auto closed = claim_output("/dev/stdout");
  ::dup2(kept, STDOUT_FILENO);
  ::close(kept);
  REQUIRE(!closed);
  CHECK_THAT(closed.error().text(), contains("cannot write: standard output is closed") && !contains("folder"));
}

TEST_CASE("a device that is full is told of, too") {
  if (!fs::exists("/dev/full")) RAYWALK_SKIP("this system has no /dev/full");
  const auto written = write_file_atomically("/dev/full", "x");
  REQUIRE(!written);
  CHECK_THAT(written.error().hint, contains("make room"));
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("what is no regular file is written directly and stays what it is") {
  REQUIRE(write_file_atomically("/dev/null", "x"));
  CHECK(fs::is_character_file("/dev/null"));

  const TemporaryFolder folder;
  REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
  std::string received;
  std::thread reader([&] { received = contents(folder.file("pipe")); });
  const auto written = write_file_atomically(folder.file("pipe"), "through the pipe");
  reader.join();
  CHECK(written);
  CHECK(received == "through the pipe");
  CHECK(fs::is_fifo(folder.file("pipe")));
}

TEST_CASE("places that cannot be written say so") {
  const TemporaryFolder folder;
  const auto refused = [](const std::string& path, const std::string& part) {
    const auto written = write_file_atomically(path, "x");
    INFO(path);
    REQUIRE(!written);
    INFO(written.error().text());
    CHECK(written.error().file == path);
    CHECK_THAT(written.error().text(), contains(part));
    CHECK(!written.error().hint.empty());
  };
  refused("", "the file name is empty");
  refused(folder.path(), "this is a folder");
  refused(folder.file("no/such/folder/file"), "make the folder first");
  refused(folder.file(std::string(300, 'n')), "shorter name");
  refused("/proc/raywalk", "cannot write");
  put(folder.file("file"), "x");
  refused(folder.file("file/below"), "cannot write");
  CHECK(folder.entries() == 1);
}

TEST_CASE("what is write-protected is not replaced") {
  if (::geteuid() == 0) RAYWALK_SKIP("nothing is write-protected for the superuser");
  const TemporaryFolder folder;
  put(folder.file("mine"), "precious");
  REQUIRE(::chmod(folder.file("mine").c_str(), 0444) == 0);
  const auto file = write_file_atomically(folder.file("mine"), "x");
  REQUIRE(!file);
  CHECK_THAT(file.error().hint, contains("write-protected"));
  REQUIRE(::chmod(folder.file("mine").c_str(), 0644) == 0);
  REQUIRE(::chmod(folder.path().c_str(), 0555) == 0);
  const auto in_folder = write_file_atomically(folder.file("mine"), "x");
  REQUIRE(::chmod(folder.path().c_str(), 0755) == 0);
  REQUIRE(!in_folder);
  CHECK(contents(folder.file("mine")) == "precious");
}

TEST_CASE("what is no file is not read: a pipe would keep the program waiting") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
  fs::create_symlink("pipe", folder.file("link"));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  folder.file("socket").copy(address.sun_path, sizeof address.sun_path - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  REQUIRE(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  const auto refusal = [](const std::string& path) {
    const auto read = read_file(path, 100);
    REQUIRE(!read);
    CHECK(!read.error().hint.empty());
    return read.error().message;
  };
  // A pipe first that has a writer and says nothing, so that a reader that waits would find no end.
  const int writer = ::open(folder.file("pipe").c_str(), O_RDWR);
  CHECK(refusal(folder.file("pipe")) == "this is a pipe (expected a file)");
  ::close(writer);
  CHECK(refusal(folder.file("link")) == "this is a pipe (expected a file)");
  CHECK(refusal(folder.file("socket")) == "this is a socket (expected a file)");
  CHECK(refusal("/dev/zero") == "this is a device (expected a file)");
  ::close(socket);
}

TEST_CASE("what cannot be read says so") {
  const TemporaryFolder folder;
  const auto missing = read_file(folder.file("missing"), 100);
  REQUIRE(!missing);
  CHECK_THAT(missing.error().text(), contains("there is no such file"));
  const auto directory = read_file(folder.path(), 100);
  REQUIRE(!directory);
  CHECK_THAT(directory.error().text(), contains("this is a folder (expected a file)"));
  put(folder.file("large"), std::string((std::size_t{3} << 20) + 1, 'x'));
  const auto large = read_file(folder.file("large"), std::size_t{3} << 20);
  REQUIRE(!large);
  CHECK_THAT(large.error().text(), contains("too large (expected at most 3 MiB)"));
  put(folder.file("exact"), std::string(100, 'x'));
  CHECK(read_file(folder.file("exact"), 100));
  CHECK(!read_file(folder.file("exact"), 99));
}

TEST_CASE("an absolute path leads to the same file, past links to folders too") {
  const TemporaryFolder folder;
  CHECK(absolute_path("mine.toml") == (fs::current_path() / "mine.toml").string());
  CHECK(absolute_path("./mine.toml") == (fs::current_path() / "mine.toml").string());
  CHECK(absolute_path("").empty());
  fs::create_directories(folder.file("far/inner"));
  CHECK(absolute_path(folder.file("far//inner/../mine.toml")) == folder.file("far/mine.toml"));
  fs::create_directory_symlink("far/inner", folder.file("link"));
  const std::string beyond = folder.file("link/../mine.toml");  // in far
  CHECK(absolute_path(beyond) == beyond);
}

TEST_CASE("a file is held by one alone, until that lets go, and the file itself may be replaced meanwhile") {
  const TemporaryFolder folder;
  const std::string path = folder.file("held");
  auto first = FileHold::take(path);
  REQUIRE(first);
  CHECK_FALSE(FileHold::take(path));
  REQUIRE(write_file_atomically(path, "new"));
  CHECK_FALSE(FileHold::take(path));
  CHECK(FileHold::take(folder.file("another")));
  first.reset();
  CHECK(folder.entries() == 1);  // no lock is left behind
  CHECK(FileHold::take(path));
  // A lock whose process is gone.
  REQUIRE(write_file_atomically(folder.file(".held.lock"), ""));
  CHECK(FileHold::take(path));
  // Where there can be no lock, everybody may have the file.
  const std::string nowhere = folder.file("missing/held");
  const auto one = FileHold::take(nowhere), two = FileHold::take(nowhere);
  CHECK((one && two));
}

TEST_CASE("a path is meant where it is pasted with quotes, blanks, as an address or from the home folder") {
  CHECK(path_meant("scenes/a b.toml", "/home/me") == "scenes/a b.toml");
  CHECK(path_meant("  /x/a.toml \n", "/home/me") == "/x/a.toml");
  CHECK(path_meant("'/x/it is.toml' ", "/home/me") == "/x/it is.toml");
  CHECK(path_meant("\" a.toml\"", "/home/me") == " a.toml");
  CHECK(path_meant("\"half.toml", "/home/me") == "\"half.toml");
  CHECK(path_meant("file:///x/a%20b%C3%A9.toml", "/home/me") == "/x/a bé.toml");
  CHECK(path_meant("file://localhost/x/a.toml", "/home/me") == "/x/a.toml");
  CHECK(path_meant("file:/x/100%.toml", "/home/me") == "/x/100%.toml");
  CHECK(path_meant("file:///x/%zz%00%4", "/home/me") == "/x/%zz%00%4");
  CHECK(path_meant("file://another/x/a.toml", "/home/me") == "file://another/x/a.toml");
  CHECK(path_meant("~/a.toml", "/home/me") == "/home/me/a.toml");
  CHECK(path_meant("~", "/home/me") == "/home/me");
  CHECK(path_meant("~you/a.toml", "/home/me") == "~you/a.toml");
  CHECK(path_meant("~/a.toml", "") == "~/a.toml");
  CHECK(path_meant(" \t ", "/home/me").empty());
}
