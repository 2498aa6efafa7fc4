#pragma once

#include <string>
#include <tl/expected.hpp>

namespace raywalk {

/// What is wrong with an input, or why an output could not be made, for users.
struct Error {
  std::string file;          ///< as the user named it; may be empty
  int line = 0, column = 0;  ///< from 1, column in characters; 0: unknown
  std::string message;       ///< one sentence without a full stop, with what was expected if applicable
  std::string hint;          ///< what to do about it; may be empty
  friend bool operator==(const Error&, const Error&) = default;

  /// "FILE:LINE:COL: MESSAGE\n  hint: HINT", without the parts that are empty; no newline at the end.
  [[nodiscard]] std::string text() const;
};

template <class T>
using Result = tl::expected<T, Error>;

/// "disk full"-style words for an errno value.
[[nodiscard]] std::string system_message(int error_number);

}  // namespace raywalk
