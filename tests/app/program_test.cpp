// The command line as a person meets it: help, mistakes, and scenes that are not there.
#include "app/process.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "io/packed_text.h"
#include "support/catch.h"

using namespace raywalk::test;

namespace {

const std::string classic = std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml";

}  // namespace

TEST_CASE("there is help at every level, with examples") {
  const Folder folder;
  const Outcome top = folder.run({"--help"});
  CHECK(top.exit_code == 0);
  CHECK(top.err == "");
  for (const std::string command : {"render", "step", "info"}) {
    INFO(command);
    CHECK_THAT(top.out, contains("\n  " + command + " "));
    const Outcome help = folder.run({command, "--help"});
    CHECK(help.exit_code == 0);
    CHECK(help.err == "");
    CHECK_THAT(help.out, contains("Usage: raywalk " + command) && contains("Examples:\n  raywalk " + command));
    CHECK(folder.run({command, "-h"}).out == help.out);
  }
  CHECK_THAT(top.out, contains("Examples:\n  raywalk ") && contains("Exit codes"));
  CHECK(folder.names().empty());
}

TEST_CASE("help is a word for --help") {
  const Folder folder;
  CHECK(folder.run({"help"}).out == folder.run({"--help"}).out);
  CHECK(folder.run({"help", "lesson", "script"}).out == folder.run({"lesson", "script", "--help"}).out);
}

TEST_CASE("the window's scene that is not there may have been meant for a scene or for a command") {
  const Folder folder;
  for (const auto& [word, said] : std::vector<std::pair<std::string, std::string>>{
           {"clasic", "did you mean \"classic\", which comes with Raywalk?"},
           {"rendr", "did you mean raywalk render?"},
           {"nothing", "or the name of a scene that comes with Raywalk: "}}) {
    const Outcome outcome = folder.run({word});
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.err, contains(word + ": cannot read") && contains(said));
  }
}

TEST_CASE("the actions of demo files are listed") {
  const Folder folder;
  const Outcome outcome = folder.run({"--demo-help"});
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, contains("\nstep forward|back [line|ray|pixel") && contains("\nlanguage TEXT\n"));
}

TEST_CASE("a lesson's script is written out with its numbers, in either language") {
  const Folder folder;
  const Outcome english = folder.run({"lesson", "script", "1"});
  CHECK(english.exit_code == 0);
  CHECK(english.err == "");
  CHECK_THAT(english.out, contains("# Ray casting\n") && contains("\n## 2. The nearest surface wins (0:"));
  CHECK_THAT(english.out, contains("Count, then reveal.") && contains("\n1. the Solid Sphere\n"));
  CHECK_THAT(english.out, contains("It meets ") && !contains("{"));
  const Outcome portuguese = folder.run({"lesson", "script", "01", "--language", "pt"});
  CHECK_THAT(portuguese.out, contains("# Lançamento de raios\n"));
  const Outcome spanish = folder.run({"lesson", "script", "01", "--language", "es"});
  CHECK(spanish.exit_code == 0);
  CHECK(spanish.out != english.out);
  const Outcome page = folder.run({"lesson", "script", "1", "-o", "one.html"});
  CHECK(page.exit_code == 0);
  CHECK(page.out == "");
  CHECK(folder.run({"lesson", "script", "1", "-o", "two.HTML"}).exit_code == 0);
  CHECK(folder.read("two.HTML") == folder.read("one.html"));
  CHECK_THAT(folder.read("one.html"), contains("<h1>Ray casting</h1>") && contains("The nearest surface wins"));
  CHECK(folder.run({"lesson", "script", "1", "-o", "no/such/folder.html"}).exit_code == 1);
  const Outcome none = folder.run({"lesson", "script", "77"});
  CHECK(none.exit_code == 2);
  CHECK_THAT(none.err, contains("there is no lesson \"77\""));
}

TEST_CASE("--version says the version") {
  const Folder folder;
  const Outcome outcome = folder.run({"--version"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "raywalk " RAYWALK_VERSION "\n");
}

TEST_CASE("wrong use exits with 2 and says what was expected") {
  struct Mistake {
    std::vector<std::string> arguments;
    std::string said;
  };
  const std::vector<Mistake> mistakes{
      {{"render"}, "SCENE is required\n  hint: such as raywalk render scenes/classic.toml -o classic.png\n"},
      {{"render", classic},
       "--output is required\n  hint: such as raywalk render scenes/classic.toml -o classic.png\n"},
      {{"render", "-o", "x.png"}, "SCENE is required"},
      {{"render", classic, "-o"}, "raywalk render: --output lacks its value (expected --output IMAGE)\n"},
      {{"step", classic, "--pixel"}, "raywalk step: --pixel lacks its value (expected --pixel N|X,Y)\n"},
      {{"render", classic, "-o", "x.jpg"}, "expected .png, .pfm or .exr"},
      {{"render", classic, "-o", "x.ps"}, ".svg for a drawing by beams"},
      {{"render", classic, "-o", "x.svg"}, "only beams make a drawing"},
      {{"render", classic, "-o", "x"}, "no ending"},
      {{"render", classic, "-o", "x.png", "--size", "640"}, "such as 640x480"},
      {{"render", classic, "-o", "x.png", "--size", "0x480"}, "such as 640x480"},
      {{"render", classic, "-o", "x.png", "--size", "640x-1"}, "such as 640x480"},
      {{"render", classic, "-o", "x.png", "--size", "99999x99999"}, "up to 32768"},
      {{"render", classic, "-o", "x.png", "--size", "6x4x3"}, "such as 640x480"},
      {{"render", classic, "-o", "x.png", "--spp", "0"}, "a whole number from 1"},
      {{"render", classic, "-o", "x.png", "--spp", "-4"}, "a whole number from 1"},
      {{"render", classic, "-o", "x.png", "--spp", "many"}, "a whole number from 1"},
      {{"render", classic, "-o", "x.png", "--spp", "99999999999999999999"}, "a whole number from 1"},
      {{"render", classic, "-o", "x.png", "--depth", "0"}, "a whole number from 1 to 1000"},
      {{"render", classic, "-o", "x.png", "--depth", "1.5"}, "a whole number from 1 to 1000"},
      {{"render", classic, "-o", "x.png", "--threshold", "-0.1"}, "a number from 0 to 1"},
      {{"render", classic, "-o", "x.png", "--threshold", "nan"}, "a number from 0 to 1"},
      {{"render", classic, "-o", "x.png", "--threshold", "5"}, "a number from 0 to 1"},
      {{"render", classic, "-o", "x.png", "--spp", "64", "--tolerance", "2"}, "a number from 0 to 1"},
      {{"render", classic, "-o", "x.png", "--numerics", "naive", "--epsilon", "inf"}, "0 or more"},
      {{"step", classic, "--threshold", "1.5"}, "a number from 0 to 1"},
      {{"render", classic, "-o", "x.png", "--threads", "-1"}, "a whole number from 0"},
      {{"render", classic, "-o", "x.png", "--seed", "-3"}, "2^64 - 1"},
      {{"render", classic, "-o", "x.png", "--seed", "18446744073709551616"}, "2^64 - 1"},
      {{"render", classic, "-o", "x.png", "--accel", "bhv"}, "did you mean bvh?"},
      {{"render", classic, "-o", "x.png", "--precision", "half"}, "expected float or double"},
      {{"render", classic, "-o", "x.png", "--thread", "2"}, "did you mean --threads"},
      {{"render", classic, "-o", "x.png", "more"}, "more"},
      {{"render", classic, "-o", ""}, "the file name has no ending"},
      {{"render", classic, "-o", "x.png", "-o", "y.png"},
       "raywalk render: --output is given twice\n  hint: give it once\n"},
      {{"render", classic, "-o", "x.png", "--threads", "1", "--threads", "2"}, "render: --threads is given twice\n"},
      {{"render", classic, "-o", "x.png", "--accel", "bvh", "--accel=bvh"}, "render: --accel is given twice\n"},
      {{"check", "numerics", "--seed", "1", "--seed", "2", "--seed", "3"}, "check numerics: --seed is given 3 times\n"},
      {{"check", "numrics"},
       "raywalk check: not expected: numrics (expected numerics)\n  hint: did you mean numerics for numrics?\n"},
      {{"check", "numerics", "--ful"}, "check numerics: not expected: --ful\n  hint: did you mean --full for --ful?\n"},
      {{"lesson", "script"}, "lesson script: NAME is required\n  hint: such as raywalk lesson script 5 -o"},
      {{"lesson"}, "a command is missing (expected list, check or script)\n  hint: such as raywalk lesson list\n"},
      {{"check", "clasic"}, "raywalk check: not expected: clasic (expected numerics)\n"},
      {{"lesson", "check", classic}, "classic.toml: this is a file (expected the folder of a lesson)\n  hint: "},
      {{"convert", classic, "out"}, "OUT: out: the file name has no ending (expected .toml or .pov)\n"},
      {{"lesson", "script", "1", "-o", "one.pdf"}, "expected .html or .md"},
      {{"lesson", "script", "1", "-o", "-"}, "standard output is /dev/stdout"},
      {{"generate", "spheres", "-o", "-"}, "names no file (expected a name)\n"},
      {{"generate", "spheres", "-o", "a"}, "a: the file name has no ending (expected .nff or .toml)\n"},
      {{"generate", "flake", "--count", "5", "-o", "a.nff"}, "--count does not go with flake\n"},
      {{"generate", "flake", "--seed", "5", "-o", "a.nff"}, "--seed does not go with flake\n"},
      {{"generate", "spheres", "--levels", "3", "-o", "a.nff"}, "--levels does not go with spheres\n"},
      {{"generate", "mesh", "--up", "x", "-o", "a.ply"}, "--up does not go with mesh\n"},
      {{"generate", "mesh", "--mesh", "m.ply", "-o", "a.ply"}, "--mesh does not go with mesh\n"},
      {{"info", "--keys", "sphere", classic}, "raywalk info: --keys does not go with a scene\n"},
      {{"info", "--keys", "sphere", "--cost"}, "raywalk info: --keys does not go with --cost\n"},
      {{"info", "--keys", "sphere", "--keys", "box"}, "raywalk info: --keys is given twice\n"},
      {{"--theme", "dark", "--theme", "dark"}, "raywalk: --theme is given twice\n"},
      {{"info"}, "SCENE is required"},
      {{"info", classic, "--seed", "3"}, "raywalk info: not expected: --seed 3\n"},
      {{"info", classic, "more", "--seed", "3", "--flag"}, "not expected: more --seed 3 --flag\n"},
      {{"check", "numerics", "sphere", "--flag", "--other"}, "not expected: --flag --other\n"},
      {{"info", classic, "--spp", "0"}, "a whole number from 1"},
      {{"rendr", classic}, "did you mean render"},
      {{"render", classic, "--outptu", "x.png"}, "did you mean --output for --outptu?"},
      {{"my scene.toml", "render", "-o", "x.png", "--stats", "render"},
       "hint: raywalk render 'my scene.toml' -o x.png --stats render\n"},
      {{"-o", "x.png", "render", "classic"},
       "raywalk render: -o stands before the command (expected the options of a command after its name)\n"
       "  hint: raywalk render classic -o x.png\n"},
      {{"--size=4x3", "classic", "render", "-o", "x.png"}, "hint: raywalk render -o x.png --size=4x3 classic\n"},
      {{"--language", "es", "step", "classic"}, "hint: raywalk step classic --language es\n"},
      {{"lesson", "-o", "x.md", "script", "5"}, "hint: raywalk lesson script 5 -o x.md\n"},
      {{"info", "--keys", "foot"}, "sky, gradient, overcast, clear, image, camera, screen, limits,"},
      {{"--window", "0x0"}, "expected two whole numbers, such as 1280x720"},
      {{"--no-such-option"}, "--no-such-option"},
      {{classic, "info"}, "raywalk info " + classic},
      {{classic, "render", "-o", "x.png"}, "raywalk render " + classic + " -o x.png"},
      {{classic, "info", classic}, "does not go with a command"},
      {{"--theme", "dark", "info", classic}, "--theme belongs to the window and does not go with a command"},
  };
  const Folder folder;
  for (const Mistake& mistake : mistakes) {
    std::string line = "raywalk";
    for (const std::string& word : mistake.arguments) line += " " + word;
    INFO(line);
    const Outcome outcome = folder.run(mistake.arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out == "");
    CHECK_THAT(outcome.err, contains(mistake.said) && contains("hint: "));
    CHECK(outcome.err.find("hint: ") == outcome.err.rfind("hint: "));  // one is enough
  }
  CHECK(folder.names().empty());
}

TEST_CASE("choices that do not exist are not taken silently") {
  const Folder folder;
  for (const std::string option : {"--numerics=careful", "--integrator=mirrors", "--sampler=halton"}) {
    INFO(option);
    CHECK(folder.run({"render", classic, "-o", "x.png", option}).exit_code == 2);
  }
  CHECK(folder.names().empty());
}

TEST_CASE("bad scenes exit with 1 and name file and line") {
  const Folder folder;
  folder.write("bad.toml", "title = \"x\"\nbackgruond = 1\n[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n");
  folder.write("empty.toml", "");
  folder.write("binary.toml", std::string("\x7f"
                                          "ELF\0\1\2",
                                          7));
  const auto fails_everywhere = [&](const std::string& scene, const std::string& said) {
    INFO(scene);
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"info", scene}, {"step", scene}, {"render", scene, "-o", "x.png"}}) {
      const Outcome outcome = folder.run(words);
      CHECK(outcome.exit_code == 1);
      CHECK(outcome.out == "");
      CHECK_THAT(outcome.err, contains(said) && contains("hint: "));
    }
  };
  fails_everywhere("bad.toml", "bad.toml:2:1: ");
  fails_everywhere("bad.toml", "background");
  fails_everywhere("empty.toml", "empty.toml");
  fails_everywhere("binary.toml", "binary.toml");
  fails_everywhere(".", ".: ");
  fails_everywhere("nowhere.toml", "nowhere.toml: cannot read");
  fails_everywhere("clasic", "did you mean \"classic\"");
  fails_everywhere("folder/clasic.toml", "folder/clasic.toml: cannot read");
  CHECK_FALSE(folder.holds("x.png"));
}

TEST_CASE("scenes that come along are found by name, files of that name come first") {
  const Folder folder;
  const Outcome shipped = folder.run({"info", "classic"});
  std::filesystem::create_directory(folder / "glass");  // which hides nothing
  CHECK_THAT(folder.run({"info", "glass"}).out, contains("/scenes/glass.toml\n"));
  CHECK(shipped.exit_code == 0);
  CHECK_THAT(shipped.out, contains("/scenes/classic.toml\n"));
  const auto scene_part = [](const std::string& out) {
    return out.substr(0, out.find("structures over"));
  };  // no times
  CHECK(scene_part(folder.run({"info", "classic.toml"}).out) == scene_part(shipped.out));
  folder.write("classic", "background = 0.25\n[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n");
  const Outcome own = folder.run({"info", "classic"});
  CHECK(own.exit_code == 0);
  CHECK(own.out.starts_with("classic\n"));
}

TEST_CASE("a warning of the scene is shown and does not stop the command") {
  const Folder folder;
  folder.write("warm.toml",
               "[camera]\neye = [-5, 0]\nlook_at = [0, 0]\nfov = 45\n[[object]]\nname = \"Ball\"\ntype = \"sphere\"\n"
               "centre = [0, 0]\nradius = 1\n[object.material]\ndiffuse = 0.8\nreflection = 0.9\n");
  const Outcome outcome = folder.run({"info", "warm.toml"});
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, contains("warm.toml:") && contains("Ball"));
}

TEST_CASE("what a scene warns of many objects is said in one line") {
  const Folder folder;
  std::string text = "[camera]\neye = [-5, 0]\nlook_at = [0, 0]\nfov = 45\n";
  for (int i = 0; i < 1000; ++i)
    text += "[[object]]\nname = \"Ball " + std::to_string(i) + "\"\ntype = \"sphere\"\ncentre = [0, " +
            std::to_string(3 * i) + "]\nradius = 1\n[object.material]\nreflection = 1." + std::to_string(i + 1) + "\n";
  folder.write("bright.toml", text);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"info", "bright.toml"}, {"step", "bright.toml", "--pixel", "10"}}) {
    const Outcome outcome = folder.run(words);
    CHECK(outcome.exit_code == 0);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_THAT(outcome.err, contains("bright.toml:5:1: warning: \"Ball 0\" sends out more light than it receives"));
    CHECK_THAT(outcome.err, contains("; and 999 more like it\n"));
  }
}

TEST_CASE("standard output that takes nothing is a failure") {
  const Folder folder;
  const Outcome outcome = [&] {
    Process process("/bin/sh", {"-c", "\"$0\" info classic > /dev/full", raywalk_program()}, folder.path());
    return process.wait();
  }();
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("cannot write to standard output: No space left on device"));
}

TEST_CASE("without a display the window says what to do instead") {
  const Folder folder;
  const Outcome outcome = folder.run({});
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("hint: ") && contains("raywalk render"));
  CHECK(folder.names().empty());
}

TEST_CASE("a link is opened by the window, and one that is none is refused with a sentence") {
  const Folder folder;
  const Outcome broken = folder.run({"https://a.example/#v=1/step=many"});
  CHECK(broken.exit_code == 1);
  CHECK_THAT(broken.err,
             contains("this link cannot be opened: its part step cannot be read") && contains("copy the link again"));
  const Outcome later = folder.run({"#v=99/scene=classic"});
  CHECK(later.exit_code == 1);
  CHECK_THAT(later.err, contains("later version"));
  for (const std::string& link : {std::string("#v=1/scene=nothing_of_that_name"), std::string("#v=1/lesson=99-nothing"),
                                  "#v=1/changes=" + raywalk::pack_text("7")}) {
    const Outcome outcome = folder.run({link});
    INFO(link << ": " << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK_THAT(outcome.err, contains("this link cannot be opened: ") && !contains("display"));
  }
  // As far as it comes without a display.
  CHECK_THAT(folder.run({"raywalk:#v=1/scene=glass/step=3"}).err, contains("display"));
  CHECK_THAT(folder.run({"#v=1/lesson=03-shadows/at=2"}).err, contains("display"));
}

TEST_CASE("a link longer than a path may be is a link all the same") {
  const Folder folder;
  const std::string link = "#v=1/scene=glass/later=";
  CHECK_THAT(folder.run({link + std::string(7000, 'x')}).err, contains("display"));
  const Outcome longer = folder.run({link + std::string(100'000, 'x')});
  CHECK(longer.exit_code == 1);
  CHECK_THAT(longer.err, contains("letters (expected at most 8000)"));
  CHECK(longer.err.size() < 400);
}

TEST_CASE("a scene from standard input is asked for as a file") {
  const Folder folder;
  const Outcome outcome = folder.run({"info", "-"});
  CHECK(outcome.exit_code == 1);
  CHECK_THAT(outcome.err, contains("nothing is read from standard input; put it into a file"));
}
