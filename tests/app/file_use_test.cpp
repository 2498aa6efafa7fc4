// No command writes over what it reads or has just written, whatever the file is called.
#include "app/process.h"
#include "image/image_file.h"
#include "support/catch.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> inputs{"scene.toml", "m.obj", "m.mtl", "g.gltf", "g.bin", "p.ply", "t.png"};

void put_scene(const Folder& folder) {
  folder.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
  folder.write("m.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("g.bin",
               std::string("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0", 36));
  folder.write(
      "g.gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"uri":"g.bin","byteLength":36}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,)"
      R"("count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"scene":0})");
  folder.write("p.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  REQUIRE(write_image(folder / "t.png", {2, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}}));
  folder.write("scene.toml",
               "[camera]\neye = [-5, 0]\nlook_at = [0, 0]\nfov = 45\n[image]\nwidth = 8\nheight = 8\n"
               "[[group]]\nname = \"G\"\n[[group.object]]\nname = \"P\"\ntype = \"mesh\"\nfile = \"p.ply\"\n"
               "[[object]]\nname = \"M\"\ntype = \"mesh\"\nfile = \"m.obj\"\n"
               "[[object]]\nname = \"N\"\ntype = \"mesh\"\nfile = \"g.gltf\"\n"
               "[[object]]\nname = \"I\"\ntype = \"instance\"\ngroup = \"G\"\n"
               "[[object]]\nname = \"Ball\"\ntype = \"sphere\"\ncentre = [0, 0]\nradius = 1\n"
               "[object.material]\ndiffuse = 0.5\n[object.material.texture]\nfile = \"t.png\"\n");
}

std::map<std::string, std::string> contents(const Folder& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& name : folder.names())
    if (fs::is_regular_file(folder / name)) all[name] = folder.read(name);
  return all;
}

/// Names of the file `name` that end in `ending`: its own and "./" before it where that has it, then links.
std::vector<std::string> aliases(const Folder& folder, const std::string& name, const std::string& ending) {
  std::vector<std::string> all;
  if (name.ends_with(ending)) all = {name, "./" + name, folder / name};
  fs::create_hard_link(folder / name, folder / ("hard" + ending));
  fs::create_symlink(name, folder / ("soft" + ending));
  fs::create_symlink("soft" + ending, folder / ("softer" + ending));
  all.insert(all.end(), {"hard" + ending, "soft" + ending, "softer" + ending});
  return all;
}
void remove_aliases(const Folder& folder, const std::string& ending) {
  for (const char* name : {"hard", "soft", "softer"}) fs::remove(folder / (name + ending));
}

/// That the command, given each name of `file` in place of "OUT", is wrong use and loses nothing.
void check_refused(const Folder& folder, const std::string& file, const std::string& ending,
                   const std::vector<std::string>& command) {
  for (const std::string& alias : aliases(folder, file, ending)) {
    std::vector<std::string> words = command;
    for (std::string& word : words)
      if (word == "OUT") word = alias;
    const auto before = contents(folder);
    const Outcome outcome = folder.run(words);
    CAPTURE(words, outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err, contains(alias + ": cannot write: this") && contains("hint: "));
    CHECK(contents(folder) == before);
  }
  remove_aliases(folder, ending);
}

}  // namespace

TEST_CASE("render writes over nothing that the scene reads") {
  const Folder folder;
  put_scene(folder);
  CHECK(folder.run({"render", "scene.toml", "-o", "fine.png", "--stats", "fine.json"}).exit_code == 0);
  for (const std::string& input : inputs) {
    check_refused(folder, input, ".png", {"render", "scene.toml", "-o", "OUT"});
    check_refused(folder, input, "", {"render", "scene.toml", "-o", "new.png", "--stats", "OUT"});
  }
}

TEST_CASE("two outputs do not go into one file") {
  const Folder folder;
  put_scene(folder);
  for (const bool exists : {false, true}) {
    CAPTURE(exists);
    if (exists) folder.write("a.png", "old");
    fs::create_symlink("a.png", folder / "b.png");
    for (const std::string name : {"a.png", "./a.png", "b.png"}) {
      const Outcome outcome = folder.run({"render", "scene.toml", "-o", "a.png", "--stats", name});
      CAPTURE(name, outcome.err);
      CHECK(outcome.exit_code == 2);
      CHECK_THAT(outcome.err, contains("already an output"));
      CHECK((exists ? folder.read("a.png") == "old" : !folder.holds("a.png")));
    }
    fs::remove(folder / "b.png");
  }
}

TEST_CASE("compare, convert and the lessons write over none of their inputs") {
  const Folder folder;
  put_scene(folder);
  const Image dark{1, 1, {{0, 0, 0}}}, light{1, 1, {{1, 1, 1}}};
  REQUIRE(write_image(folder / "a.pfm", dark));
  REQUIRE(write_image(folder / "b.pfm", light));
  for (const std::string input : {"a.pfm", "b.pfm"})
    for (const std::string ending : {".pfm", ".png"})
      check_refused(folder, input, ending, {"compare", "a.pfm", "b.pfm", "-o", "OUT"});
  for (const std::string& input : inputs)
    for (const std::string ending : {".toml", ".pov"})
      check_refused(folder, input, ending, {"convert", "scene.toml", "OUT"});
  check_refused(folder, "m.mtl", ".toml", {"convert", "m.obj", "OUT"});

  const fs::path lesson = fs::path(RAYWALK_SOURCE_DIR) / "lessons" / "01-ray-casting";
  if (fs::exists(lesson)) {
    fs::copy(lesson, folder / "lesson", fs::copy_options::recursive);
    fs::create_symlink("lesson/lesson.toml", folder / "l.toml");
    check_refused(folder, "l.toml", ".md", {"lesson", "script", "./lesson", "-o", "OUT"});
  }
}

TEST_CASE("a study's files are as many as their names say") {
  const Folder folder;
  fs::create_directory(folder / "out");
  fs::create_symlink("samples.csv", folder / "out/index.html");
  const Outcome outcome = folder.run({"study", "samples", "--quick", "-o", "out"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK_THAT(outcome.err, contains("samples.csv"));
}

TEST_CASE("a file name that is empty is not as good as none") {
  const Folder folder;
  put_scene(folder);
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"render", "scene.toml", "-o", "a.png", "--stats", ""},
                                             {"render", "scene.toml", "-o", ""},
                                             {"compare", "t.png", "t.png", "-o", ""},
                                             {"convert", "scene.toml", ""},
                                             {"generate", "spheres", "-o", ""},
                                             {"study", "-o", ""},
                                             {"lesson", "script", "1", "-o", ""},
                                             {"check", "numerics", "--state", ""},
                                             {"--demo", ""}}) {
    const Outcome outcome = folder.run(words);
    CAPTURE(words, outcome.err);
    CHECK(outcome.exit_code == 2);
    // Where the ending counts, that is missed first.
    CHECK_THAT(outcome.err, contains("names no file") || contains("expected .png") || contains("expected .toml"));
  }
  CHECK_FALSE(folder.holds("a.png"));
}

TEST_CASE("what goes to devices and to what is open already may be the same") {
  const Folder folder;
  put_scene(folder);
  CHECK(folder.run({"render", "scene.toml", "-o", "a.png", "--stats", "/dev/null"}).exit_code == 0);
  const Outcome outcome = folder.run({"render", "scene.toml", "-o", "a.png", "--stats", "/dev/stdout"});
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, contains("\"pixels\"") || contains("{"));
  Process piped("/bin/sh", {"-c", "\"$0\" render scene.toml -o a.png --stats /dev/stdout | cat", raywalk_program()},
                folder.path());
  CHECK_THAT(piped.wait().out, contains("\"rays\""));
  const Outcome dash = folder.run({"render", "scene.toml", "-o", "a.png", "--stats", "-"});
  CHECK(dash.exit_code == 2);
  CHECK_THAT(dash.err, contains("/dev/stdout"));
}

TEST_CASE("closed streams are named, and their numbers go to no file") {
  const Folder folder;
  put_scene(folder);
  const auto run = [&](const std::string& line) {
    Process process("/bin/sh", {"-c", "\"$0\" " + line, raywalk_program()}, folder.path());
    return process.wait();
  };
  const Outcome statistics = run("render scene.toml -o a.png --stats /dev/stdout >&-");
  CHECK(statistics.exit_code == 1);
  CHECK_THAT(statistics.err,
             contains("/dev/stdout: cannot write: standard output is closed") && !contains("choose another"));
  CHECK_FALSE(folder.holds("a.png"));
  const Outcome info = run("info scene.toml >&-");
  CHECK(info.exit_code == 1);
  CHECK_THAT(info.err, contains("cannot write to standard output"));
  CHECK(run("render scene.toml -o open.pfm").exit_code == 0);
  CHECK(run("render scene.toml -o closed.pfm <&- >&- 2>&-").exit_code == 0);
  CHECK(folder.read("open.pfm") == folder.read("closed.pfm"));
}
