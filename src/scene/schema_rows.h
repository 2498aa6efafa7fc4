#pragma once
// What those `Fields` of the schema (scene/schema.h) have in common that make a row of each key of a thing.

#include "scene/schema.h"

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk::schema {

/// `Own` has `key` for the kinds that it makes rows of, and takes in the others by `using RowFields<Own>::key`.
template <class Own>
class RowFields {
 public:
  void about(std::string_view /*sentence*/) {}
  // The tables of a scene and of an object have rows of their own.
  template <class T>
  void key(std::string_view /*name*/, T& /*value*/, const Table& /*kind*/) {}
  template <class T>
  void key(std::string_view /*name*/, T& /*value*/, const Tables& /*kind*/) {}
  template <class T, class Kind, class... Sentence>
  void required(std::string_view name, T& value, const Kind& kind, const Sentence&... sentence) {
    own().key(name, value, kind, sentence...);
  }
  template <class T>
  void together(std::optional<T>& value) {
    if (value) describe(own(), *value);
  }
  template <class T>
  void complete(const T& /*value*/) {}

 private:
  Own& own() { return static_cast<Own&>(*this); }
};

/// The kinds of sky that need no file, and the one that it is; `words`: what they are called.
[[nodiscard]] inline std::vector<AnySky> kinds_beside(const AnySky& value, std::vector<std::string_view>& words) {
  std::vector<AnySky> kinds;
  const auto offer = [&]<class Kind>(const Kind& kind) {
    if constexpr (requires { kind.file; })
      if (!std::holds_alternative<Kind>(value)) return;
    words.emplace_back(type_name(kind));
    kinds.emplace_back(kind);
  };
  [&]<class... Kinds>(const std::variant<Kinds...>* /*all*/) { (offer(Kinds{}), ...); }(&value);
  return kinds;
}

}  // namespace raywalk::schema
