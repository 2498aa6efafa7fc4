#pragma once
// The reference of the scene format, made from its schema.

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A key as people read it.
struct KeyEntry {
  std::string name;
  std::string expected;  ///< what it takes, with its unit
  std::string usual;     ///< what it is when left out, as TOML; "none" for nothing, "" where it must be given
  std::string sentence;
};

/// The keys of a table, or those that one type of light or object has besides.
struct KeyTable {
  std::string name;     ///< what people ask for it by: "camera", "sphere"
  std::string heading;  ///< as it stands in a file: "[camera]", "[[light]] of type \"sphere\""
  std::string about;
  std::vector<KeyEntry> keys;
};

/// All tables, in the order of a file; a type's own keys follow the table that has the type.
[[nodiscard]] std::vector<KeyTable> key_tables();

/// Lines for a terminal and for scenes/README.md.
[[nodiscard]] std::string reference_text(const std::vector<KeyTable>& tables);

}  // namespace raywalk
