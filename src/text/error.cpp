#include "text/error.h"

#include <fmt/format.h>

#include <system_error>

namespace raywalk {

std::string Error::text() const {
  std::string text = file;
  if (line > 0) text += fmt::format(":{}", line);
  if (line > 0 && column > 0) text += fmt::format(":{}", column);
  if (!text.empty()) text += ": ";
  text += message;
  if (!hint.empty()) text.append("\n  hint: ").append(hint);
  return text;
}

std::string system_message(int error_number) { return std::generic_category().message(error_number); }

}  // namespace raywalk
