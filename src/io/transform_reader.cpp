// Reads the scene keys of transforms.

#include "io/scene_reader.h"

#include <fmt/format.h>

#include <variant>

namespace raywalk::detail {

namespace {

/// One default step of each kind.
template <class... Kinds>
std::vector<TransformStep> all_steps(const std::variant<Kinds...>& /*kinds*/) {
  return {TransformStep{Kinds{}}...};
}

}  // namespace

bool SceneReader::step_of(const toml::node& node, std::string_view key, TransformStep& value) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->empty() || !array->get(0)->is_string()) {
    fail_type(node, key, "steps such as [\"translate\", 1, 0, 0]", "each step is a list of its name and its numbers");
    return false;
  }
  const std::vector<TransformStep> steps = all_steps(value.kind);
  std::vector<std::string_view> words;
  for (const TransformStep& step : steps) words.push_back(schema::words_of(step).word);
  const auto index = word_of(*array->get(0), key, words);
  if (!index) return false;
  value = steps[*index];
  std::vector<double> numbers;
  for (std::size_t i = 1; i < array->size(); ++i)
    if (!read(*array->get(i), key, schema::any_number, numbers.emplace_back())) return false;
  std::size_t count = 0;
  schema::each_number(value, [&](double& number) {
    if (count < numbers.size()) number = numbers[count];
    ++count;
  });
  if (count == numbers.size()) return true;
  const schema::StepWords known = schema::words_of(value);
  fail_type(node, key, fmt::format("[\"{}\", {}]", known.word, known.arguments), known.meaning);
  return false;
}

bool SceneReader::read(const toml::node& node, std::string_view key, const schema::Steps& kind,
                       std::vector<TransformStep>& value) {
  value.clear();
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() > kind.most) {
    fail_type(node, key, kind.expected(),
              "such as transform = [[\"scale\", 2, 1, 1], [\"translate\", 0, 3, 0]]; the first is done first");
    return false;
  }
  for (const toml::node& element : *array) {
    if (!step_of(element, key, value.emplace_back())) return false;
    const Affine<double> map = affine_of({value.back()});
    if (!inverse(map) || !is_finite(map.x) || !is_finite(map.y) || !is_finite(map.z)) {
      fail(element, key, "this step flattens the object to nothing (expected one that can be undone)",
           "no scale may be 0, no axis and no mirror's normal [0, 0, 0]");
      return false;
    }
  }
  if (inverse(affine_of(value))) return true;
  fail(node, key, "the steps together flatten the object to nothing (expected ones that can be undone)",
       "use less extreme scales");
  return false;
}

}  // namespace raywalk::detail
