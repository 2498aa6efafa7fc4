// The page that steps offline holds what the window shows at each step; the drawing is well-formed.
#include "view/export/slides.h"
#include "view/walk/status.h"

#include "fixtures.h"
#include "text/markup.h"
#include "timeline/recorder.h"
#include "view/drawing/svg.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"
#include "view/walk/code_panel.h"
#include "view/walk/equation.h"

#include <nlohmann/json.hpp>

#include <set>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// What is wrong with the nesting of tags; empty when nothing is.
std::string badly_nested(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return "a tag without an end";
    const std::string tag = text.substr(at + 1, end - at - 1);
    const std::string name =
        tag.substr(tag.front() == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag.front() == '/' ? 1 : 0));
    if (tag.back() == '/') continue;
    if (tag.front() != '/') {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return "</" + name + "> closes nothing";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is left open";
}

Scene classic_scene() { return read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml").scene; }

/// The data of a page.
nlohmann::json walk_of(const std::string& page) {
  const std::string head = "const W = ";
  const std::size_t begin = page.find(head) + head.size(), end = page.find(";\nconst box", begin);
  REQUIRE(end != std::string::npos);
  // Nothing in the data may end the script.
  CHECK(page.find("</", begin) > end);
  return nlohmann::json::parse(page.substr(begin, end - begin));
}

}  // namespace

TEST_CASE("every shape becomes elements that are closed, with its numbers and its dashes") {
  Stroke dashed{{255, 0, 16, 128}, 2.5, {{3, 4, 0, 0}, 2}, 1.25};
  CHECK(svg_element(LineItem{{0, 1}, {10.126, -2}, dashed}) ==
        "<line x1=\"0\" y1=\"1\" x2=\"10.13\" y2=\"-2\" stroke=\"#ff0010\" stroke-opacity=\"0.5\" stroke-width=\"2.5\" "
        "stroke-dasharray=\"3 4\" stroke-dashoffset=\"1.25\"/>");
  CHECK_THAT(svg_element(LineItem{{0, 0}, {10, 0}, dashed, 5}), contains("<polygon points="));
  CHECK(svg_element(CircleItem{{1, 2}, 3, Colour{1, 2, 3}, std::nullopt}) ==
        "<circle cx=\"1\" cy=\"2\" r=\"3\" fill=\"#010203\"/>");
  CHECK_THAT(svg_element(CircleItem{{1, 2}, 3, std::nullopt, dashed}), contains("fill=\"none\""));
  CHECK_THAT(svg_element(TextItem{{5, 5}, "A < B & \"C\"", 10, {}, TextAnchor::middle}),
             contains("A &lt; B &amp; &quot;C&quot;</text>") && contains("text-anchor=\"middle\""));
  CHECK(badly_nested("<a><b/></a>") == "");
  CHECK(badly_nested("<a><b></a>") != "");
}

TEST_CASE("the drawing of a walk is one file, well nested, with all that the plan shows") {
  const Scene scene = classic_scene();
  const std::string file = plan_picture(scene, std::make_shared<const Timeline>(record_strip(scene)), in_english);
  CHECK(badly_nested(file) == "");
  for (const char* word : {"EYE", "SCREEN", "Solid Sphere", "Transparent Sphere", "Polygon", "Light Source"})
    CHECK_THAT(file, contains(std::string(">") + word + "</text>"));
  CHECK(file.find("nan") == std::string::npos);
  CHECK(file.find("inf") == std::string::npos);
}

TEST_CASE("the page has every step as the window shows it, and asks no network") {
  const Scene scene = classic_scene();
  const auto timeline = std::make_shared<const Timeline>(record_strip(scene));
  const std::string page = slides_page(scene, timeline, in_english);
  for (const char* outside : {"http:", "https:", "src=", "@import", "url("})
    CHECK(page.find(outside) == std::string::npos);
  CHECK(page.size() < 4'000'000);
  const std::string legend = page.substr(page.find("<ul id=\"legend\">"), 3000);
  for (const RayKind kind : {RayKind::primary, RayKind::shadow, RayKind::reflect, RayKind::refract})
    CHECK_THAT(legend, contains(std::string(raywalk::text(kind, Language()))));
  const std::size_t html = page.find("<html");
  CHECK(badly_nested(page.substr(html, page.find("<script>") - html) + "</body></html>") == "");
  const auto walk = walk_of(page);
  const auto& steps = walk.at("steps");
  REQUIRE(steps.size() == static_cast<std::size_t>(timeline->steps()) + 1);

  State state = make_state(read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml"));
  state.walk.mode = Mode::trace;
  for (int position = 0; position <= timeline->steps(); ++position) {
    state.walk.position = position;
    const auto& step = steps.at(static_cast<std::size_t>(position));
    INFO(position);
    REQUIRE(walk.at("said").at(step.at("s").get<std::size_t>()) == escaped(sentence(state)));
    REQUIRE(step.at("r") == (position == 0 ? -1 : static_cast<int>(timeline->event(position - 1).line)));
    REQUIRE(step.at("n") == (position == timeline->steps() ? -1 : static_cast<int>(timeline->event(position).line)));
    const EquationPanel equation = equation_panel(state);
    REQUIRE(step.at("e").size() == equation.rows.size());
    for (std::size_t i = 0; i < equation.rows.size(); ++i)
      REQUIRE_THAT(walk.at("said").at(step.at("e").at(i).get<std::size_t>()).get<std::string>(),
                   contains(escaped(equation.rows[i].text)));
  }
}

TEST_CASE("the page's plan of each step, put together as its script does, is the window's") {
  const Scene scene = classic_scene();
  const auto timeline = std::make_shared<const Timeline>(record_strip(scene));
  const auto walk = walk_of(slides_page(scene, timeline, in_english));
  State state = make_state(read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml"));
  state.walk.mode = Mode::trace;
  state.appearance.theme = Theme::projector;
  state.appearance.tab = EquationRoom::tab;
  state.plan.viewport = {750, 500};
  state.plan.camera = fitted(state);
  std::vector<std::size_t> items;
  for (int position = 0; position <= timeline->steps(); ++position) {
    const std::vector<std::size_t> before =
        position % walk.at("complete").get<int>() == 0 ? std::vector<std::size_t>() : std::move(items);
    items.clear();
    for (const auto& item : walk.at("steps").at(static_cast<std::size_t>(position)).at("d")) {
      if (!item.is_array()) {
        items.push_back(item.get<std::size_t>());
        continue;
      }
      const auto first = item.at(0).get<std::ptrdiff_t>(), count = item.at(1).get<std::ptrdiff_t>();
      REQUIRE(first + count <= static_cast<std::ptrdiff_t>(before.size()));
      items.insert(items.end(), before.begin() + first, before.begin() + first + count);
    }
    state.walk.position = position;
    const DisplayList list = plan_view(state);
    INFO(position);
    REQUIRE(items.size() == list.size());
    for (std::size_t i = 0; i < items.size(); ++i) REQUIRE(walk.at("drawn").at(items[i]) == svg_element(list[i].shape));
  }
}

TEST_CASE("a page grows with the number of its steps, not with their square") {
  Scene scene = read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/hard/facing_mirrors.toml").scene;
  const auto page_of = [&](int depth) {
    scene.limits = {depth, 0};
    return slides_page(scene, std::make_shared<const Timeline>(record_cell(scene, 10)), in_english).size();
  };
  const std::size_t few = page_of(20), more = page_of(80), most = page_of(140);
  CHECK(static_cast<double>(most - more) < 1.2 * static_cast<double>(more - few));
}

TEST_CASE("every line that a page marks is on it, also where a walk has three procedures") {
  Scene scene = read_document(std::string(RAYWALK_SOURCE_DIR) + "/scenes/caustic.toml").scene;
  scene.render.photons.count = 300;
  const auto timeline = std::make_shared<const Timeline>(record_cell(scene, 10));
  REQUIRE(timeline->of_photons());
  const std::string page = slides_page(scene, timeline, in_english);
  const auto walk = walk_of(page);
  std::set<int> marked;
  for (const auto& step : walk.at("steps"))
    for (const char* line : {"r", "n"}) marked.insert(step.at(line).get<int>());
  marked.erase(-1);
  REQUIRE(marked.size() > 10);
  for (const int line : marked) {
    const std::string id = "<li id=\"l" + std::to_string(line) + "\"";
    CHECK_THAT(page, contains(id));
    CHECK(page.find(id) == page.rfind(id));
  }
}
