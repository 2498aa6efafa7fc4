#include "io/toml_table.h"

#include "support/catch.h"

using namespace raywalk;

namespace {

std::string rewritten(std::string_view text) {
  const toml::parse_result parsed = toml::parse(text);
  REQUIRE(parsed);
  return text_of(parsed.table());
}

}  // namespace

TEST_CASE("A table is written as a file that holds the same", "[io]") {
  constexpr std::string_view text = R"(
flag = true
height = 0.1
count = -12
name = 'a "quoted"	name'
corners = [[0, 0.08], [1e-300, -3.5], []]
mixed = [{ x = 1 }, 2]
day = 2026-11-21
moments = [07:32:00, 23:59:59.000000001, 1979-05-27T07:32:00, 1979-05-27T00:32:00.5-07:30, 0001-01-01T00:00:00Z]
limits.depth = 3
"a ball".radius = 0.30000000000000004
[[object]]
name = "first"
material = { diffuse = [0.1, 0.2, 0.3], deep = { er = [{ a = 1 }] } }
[[object]]
[object.transform]
"two words" = inf
)";
  const std::string once = rewritten(text);
  const toml::parse_result before = toml::parse(text), after = toml::parse(once);
  REQUIRE(after);
  INFO(once);
  CHECK((before.table() == after.table()));  // toml++ cannot print fractions safely
  CHECK(rewritten(once) == once);
}

TEST_CASE("An empty table is an empty file", "[io]") { CHECK(rewritten("") == ""); }
