#pragma once
// The reference of the scene format, generated from its schema.

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The description of a key.
struct KeyEntry {
  std::string name;
  std::string expected;       ///< its values, with their unit
  std::string default_value;  ///< the default, as TOML; "none" for nothing, "" if required
  std::string sentence;
};

/// The keys of a table, or the additional ones of a type of light or object.
struct KeyTable {
  std::string name;     ///< its name on the command line: "camera", "sphere"
  std::string heading;  ///< as in a file: "[camera]", "[[light]] of type \"sphere\""
  std::string about;
  std::vector<KeyEntry> keys;
};

/// All tables, in the order of a file; a type's own keys follow the table that has the type.
[[nodiscard]] std::vector<KeyTable> key_tables();

/// Lines for a terminal and for scenes/README.md.
[[nodiscard]] std::string reference_text(const std::vector<KeyTable>& tables);

}  // namespace raywalk
