#include "app/part_file.h"
#include "app/process.h"
#include "support/catch.h"

#include <fmt/format.h>

using namespace raywalk;
using namespace raywalk::test;

namespace {

std::string shipped(const std::string& name) { return std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml"; }

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Renders all parts but the one left out, and merges them.
Outcome in_parts(const Folder& folder, const std::vector<std::string>& render, const std::string& name, int parts,
                 int left_out = 0) {
  std::vector<std::string> merge{"merge"};
  for (int part = parts; part >= 1; --part) {  // in any order
    if (part == left_out) continue;
    const Outcome made = folder.run(with(render, {"-o", name, "--part", fmt::format("{}/{}", part, parts)}));
    INFO(made.err);
    REQUIRE(made.exit_code == 0);
    merge.push_back(part_path(name, {part, parts}));
  }
  CHECK_FALSE(folder.holds(name));
  return folder.run(with(merge, {"-o", name}));
}

}  // namespace

TEST_CASE("parts of a picture, merged, are the picture that one run makes") {
  const Folder folder;
  const std::vector<std::pair<std::string, std::vector<std::string>>> renders{
      {"classic", {"--size", "201x133"}},
      {"cornell", {"--size", "75x70", "--spp", "3", "--seed", "9", "--precision", "float"}},
      {"distributed", {"--size", "131x70", "--spp", "64", "--tolerance", "0.05"}},  // looks at neighbours
      {"sphereflake", {"--size", "64x64", "--corner-samples"}},                     // pixels share samples
      {"caustic", {"--size", "70x40", "--integrator", "photons"}}};                 // each part sends them all
  for (const auto& [scene, options] : renders) {
    const std::vector<std::string> render = with({"render", shipped(scene)}, options);
    for (const std::string ending : {".pfm", ".png"}) {
      const std::string whole = "whole" + ending;
      REQUIRE(folder.run(with(render, {"-o", whole})).exit_code == 0);
      for (const int parts : ending == ".png"     ? std::vector{3}
                             : scene == "classic" ? std::vector{1, 2, 7, 64}
                                                  : std::vector{2}) {
        INFO(scene << ", " << parts << " parts");
        const std::string name = fmt::format("{}-{}{}", scene, parts, ending);
        const Outcome merged = in_parts(folder, render, name, parts);
        INFO(merged.err);
        REQUIRE(merged.exit_code == 0);
        CHECK(folder.read(name) == folder.read(whole));
      }
    }
  }
}

TEST_CASE("merge names what is missing, given twice, damaged, or of another picture, and then writes nothing") {
  const Folder folder;
  const std::vector<std::string> render{"render", shipped("classic"), "--size", "101x67"};
  const Outcome missing = in_parts(folder, render, "a.pfm", 4, 3);
  CHECK(missing.exit_code == 1);
  CHECK_THAT(missing.err, contains("of 4 parts, 1 is missing: 3; nothing was written") && contains("--part 3/4"));
  CHECK_FALSE(folder.holds("a.pfm"));

  // One that was lost is made again by its own command, and all is well.
  REQUIRE(folder.run(with(render, {"-o", "a.pfm", "--part", "3/4"})).exit_code == 0);
  std::vector<std::string> all{"merge", "-o", "a.pfm"};
  for (int part = 1; part <= 4; ++part) all.push_back(part_path("a.pfm", {part, 4}));
  CHECK(folder.run(all).exit_code == 0);
  std::filesystem::remove(folder / "a.pfm");

  folder.write("again", folder.read(part_path("a.pfm", {2, 4})));
  const Outcome twice = folder.run(with(all, {"again"}));
  CHECK(twice.exit_code == 1);
  CHECK_THAT(twice.err, contains("again: this is part 2 of 4, and so is a.pfm.part-2-of-4"));

  // Cut off anywhere, or with any byte changed.
  const std::string bytes = folder.read(part_path("a.pfm", {2, 4}));
  for (const std::size_t at :
       {std::size_t{0}, std::size_t{14}, std::size_t{18}, std::size_t{30}, bytes.size() / 2, bytes.size() - 1}) {
    folder.write("cut", bytes.substr(0, at));
    CHECK(folder.run({"merge", "cut", "-o", "b.pfm"}).exit_code == 1);
    std::string other = bytes;
    other[at] = static_cast<char>(other[at] ^ 4);
    folder.write("changed", other);
    const Outcome changed = folder.run({"merge", "changed", "-o", "b.pfm"});
    INFO(at << ": " << changed.err);
    CHECK(changed.exit_code == 1);
    CHECK_THAT(changed.err, contains("changed: this"));
  }

  const std::vector<std::pair<std::vector<std::string>, std::string>> others{
      {{"--seed", "3"}, "seed here is 3, there 0"},
      {{"--depth", "2"}, "depth here is 2, there 5"},
      {{"--threshold", "0.5"}, "checksum of the scene"},
      {{"--precision", "float"}, "precision here is float, there double"}};
  for (const auto& [options, words] : others) {
    REQUIRE(folder.run(with(with(render, options), {"-o", "c.pfm", "--part", "3/4"})).exit_code == 0);
    const Outcome mixed = folder.run({"merge", part_path("a.pfm", {1, 4}), part_path("c.pfm", {3, 4}), "-o", "b.pfm"});
    CHECK(mixed.exit_code == 1);
    CHECK_THAT(mixed.err, contains("no part of the same picture as a.pfm.part-1-of-4") && contains(words));
  }
  REQUIRE(folder.run(with(render, {"-o", "c.pfm", "--part", "3/5"})).exit_code == 0);
  CHECK_THAT(folder.run({"merge", part_path("a.pfm", {1, 4}), part_path("c.pfm", {3, 5}), "-o", "b.pfm"}).err,
             contains("of 5 parts, not of 4"));
  CHECK_THAT(folder.run({"merge", shipped("classic"), "-o", "b.pfm"}).err, contains("this is no part of a picture"));
  CHECK_FALSE(folder.holds("b.pfm"));
}

TEST_CASE("naive numerics may lose what a structure leaves out, so parts by different ones are of different pictures") {
  const Folder folder;
  const auto merged = [&](const std::string& numerics, const std::vector<std::string>& other) {
    const std::vector<std::string> render{"render",     shipped("classic"), "--size", "40x30",
                                          "--numerics", numerics,           "-o",     "a.pfm"};
    REQUIRE(folder.run(with(render, {"--part", "1/2", "--accel", "none"})).exit_code == 0);
    REQUIRE(folder.run(with(with(render, {"--part", "2/2"}), other)).exit_code == 0);
    return folder.run({"merge", "a.pfm.part-1-of-2", "a.pfm.part-2-of-2", "-o", "a.pfm"});
  };
  CHECK(merged("robust", {"--accel", "bvh"}).exit_code == 0);
  CHECK(merged("naive", {"--accel", "none"}).exit_code == 0);
  CHECK_THAT(merged("naive", {"--accel", "bvh"}).err, contains("accel here is bvh, there none"));
  CHECK_THAT(merged("naive", {"--accel", "none", "--build", "best"}).err, contains("build here is best, there auto"));
}

TEST_CASE("what a part was made from includes the files of a scene") {
  const Folder folder;
  const std::string mesh =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n2 0 0\n2 1 0\n2 0 1\n3 0 1 2\n";
  folder.write("m.ply", mesh);
  REQUIRE(folder.run({"render", "m.ply", "-o", "m.pfm", "--size", "40x40", "--part", "1/2"}).exit_code == 0);
  std::string moved = mesh;
  moved.replace(moved.find("2 1 0"), 5, "2 1 1");
  folder.write("m.ply", moved);
  REQUIRE(folder.run({"render", "m.ply", "-o", "m.pfm", "--size", "40x40", "--part", "2/2"}).exit_code == 0);
  const Outcome mixed = folder.run({"merge", "m.pfm.part-1-of-2", "m.pfm.part-2-of-2", "-o", "m.pfm"});
  CHECK(mixed.exit_code == 1);
  CHECK_THAT(mixed.err, contains("no part of the same picture"));
}

TEST_CASE("a part is asked for by two numbers") {
  const Folder folder;
  for (const std::string word : {"0/4", "5/4", "3", "/", "1/", "a/b", "1/1000000", "-1/2", "1/2/3"}) {
    INFO(word);
    const Outcome refused = folder.run({"render", shipped("classic"), "-o", "a.pfm", "--part", word});
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, contains("--part") && contains("such as 3/7"));
  }
  CHECK(folder.names().empty());
}
