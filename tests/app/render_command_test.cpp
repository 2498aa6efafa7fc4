#include "app/render_command.h"

#include "app/process.h"
#include "image/image_file.h"
#include "io/scene_file.h"

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/catch.h"
#include "text/file.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

const std::string classic = std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml";

Scene classic_scene() { return read_scene(classic).value().scene; }

}  // namespace

TEST_CASE("render writes the picture that the renderer makes") {
  const Folder folder;
  const Outcome outcome = folder.run({"render", classic, "-o", "out.pfm", "--size", "63x41"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "");
  CHECK(outcome.err == "");
  const auto image = read_pfm(folder / "out.pfm");
  REQUIRE(image.has_value());
  RenderSettings settings{ImageSize{63, 41}};
  CHECK(*image == render(classic_scene(), settings).value().image());

  // Every option that may change the picture does.
  const std::vector<std::pair<std::vector<std::string>, std::string>> options{
      {{"--spp", "3"}, "spp"},
      {{"--depth", "2"}, "depth"},
      {{"--threshold", "0.3"}, "thr"},
      {{"--precision", "float"}, "float"},
      {{"--spp", "3", "--seed", "5"}, "seed"},
      {{"--integrator", "cast"}, "cast"},
      {{"--spp", "3", "--sampler", "sobol"}, "sobol"},
      {{"--spp", "3", "--integrator", "whitted"}, "fixed"},
      {{"--spp", "64", "--tolerance", "0.1"}, "adaptive"}};
  std::vector<std::string> pictures{folder.read("out.pfm")};
  for (const auto& [words, name] : options) {
    std::vector<std::string> arguments{"render", classic, "-o", name + ".pfm", "--size", "63x41"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    INFO(name);
    REQUIRE(folder.run(arguments).exit_code == 0);
    const std::string picture = folder.read(name + ".pfm");
    REQUIRE_FALSE(picture.empty());
    CHECK(std::count(pictures.begin(), pictures.end(), picture) == 0);
    pictures.push_back(picture);
  }

  settings.sampling = {3, 5};
  settings.precision = Precision::float_;
  REQUIRE(folder.run({"render", classic, "-o", "all.pfm", "--size=63x41", "--spp=3", "--seed=5", "--precision=float"})
              .exit_code == 0);
  CHECK(read_pfm(folder / "all.pfm").value() == render(classic_scene(), settings).value().image());
}

TEST_CASE("neither threads nor the accelerator change a byte of the picture") {
  const Folder folder;
  REQUIRE(folder.run({"render", classic, "-o", "one.pfm", "--threads", "1", "--spp", "2"}).exit_code == 0);
  const std::string expected = folder.read("one.pfm");
  REQUIRE(expected.size() > 441 * 331 * 12);
  for (const std::string threads : {"0", "2", "3"}) {
    REQUIRE(folder.run({"render", classic, "-o", "other.pfm", "--threads", threads, "--spp", "2"}).exit_code == 0);
    CHECK(folder.read("other.pfm") == expected);
  }
  for (const std::string name : {"none", "bvh", "grid", "octree", "kdtree", "auto"}) {
    REQUIRE(folder.run({"render", classic, "-o", "other.pfm", "--accel", name, "--spp", "2"}).exit_code == 0);
    CHECK(folder.read("other.pfm") == expected);
  }
}

TEST_CASE("the shadow cache is on or off as is said, saves tests, and changes no byte of the picture") {
  const Folder folder;
  std::string expected;
  const auto tests = [&](const std::vector<std::string>& words) {
    std::vector<std::string> arguments{"render", "mesh", "-o", "x.pfm", "--size", "63x41", "--stats", "x.json"};
    arguments.insert(arguments.end(), {"--threads", "1"});
    arguments.insert(arguments.end(), words.begin(), words.end());
    REQUIRE(folder.run(arguments).exit_code == 0);
    if (expected.empty()) expected = folder.read("x.pfm");
    CHECK(folder.read("x.pfm") == expected);
    return nlohmann::json::parse(folder.read("x.json")).at("tests").at("nodes").get<int>();
  };
  const int left_out = tests({}), on = tests({"--shadow-cache"}), off = tests({"--no-shadow-cache"});
  CHECK(on < off);
  CHECK(left_out == on);
  const Outcome both = folder.run({"render", "mesh", "-o", "y.pfm", "--shadow-cache", "--no-shadow-cache"});
  CHECK(both.exit_code == 2);
  CHECK_FALSE(folder.holds("y.pfm"));
}

TEST_CASE(
    "how long a tree over meshes is built changes no byte of the picture, and the file says what it costs a ray") {
  const Folder folder;
  std::string expected;
  std::vector<double> costs;
  for (const std::string quality : {"fast", "good", "best", "auto"}) {
    CAPTURE(quality);
    REQUIRE(folder.run({"render", "mesh", "-o", "x.pfm", "--size", "150x100", "--build", quality, "--stats", "x.json"})
                .exit_code == 0);
    if (expected.empty()) expected = folder.read("x.pfm");
    CHECK(folder.read("x.pfm") == expected);
    const nlohmann::json tree = nlohmann::json::parse(folder.read("x.json"))["accelerator"];
    CHECK(tree["name"] == "bvh");
    costs.push_back(tree["expected_cost"].get<double>());
    CHECK(costs.back() > 1);
  }
  CHECK(costs[1] < costs[0]);
  CHECK(costs[2] <= costs[1]);
  CHECK(costs[3] == costs[1]);
}

TEST_CASE("a PNG has the size of the scene, and replaces the old one") {
  const Folder folder;
  folder.write("out.png", "old");
  REQUIRE(folder.run({"render", "classic", "-o", "out.png"}).exit_code == 0);
  const std::string png = folder.read("out.png");
  REQUIRE(png.size() > 24);
  CHECK(png.substr(1, 3) == "PNG");
  CHECK(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]) == 441);
  CHECK(static_cast<unsigned char>(png[22]) * 256 + static_cast<unsigned char>(png[23]) == 331);
  CHECK(folder.names() == std::vector<std::string>{"out.png"});
}

TEST_CASE("paths end at the length that is asked for") {
  const Folder folder;
  const auto ended = [&](const std::string& longest) {
    REQUIRE(folder
                .run({"render", classic, "-o", "a.png", "--size", "40x30", "--integrator", "path", "--path-length",
                      longest, "--stats", "a.json"})
                .exit_code == 0);
    const auto json = nlohmann::json::parse(folder.read("a.json"));
    CHECK(json.at("rays").at("shadow").get<int>() == (longest == "1" ? 0 : json.at("rays").at("shadow").get<int>()));
    return json.at("ended").at("path_length").get<int>();
  };
  CHECK(ended("1") > 0);
  CHECK(ended("2") > 0);
  CHECK(ended("1000") == 0);
}

TEST_CASE("an option that can do nothing is said, and the picture is the same without it") {
  const Folder folder;
  const auto render = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"render", classic, "-o", "a.pfm", "--size", "40x30"});
    const Outcome outcome = folder.run(words);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out == "");
    return std::pair(outcome.err, folder.read("a.pfm"));
  };
  const auto [silence, expected] = render({});
  CHECK(silence == "");
  const std::vector<std::string> idle{"--tolerance", "0.1", "--epsilon", "1", "--path-length", "2"};
  const auto [said, picture] = render(idle);
  CHECK(said ==
        "raywalk render: note: --tolerance has no effect: a pixel always takes its first 16 samples, and has only 1 "
        "here\n"
        "raywalk render: note: --path-length has no effect: the integrator is whitted (expected --integrator path)\n"
        "raywalk render: note: --epsilon has no effect: numerics are robust (expected --numerics naive)\n");
  CHECK(picture == expected);
  std::vector<std::string> quietly = idle;
  quietly.emplace_back("--quiet");
  CHECK(render(quietly) == std::pair(std::string(), expected));
  CHECK_THAT(folder.run({"render", "--help"}).out, contains("the first 16 always"));
}

TEST_CASE("a render of no object says so, and writes the picture") {
  const Folder folder;
  const std::string camera = "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n";
  folder.write("empty.toml", camera);
  folder.write("sky.toml", camera + "[sky]\ntype = \"clear\"\nsun = [1, 0, 1]\n");
  folder.write("empty.nff", "v\nfrom 0 0 0\nat 1 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 4 3\n");
  const Outcome loud = folder.run({"render", "empty.toml", "-o", "a.png", "--size", "4x3"});
  CHECK(loud.exit_code == 0);
  CHECK_THAT(loud.err, Catch::StartsWith("empty.toml: warning: there is no object in this scene") &&
                           contains("; add an [[object]]"));
  CHECK(folder.holds("a.png"));
  const Outcome foreign = folder.run({"render", "empty.nff", "-o", "b.png"});
  CHECK_THAT(foreign.err, contains("there is no object in this scene") && contains("cut short?"));
  CHECK(folder.holds("b.png"));
  CHECK(folder.run({"render", "empty.toml", "-o", "c.png", "--size", "4x3", "--quiet"}).err.empty());
  CHECK_THAT(folder.run({"render", "sky.toml", "-o", "d.png", "--size", "4x3"}).err, !contains("no object"));
}

TEST_CASE("a quiet render keeps the scene's warnings to itself, but not what went wrong") {
  const Folder folder;
  const std::string whitted = std::string(RAYWALK_SOURCE_DIR) + "/scenes/whitted.toml";
  const std::vector<std::string> words{"render", whitted, "-o", "a.png", "--size", "8x8"};
  const Outcome loud = folder.run(words);
  CHECK(loud.exit_code == 0);
  CHECK_THAT(loud.err, contains("warning: \"Glass Sphere\"") && contains("; and 1 more like it\n"));
  std::vector<std::string> quietly = words;
  quietly.emplace_back("-q");
  const Outcome quiet = folder.run(quietly);
  CHECK(quiet.exit_code == 0);
  CHECK(quiet.err == "");
  quietly[3] = "no/such/folder.png";
  CHECK_THAT(folder.run(quietly).err, contains("cannot write"));
}

TEST_CASE("the statistics hold what is promised, and add up") {
  const Folder folder;
  REQUIRE(
      folder.run({"render", "classic", "-o", "a.png", "--stats", "a.json", "--threads", "2", "--spp", "4"}).exit_code ==
      0);
  const auto json = nlohmann::json::parse(folder.read("a.json"));
  const auto& rays = json.at("rays");
  const auto& ended = json.at("ended");
  std::uint64_t formed = 0;
  for (const std::string kind : {"primary", "shadow", "reflect", "refract"}) {
    CHECK(rays.at(kind).get<std::uint64_t>() > 0);
    formed += rays.at(kind).get<std::uint64_t>();
  }
  CHECK(rays.at("photon") == 0);
  CHECK(rays.size() == 6);
  CHECK(rays.at("primary") == 441 * 331 * 4);
  std::uint64_t endings = 0;
  for (const std::string ending : {"hit", "missed", "blocked", "reached_light", "scattered"})
    endings += ended.at(ending).get<std::uint64_t>();
  CHECK(formed == endings);
  for (const std::string ending :
       {"depth", "threshold", "total_internal_reflection", "path_length", "facing_away", "outside_cone", "wrong_side"})
    CHECK(ended.at(ending).is_number_unsigned());
  CHECK(ended.size() == 12);
  CHECK(json.at("tests").at("primitives").get<std::uint64_t>() > 0);
  CHECK(json.at("tests").at("nodes").is_number_unsigned());
  const auto exactly = json.at("tests").at("exactly_decided").get<std::uint64_t>();
  CHECK(exactly < json.at("tests").at("primitives").get<std::uint64_t>() / 100);
  CHECK(json.at("random_draws") == 2 * 441 * 331 * 4);
  for (const std::string phase : {"load", "build", "trace", "write"})
    CHECK(json.at("seconds").at(phase).get<double>() >= 0);
  CHECK(json.at("seconds").at("trace").get<double>() > 0);
  CHECK(json.at("threads") == 2);
  CHECK(json.at("effects").size() == effect_count);
  for (const auto& [name, effect] : json.at("effects").items()) {
    INFO(name);
    CHECK(effect.at("used").is_boolean());
    CHECK_FALSE(effect.at("why").get<std::string>().empty());
  }
  CHECK(json.at("effects").at("antialiasing").at("used") == true);
  CHECK(json.at("effects").at("motion_blur").at("used") == false);
}

TEST_CASE("Ctrl-C leaves what is done in a file of its own and the old picture whole") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const Folder folder;
  folder.write("long.pfm", "an old picture");
  Process process(raywalk_program(),
                  {"render", classic, "-o", "long.pfm", "--spp", "1000000", "--threads", "2", "--stats", "long.json"},
                  folder.path());
  process.wait_until_busy_and_catching(signal);
  process.send(signal);
  const Outcome outcome = process.wait();
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("interrupted with ") && contains("% done") && contains("long.partial.pfm"));
  CHECK(folder.read("long.pfm") == "an old picture");
  CHECK(folder.names() == std::vector<std::string>{"long.partial.pfm", "long.pfm"});
  const auto partial = read_pfm(folder / "long.partial.pfm");
  REQUIRE(partial.has_value());
  CHECK(partial->width == 441);
  CHECK(partial->at(0, 0) != Rgb<float>(0));
  CHECK(partial->at(440, 330) == Rgb<float>(0));
}

TEST_CASE("a partial file that cannot be written is not kept, and no old one is spoken of") {
  const Folder folder;
  Process process("/bin/sh",
                  {"-c", "ulimit -f 8; exec \"$0\" \"$@\"", raywalk_program(), "render", classic, "-o", "long.pfm",
                   "--spp", "1000000", "--threads", "2"},
                  folder.path());
  process.wait_until_busy_and_catching(SIGINT);
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("interrupted with ") && contains("long.partial.pfm: cannot write: File too large") &&
                              !contains("old file"));
  CHECK(folder.names().empty());
}

TEST_CASE("a picture that cannot be written is refused before the render") {
  const Folder folder;
  std::filesystem::create_directory(folder / "folder.png");
  // The render itself would take hours.
  const auto refused = [&](const std::string& image) {
    const Outcome outcome = folder.run({"render", classic, "-o", image, "--spp", "1000000"});
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.err, contains(image + ": cannot write") && contains("hint: "));
  };
  refused("folder.png");
  refused("nowhere/out.png");
  refused("/proc/out.png");
  const Outcome statistics =
      folder.run({"render", classic, "-o", "out.png", "--spp", "1000000", "--stats", "nowhere/a.json"});
  CHECK(statistics.exit_code == 1);
  CHECK_THAT(statistics.err, contains("nowhere/a.json: cannot write"));
  CHECK(folder.names() == std::vector<std::string>{"folder.png"});
}

TEST_CASE("a full disk is said") {
  const Folder folder;
  std::filesystem::create_symlink("/dev/full", folder / "full.png");
  const Outcome outcome = folder.run({"render", classic, "-o", "full.png", "--size", "8x8"});
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("full.png: cannot write: No space left on device") && contains("hint: "));
}

TEST_CASE("a picture of more pixels than a file takes is refused before the render") {
  const Folder folder;
  const Outcome outcome = folder.run({"render", classic, "-o", "out.png", "--size", "32768x32768"});
  CHECK(outcome.exit_code == 2);
  CHECK_THAT(outcome.err, contains("32768 x 32768") && contains("too large") && contains("--size"));
  CHECK(folder.names().empty());
}

TEST_CASE("samples that are no finite number are reported") {
  const Folder folder;
  // Bright beyond what a float can hold, though each number of the file is allowed.
  folder.write("bright.toml",
               "background = 1e12\n[camera]\neye = [-5, 0]\nlook_at = [0, 0]\nfov = 45\n"
               "[[object]]\nname = \"Ball\"\ntype = \"sphere\"\ncentre = [0, 0]\nradius = 1\n"
               "[object.material]\nreflection = 1000\nambient = 1000\ndiffuse = 1000\n"
               "[[light]]\nname = \"Lamp\"\ntype = \"point\"\nposition = [-5, 1]\nstrength = 1e12\n"
               "attenuation = [1e-30, 0, 0]\n");
  const Outcome outcome =
      folder.run({"render", "bright.toml", "-o", "bright.png", "--size", "9x9", "--precision", "float"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("pixels are no finite number") && contains("bright.png"));
  CHECK(folder.holds("bright.png"));
}

TEST_CASE("the partial file's name keeps the folder and the ending, and is one that was free") {
  const Folder folder;
  std::filesystem::create_directory(folder / "a.b");
  folder.write("out.partial.png", "the user's own");
  CHECK(new_partial_file(folder / "out.png").value() == folder / "out.partial-2.png");
  CHECK(new_partial_file(folder / "out.png").value() == folder / "out.partial-3.png");
  CHECK(folder.read("out.partial.png") == "the user's own");
  CHECK(new_partial_file(folder / "a.b/c.d.PFM").value() == folder / "a.b/c.d.partial.PFM");
  CHECK(new_partial_file(folder / ".png").value() == folder / ".partial.png");
  CHECK_FALSE(new_partial_file(folder / "missing/out.png"));
}

TEST_CASE("beams make a picture, and a drawing of it; what they cannot do is refused by name") {
  const Folder folder;
  const auto refused = [&](std::vector<std::string> words, const std::string& why, int exit_code = 2) {
    words.insert(words.begin(), {"render"});
    const Outcome outcome = folder.run(words);
    INFO(outcome.err);
    CHECK(outcome.exit_code == exit_code);
    CHECK(outcome.err.find(why) != std::string::npos);
  };
  REQUIRE(folder.run({"render", classic, "-o", "beams.pfm", "--size", "21x15", "--integrator", "beams"}).exit_code ==
          0);
  REQUIRE(folder.run({"render", classic, "-o", "rays.pfm", "--size", "21x15"}).exit_code == 0);
  CHECK(folder.read("beams.pfm") != folder.read("rays.pfm"));
  const Outcome drawn =
      folder.run({"render", classic, "-o", "out.SVG", "--size", "42x30", "--integrator", "beams", "--spp", "4"});
  REQUIRE(drawn.exit_code == 0);
  CHECK(drawn.err.find("note: --spp has no effect: a drawing") != std::string::npos);
  CHECK(folder.read("out.SVG").find("<title>Transparent Sphere</title>") != std::string::npos);
  refused({classic, "-o", "no.svg"}, "only beams make a drawing of a picture");
  refused({classic, "-o", "no.svg", "--integrator", "beams", "--part", "1/2"}, "a drawing has no parts");
  refused({classic, "-o", "no.svg", "--integrator", "beams", "--stats", "s.json"}, "a drawing has no statistics");
  refused({"motion_blur", "-o", "no.png", "--integrator", "beams"}, "beams cannot be followed here: Rolling Ball moves",
          1);
  // A file that asks for them is walked by beams in the plan, and may have a picture of rays.
  std::string moving = read_file(RAYWALK_SOURCE_DIR "/scenes/motion_blur.toml", 1 << 20).value();
  moving.replace(moving.find("samples = 64"), 12, "integrator = \"beams\"");
  folder.write("moving.toml", moving);
  refused({"moving.toml", "-o", "no.svg"}, "beams cannot be followed here: Rolling Ball moves", 1);
  const Outcome by_rays = folder.run({"render", "moving.toml", "-o", "rays.pfm", "--size", "9x7"});
  CHECK(by_rays.exit_code == 0);
  CHECK(by_rays.err.find("warning: rays make this picture, for beams cannot be followed here: Rolling Ball moves") !=
        std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder / "no.svg"));
  CHECK_FALSE(std::filesystem::exists(folder / "no.png"));
}
