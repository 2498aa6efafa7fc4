#include "text/spelling.h"

#include "support/catch.h"

using namespace raywalk;

TEST_CASE("a misspelt word finds the word that was meant") {
  const std::vector<std::string_view> words{"eye", "look_at", "up", "fov", "fov_axis"};
  CHECK(nearest_word("eey", words) == "eye");
  CHECK(nearest_word("lookat", words) == "look_at");
  CHECK(nearest_word("LOOK_AT", words) == "look_at");
  CHECK(nearest_word("fovaxis", words) == "fov_axis");
  CHECK(nearest_word("fv", words) == "fov");
  CHECK(nearest_word("background", words) == "");
  CHECK(nearest_word("", words) == "");
  CHECK(nearest_word(std::string(100'000, 'e'), words) == "");
  CHECK(nearest_word("eye", {}) == "");
}

TEST_CASE("words are listed as a sentence has them") {
  CHECK(one_of({}) == "");
  CHECK(one_of({"a"}) == "a");
  CHECK(one_of({"a", "b"}) == "a or b");
  CHECK(one_of({"a", "b", "c"}) == "a, b or c");
}
