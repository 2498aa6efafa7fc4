// Links by keys and mouse, the page in somebody else's page, and a link that the window begins with.

#include "view/link/link.h"

#include <filesystem>
#include <string>

#include "gui/bench.h"
#include "gui/folder.h"
#include "gui/session.h"
#include "support/catch.h"
#include "support/languages.h"
#include "text/file.h"
#include "view/link/qr_code.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State with_scenes() {
  State state = classic();
  state.lessons.scenes_folder = RAYWALK_SOURCE_DIR "/scenes";
  return state;
}

}  // namespace

TEST_CASE("a link is copied by its key, and shown with its code, which leaves nothing else a meaning") {
  Bench bench(with_scenes());
  bench.frames(2);
  bench.key("Ctrl+Shift+E");
  CHECK(bench.state.link.copies == 1);
  CHECK(bench.state.link.copied.starts_with("raywalk:#v=1/"));
  CHECK_FALSE(bench.state.link.shown);
  update(bench.state, action::ShowLink{true});
  bench.frames(3);
  REQUIRE(bench.has("link-code"));
  // Whole pixels a square, and the window keeps the code on the screen.
  const Rect code = bench.rect("link-code");
  CHECK(code.width == code.height);
  CHECK(code.bottom() < 720);
  const int position = bench.state.walk.position;
  bench.key("Space");
  CHECK(bench.state.walk.position == position);
  bench.click("link-page");
  bench.type("https://a.example/");
  bench.frames(2);
  CHECK(bench.state.link.page == "https://a.example/");
  CHECK(address_shown(bench.state).starts_with("https://a.example/#v=1/"));
  bench.key("Escape");
  bench.frames(2);
  CHECK_FALSE(bench.state.link.shown);
  update(bench.state, action::ShowLink{true});
  bench.frames(3);
  bench.click("link-copy");
  CHECK(bench.state.link.copies == 2);
  CHECK(bench.state.link.copied.starts_with("https://a.example/#v=1/"));
}

TEST_CASE("the link dialog fits the window in every language, with a code and without") {
  for (const Language language : all_languages())
    for (const auto& [width, height] :
         {std::pair{1280.0f, 720.0f}, {640.0f, 480.0f}, {390.0f, 844.0f}, {360.0f, 640.0f}}) {
      State state = with_scenes();
      state.appearance.language = language;
      Bench bench(state, width, height);
      bench.unit = bench.dpi = shrink_to_fit(width, height, 1);
      update(bench.state, action::SetLinkPage{std::string(260, 'x')});
      update(bench.state, action::ShowLink{true});
      bench.frames(4);
      CHECK_FALSE(bench.has("link-code"));
      update(bench.state, action::SetLinkPage{});
      bench.frames(4);
      REQUIRE(bench.has("link-code"));
      CHECK(bench.rect("link-close").bottom() <= height);
      // An address has no spaces, and is seen all the same; of a long one as much as three lines hold.
      const Rect address = bench.rect("link-address");
      CHECK(address.right() <= width);
      update(bench.state, action::SetLinkPage{"https://" + std::string(200, 'x') + ".example/"});
      bench.frames(4);
      CHECK(bench.rect("link-address").right() <= width);
      CHECK(bench.rect("link-close").bottom() <= height);
    }
}

TEST_CASE("embedded, the window is the scene, the code and the transport") {
  Bench bench(with_scenes());
  bench.state.appearance.embedded = true;
  for (const Tab tab : {PictureRoom::tab, CostRoom::tab, MicroscopeRoom::tab, StructureRoom::tab}) {
    update(bench.state, action::SetTab{tab});
    bench.frames(3);
    const Layout& layout = bench.interface().layout();
    CHECK((layout.bar.empty() && layout.tabs.empty() && layout.strip.empty()));
    CHECK((!layout.plan.empty() && !layout.side.empty() && !layout.transport.empty()));
    CHECK(bench.has("step"));
    CHECK_FALSE(bench.has("menu-file"));
  }
  const int before = bench.state.walk.position;
  bench.click("step");
  CHECK(bench.state.walk.position == before + 1);
  bench.key("M");
  bench.frames(3);
  bench.key("Ctrl+Z");
}

TEST_CASE("the window begins with a link, whose language it takes") {
  const Folder folder;
  GuiOptions options;
  options.data_dir = RAYWALK_SOURCE_DIR;
  options.state_dir = folder.path().string();
  options.languages = shipped_texts().languages;
  options.language = in_english;
  options.link = "https://a.example/#v=1/scene=glass/step=12/tab=tree/lang=pt/theme=projector";
  const auto state = start(options);
  REQUIRE(state.has_value());
  CHECK(state->walk.position == 12);
  CHECK(state->document.path.ends_with("glass.toml"));
  CHECK(state->appearance.tab == TreeRoom::tab);
  CHECK(state->appearance.theme == Theme::projector);
  CHECK(state->appearance.language == in_portuguese);
  CHECK_FALSE(state->document.question);
  // What an earlier session left is asked about all the same, and stays until that is answered.
  const std::string left =
      folder.put("autosave.toml", read_file(options.data_dir + "/scenes/mirrors.toml", 1 << 20).value());
  const auto asked = start(options);
  REQUIRE(asked.has_value());
  CHECK(asked->document.path.ends_with("glass.toml"));
  REQUIRE(asked->document.question);
  CHECK(asked->document.question->kind == Question::Kind::recover);
  CHECK(std::filesystem::exists(left));
}
