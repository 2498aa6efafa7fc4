#pragma once

#include "gui/ui.h"
#include "view/text/key_label.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace raywalk {

/// What a form remembers between frames.
struct FormMemory {
  // Fields by their names; empty: none. (Not by ImGui's ids: to ask for one keeps it alive, and then a group, which a
  // number with buttons is, does not find its own.)
  std::string edited;   ///< the field whose edits continue each other
  std::string naming;   ///< the text field being typed in
  std::string typed;    ///< its contents
  std::string number;   ///< the field of a number being typed in
  std::string refused;  ///< the field whose last input was refused
  std::string why;      ///< the message below it
  double before = 0;    ///< the number when the field was entered
};

/// Rows of a label and fields. Each field changes its value in place and returns whether it did; numbers are read as
/// people type them (view/lesson/typed_number.h), in every language alike, and kept within the limits of the scene
/// format: other input is refused with a message below the field, and discarded when the field is left.
class Form {
 public:
  Form(const Ui& ui, FormMemory& memory, float width);

  /// Focuses the next field drawn.
  void focus_next() { focus_ = true; }

  void heading(const KeyLabel& label);
  /// `step`: change for each unit of dragging.
  bool number(const KeyLabel& label, double& value, double step, double least, double most);
  /// `at_enter`: input takes effect when it is finished, not digit by digit.
  bool whole(const KeyLabel& label, int& value, int least, int most, bool at_enter = false);
  /// x, y and z, or the first `count` of them.
  bool vector(const KeyLabel& label, double* values, int count, double step, double least, double most);
  /// Linear RGB as three numbers, and a field of its colour that opens a palette.
  bool colour(const KeyLabel& label, Rgbd& value, double most);
  bool flag(const KeyLabel& label, bool& value);
  /// One of a few words; `chosen` is its index.
  bool pick(const KeyLabel& label, const std::vector<std::string>& words, int& chosen);
  /// The same of words that scene files use, shown in the language of the window.
  bool pick(const KeyLabel& label, const std::vector<std::string_view>& names, int& chosen);
  /// True once, when the typing has ended; `value` is then the new text.
  bool text(const KeyLabel& label, std::string& value);

  /// Whether the last change joins the previous one into one undo entry.
  [[nodiscard]] bool continues() const { return continues_; }

 private:
  void row(const KeyLabel& label);
  /// A field from here to `after_field`.
  void before_field(const std::string& field, float width);
  /// After what draws a field of a number: whether it is typed into now.
  void after_number(const std::string& field, bool is_typed, double value);
  /// `needs`: the text that says what is expected of a number that was refused; empty: none was.
  void after_field(const std::string& field, std::string_view needs, double least, double most);
  /// Shows below the row why input was refused, if it was.
  void end_row();
  bool drag(const std::string& id, double& value, double step, double least, double most, float width);
  bool changed(bool now, const std::string& field);

  const Ui& ui_;
  FormMemory& memory_;
  float width_, label_width_;
  std::string name_;  ///< of the row, for tests
  bool refused_in_row_ = false, reddened_ = false;
  bool focus_ = false, continues_ = false;
  FingerFields fields_;
};

}  // namespace raywalk
