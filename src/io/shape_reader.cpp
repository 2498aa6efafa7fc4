// What the shapes of the whole renderer and their transforms add to reading.

#include "io/scene_reader.h"
#include "io/transform_words.h"

#include <fmt/format.h>

#include <cmath>

namespace raywalk::detail {

namespace {

constexpr std::size_t most_polygon_corners = 10000, most_steps = 1000;

}  // namespace

void SceneReader::check(bool holds, std::string_view key, std::string_view message, std::string_view hint) {
  if (holds || log_.error()) return;
  const toml::node* node = table_.get(key);
  fail(node == nullptr ? static_cast<const toml::node&>(table_) : *node, key, std::string(message), std::string(hint));
}

void SceneReader::lengths(std::string_view key, Vec3d& value) {
  const toml::node* node = take(key, scene_keys::required);
  if (node == nullptr) return;
  const scene_keys::NumberRule& rule = scene_keys::lengths_above_zero;
  if (node->is_number()) {
    if (const auto length = number_of(*node, key, rule)) value = Vec3d(*length);
    return;
  }
  const auto xyz = numbers_of(*node, key, rule, 3, 3, std::string(rule.expected));
  if (!xyz.empty()) value = {xyz[0], xyz[1], xyz[2]};
}

void SceneReader::limit(std::string_view key, double& value) {
  if (const toml::node* node = take(key, scene_keys::optional))
    value = number_of(*node, key, scene_keys::coordinate).value_or(value);
}

std::vector<Vec3d> SceneReader::points_of(const toml::node& node, std::string_view key) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() < 3 || array->size() > most_polygon_corners) {
    fail_type(node, key, fmt::format("a list of 3 to {} corners [x, y, z]", most_polygon_corners),
              "such as [[0, 0, 1], [2, 0, 1], [1, 2, 1]]");
    return {};
  }
  std::vector<Vec3d> points;
  for (const toml::node& element : *array) {
    const auto xyz = numbers_of(element, key, scene_keys::coordinate, 3, 3, "a corner [x, y, z]");
    if (xyz.empty()) return {};
    points.emplace_back(xyz[0], xyz[1], xyz[2]);
  }
  return points;
}

void SceneReader::points(std::string_view key, std::vector<Vec3d>& value) {
  if (const toml::node* node = take(key, scene_keys::required)) value = points_of(*node, key);
}

void SceneReader::holes(std::string_view key, std::vector<std::vector<Vec3d>>& value) {
  value.clear();
  const toml::node* node = take(key, scene_keys::optional);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  if (array == nullptr)
    return fail_type(*node, key, "a list of holes, each a list of corners", "such as [[[0, 0, 1], ...]]");
  for (const toml::node& hole : *array) value.push_back(points_of(hole, key));
}

std::optional<TransformStep> SceneReader::step_of(const toml::node& node, std::string_view key) {
  const toml::array* array = node.as_array();
  const auto* word = array == nullptr || array->empty() ? nullptr : array->get(0)->as_string();
  std::vector<std::string_view> words;
  for (const TransformWord& each : transform_words) words.push_back(each.word);
  if (word == nullptr) {
    fail_type(node, key, "steps such as [\"translate\", 1, 0, 0]", "each step is a list of its name and its numbers");
    return std::nullopt;
  }
  const auto index = word_of(*array->get(0), key, words);
  if (!index) return std::nullopt;
  const TransformWord& known = transform_words[*index];
  std::vector<double> numbers;
  for (std::size_t i = 1; i < array->size(); ++i) {
    const auto number = number_of(*array->get(i), key, scene_keys::coordinate);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() != known.numbers) {
    fail_type(node, key, fmt::format("[\"{}\", {}]", known.word, known.arguments), std::string(known.meaning));
    return std::nullopt;
  }
  return step_from(*index, numbers);
}

void SceneReader::steps(std::string_view key, std::vector<TransformStep>& value) {
  value.clear();
  const toml::node* node = take(key, scene_keys::optional);
  if (node == nullptr) return;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->size() > most_steps)
    return fail_type(*node, key, fmt::format("a list of at most {} steps", most_steps),
                     "such as transform = [[\"scale\", 2, 1, 1], [\"translate\", 0, 3, 0]]; the first is done first");
  for (const toml::node& element : *array) {
    const auto step = step_of(element, key);
    if (!step) return;
    value.push_back(*step);
    const Affine<double> map = affine_of({*step});
    if (!inverse(map) || !is_finite(map.x) || !is_finite(map.y) || !is_finite(map.z))
      return fail(element, key, "this step flattens the object to nothing (expected one that can be undone)",
                  "no scale may be 0, no axis and no mirror's normal [0, 0, 0]");
  }
  if (!inverse(affine_of(value)))
    fail(*node, key, "the steps together flatten the object to nothing (expected ones that can be undone)",
         "use less extreme scales");
}

}  // namespace raywalk::detail
