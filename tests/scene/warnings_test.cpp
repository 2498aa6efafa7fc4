#include "scene/warnings.h"

#include "support/catch.h"

using raywalk::collected;
using Lines = std::vector<std::string>;

TEST_CASE("warnings that differ in place, name and numbers only become one line") {
  const Lines warnings{
      "a1.toml:5:1: warning: \"Ball\" sends out more light than it receives: 1.605 (expected at most 1)",
      "a1.toml:15:12: warning: \"Ball 2\" sends out more light than it receives: 1e+15 (expected at most 1)",
      "a1.toml:16:1: warning: a polygon is not flat",
      "a1.toml:25:1: warning: \"The \\\"other\\\" one\\\\\" sends out more light than it receives: 2 (expected at most "
      "1)",
      "a1.toml:99:1: warning: a polygon is not flat",
      "a1.toml:7:1: warning: something else"};
  const Lines lines = collected(warnings);
  CHECK(lines == Lines{warnings[0] + "; and 2 more like it", warnings[2] + "; and 1 more like it", warnings[5]});
  CHECK(collected(lines) == lines);
}

TEST_CASE("warnings of different kinds, and none, stay as they are") {
  CHECK(collected({}).empty());
  const Lines different{"a:1:1: warning: \"A\" is large", "a:1:1: warning: \"A\" is small", "\"", "1", ""};
  CHECK(collected(different) == different);
}
