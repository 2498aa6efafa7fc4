#include "app/process.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "support/effort.h"

#include <fmt/format.h>

#include <csignal>
#include <string>

using namespace raywalk;
using namespace raywalk::test;

namespace {

const std::string scenes = std::string(RAYWALK_SOURCE_DIR) + "/scenes/";
const std::string nff =
    "v from 0 -5 1 at 0 0 1 up 0 0 1 angle 40 resolution 64 48\nl 3 -4 5\nf 1 0.5 0.2 0.8 0.2 20 0 0\ns 0 0 1 1\n"
    "c 2 0 0 0.5 2 0 2 0.2\np 4 -9 -9 0 9 -9 0 9 9 0 -9 9 0\n";

}  // namespace

TEST_CASE("convert writes our own format without loss, comments and all") {
  const Folder folder;
  for (const std::string name : {"classic", "quadrics", "whitted"}) {
    const Outcome outcome = folder.run({"convert", scenes + name + ".toml", name + ".toml"});
    CHECK(outcome.exit_code == 0);
    const auto before = read_scene(scenes + name + ".toml"), after = read_scene(folder / (name + ".toml"));
    REQUIRE(before);
    REQUIRE(after);
    CHECK(before->scene == after->scene);
    CHECK(before->text == after->text);
  }
}

TEST_CASE("convert writes a foreign scene as ours, and every command opens a foreign one") {
  const Folder folder;
  folder.write("a.nff", nff);
  CHECK(folder.run({"convert", "a.nff", "a.toml"}).exit_code == 0);
  const auto before = read_scene(folder / "a.nff"), after = read_scene(folder / "a.toml");
  REQUIRE(before);
  REQUIRE(after);
  CHECK(before->scene == after->scene);
  const Outcome info = folder.run({"info", "a.nff"});
  CHECK(info.exit_code == 0);
  CHECK_THAT(info.out, contains("1 sphere"));
  CHECK(folder.run({"step", "a.nff", "--pixel", "3,4"}).exit_code == 0);
  CHECK(folder.run({"render", "a.nff", "-o", "a.pfm", "--corner-samples"}).exit_code == 0);
  CHECK(folder.run({"render", "a.toml", "-o", "b.pfm", "--corner-samples"}).exit_code == 0);
  CHECK(folder.read("a.pfm") == folder.read("b.pfm"));
  CHECK(folder.run({"render", "a.nff", "-o", "a.pfm", "--corner-samples", "--spp", "4"}).exit_code == 2);
}

TEST_CASE("convert writes POV-Ray's language, and says what of a scene is not in it") {
  const Folder folder;
  CHECK(folder.run({"convert", scenes + "whitted.toml", "whitted.pov"}).err.find("without") == std::string::npos);
  const std::string pov = folder.read("whitted.pov");
  CHECK_THAT(pov, contains("#version 3.7"));
  CHECK_THAT(pov, contains("sphere { <-0.6, 1.25, -0.6>, 0.9"));
  CHECK_THAT(pov, contains("max_trace_level 6"));
  folder.write("fixed.test", "size 8 6\ncamera 0 0 4 0 0 0 0 1 0 30\nsphere 0 0 0 1\n");
  const Outcome outcome = folder.run({"convert", "fixed.test", "fixed.pov"});
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, contains("fixed normals"));
  CHECK_THAT(outcome.err, contains("sRGB"));
  const Outcome milk = folder.run({"convert", RAYWALK_SOURCE_DIR "/scenes/milk.toml", "milk.pov"});
  CHECK(milk.exit_code == 0);
  CHECK_THAT(milk.err, contains("scattered inside"));
}

TEST_CASE("convert and generate refuse what they cannot write, and leave nothing behind") {
  const Folder folder;
  CHECK(folder.run({"convert", scenes + "classic.toml", "classic.nff"}).exit_code == 2);
  CHECK(folder.run({"convert", scenes + "classic.toml"}).exit_code == 2);
  CHECK(folder.run({"convert", "nothing.toml", "a.pov"}).exit_code == 1);
  CHECK(folder.run({"generate", "cubes", "-o", "a.nff"}).exit_code == 2);
  CHECK(folder.run({"generate", "mesh", "-o", "a.toml"}).exit_code == 2);
  CHECK(folder.run({"generate", "mesh", "--count", "0", "-o", "a.ply"}).exit_code == 2);
  CHECK(folder.run({"generate", "mesh", "-o", "no/such/folder.ply"}).exit_code == 1);
  CHECK(folder.names().empty());
}

TEST_CASE("generate writes what can be rendered at once") {
  const Folder folder;
  CHECK(folder.run({"generate", "flake", "--levels", "1", "-o", "flake.toml"}).exit_code == 0);
  CHECK(folder.run({"generate", "spheres", "--count", "50", "--seed", "2", "-o", "spheres.nff"}).exit_code == 0);
  for (const std::string name : {"flake.toml", "spheres.nff"})
    CHECK(folder.run({"render", name, "-o", name + ".png", "--size", "32x32"}).exit_code == 0);
}

TEST_CASE("generate makes a forest of a mesh, whose upward axis is said") {
  const Folder folder;
  CHECK(folder.run({"generate", "mesh", "--count", "60", "-o", "ball.ply"}).exit_code == 0);
  const auto forest = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"generate", "forest", "--count", "5", "--mesh", "ball.ply", "-o", "forest.toml"});
    const Outcome outcome = folder.run(words);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const auto read = read_scene(folder / "forest.toml");
    REQUIRE(read);
    CHECK(read->scene.objects.size() == 6);  // with the floor
    REQUIRE(read->scene.groups.size() == 1);
    CHECK(std::get<MeshShape>(read->scene.groups[0].objects.at(0).shape).file == "ball.ply");
    return folder.read("forest.toml");
  };
  const std::string upright = forest({}), from_y = forest({"--up", "y"}), from_x = forest({"--up", "x"});
  CHECK(forest({"--up", "z"}) == upright);
  CHECK(upright != from_y);
  CHECK(upright != from_x);
  CHECK(from_x != from_y);
  CHECK(folder.run({"render", "forest.toml", "-o", "forest.png", "--size", "16x12"}).exit_code == 0);
  CHECK(folder.run({"generate", "forest", "-o", "other.toml"}).exit_code == 2);
  CHECK(folder.run({"generate", "forest", "--mesh", "ball.ply", "--up", "w", "-o", "other.toml"}).exit_code == 2);
  CHECK(folder.run({"generate", "forest", "--mesh", "none.ply", "-o", "other.toml"}).exit_code == 1);
  CHECK_FALSE(folder.holds("other.toml"));
}

TEST_CASE("generate leaves nothing half-written, whatever ends it") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
    CAPTURE(signal);
    const Folder folder;
    Process process(raywalk_program(), {"generate", "mesh", "--count", "100000000", "-o", "big.ply"}, folder.path());
    process.wait_until_busy_and_catching(SIGTERM);
    process.send(signal);
    CHECK(process.wait().exit_code != 0);
    // Where a file system knows no files without a name, the next one to write there clears what a kill left.
    CHECK(folder.run({"generate", "spheres", "--count", "5", "-o", "small.nff"}).exit_code == 0);
    CHECK(folder.names() == std::vector<std::string>{"small.nff"});
  }
}

TEST_CASE("a file that grows beyond what is allowed is an error and leaves nothing") {
  const Folder folder;
  Process process("/bin/sh",
                  {"-c", "ulimit -f 64; exec \"$0\" generate mesh --count 1000000 -o big.ply", raywalk_program()},
                  folder.path());
  const Outcome outcome = process.wait();
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("big.ply: cannot write: File too large") && contains("hint: "));
  CHECK(folder.names().empty());
}

TEST_CASE("convert names meshes and textures from the new file's folder") {
  const Folder folder;
  for (const char* name : {"from", "to"}) std::filesystem::create_directory(folder / name);
  CHECK(folder.run({"generate", "mesh", "--count", "20", "-o", "from/ball.ply"}).exit_code == 0);
  CHECK(folder.run({"convert", "from/ball.ply", "to/ball.toml"}).exit_code == 0);
  CHECK_THAT(folder.read("to/ball.toml"), contains("file = \"../from/ball.ply\""));
  CHECK(folder.run({"convert", "to/ball.toml", "ball.toml"}).exit_code == 0);
  CHECK_THAT(folder.read("ball.toml"), contains("file = \"from/ball.ply\""));
  CHECK(folder.run({"convert", "ball.toml", "to/ball.pov"}).exit_code == 0);
  for (const std::string name : {"to/ball.toml", "ball.toml"})
    CHECK(folder.run({"render", name, "-o", "ball.png", "--size", "8x8"}).exit_code == 0);
}

TEST_CASE("what is too large for the memory there is, is said before it is taken") {
  if (sanitized) RAYWALK_SKIP("under sanitizers no limit of addresses can be set");
  const Folder folder;
  std::string many = nff;
  for (int i = 0; i < 800'000; ++i) many += fmt::format("s {} {} {} 0.4\n", i % 100, i / 100 % 100, i / 10'000);
  folder.write("many.nff", many);
  for (const std::string command :
       {"render many.nff -o a.png", "info many.nff", "step many.nff", "convert many.nff a.toml"}) {
    Process limited("/bin/bash", {"-c", "ulimit -v 400000; exec " + raywalk_program() + " " + command}, folder.path());
    const Outcome outcome = limited.wait();
    INFO(command << "\n" << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.err, contains("many.nff: a scene of 800002 objects would take about "));
    CHECK_THAT(outcome.err, contains("too much (expected at most "));
    CHECK_THAT(outcome.err, contains("which the address-space limit (ulimit -v) leaves"));
  }
  CHECK(folder.names() == std::vector<std::string>{"many.nff"});
}
