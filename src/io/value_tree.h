#pragma once
// Converts a value of each kind of the schema to its form in a scene's file. Internal to `io`.

#include "io/scene_values.h"
#include "scene/schema.h"
#include "text/toml_text.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace raywalk::detail {

/// Whether there is nothing to write: a scalar without text.
inline bool is_absent(const Value& value) { return value.kind == Value::Kind::scalar && value.text.empty(); }

inline Value scalar(std::string text) { return {.text = std::move(text)}; }

inline Value tree(const schema::Number& /*kind*/, double value) {
  return scalar(std::isfinite(value) ? toml_text::number(value) : "");
}
inline Value tree(const schema::Whole& /*kind*/, int value) { return scalar(std::to_string(value)); }
inline Value tree(const schema::Flag& /*kind*/, bool value) { return scalar(value ? "true" : "false"); }
inline Value tree(const schema::Text& /*kind*/, const std::string& value) { return scalar(toml_text::quoted(value)); }
inline Value tree(const schema::OneLine& /*kind*/, const std::string& value) {
  return scalar(toml_text::quoted(value));
}
inline Value tree(const schema::Name& /*kind*/, const std::string& value) { return scalar(toml_text::quoted(value)); }
inline Value tree(const schema::Names& /*kind*/, const std::vector<std::string>& value) {
  Value names{.kind = Value::Kind::list};
  for (const std::string& name : value) names.children.push_back(scalar(toml_text::quoted(name)));
  return names;
}
inline Value tree(const schema::GroupName& /*kind*/, const Instance& value) {
  return scalar(toml_text::quoted(value.group));
}
inline Value tree(const schema::FileName& /*kind*/, const std::string& value) {
  return scalar(value.empty() ? "" : toml_text::quoted(value));
}
template <class T>
Value tree(const schema::Choice<T>& /*kind*/, T value) {
  return scalar(toml_text::quoted(name_of(value)));
}
template <class T>
Value tree(const schema::Tuple& kind, T value) {
  Value list{.kind = Value::Kind::list, .shorthand = kind.shorthand};
  schema::each_number(value, [&](double number) { list.children.push_back(scalar(toml_text::number(number))); });
  return list;
}
template <class T>
Value tree(const schema::Rows& kind, const std::vector<T>& value) {
  Value rows{.kind = Value::Kind::list};
  for (const T& row : value) rows.children.push_back(tree(kind.row, row));
  return rows;
}
template <class T>
Value tree(const schema::Lists& kind, const std::vector<T>& value) {
  Value lists{.kind = Value::Kind::list};
  for (const T& list : value) lists.children.push_back(tree(kind.rows, list));
  return lists;
}
inline Value tree(const schema::MeshRows& kind, const MeshShape& value) {
  if (!value.file.empty() || !value.mesh) return {};
  const Mesh& mesh = *value.mesh;
  switch (kind.part) {
    case schema::MeshRows::Part::positions:
      return tree(kind.rows, mesh.positions);
    case schema::MeshRows::Part::normals:
      return tree(kind.rows, mesh.normals);
    case schema::MeshRows::Part::uv:
      return tree(kind.rows, mesh.uv);
    case schema::MeshRows::Part::triangles:
      break;
  }
  Value rows{.kind = Value::Kind::list};
  for (const Mesh::Corners& corners : mesh.triangles) {
    Value& row = rows.children.emplace_back(Value{.kind = Value::Kind::list});
    for (const std::int32_t corner : corners) row.children.push_back(scalar(std::to_string(corner)));
  }
  return rows;
}
inline Value tree(const schema::Steps& /*kind*/, const std::vector<TransformStep>& value) {
  Value steps{.kind = Value::Kind::list};
  for (TransformStep step : value) {
    Value& words = steps.children.emplace_back(Value{.kind = Value::Kind::list});
    words.children.push_back(scalar(toml_text::quoted(schema::words_of(step).word)));
    schema::each_number(step, [&](double number) { words.children.push_back(scalar(toml_text::number(number))); });
  }
  return steps;
}
}  // namespace raywalk::detail
