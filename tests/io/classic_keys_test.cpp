// scenes/classic.toml is the reference of the format: every key that can be read stands in it.

#include <regex>
#include <set>
#include <string>

#include "io/scene_keys.h"
#include "io/transform_words.h"
#include "support/catch.h"
#include "temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// The `Fields` of scene_keys that only notes the keys, those of every type of light and shape.
class KeyLister {
 public:
  void text(std::string_view key, std::string& /*value*/) { add(key); }
  void name(std::string_view key, std::string& /*value*/) { add(key); }
  void number(std::string_view key, double& /*value*/, const scene_keys::NumberRule& /*rule*/,
              scene_keys::Presence /*presence*/) {
    add(key);
  }
  void number_or_nothing(std::string_view key, std::optional<double>& /*value*/,
                         const scene_keys::NumberRule& /*rule*/) {
    add(key);
  }
  void whole(std::string_view key, int& /*value*/, scene_keys::WholeRule /*rule*/) { add(key); }
  void whole_or_nothing(std::string_view key, std::optional<int>& /*value*/, scene_keys::WholeRule /*rule*/) {
    add(key);
  }
  void pair(std::string_view key, double& /*first*/, double& /*second*/, const scene_keys::NumberRule& /*rule*/,
            std::string_view /*expected*/) {
    add(key);
  }
  void file(std::string_view key, std::string& /*value*/) { add(key); }
  void yes_or_no(std::string_view key, bool& /*value*/) { add(key); }
  void colour(std::string_view key, Rgbd& /*value*/) { add(key); }
  void point(std::string_view key, Vec3d& /*value*/, scene_keys::Presence /*presence*/) { add(key); }
  void direction(std::string_view key, Vec3d& /*value*/, scene_keys::Presence /*presence*/) { add(key); }
  void attenuation(std::string_view key, Attenuation& /*value*/) { add(key); }
  void corners(std::string_view key, std::vector<Vec2d>& /*value*/) { add(key); }
  void lengths(std::string_view key, Vec3d& /*value*/) { add(key); }
  void limit(std::string_view key, double& /*value*/) { add(key); }
  void points(std::string_view key, std::vector<Vec3d>& /*value*/) { add(key); }
  void holes(std::string_view key, std::vector<std::vector<Vec3d>>& /*value*/) { add(key); }
  void steps(std::string_view key, std::vector<TransformStep>& /*value*/) {
    add(key);
    for (const auto& step : detail::transform_words) words.insert(std::string(step.word));
  }
  void motion(std::string_view key, Motion& /*value*/) { add(key); }
  void mesh_file(std::string_view key, MeshShape& /*value*/) { add(key); }
  void vertices(std::string_view positions, std::string_view triangles, std::string_view normals, std::string_view uv,
                MeshShape& /*value*/) {
    for (const std::string_view key : {positions, triangles, normals, uv}) add(key);
  }
  void group_name(std::string_view key, Instance& /*value*/) { add(key); }
  void define(const Group& /*group*/) {}
  void check(bool /*holds*/, std::string_view /*key*/, std::string_view /*message*/, std::string_view /*hint*/) {}
  template <class Value>
  void choice(std::string_view key, Value& /*value*/) {
    add(key);
    for (const auto& [value, word] : scene_keys::Names<Value>::all) words.insert(std::string(word));
  }
  template <class... Kinds>
  void type(std::string_view key, std::variant<Kinds...>& /*value*/) {
    add(key);
    (visit<Kinds>(), ...);
    (words.insert(std::string(scene_keys::type_name(Kinds{}))), ...);
  }
  template <class T>
  void table(std::string_view key, T& /*value*/, scene_keys::Presence /*presence*/) {
    tables_.insert(std::string(key));
    visit<T>();
  }
  template <class T>
  void table_or_nothing(std::string_view key, std::optional<T>& /*value*/) {
    tables_.insert(std::string(key));
    visit<T>();
  }
  template <class T>
  void tables(std::string_view key, std::vector<T>& /*value*/) {
    tables_.insert(std::string(key));
    visit<T>();
  }
  template <class T>
  void together(std::optional<T>& /*value*/) {
    visit<T>();
  }

  [[nodiscard]] const std::set<std::string>& table_keys() const { return tables_; }
  std::set<std::string> keys, words;

 private:
  void add(std::string_view key) { keys.insert(std::string(key)); }
  template <class T>
  void visit() {
    T value{};
    scene_keys::describe(*this, value);
  }
  std::set<std::string> tables_;
};

}  // namespace

TEST_CASE("every key, table and word of the format is explained in the classic scene") {
  const std::string classic = contents(RAYWALK_SOURCE_DIR "/scenes/classic.toml");
  KeyLister lister;
  Scene scene;
  scene_keys::describe(lister, scene);
  CHECK(lister.keys.size() > 30);
  CHECK(lister.table_keys() == std::set<std::string>{"camera", "checker", "group", "image", "light", "limits",
                                                     "material", "object", "render", "screen", "texture"});
  for (const std::string& key : lister.keys) {
    INFO(key);
    CHECK(std::regex_search(classic, std::regex("\\b" + key + " = ")));
  }
  for (const std::string& table : lister.table_keys()) CHECK_THAT(classic, contains(table + "]"));
  for (const std::string& word : lister.words) CHECK_THAT(classic, contains("\"" + word + "\""));
  // Whoever reads it sees what each line means: none without a comment, but for those that repeat an earlier one.
  const std::size_t transparent = classic.find("\"Transparent Sphere\"");
  REQUIRE(transparent != std::string::npos);
  for (std::size_t at = 0; at < transparent;) {
    const std::size_t end = classic.find('\n', at);
    const std::string line = classic.substr(at, end - at);
    at = end + 1;
    INFO(line);
    const bool is_obvious = line.find("name = ") == 0 || line.find("description = ") == 0 || line.find("[") == 0;
    if (line.find(" = ") != std::string::npos && !is_obvious) CHECK(line.find('#') != std::string::npos);
  }
}
