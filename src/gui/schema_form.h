#pragma once
// The fields of a form for the keys of a scene, made from the schema: a new key of a number, a colour, a flag or a
// choice gets its row without a line here.

#include "gui/form.h"
#include "scene/schema.h"
#include "scene/schema_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace raywalk {

/// The `Fields` of the schema that draws a row for each key whose value a form can change.
class SchemaForm : public schema::RowFields<SchemaForm> {
 public:
  using schema::RowFields<SchemaForm>::key;

  /// `table` names what is shown, for labels that differ from those of the same key elsewhere.
  SchemaForm(Form& form, std::string_view table) : form_(form), table_(table) {}

  /// Draws the rows of `value`. Whether it was changed to something that breaks no rule of the schema.
  template <class T>
  static bool draw(Form& form, std::string_view table, T& value) {
    SchemaForm rows(form, table);
    schema::describe(rows, value);
    return rows.is_changed_ && rows.holds_;
  }

  template <class T, class Kind>
  void key(std::string_view name, T& value, const Kind& kind, std::string_view sentence) {
    is_changed_ |= row({table_, name, sentence}, kind, value);
  }
  template <class T, class Kind>
  void key(std::string_view name, std::optional<T>& value, const Kind& kind, std::string_view sentence) {
    const std::string set = std::string(name) + "_set";
    switch_on({table_, set, sentence}, value);
    if (value) key(name, *value, kind, sentence);
  }
  template <class T>
  void key(std::string_view name, std::optional<T>& value, const schema::Table& /*kind*/);
  template <class... Kinds>
  void type(std::variant<Kinds...>& value, std::string_view sentence) {
    if constexpr (std::is_same_v<std::variant<Kinds...>, AnySky>) pick_kind(value, sentence);
    std::visit([&](auto& kind) { schema::describe(*this, kind); }, value);
  }
  void check(std::string_view /*key*/, bool holds, std::string_view /*message*/, std::string_view /*hint*/) {
    holds_ &= holds;
  }
  template <class Why>
  void check(std::string_view /*key*/, const Why& why, std::string_view /*hint*/) {
    if (is_changed_) holds_ &= std::string_view(why()).empty();
  }

 private:
  bool row(const KeyLabel& label, const schema::Number& kind, double& value) {
    return std::isfinite(value) && form_.number(label, value, step_of(kind, value), least(kind), most(kind));
  }
  bool row(const KeyLabel& label, const schema::Whole& kind, int& value) {
    return form_.whole(label, value, kind.low, kind.high);
  }
  bool row(const KeyLabel& label, const schema::Flag& /*kind*/, bool& value) { return form_.flag(label, value); }
  template <class T>
  bool row(const KeyLabel& label, const schema::Choice<T>& /*kind*/, T& value) {
    int chosen = static_cast<int>(value);
    if (!form_.pick(label, all_words<T>(), chosen)) return false;
    value = static_cast<T>(chosen);
    return true;
  }
  bool row(const KeyLabel& label, const schema::Colour& kind, Rgbd& value) {
    return form_.colour(label, value, kind.number.high);
  }
  template <class T>
  bool row(const KeyLabel& label, const schema::Tuple& kind, T& value) {
    std::vector<double> numbers;
    double largest = 0;
    schema::each_number(value, [&](double& number) {
      numbers.push_back(number);
      largest = std::max(largest, std::abs(number));
    });
    if (!form_.vector(label, numbers.data(), static_cast<int>(numbers.size()), step_of(kind.number, largest),
                      least(kind.number), most(kind.number)))
      return false;
    std::size_t next = 0;
    schema::each_number(value, [&](double& number) { number = numbers[next++]; });
    if constexpr (std::is_same_v<T, Vec3d>) holds_ &= !kind.is_direction || length(value) >= 1 / schema::max_magnitude;
    return true;
  }
  template <class T>
  bool row(const KeyLabel& label, const schema::Rows& kind, std::vector<T>& value) {
    bool is_changed = false;
    int number = 0;
    for (T& each : value) is_changed |= row({label, ++number}, kind.row, each);
    return is_changed;
  }
  // What a form has no field for: names, files, transforms, and the lists of a mesh.
  template <class Kind, class T>
  bool row(const KeyLabel& /*label*/, const Kind& /*kind*/, T& /*value*/) {
    return false;
  }

  /// One of the kinds that need no file, or the one that it is.
  void pick_kind(AnySky& value, std::string_view sentence) {
    std::vector<std::string_view> words;
    const std::vector<AnySky> kinds = schema::kinds_beside(value, words);
    const auto own =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.index() == value.index(); });
    int chosen = static_cast<int>(own - kinds.begin());
    if (!form_.pick({table_, "type", sentence}, words, chosen)) return;
    is_changed_ = true;
    value = kinds[static_cast<std::size_t>(chosen)];
  }

  /// A flag: whether there is a value.
  template <class T>
  void switch_on(const KeyLabel& label, std::optional<T>& value) {
    bool is_there = value.has_value();
    if (!form_.flag(label, is_there)) return;
    is_changed_ = true;
    value.reset();
    if (is_there) value.emplace();
  }

  /// Of dragging by a pixel.
  static double step_of(const schema::Number& kind, double value) {
    return kind.unit == schema::degrees ? 0.2 : std::max(0.005, std::abs(value) / 200);
  }
  static double least(const schema::Number& kind) {
    return kind.above_low ? kind.low + 1 / schema::max_magnitude : kind.low;
  }
  static double most(const schema::Number& kind) {
    return kind.below_high ? std::nextafter(kind.high, kind.low) : kind.high;
  }

  Form& form_;
  std::string_view table_;
  bool is_changed_ = false, holds_ = true;
};

template <class T>
void SchemaForm::key(std::string_view name, std::optional<T>& value, const schema::Table& /*kind*/) {
  if constexpr (requires { value->file; }) {
    // It is there with its file.
    std::string file = value ? value->file : std::string();
    if (form_.text({table_, name, {}}, file)) {
      is_changed_ = true;
      if (!value) value.emplace();
      value->file = file;
      value->pixels = nullptr;  // loaded with the change
      if (file.empty()) value.reset();
    }
  } else {
    switch_on({table_, name, {}}, value);
  }
  if (!value) return;
  const std::string_view outer = std::exchange(table_, name);
  schema::describe(*this, *value);
  table_ = outer;
}

}  // namespace raywalk
