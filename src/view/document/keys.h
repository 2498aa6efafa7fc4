#pragma once
// The keys of a thing of the scene as texts, made from the schema: for who cannot use the fields of its form
// (gui/schema_form.h), and for demo files.

#include "text/error.h"
#include "view/document/room.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

/// A key whose value fits into a line.
struct KeyText {
  std::string key;    ///< its way from the thing's table: "radius", "material.diffuse", "corners.2"
  std::string label;  ///< in the language of the state
  std::string hint{};
  /// Numbers with spaces between them; a word of scene files; empty: there is none.
  std::string value{};
  std::vector<std::string_view> words{};  ///< what it may be, where these are a few words; "on", "off" of a flag
};
/// What has properties: a handle has those of its object.
enum class Owner { object, light, camera_and_scene };
[[nodiscard]] Owner owner_of(const Target& target);
[[nodiscard]] std::vector<KeyText> keys_of(const State& state, const Target& target);

/// Whether the window shows the properties of what is selected.
[[nodiscard]] bool shows_properties(const State& state);
/// What they are of, in the language of the state.
[[nodiscard]] std::string properties_title(const State& state);

using KeyEdit = std::variant<action::SetShape, action::SetMaterial, action::SetLight, action::SetCamera,
                             action::SetSurroundings, action::SetLimits>;
/// What gives a key that value. A number may have the language's decimal mark; one number is a grey.
[[nodiscard]] Result<KeyEdit> edit_of_key(const State& state, const Target& target, std::string_view key,
                                          std::string_view value);

}  // namespace raywalk
