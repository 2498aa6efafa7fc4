#include "text/error.h"

#include <cerrno>

#include "support/catch.h"

using namespace raywalk;

TEST_CASE("an error's text has the parts that it has") {
  CHECK(Error{"a.toml", 3, 14, "wrong (expected right)", "do this"}.text() ==
        "a.toml:3:14: wrong (expected right)\n  hint: do this");
  CHECK(Error{"a.toml", 3, 0, "wrong", ""}.text() == "a.toml:3: wrong");
  CHECK(Error{"a.toml", 0, 0, "wrong", "h"}.text() == "a.toml: wrong\n  hint: h");
  CHECK(Error{"", 0, 0, "wrong", ""}.text() == "wrong");
}

TEST_CASE("an errno is told in words") { CHECK(system_message(ENOENT) == "No such file or directory"); }
