#pragma once
// A presenter's script in its two parts.

#include <algorithm>
#include <string>

namespace raywalk {

struct ScriptParts {
  std::string before;  ///< what leads to the answer
  std::string after;   ///< behind the first empty line: what is said about it; may be empty
};

[[nodiscard]] inline ScriptParts parts_of_script(const std::string& script) {
  const std::size_t end = std::min(script.find("\n\n"), script.size());
  return {script.substr(0, end), script.substr(std::min(end + 2, script.size()))};
}

}  // namespace raywalk
