// Signals at heavy work, small stacks, and trees without end.

#include <csignal>
#include <string>
#include <vector>

#include "app/process.h"
#include "support/catch.h"
#include "support/endless_room.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// raywalk with a stack of so many KiB.
Outcome with_stack(const Folder& folder, int kibibytes, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"-c", "ulimit -s " + std::to_string(kibibytes) + "; exec \"$0\" \"$@\"",
                                 raywalk_program()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Process process("/bin/sh", words, folder.path());
  return process.wait();
}

}  // namespace

TEST_CASE("a pixel whose rays never end is warned of and can be stopped") {
  const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
  const Folder folder;
  folder.write("room.toml", endless_room);
  Process process(raywalk_program(), {"render", "room.toml", "-o", "room.pfm", "--threads", "2"}, folder.path());
  process.wait_until_busy_and_catching(signal);
  process.send(signal);
  process.send(signal);  // as `timeout` does
  const Outcome outcome = process.wait();
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("a single pixel may take about") && contains("lower --depth") &&
                              contains("raise --threshold") && contains("interrupted"));
  CHECK_FALSE(folder.holds("room.pfm"));
}

TEST_CASE("ordinary scenes are not warned of") {
  const Folder folder;
  for (const std::string scene : {"classic", "whitted", "distributed"}) {
    const Outcome outcome = folder.run({"render", scene, "-o", "small.png", "--size", "21x21"});
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.err, !contains("a single pixel"));
  }
}

TEST_CASE("whatever has nothing to keep ends at once") {
  const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
  const Folder folder;
  Process process(raywalk_program(), {"generate", "mesh", "--count", "2000000000", "-o", "big.ply"}, folder.path());
  process.wait_until_busy_and_catching(signal);
  process.send(signal);
  const Outcome outcome = process.wait();
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("interrupted"));
  CHECK_FALSE(folder.holds("big.ply"));
}

TEST_CASE("where files cannot be nameless, a signal leaves none behind either") {
  const int signal = GENERATE(SIGINT, SIGTERM, SIGHUP);
  const Folder folder;
  // Without /proc a file cannot be given its name later.
  const std::string without_proc = "mount -t tmpfs none /proc && exec \"$@\"";
  Process tried("/bin/sh", {"-c", "unshare -m sh -c '" + without_proc + "' sh true"}, folder.path());
  if (tried.wait().exit_code != 0) RAYWALK_SKIP("no way to hide /proc: it takes the superuser");
  Process process("/bin/sh",
                  {"-c", "exec unshare -m sh -c '" + without_proc + "' sh \"$@\"", "sh", raywalk_program(), "generate",
                   "mesh", "--count", "2000000000", "-o", "big.ply"},
                  folder.path());
  process.wait_until_busy_and_catching(signal);
  process.send(signal);
  CHECK(process.wait().exit_code == 1);
  CHECK(folder.names().empty());
}

TEST_CASE("a build of a structure is stopped") {
  const Folder folder;
  REQUIRE(folder.run({"generate", "mesh", "--count", "300000", "-o", "ball.ply"}).exit_code == 0);
  Process process(raywalk_program(), {"render", "ball.ply", "-o", "ball.pfm", "--accel", "kdtree"}, folder.path());
  process.wait_until_busy_and_catching(SIGTERM);
  process.send(SIGTERM);
  const Outcome outcome = process.wait();
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("interrupted"));
  CHECK_FALSE(folder.holds("ball.pfm"));
}

TEST_CASE("what the parent ignores stays ignored") {
  const Folder folder;
  Process process(
      "/bin/sh",
      {"-c", "trap '' HUP; exec \"$0\" \"$@\"", raywalk_program(), "render", "classic", "-o", "c.png", "--spp", "2000"},
      folder.path());
  process.wait_until_busy_and_catching(SIGTERM);
  CHECK_FALSE(process.catches(SIGHUP));
  process.send(SIGHUP);
  process.wait_until_busy_and_catching(SIGTERM);  // it goes on
  process.send(SIGTERM);
  const Outcome outcome = process.wait();
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("% done"));
}

TEST_CASE("the deepest scenes fit on the smallest stacks") {
  const Folder folder;
  const int kibibytes = GENERATE(128, 512, 1024);
  CAPTURE(kibibytes);
  // Two mirrors that face each other: a ray a level, to the last one.
  folder.write("mirrors.toml",
               "[camera]\neye = [0, 0, 0]\nlook_at = [1, 0.001, 0]\nfov = 45\n[image]\nwidth = 3\nheight = 3\n"
               "[limits]\ndepth = 1000\nthreshold = 0\n"
               "[[light]]\nname = \"Lamp\"\ntype = \"point\"\nposition = [0, 0.5, 0]\n"
               "[[object]]\nname = \"Right\"\ntype = \"plane\"\npoint = [1, 0, 0]\nnormal = [-1, 0, 0]\n"
               "material = { reflection = 1 }\n"
               "[[object]]\nname = \"Left\"\ntype = \"plane\"\npoint = [-1, 0, 0]\nnormal = [1, 0, 0]\n"
               "material = { reflection = 1 }\n");
  for (const std::string integrator : {"cast", "whitted", "distributed", "path"})
    for (const std::string numerics : {"robust", "naive"})
      for (const std::string depth : {"1", "10", "100", "1000"}) {
        CAPTURE(integrator, numerics, depth);
        const Outcome outcome = with_stack(folder, kibibytes,
                                           {"render", "mirrors.toml", "-o", "m.pfm", "--threads", "2", "--depth", depth,
                                            "--integrator", integrator, "--numerics", numerics});
        CAPTURE(outcome.err);
        CHECK(outcome.exit_code == 0);
      }
  for (const std::string numerics : {"robust", "naive"}) {
    const Outcome outcome =
        with_stack(folder, kibibytes, {"step", "mirrors.toml", "--pixel", "1,1", "--numerics", numerics});
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
  }
}
