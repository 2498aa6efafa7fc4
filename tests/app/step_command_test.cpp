#include "app/process.h"
#include "image/image_file.h"
#include "io/scene_file.h"
#include "timeline/recorder.h"
#include "view/text/text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

const std::string classic = std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml";

Scene classic_scene() { return read_scene(classic).value().scene; }

}  // namespace

TEST_CASE("step writes the transcript of the strip, of a cell, or of a pixel of the image") {
  const Folder folder;
  const Scene scene = classic_scene();
  const Outcome strip = folder.run({"step", classic});
  CHECK(strip.exit_code == 0);
  CHECK(strip.err == "");
  CHECK(strip.out == transcript(scene, record_strip(scene), in_english));
  CHECK_THAT(strip.out, contains("Pixel 0 is next; SCREEN has pixels 0 to 20") && contains("Pixel 20 is next"));

  const Outcome cell = folder.run({"step", classic, "--pixel", "10", "--format", "text"});
  CHECK(cell.out == transcript(scene, record_cell(scene, 10), in_english));
  CHECK_THAT(cell.out, contains("Pixel 10 is next") && !contains("Pixel 11 ") && !contains("Pixel 0 "));

  const Outcome pixel = folder.run({"step", classic, "--pixel", "40,30", "--size", "63x41"});
  CHECK(pixel.out == transcript(scene, record_pixel(scene, {63, 41}, 40, 30), in_english));
  CHECK_THAT(pixel.out, contains("column 40, row 30") && !contains("SCREEN"));
  CHECK(pixel.out != folder.run({"step", classic, "--pixel", "40,30"}).out);
}

TEST_CASE("a cell is the part of the strip that it is, number by number") {
  const Scene scene = classic_scene();
  const Timeline strip = record_strip(scene), cell = record_cell(scene, 13);
  const PixelRecord& pixel = strip.pixels()[13];
  REQUIRE(cell.steps() == pixel.done_at - pixel.begun_at + 1);
  CHECK(cell.pixels().front().shade == pixel.shade);
  CHECK(cell.pixels().front().column == 13);
}

TEST_CASE("a walk can be broken on purpose, and says so to programs") {
  const Folder folder;
  const Scene scene = classic_scene();
  const Outcome broken = folder.run({"step", classic, "--pixel", "9", "--fault", "reflection_flipped"});
  CHECK(broken.exit_code == 0);
  CHECK(broken.out ==
        transcript(scene, record_cell(scene, 9, {Precision::double_, {}, Fault::reflection_flipped}), in_english));
  CHECK(broken.out != folder.run({"step", classic, "--pixel", "9", "--numerics", "naive"}).out);
  const auto json = nlohmann::json::parse(
      folder.run({"step", classic, "--pixel", "9", "--fault", "depth_not_counted", "--format", "json"}).out);
  CHECK(json["fault"] == "depth_not_counted");
  CHECK(json["numerics"] == "naive");
  CHECK(json["integrator"] == "automatic");
  const Outcome unknown = folder.run({"step", classic, "--fault", "reflection_fliped"});
  CHECK(unknown.exit_code == 2);
  CHECK_THAT(unknown.err, contains("did you mean reflection_flipped?"));

  // What would walk something else than was asked for is refused.
  const auto refused = [&](const std::vector<std::string>& words) {
    std::vector<std::string> arguments{"step", "classic", "--pixel", "9"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const Outcome outcome = folder.run(arguments);
    CHECK(outcome.exit_code == 2);
    return outcome.err;
  };
  for (const std::string integrator : {"path", "photons", "radiosity", "beams", "cones"})
    CHECK_THAT(refused({"--fault", "reflection_flipped", "--integrator", integrator}),
               contains("reflection_flipped breaks the integrator whitted, and that of this scene is " + integrator) &&
                   contains("--integrator whitted"));
  CHECK_THAT(refused({"--fault", "cosine_counted_twice"}), contains("--integrator path"));
  CHECK_THAT(refused({"--fault", "reflection_flipped", "--numerics", "robust"}), contains("breaks naive numerics"));
  CHECK(folder.run({"step", classic, "--pixel", "9", "--fault", "reflection_flipped", "--integrator", "whitted"}).out ==
        broken.out);
}

TEST_CASE("a path is walked by a pseudocode of its own") {
  const Folder folder;
  const std::string path = folder.run({"step", classic, "--pixel", "10", "--integrator", "path"}).out;
  CHECK_THAT(path, contains("While there is a ray") && contains("Choose direction") && !contains("If reflective"));
  const Outcome one_ray = folder.run({"step", classic, "--pixel", "10", "--integrator", "path", "--path-length", "1"});
  CHECK_THAT(one_ray.out, contains("it may have at most 1 ray.") || contains("left the scene"));
  CHECK(folder.run({"step", classic, "--path-length", "0"}).exit_code == 2);
  Scene scene = classic_scene();
  scene.render.integrator = Integrator::path;
  CHECK(path == transcript(scene, record_cell(scene, 10), in_english));
}

TEST_CASE("limits and precision change the steps") {
  const Folder folder;
  const std::string usual = folder.run({"step", classic}).out;
  const std::string shallow = folder.run({"step", classic, "--depth", "1"}).out;
  CHECK(std::count(shallow.begin(), shallow.end(), '\n') < std::count(usual.begin(), usual.end(), '\n'));
  CHECK(folder.run({"step", classic, "--threshold", "0.4"}).out != usual);
  const Outcome idle = folder.run({"step", classic, "--epsilon", "5", "--path-length", "3"});
  CHECK(idle.out == usual);
  CHECK_THAT(idle.err, contains("raywalk step: note: --epsilon has no effect") && contains("note: --path-length has"));
  CHECK(folder.run({"step", classic, "--precision", "float", "--format", "json"}).out !=
        folder.run({"step", classic, "--format", "json"}).out);
}

TEST_CASE("step's JSON holds every step with its numbers and its sentence") {
  const Folder folder;
  const Scene scene = classic_scene();
  const Outcome outcome = folder.run({"step", classic, "--format", "json"});
  CHECK(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json.at("title") == scene.title);
  CHECK(json.at("depth") == scene.limits.depth);
  CHECK(json.at("precision") == "double");
  const Timeline timeline = record_strip(scene);
  const auto& steps = json.at("steps");
  REQUIRE(steps.size() == static_cast<std::size_t>(timeline.steps()));
  for (int position = 1; position <= timeline.steps(); ++position) {
    const auto& step = steps.at(static_cast<std::size_t>(position) - 1);
    CHECK(step.at("step") == position);
    CHECK(step.at("depth") == timeline.event(position - 1).depth);
    CHECK(step.at("sentence") == sentence_of(scene, describe(scene, timeline, position), in_english));
  }
  // One line a step, between a line at the top and one at the bottom.
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == timeline.steps() + 2);
}

TEST_CASE("step writes a page that steps in a browser, and a drawing") {
  const Folder folder;
  const Outcome page = folder.run({"step", classic, "--pixel", "10", "--format", "html"});
  CHECK(page.exit_code == 0);
  CHECK(page.err == "");
  CHECK_THAT(page.out, contains("<!DOCTYPE html>") && contains("Pixel 10 is next") && contains("</html>"));
  const Outcome drawing = folder.run({"step", classic, "--format", "svg"});
  CHECK(drawing.exit_code == 0);
  CHECK_THAT(drawing.out, contains("<svg xmlns=") && contains("Solid Sphere") && contains("</svg>"));
}

TEST_CASE("step speaks Portuguese as text and as a page; JSON is the same in every language") {
  const Folder folder;
  const Scene scene = classic_scene();
  const std::vector<std::string> words{"step", classic, "--pixel", "10", "--language", "pt"};
  const Outcome text = folder.run(words);
  CHECK(text.exit_code == 0);
  CHECK(text.out == transcript(scene, record_cell(scene, 10), in_portuguese));
  CHECK_THAT(text.out, contains("raio de sombra") && contains("Formar raio de sombra"));
  const auto as = [&](const std::string& format, const std::string& language) {
    return folder.run({"step", classic, "--pixel", "10", "--format", format, "--language", language}).out;
  };
  CHECK_THAT(as("html", "pt"), contains("<html lang=\"pt\">") && contains("raio de sombra"));
  CHECK(as("json", "pt") == as("json", "en"));
  const Outcome unknown = folder.run({"step", classic, "--language", "xx"});
  CHECK(unknown.exit_code == 2);
  CHECK_THAT(unknown.err, contains("expected en, es or pt") && contains("xx.toml"));
}

TEST_CASE("a walk without end is refused, a deep one with an end is not") {
  const Folder folder;
  // Inside a glass ball in a glass ball every ray goes on as two, without end.
  const std::string camera = "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n[screen]\ncells = 5\n";
  const auto ball = [](const std::string& name, const std::string& radius, const std::string& material) {
    return "[[object]]\nname = \"" + name + "\"\ntype = \"sphere\"\ncentre = [0.1, 0.2]\nradius = " + radius +
           "\n[object.material]\ndiffuse = 0\n" + material;
  };
  const std::string glass = "reflection = 0.5\ntransmission = 0.5\n";
  folder.write("balls.toml", camera + "[limits]\ndepth = 1000\n" + ball("A", "1", glass) + ball("B", "2", glass));
  const Outcome endless = folder.run({"step", "balls.toml"});
  CHECK(endless.exit_code == 1);
  CHECK(endless.out == "");
  CHECK_THAT(endless.err, contains("balls.toml: there are") && contains("--depth"));
  CHECK(folder.run({"step", "balls.toml", "--depth", "4"}).exit_code == 0);

  folder.write("mirror.toml", camera + "[limits]\ndepth = 300\n" + ball("A", "1", "reflection = 1\n"));
  const Outcome deep = folder.run({"step", "mirror.toml"});
  CHECK(deep.exit_code == 0);
  CHECK_THAT(deep.out, contains("[300]") && !contains("[301]"));
}

TEST_CASE("rays that no step tells of, behind a beam's middle, are followed as deep as the scene says") {
  const Folder folder;
  const std::vector<std::string> how{"--integrator", "beams", "--size", "21x15"};
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), how.begin(), how.end());
    const Outcome done = folder.run(arguments);
    CHECK(done.exit_code == 0);
    return done.out;
  };
  run({"render", "glass_in_water", "-o", "whole.pfm", "-q"});
  const Image whole = read_image((folder.path() / "whole.pfm").string()).value();
  for (const auto& [column, row] : {std::pair(10, 6), std::pair(5, 6)}) {
    const auto steps = nlohmann::json::parse(run(
        {"step", "glass_in_water", "--pixel", std::to_string(column) + "," + std::to_string(row), "--format", "json"}));
    const auto& put = steps["steps"].back()["shade"];
    const auto& expected = whole.pixels[static_cast<std::size_t>(row * whole.width + column)];
    CAPTURE(column, row, put.dump());
    for (int channel = 0; channel < 3; ++channel)
      CHECK(put[static_cast<std::size_t>(channel)].get<double>() == Approx(expected[channel]).epsilon(1e-5));
  }
}

TEST_CASE("lights of so many samples that one hit fills the memory are refused") {
  const Folder folder;
  std::string scene = "[camera]\neye = [0, 0]\nlook_at = [1, 0]\nfov = 45\n[render]\nlight_grid = 256\n";
  for (int i = 0; i < 4; ++i)
    scene +=
        "[[light]]\nname = \"L" + std::to_string(i) + "\"\ntype = \"sphere\"\nposition = [0, 3, 3]\nradius = 0.5\n";
  folder.write("lights.toml", scene + "[[object]]\nname = \"B\"\ntype = \"sphere\"\ncentre = [4, 0]\nradius = 1\n");
  const Outcome strip = folder.run({"step", "lights.toml", "--integrator", "whitted"});
  CHECK(strip.exit_code == 1);
  CHECK(strip.out == "");
  CHECK_THAT(strip.err, contains("the first hits alone take about 1.1e+07 steps") && contains("light_grid"));
}

TEST_CASE("a pixel that is not there is wrong use") {
  const Folder folder;
  const auto refused = [&](const std::vector<std::string>& words, const std::string& said) {
    std::vector<std::string> arguments{"step", classic};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const Outcome outcome = folder.run(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out == "");
    CHECK_THAT(outcome.err, contains(said) && contains("hint: "));
  };
  refused({"--pixel", "21"}, "no cell 21 (expected 0 to 20)");
  refused({"--pixel", "441,0"}, "columns 0 to 440, rows 0 to 330");
  refused({"--pixel", "0,41", "--size", "63x41"}, "rows 0 to 40");
  refused({"--pixel", "-1"}, "a cell of the strip, such as 10");
  refused({"--pixel", "1,2,3"}, "a cell of the strip, such as 10");
  refused({"--format", "xml"}, "expected text, json, html or svg");
  CHECK(folder.run({"step", classic, "--pixel", "20"}).exit_code == 0);
  CHECK(folder.run({"step", classic, "--pixel", "440,330"}).exit_code == 0);
}
