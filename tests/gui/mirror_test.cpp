// The window in words has every command, and what it says of them is what the window would do.
#include "gui/mirror.h"

#include "gui/command.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/state.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>

using namespace raywalk;

namespace {

State classic_in_english() {
  State state = make_state(read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml").value());
  state.appearance.language = test::in_english;
  return state;
}

std::map<std::string, OutlineItem> buttons(const State& state) {
  std::map<std::string, OutlineItem> found;
  const auto gather = [&](const auto& self, const std::vector<OutlineItem>& items) -> void {
    for (const OutlineItem& item : items) {
      if (item.does.starts_with("command ")) CHECK(found.emplace(item.does.substr(8), item).second);
      self(self, item.items);
    }
  };
  gather(gather, outline_with_commands(state));
  return found;
}

}  // namespace

TEST_CASE("the outline has every command once, in every mode and in every language") {
  State state = classic_in_english();
  for (const Language language : state.appearance.language.others().all())
    for (const Mode mode : {Mode::move, Mode::trace, Mode::help}) {
      state.appearance.language = language;
      update(state, action::SetMode{mode});
      const auto found = buttons(state);
      const Outline regions = outline_with_commands(state);
      CHECK(found.size() == commands().size());
      for (const Command* each : commands()) {
        INFO(each->name);
        const auto at = found.find(std::string(each->name));
        REQUIRE(at != found.end());
        CHECK(at->second.role == OutlineItem::Role::button);
        CHECK(at->second.name == command_label(*each, state));
        CHECK(at->second.enabled == enabled(*each, state));
        CHECK(at->second.chosen.has_value() == (each->chosen != nullptr));
        CHECK(at->second.chosen.value_or(false) == chosen(*each, state));
        const std::string& to = at->second.leads_to;
        CHECK(to.empty() !=
              (each->name == "breakpoints" || each->name == "image-settings" || each->name == "cost-knobs"));
        const auto is_there = [&](const OutlineItem& item) { return item.key == to && item.folded; };
        CHECK((to.empty() || std::any_of(regions.begin(), regions.end(), is_there)));
      }
    }
}

TEST_CASE("while an answer is waited for, the outline offers no commands") {
  State state = classic_in_english();
  update(state, action::AskSaveAs{});
  CHECK(buttons(state).empty());
  const auto json = nlohmann::ordered_json::parse(outline_json(state));
  const auto& field = json[0]["items"][0];
  CHECK(field["role"] == "path");
  CHECK(field["value"] == "scene.toml");
}

TEST_CASE("as JSON an outline keeps its words and its order, and leaves out what is usual") {
  const State state = classic_in_english();
  const Outline outlined = outline_with_commands(state);
  const auto json = nlohmann::ordered_json::parse(outline_json(state));
  REQUIRE(json.size() == outlined.size());
  for (std::size_t i = 0; i < outlined.size(); ++i) {
    CHECK(json[i]["name"] == outlined[i].name);
    CHECK(json[i]["role"] == std::string(name_of(outlined[i].role)));
    CHECK(json[i].contains("folded") == outlined[i].folded);
    CHECK(json[i].value("items", nlohmann::ordered_json::array()).size() == outlined[i].items.size());
  }
}
