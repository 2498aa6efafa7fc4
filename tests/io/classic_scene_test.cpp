// scenes/classic.toml is the example of the format.

#include <string>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("the classic scene explains each of its keys") {
  const std::string classic = contents(RAYWALK_SOURCE_DIR "/scenes/classic.toml");
  // A reader sees what each line means: none without a comment, but for those that repeat an earlier one.
  const std::size_t transparent = classic.find("\"Transparent Sphere\"");
  REQUIRE(transparent != std::string::npos);
  for (std::size_t at = 0; at < transparent;) {
    const std::size_t end = classic.find('\n', at);
    const std::string line = classic.substr(at, end - at);
    at = end + 1;
    INFO(line);
    const bool is_obvious = line.find("name = ") == 0 || line.find("description = ") == 0 || line.find("[") == 0;
    if (line.find(" = ") != std::string::npos && !is_obvious) CHECK(line.find('#') != std::string::npos);
  }
}
