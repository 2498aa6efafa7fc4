#pragma once
// The properties of what is selected, made from the schema: a new key of a number, a colour, a flag or a choice gets
// its row without a line here, in the form of the window (gui/properties.cpp), and as a text, for who cannot use its
// fields and for demo files.

#include "scene/schema_kinds.h"
#include "text/error.h"
#include "view/document/room.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

/// Whether the window shows the properties of what is selected.
[[nodiscard]] bool shows_properties(const State& state);
/// What they are of, in the language of the state.
[[nodiscard]] std::string properties_title(const State& state);

/// What makes rows of properties: fields, or texts. Each row changes its value in place, to what its kind accepts, and
/// returns whether it did.
class PropertyRows {
 public:
  /// A key of the schema; of a list, a row of this number from 1.
  struct Key {
    std::string_view table, name, sentence{};
    int row = 0;
  };

  virtual ~PropertyRows() = default;
  virtual bool number(const Key& key, double& value, const schema::Number& kind) = 0;
  virtual bool whole(const Key& key, int& value, const schema::Whole& kind) = 0;
  virtual bool flag(const Key& key, bool& value) = 0;
  /// One of these words of scene files, by its index.
  virtual bool choice(const Key& key, std::size_t& chosen, const std::vector<std::string_view>& words) = 0;
  virtual bool numbers(const Key& key, std::span<double> values, const schema::Tuple& kind) = 0;
  virtual bool colour(const Key& key, Rgbd& value, const schema::Colour& kind) = 0;
  virtual bool file(const Key& key, std::string& value) = 0;
  virtual bool name(std::string& value) = 0;
  virtual void heading(std::string_view id) = 0;
  /// What follows stands in a table of this name, until `leave`.
  virtual void enter(std::string_view /*table*/) {}
  virtual void leave() {}
  /// A rule of the schema that the changed value breaks.
  virtual void broken(std::string_view message, std::string_view hint) = 0;
};

using PropertyEdit = std::variant<action::Rename, action::SetShape, action::SetMaterial, action::SetLight,
                                  action::SetCamera, action::SetSurroundings, action::SetLimits>;
/// Makes the rows of an object, a light, or of camera and scene: of what a target belongs to, which exists. What was
/// changed, unless that breaks a rule of the schema.
[[nodiscard]] std::optional<PropertyEdit> property_rows(const State& state, const Target& target, PropertyRows& rows);

/// A property whose value fits into a line.
struct PropertyText {
  std::string key;  ///< its name after those of the tables that it stands in: "radius", "material.diffuse", "corners.2"
  std::string label;  ///< in the language of the state
  /// Numbers with spaces between them, none for what has no limit; a word of scene files; a name.
  std::string value{};
  std::vector<std::string_view> words{};  ///< what it may be, where these are a few words; "on", "off" of a flag
};
[[nodiscard]] std::vector<PropertyText> property_texts(const State& state, const Target& target);
/// What gives a property that value. A number may have the language's decimal mark; one number is a grey.
/// Nothing where it has it already.
[[nodiscard]] Result<std::optional<PropertyEdit>> edit_of_property(const State& state, const Target& target,
                                                                   std::string_view key, std::string_view value);

}  // namespace raywalk
