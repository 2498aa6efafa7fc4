// The schema of a scene as a whole: every key is written and read, refused out of its range and found when misspelt.

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "bad_scene.h"
#include "io/key_reference.h"
#include "io/scene_file.h"
#include "scene/schema.h"
#include "support/catch.h"
#include "support/temporary_folder.h"
#include "text/toml.h"
#include "view/cost/cost.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// One of each kind of light, shape and table.
const std::string everything = R"([camera]
eye = [-7, 0, 1]
look_at = [0, 0]
fov = 45

[[group]]
name = "tree"
[[group.object]]
name = "crown"
type = "sphere"
centre = [0, 0]
radius = 1

[[group]]
name = "bush"
[[group.object]]
name = "leaf"
type = "sphere"
centre = [0, 0]
radius = 1

[[light]]
name = "L1"
type = "point"
position = [0, 0]
[[light]]
name = "L2"
type = "directional"
direction = [0, 0, 1]
[[light]]
name = "L3"
type = "spot"
position = [0, 3]
look_at = [0, 0]
[[light]]
name = "L4"
type = "sphere"
position = [0, 3]
radius = 1
[[light]]
name = "L5"
type = "rectangle"
corner = [0, 3]
u = [1, 0]
v = [0, 0, 1]

[[object]]
name = "sphere"
type = "sphere"
centre = [0, 0]
radius = 1
transform = [["translate", 1, 0, 0]]
motion = [[0, 0, 0, 0], [1, 2, 0, 0]]
[object.material.checker]
size = 2
[object.material.texture]
file = "wood.png"
[[object]]
name = "plane"
type = "plane"
point = [0, 0]
normal = [0, 0, 1]
[object.material]
emission = 1
normal_map = { file = "normals.png" }
bump_map = { file = "heights.png" }
mask = { file = "mask.png", second = { emission = 1, map = [{ of = "diffuse", file = "wood.png" }] } }
[[object.material.map]]
of = "emission"
file = "wood.png"
[[object]]
name = "polygon"
type = "polygon"
corners = [[0, 0], [1, 0], [0, 1]]
[[object]]
name = "box"
type = "box"
min = [0, 0]
max = [1, 1, 1]
QUADRICS
[[object]]
name = "disk"
type = "disk"
centre = [0, 0]
normal = [0, 0, 1]
radius = 1
[[object]]
name = "flat"
type = "flat_polygon"
corners = [[0, 0, 0], [9, 0, 0], [0, 9, 0]]
holes = [[[1, 1, 0], [2, 1, 0], [1, 2, 0]]]
[[object]]
name = "triangle"
type = "triangle"
a = [0, 0]
b = [1, 0]
c = [0, 1]
[[object]]
name = "mesh"
type = "mesh"
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
triangles = [[0, 1, 2]]
normals = [[0, 0, 1], [0, 0, 1], [0, 0, 1]]
uv = [[0, 0], [1, 0], [0, 1]]
[[object]]
name = "instance"
type = "instance"
group = "tree"
[[ink]]
type = "pen"
points = [[0, 0], [1, 2]]
[[ink]]
type = "arrow"
from = [0, 0]
to = [1, 0]
[[ink]]
type = "text"
at = [0, 0]
text = "n"
[[ink]]
type = "ruler"
from = [0, 0]
to = [1, 0]
[[ink]]
type = "protractor"
vertex = [0, 0]
from = [1, 0]
to = [0, 1]
)";

schema::SceneFile file_of_everything() {
  std::string quadrics;
  for (const char* type :
       {"ellipsoid", "paraboloid", "cone", "cylinder", "hyperboloid_one_sheet", "hyperboloid_two_sheets"})
    quadrics +=
        "[[object]]\nname = \"" + std::string(type) + "\"\ntype = \"" + type + "\"\nradii = 1\nz_min = -2\nz_max = 2\n";
  const auto read = parse_scene(std::regex_replace(everything, std::regex("QUADRICS\n"), quadrics), "everything");
  if (!read) FAIL(read.error().text());
  return {read->scene, read->ink};
}

/// The same under each kind of sky, of which a scene has but one.
std::vector<schema::SceneFile> files_of_everything() {
  std::vector<schema::SceneFile> files;
  const schema::SceneFile base = file_of_everything();
  for (const AnySky& kind :
       {AnySky(GradientSky{}), AnySky(OvercastSky{}), AnySky(ClearSky{}), AnySky(ImageSky{"a.hdr"})}) {
    files.push_back(base);
    files.back().scene.sky = Sky{kind};
  }
  static_assert(std::variant_size_v<AnySky> == 4);
  return files;
}

Result<std::string> format_file(const schema::SceneFile& file) { return format_scene(file.scene, {}, file.ink); }

/// The `Fields` of the schema that gives one key of a scene, the one of a number, another value: a legal one or, where
/// there are such, one below or above what its kind takes.
class Changer {
 public:
  enum class To { another, too_low, too_high };
  Changer(int wanted, To to) : wanted_(wanted), to_(to) {}

  std::string changed;   ///< "sphere.radius", or nothing
  std::string expected;  ///< what must be told of a bad value
  int count = 0;         ///< of the keys

  void about(std::string_view /*sentence*/) {}
  template <class T, class Kind>
  void key(std::string_view name, T& value, const Kind& kind, std::string_view /*sentence*/ = {}) {
    if (count++ == wanted_ && change(kind, value)) changed = table_ + "." + std::string(name);
  }
  template <class T, class Kind>
  void key(std::string_view name, std::optional<T>& value, const Kind& kind, std::string_view sentence = {}) {
    T inner = value.value_or(T{});
    const int before = count;
    key(name, inner, kind, sentence);
    if (before <= wanted_ && wanted_ < count && !changed.empty()) value = inner;
  }
  template <class T>
  void key(std::string_view name, T& value, const schema::Table& /*kind*/) {
    const std::string outer = std::exchange(table_, std::string(name));
    schema::describe(*this, value);
    table_ = outer;
  }
  template <class T>
  void key(std::string_view name, std::optional<T>& value, const schema::Table& kind) {
    if (value) key(name, *value, kind);
  }
  template <class T>
  void key(std::string_view name, std::vector<T>& value, const schema::Tables& /*kind*/) {
    for (T& element : value) key(name, element, schema::table);
  }
  template <class T, class Kind, class... Sentence>
  void required(std::string_view name, T& value, const Kind& kind, const Sentence&... sentence) {
    key(name, value, kind, sentence...);
  }
  template <class... Kinds>
  void type(std::variant<Kinds...>& value, std::string_view /*sentence*/) {
    std::visit([&](auto& kind) { key(schema::type_name(kind), kind, schema::table); }, value);
  }
  template <class T>
  void together(std::optional<T>& value) {
    if (value) schema::describe(*this, *value);
  }
  template <class... Rule>
  void check(const Rule&... /*rule*/) {}
  template <class T>
  void left_out(std::string_view /*name*/, const T& /*value*/, const T& /*usual*/) {}
  void without(std::string_view /*name*/, std::string_view /*message*/, std::string_view /*hint*/) {}
  template <class T>
  void complete(const T& /*value*/) {}

 private:
  bool change(const schema::Number& kind, double& value) {
    std::vector<double> candidates{value + 0.25, value - 0.25, value / 2};
    if (to_ == To::too_low) candidates = {kind.above_low ? kind.low : kind.low - 1, 2 * kind.low};
    if (to_ == To::too_high) candidates = {kind.below_high ? kind.high : kind.high + 1, 2 * kind.high};
    for (const double candidate : candidates) {
      const auto refusal = kind.refusal(candidate);
      if (refusal.has_value() == (to_ == To::another)) continue;
      value = candidate;
      if (refusal) expected = "(expected " + refusal->expected + ")";
      return true;
    }
    return false;
  }
  bool change(const schema::Whole& kind, int& value) {
    if (to_ != To::another) expected = "(expected " + kind.expected() + ")";
    value = to_ == To::too_low                          ? kind.low - 1
            : to_ == To::too_high || value == kind.high ? kind.high + (to_ == To::another ? -1 : 1)
                                                        : value + 1;
    return true;
  }
  template <class T>
  bool change(const schema::Tuple& kind, T& value) {
    bool is_first = true, is_changed = false;
    schema::each_number(value, [&](double& number) {
      if (std::exchange(is_first, false)) is_changed = change(kind.number, number);
    });
    return is_changed;
  }
  template <class T>
  bool change(const schema::Rows& kind, std::vector<T>& value) {
    return !value.empty() && change(kind.row, value.front());
  }
  template <class T>
  bool change(const schema::Lists& kind, std::vector<T>& value) {
    return !value.empty() && change(kind.rows, value.front());
  }
  bool change(const schema::Steps& /*kind*/, std::vector<TransformStep>& value) {
    return !value.empty() && change(schema::Tuple{{}, schema::any_number}, value.front());
  }
  bool change(const schema::MeshRows& kind, MeshShape& value) {
    using Part = schema::MeshRows::Part;
    if (!value.mesh) return false;
    Mesh mesh = *value.mesh;
    Mesh::Corners& corners = mesh.triangles.front();
    bool is_changed = to_ == To::another;
    if (kind.part == Part::positions) is_changed = change(kind.rows, mesh.positions);
    if (kind.part == Part::normals) is_changed = change(kind.rows, mesh.normals);
    if (kind.part == Part::uv) is_changed = change(kind.rows, mesh.uv);
    if (kind.part == Part::triangles) corners = {corners[1], corners[2], corners[0]};
    value.mesh = std::make_shared<const Mesh>(mesh);
    return is_changed;
  }
  // Words have no range.
  bool change(const schema::Flag& /*kind*/, bool& value) {
    value = !value;
    return to_ == To::another;
  }
  template <class T>
  bool change(const schema::Choice<T>& /*kind*/, T& value) {
    value = static_cast<T>((static_cast<std::size_t>(value) + 1) % all_words<T>().size());
    return to_ == To::another;
  }
  template <class Kind>
  bool change(const Kind& /*kind*/, std::string& value) {
    value += "2";
    return to_ == To::another;
  }
  bool change(const schema::Names& /*kind*/, std::vector<std::string>& value) {
    value.emplace_back("Ball");
    return to_ == To::another;
  }
  bool change(const schema::GroupName& /*kind*/, Instance& value) {
    value.group = "bush";
    return to_ == To::another;
  }

  int wanted_;
  To to_;
  std::string table_ = "scene";
};

/// `file` with the `wanted`-th key changed, and what else must change with it.
Changer change(schema::SceneFile& file, int wanted, Changer::To to) {
  Scene& scene = file.scene;
  const std::string tree = scene.groups.front().name;
  Changer changer(wanted, to);
  schema::describe(changer, file);
  if (scene.camera.screen.width) scene.camera.fov.reset();  // one of them says how wide the view is
  for (Object& object : scene.objects)
    if (auto& mask = object.material.mask; mask && mask->squares) mask->file.clear();  // an image or a checker
  for (Object& object : scene.objects)
    if (auto* instance = std::get_if<Instance>(&object.shape)) {
      if (instance->group == tree) instance->group = scene.groups.front().name;
    }
  return changer;
}

}  // namespace

TEST_CASE("every key of the schema is written and read again") {
  std::set<std::string> written;
  for (const schema::SceneFile& base : files_of_everything()) {
    int count = 1;
    for (int i = 0; i < count; ++i) {
      schema::SceneFile changed = base;
      const Changer changer = change(changed, i, Changer::To::another);
      count = changer.count;
      if (changed == base || written.contains(changer.changed)) continue;
      INFO(changer.changed);
      const auto text = format_file(changed);
      if (!text) FAIL(text.error().text());
      const auto read = parse_scene(*text, "changed", MeshReading::skip);
      REQUIRE(read);
      CHECK(schema::SceneFile{read->scene, read->ink} == changed);
      const std::string key = changer.changed.substr(changer.changed.find('.') + 1);
      CHECK_THAT(*text, contains(key + " = "));
      written.insert(changer.changed);
    }
  }
  std::set<std::string> known;
  for (const KeyTable& table : key_tables())
    for (const KeyEntry& key : table.keys) {
      INFO(table.name << " " << key.name);
      CHECK(!key.sentence.empty());
      const bool is_table = key.expected == schema::Table::expected() || key.expected == schema::Tables::expected();
      if (!is_table && key.name != "type" && !key.expected.empty()) known.insert(table.name + "." + key.name);
    }
  CHECK(known.size() > 100);
  CHECK(written == known);
}

TEST_CASE("a number out of its key's range is refused in the schema's words") {
  std::set<std::string> refused;
  for (const schema::SceneFile& base : files_of_everything())
    for (const auto to : {Changer::To::too_low, Changer::To::too_high}) {
      const std::string end = to == Changer::To::too_low ? "below" : "above";
      int count = 1;
      for (int i = 0; i < count; ++i) {
        schema::SceneFile changed = base;
        const Changer changer = change(changed, i, to);
        count = changer.count;
        if (changer.changed.empty() || changed == base || !refused.insert(changer.changed + end).second) continue;
        INFO(changer.changed);
        const auto text = format_file(changed);
        REQUIRE(!text);
        CHECK_THAT(text.error().message, contains(changer.expected));
      }
    }
  CHECK(refused.size() > 150);
}

TEST_CASE("a misspelt key is told the one that was meant") {
  const std::string text = *format_file(file_of_everything());
  const std::regex line("(^|\n)([a-z_]{4,}) = ");
  int count = 0;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), line); at != std::sregex_iterator(); ++at) {
    const std::string key = (*at)[2].str();
    std::string misspelt = text;
    misspelt.insert(static_cast<std::size_t>(at->position(2) + at->length(2)), "x");
    INFO(key);
    const auto read = parse_scene(misspelt, "misspelt.toml", MeshReading::skip);
    REQUIRE(!read);
    CHECK_THAT(read.error().message, contains("unknown key \"" + key + "x\""));
    CHECK(read.error().hint == "did you mean \"" + key + "\"?");
    ++count;
  }
  CHECK(count > 50);
}

namespace {

void check_known(const toml::node& node, const std::set<std::string>& known) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) {
      INFO(key.str());
      CHECK(known.contains(std::string(key.str())));
      check_known(value, known);
    }
  } else if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) check_known(element, known);
  }
}

}  // namespace

TEST_CASE("every key of the scenes that come along stands in the reference") {
  std::set<std::string> known;
  for (const KeyTable& table : key_tables())
    for (const KeyEntry& key : table.keys) known.insert(key.name);
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(RAYWALK_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path());
    const toml::parse_result parsed = toml::parse(contents(entry.path().string()));
    REQUIRE(parsed);
    check_known(parsed.table(), known);
    ++count;
  }
  CHECK(count > 20);
}

TEST_CASE("the reference says of a key what it takes and what it is when left out") {
  const std::string text = reference_text(key_tables());
  for (const char* part :
       {"[[object]] of type \"sphere\"\n", "an angle in degrees above 0 and below 180; may be left out",
        "in scene units; must be given", "a number above 0; 1.5 when left out",
        "a number above 0, in scene units; 1 when left out", "a hole within a hole is an island",
        "\"opaque\" or \"filtered\"; \"opaque\" when left out", "[\"rotate\", x, y, z, degrees]\n"})
    CHECK_THAT(text, contains(part));
  const std::regex long_line("\n[^\n]{101,}");
  CHECK(!std::regex_search(text, long_line));
}

TEST_CASE("scenes/README.md holds the reference as the program prints it") {
  // scenes/pictures.sh keys writes it.
  const std::string readme = contents(RAYWALK_SOURCE_DIR "/scenes/README.md");
  CHECK_THAT(readme, contains("\n```text\n" + reference_text(key_tables()) + "```\n"));
}
