#include "text/file_ledger.h"

#include "text/file.h"

#include <filesystem>
#include <string>
#include <vector>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace raywalk;
using namespace raywalk::test;
namespace fs = std::filesystem;

TEST_CASE("files are the same by what they are, and not by name") {
  const TemporaryFolder folder;
  REQUIRE(write_file_atomically(folder.file("a"), "x"));
  REQUIRE(write_file_atomically(folder.file("other"), "x"));
  fs::create_hard_link(folder.file("a"), folder.file("hard"));
  fs::create_symlink("a", folder.file("soft"));
  fs::create_symlink("nothing", folder.file("leads-nowhere"));
  fs::create_directory_symlink(".", folder.file("here"));
  for (const char* name : {"a", "./a", "hard", "soft", "here/soft", "here/here/hard"}) {
    CAPTURE(name);
    CHECK(is_same_file(folder.file("a"), folder.file(name)));
    CHECK(is_same_file(folder.file(name), folder.file("a")));
    CHECK_FALSE(is_same_file(folder.file(name), folder.file("other")));
    CHECK_FALSE(is_same_file(folder.file(name), folder.file("nothing")));
  }
  // What is not there yet may come to be one file as well.
  CHECK(is_same_file(folder.file("nothing"), folder.file("here/nothing")));
  CHECK(is_same_file(folder.file("nothing"), folder.file("leads-nowhere")));
  CHECK_FALSE(is_same_file(folder.file("nothing"), folder.file("Nothing")));
  CHECK_FALSE(is_same_file(folder.file("no/nothing"), folder.file("nothing")));
  CHECK_FALSE(is_same_file("/dev/null", "/dev/null"));
  CHECK(folder.entries() == 6);
}

TEST_CASE("nothing is written over what was read, nor twice, while a ledger is kept") {
  const TemporaryFolder folder;
  REQUIRE(write_file_atomically(folder.file("in"), "input"));
  fs::create_symlink("in", folder.file("link"));
  {
    const FileLedger ledger;
    REQUIRE(read_file(folder.file("in"), 100));
    REQUIRE(read_file(folder.file("in"), 100));
    CHECK(ledger.files_read() == std::vector{folder.file("in")});
    for (const char* name : {"in", "link"}) {
      const auto written = write_file_atomically(folder.file(name), "new");
      REQUIRE_FALSE(written);
      CHECK(ledger.has_refused());
      CHECK(written.error().file == folder.file(name));
      CHECK_FALSE(claim_output(folder.file(name)));
    }
    CHECK(contents(folder.file("in")) == "input");
    // An output is written once, by the name under which it was claimed.
    REQUIRE(claim_output(folder.file("out")));
    CHECK_FALSE(claim_output(folder.file("out")));
    fs::create_symlink("out", folder.file("to-out"));
    CHECK_FALSE(write_file_atomically(folder.file("to-out"), "other"));
    REQUIRE(write_file_atomically(folder.file("out"), "done"));
    CHECK_FALSE(write_file_atomically(folder.file("out"), "again"));
    CHECK(contents(folder.file("out")) == "done");
    // Unless it is kept for going on from.
    REQUIRE(claim_output(folder.file("kept"), OutputUse::kept));
    for (const char* text : {"one", "two"}) {
      REQUIRE(write_file_atomically(folder.file("kept"), text));
      REQUIRE(read_file(folder.file("kept"), 100));
    }
    CHECK_FALSE(claim_output(folder.file("kept")));
  }
  CHECK(write_file_atomically(folder.file("in"), "new"));
}

TEST_CASE("claiming an output says what would go wrong, and touches nothing") {
  const TemporaryFolder folder;
  REQUIRE(write_file_atomically(folder.file("a"), "x"));
  fs::create_directory(folder.file("folder"));
  const auto why = [&](const std::string& name) {
    const auto claimed = claim_output(folder.file(name));
    return claimed ? "" : claimed.error().text();
  };
  CHECK(why("a").empty());
  CHECK(why("b").empty());
  CHECK_THAT(why("folder"), contains("this is a folder"));
  CHECK_THAT(why("no/such/b"),
             contains("there is no folder " + folder.file("no/such")) && contains("make the folder first"));
  CHECK_THAT(why("a/b"), contains("a file stands where the path has a folder"));
  CHECK_THAT(why(std::string(300, 'n')), contains("name too long") && contains("shorter"));
  fs::create_symlink("circle", folder.file("circle"));
  CHECK_THAT(why("circle"), contains("circle") && !contains("permission"));
  const auto read = read_file(folder.file("circle"), 100);
  REQUIRE_FALSE(read);
  CHECK_THAT(read.error().text(), contains("links lead in a circle") && !contains("permission"));
  CHECK_THAT(claim_output("").error().text(), contains("empty"));
  CHECK(claim_output("/dev/null"));
  CHECK(folder.entries() == 3);
  CHECK(contents(folder.file("a")) == "x");
}
