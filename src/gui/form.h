#pragma once

#include "gui/ui.h"

#include <string>
#include <vector>

namespace raywalk {

/// What a form remembers between frames.
struct FormMemory {
  unsigned edited = 0;  ///< ImGui's id of the field whose edits continue each other; 0: none
  unsigned naming = 0;  ///< the text field being typed in
  std::string typed;    ///< what stands in it
};

/// Rows of a label and fields. Each field changes its value in place and tells whether it did; all numbers are kept
/// within their limits, which are those of the scene's format.
class Form {
 public:
  Form(const Ui& ui, FormMemory& memory, float width);

  /// Puts the keyboard into the first field drawn from now on.
  void focus_next() { focus_ = true; }

  void heading(std::string_view text);
  /// `step`: change for each unit of dragging.
  bool number(std::string_view label, double& value, double step, double least, double most);
  bool whole(std::string_view label, int& value, int least, int most);
  /// x, y and z, or the first `count` of them.
  bool vector(std::string_view label, double* values, int count, double step);
  /// Linear RGB as three numbers, and a field of its colour that opens a palette.
  bool colour(std::string_view label, Rgbd& value, double most);
  bool flag(std::string_view label, bool& value);
  /// True once, when the typing has ended; `value` is then the new text.
  bool text(std::string_view label, std::string& value);

  /// Whether the last change joins the one before it into one entry of undo.
  [[nodiscard]] bool continues() const { return continues_; }

 private:
  void row(std::string_view label);
  bool drag(const std::string& id, double& value, double step, double least, double most);
  bool changed(bool now, const std::string& field);
  void before_field(float width);

  const Ui& ui_;
  FormMemory& memory_;
  float width_, label_width_;
  std::string name_;  ///< of the row, for tests
  bool focus_ = false, continues_ = false;
};

}  // namespace raywalk
