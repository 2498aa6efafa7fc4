// Files of the folder that stands beside the project; a test that needs one and does not find it is skipped.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace raywalk::test {

/// The environment variable wins over what the build was configured with.
inline std::filesystem::path shared_file(const std::string& name) {
  const char* shared = std::getenv("RAYWALK_SHARED_DIR");
  return std::filesystem::path(shared != nullptr && *shared != '\0' ? shared : RAYWALK_SHARED_DIR) / name;
}

}  // namespace raywalk::test
