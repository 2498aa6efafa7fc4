// The rules themselves, tried on planted text: each must see what it forbids and let pass what it does not.
#include "house/rules.h"

#include "support/catch.h"

using namespace raywalk::house;

namespace {

const Floors floors = declared_floors(
    "x\nraywalk_floor(math USES dep::glm)\nraywalk_floor(shape BELOW math)\nraywalk_floor(io BELOW shape USES png)\n"
    "raywalk_floor(trace BELOW shape)\nraywalk_floor(lesson BELOW trace io)\nraywalk_floor(study BELOW trace io)\n"
    "raywalk_floor(view BELOW lesson\n study)\nraywalk_floor(gui BELOW view)\nraywalk_floor(app BELOW gui)\n");

std::string includes(const std::string& path, const std::string& text) {
  return report(check_includes(floors, {path, text}));
}
std::string edges(const Floors& house, const std::vector<SourceFile>& files) {
  return report(check_edges(house, files));
}
std::string names(const std::string& path, const std::string& text) { return report(check_names({path, text})); }

}  // namespace

TEST_CASE("comments and literals are blanked, lines stay") {
  CHECK(without_comments("a // b\nc", false) == "a     \nc");
  CHECK(without_comments("a /* b\nc */ d", false) == "a     \n     d");
  CHECK(without_comments("f(\"x // y\") g", false) == "f(\"      \") g");
  CHECK(without_comments("f(\"x // y\") g", true) == "f(\"x // y\") g");
  CHECK(without_comments("f(\"a\\\"b\") // c", false) == "f(\"    \")     ");
  CHECK(without_comments("n = 1'000; // c", false) == "n = 1'000;     ");
  CHECK(without_comments("c = '\"'; d", false) == "c = ' '; d");
  CHECK(without_comments("R\"x(a \" // )x\" b", false) == "R\"         )x\" b");
  CHECK(without_comments("open /* never closed", false) == "open                ");
}

TEST_CASE("pictures depend on no function whose last bit is the library's own") {
  const auto portable = [](const std::string& path, const std::string& text) {
    return report(check_portable({path, text}));
  };
  const std::string reason = "' of the library differs in its last bit between machines: see math/elementary.h\n";
  CHECK(portable("src/trace/a.h", "T x = std::pow(a, b);\nT y = exp (a);") ==
        "src/trace/a.h:1: 'pow" + reason + "src/trace/a.h:2: 'exp" + reason);
  CHECK(portable("src/math/b.h", "glm::sin(a) + ::cos(b)") == "src/math/b.h:1: 'sin" + reason);
  CHECK(portable("src/math/b.h", "return ::cos(b);") == "src/math/b.h:1: 'cos" + reason);
  CHECK(portable("src/io/c.cpp", "std::normal_distribution<> d; std::complex<float> c;") ==
        "src/io/c.cpp:1: 'normal_distribution" + reason + "src/io/c.cpp:1: 'complex" + reason);
  CHECK(portable("src/trace/a.h", "portable::pow(a, b) + std::sqrt(a) + wave.sin(a) + cos * (b) + std::fma(a, b, c)") ==
        "");
  CHECK(portable("src/math/elementary/d.cpp", "return exp(x) - big::sin(y);") == "");
  CHECK(portable("src/math/elementary/d.cpp", "return std::exp(x);") == "src/math/elementary/d.cpp:1: 'exp" + reason);
  CHECK(portable("src/io/c.cpp", "Log log(name);") == "");
  CHECK(portable("src/io/c.cpp", "return log(x);") == "src/io/c.cpp:1: 'log" + reason);
  CHECK(portable("src/view/e.cpp", "std::sin(a)") == "");
}

TEST_CASE("a room includes itself, shared rooms and what stands above all rooms, and no other feature") {
  const auto rooms = [](const std::string& path, const std::string& text) { return report(check_rooms({path, text})); };
  CHECK(rooms("src/view/cost/cost.cpp",
              "#include \"view/cost/cost.h\"\n#include \"view/plan/painter.h\"\n#include \"view/state.h\"\n") == "");
  CHECK(rooms("src/view/cost/cost.cpp", "\n#include \"view/lesson/lesson.h\"\n") ==
        "src/view/cost/cost.cpp:2: room cost may not include room lesson: what two features need stands in a shared "
        "room\n");
  CHECK(
      rooms("src/view/walk/playback.cpp", "#include \"view/lesson/lesson.h\"\n") ==
      "src/view/walk/playback.cpp:1: room walk may not include room lesson: what two features need stands in a shared "
      "room\n");
  CHECK(rooms("src/view/state.h", "#include \"view/lesson/lesson.h\"\n") == "");
}

TEST_CASE("a floor includes only from its own folder and from floors below") {
  CHECK(includes("src/trace/tracer.h", "#include \"math/vec.h\"\n#include \"trace/event.h\"\n#include <vector>\n") ==
        "");
  CHECK(includes("src/math/ray.h", "\n#include \"shape/sphere.h\"\n") ==
        "src/math/ray.h:2: floor math may not include \"shape/sphere.h\": it does not stand on shape\n");
  CHECK_THAT(includes("src/view/state.cpp", "#include \"gui/window.h\"\n"),
             raywalk::test::contains("does not stand on gui"));
  CHECK_THAT(includes("src/lesson/a.h", "#include \"study/b.h\"\n"),
             raywalk::test::contains("does not stand on study"));
  CHECK_THAT(includes("src/math/ray.h", "  #  include <shape/sphere.h>\n"), raywalk::test::contains("not stand on"));
  CHECK_THAT(includes("src/math/ray.h", "#include \"vec.h\"\n"), raywalk::test::contains("FLOOR/name.h"));
  CHECK_THAT(includes("src/math/ray.h", "#include \"../shape/sphere.h\"\n"), raywalk::test::contains("FLOOR/name.h"));
  CHECK(includes("src/math/ray.h", "// #include \"shape/sphere.h\"\n") == "");
  CHECK(includes("tests/math/ray_test.cpp", "#include \"gui/window.h\"\n") == "");
}

TEST_CASE("the floors are those that CMakeLists.txt declares") {
  CHECK(floors.size() == 9);
  CHECK(floors.at("math").empty());
  CHECK(floors.at("io") == std::set<std::string>{"shape"});
  CHECK(floors.at("view") == std::set<std::string>{"lesson", "study"});
  CHECK(floors_below(floors, "study") == std::set<std::string>{"trace", "io", "shape", "math"});
}

TEST_CASE("a floor stands on what it includes, and not twice") {
  const SourceFile shape{"src/shape/a.h", "#include \"math/a.h\"\n"};
  const SourceFile io{"src/io/a.h", "#include \"shape/a.h\"\n#include \"math/a.h\"\n#include <math/b.h>\n"};
  CHECK(edges({{"math", {}}, {"shape", {"math"}}, {"io", {"shape"}}}, {shape, io}) == "");
  CHECK(edges({{"math", {}}, {"shape", {"math"}}, {"io", {"math", "shape"}}}, {shape, io}) ==
        "CMakeLists.txt:0: io reaches math through shape already\n");
  CHECK(edges({{"math", {}}, {"shape", {"math"}}}, {{"src/shape/a.h", "// #include \"math/a.h\"\n"}}) ==
        "CMakeLists.txt:0: shape includes nothing from math, below it\n");
  CHECK_THAT(edges({{"math", {"shape"}}, {"shape", {"math"}}}, {shape}),
             raywalk::test::contains("stand on each other"));
}

TEST_CASE("others' headers stand only where they belong") {
  CHECK(includes("src/math/vec.h", "#include <glm/glm.hpp>\n") == "");
  CHECK_THAT(includes("src/math/ray.h", "#include <glm/glm.hpp>\n"), raywalk::test::contains("only src/math/vec.h"));
  for (const std::string header : {"GLFW/glfw3.h", "imgui.h", "imgui_impl_glfw.h", "imgui/imgui.h", "GL/gl.h"}) {
    CHECK(includes("src/gui/window.cpp", "#include <" + header + ">\n") == "");
    CHECK_THAT(includes("src/view/state.h", "#include <" + header + ">\n"),
               raywalk::test::contains("only gui includes"));
    CHECK_THAT(includes("src/app/main.cpp", "#include <" + header + ">\n"),
               raywalk::test::contains("only gui includes"));
  }
  CHECK_THAT(includes("src/io/read.cpp", "#include <expected>\n"), raywalk::test::contains("libc++"));
  CHECK(includes("src/app/main.cpp", "#include <format>\n") == "");
}

TEST_CASE("nothing prints or ends the program below app") {
  for (const std::string line :
       {"std::cout << x;", "printf(\"%d\", x);", "std::puts(s);", "fprintf(stderr, \"x\");", "fmt::print(\"x\");",
        "std::println(\"x\");", "std::exit(1);", "exit(1);", "std::abort();", "std::terminate();"}) {
    CAPTURE(line);
    CHECK(names("src/io/read.cpp", "int f();\n" + line + "\n") != "");
    CHECK(names("src/app/main.cpp", line) == "");
    CHECK(names("src/io/read.cpp", "// " + line) == "");
    CHECK(names("src/io/read.cpp", "const char* s = R\"(" + line + ")\";") == "");
  }
  for (const std::string line :
       {"std::snprintf(b, n, \"%d\", x);", "const double exit = box.exit();", "span.exit(ray);", "fmt::format(\"x\");",
        "std::string footprint(int);", "player->print();", "interval::exit(t);"}) {
    CAPTURE(line);
    CHECK(names("src/io/read.cpp", line) == "");
  }
  CHECK(names("src/io/read.cpp", "a\n\ncout").starts_with("src/io/read.cpp:3: "));
}

TEST_CASE("floors up to view do without what the web's libc++ lacks") {
  CHECK_THAT(names("src/render/tiles.cpp", "std::jthread t;"), raywalk::test::contains("libc++"));
  CHECK_THAT(names("src/render/tiles.cpp", "std::atomic_ref<int> a(x);"), raywalk::test::contains("libc++"));
  CHECK(names("src/gui/window.cpp", "std::jthread t;") == "");
}

TEST_CASE("long files are named and headers guard themselves") {
  const auto lines = [](int n) {
    std::string text = "#pragma once\n";
    for (int i = 1; i < n; ++i) text += "\n";
    return text;
  };
  CHECK(report(check_length({"src/math/vec.h", lines(400)})) == "");
  CHECK_THAT(report(check_length({"src/math/vec.h", lines(401)})), raywalk::test::contains("has 401 lines"));
  CHECK(report(check_length({"scenes/classic.toml", lines(401)})) == "");
  CHECK_THAT(report(check_shape({"src/math/vec.h", "struct A {};\n"})), raywalk::test::contains("#pragma once"));
  CHECK(report(check_shape({"src/math/vec.cpp", "struct A {};\n"})) == "");
}

TEST_CASE("two types of one name are seen, unless they are of one file or of other namespaces") {
  const std::string node = "namespace raywalk {\n\nstruct Node {\n};\n\n}  // namespace raywalk\n";
  CHECK(
      report(check_types({{"src/a.h", node}, {"src/b.h", "namespace raywalk {\nclass alignas(64) Node : Base {\n"}})) ==
      "src/b.h:2: defines raywalk::Node, as src/a.h does\n");
  CHECK(report(check_types(
            {{"src/a.h", node},
             {"src/b.h", "namespace raywalk {\nstruct Node;\nstruct Node::Part {\n};\nstruct Node<int> {\n"},
             {"src/c.h", "namespace raywalk::check {\nstruct Node {\n"},
             {"src/d.cpp", "namespace raywalk {\nnamespace {\nstruct Node {\n"}})) == "");
}

TEST_CASE("what is not finished is not in the tree") {
  CHECK_THAT(report(check_finished({"src/a.h", std::string("ok\n// TO") + "DO: later"})),
             raywalk::test::contains("src/a.h:2"));
  CHECK(report(check_finished({"src/a.h", std::string("kFIX") + "MES"})) == "");
}

TEST_CASE("the version stands in one place") {
  CHECK(declared_version("x\nproject(raywalk VERSION 1.22.3 LANGUAGES CXX)\n") == "1.22.3");
  CHECK(declared_version("x\nproject(raywalk\n  VERSION 1.22.3)\n") == "1.22.3");
  CHECK(declared_version("x\nproject(raywalk)\nset(A VERSION 1.0)\n") == "");
  CHECK_THAT(report(check_version({"src/app/main.cpp", "auto v = \"1.22.3\";"}, "1.22.3")),
             raywalk::test::contains("RAYWALK_VERSION"));
  CHECK(report(check_version({"src/app/main.cpp", "auto v = RAYWALK_VERSION; // 1.22.3"}, "1.22.3")) == "");
}

TEST_CASE("the top level and src hold only what the design has") {
  CHECK(report(check_top_level({"src", "tests", "README.md", ".git", "build"}, "/build/\n/x.png\n")) == "");
  CHECK(report(check_top_level({"src", "cmake"}, "/build/\n")) ==
        "cmake:0: the design has no place for it at the top level\n");
  CHECK(report(check_floors(floors, {"math", "app", "study"})) == "");
  CHECK(report(check_floors(floors, {"math", "util"})) == "src/util:0: is no floor of the house\n");
}
