#include "view/text/text.h"
#include "fixtures.h"
#include "timeline/recorder.h"

#include <algorithm>
#include <set>

#include "support/catch.h"
#include "support/languages.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("every message has a sentence of its own, every ending a sign of its own") {
  for (const Language language : all_languages()) {
    std::set<std::string_view> sentences;
    for (const std::string_view id : language.catalogue().ids()) {
      if (!id.starts_with("walk.")) continue;
      INFO(id);
      const std::string_view pattern = text(id, language);
      CHECK(pattern.ends_with('.'));
      CHECK(sentences.insert(pattern).second);
    }
  }
  std::set<std::string_view> symbols;
  for (int i = 0; i < ending_count; ++i) CHECK(symbols.insert(symbol(static_cast<Ending>(i))).second);
}

TEST_CASE("arguments stand where their numbers are") {
  CHECK(fill("question.unsaved_open", in_english, {{"file", "a"}, {"other", "b"}}).find("a has") == 0);
  CHECK_THAT(fill("question.unsaved_open", in_english, {{"file", "a"}, {"other", "{0}"}}), contains("opening “{0}”?"));
}

TEST_CASE("a title begins with a capital, also where its letter has an accent") {
  CHECK(capitalised("shadows") == "Shadows");
  CHECK(capitalised("árbol") == "Árbol");
  CHECK(capitalised("índice") == "Índice");
  CHECK(capitalised("EYE") == "EYE");
  CHECK(capitalised("÷") == "÷");
  CHECK(capitalised("3-D") == "3-D");
  CHECK(capitalised("").empty());
}

TEST_CASE("numbers are short") {
  CHECK(number_text(0, in_english) == "0");
  CHECK(number_text(-0.0, in_english) == "0");
  CHECK(number_text(1.23456, in_english) == "1.23");
  CHECK(number_text(12, in_english) == "12");
  CHECK(number_text(0.5, in_english) == "0.5");
  CHECK(percent_text(1, in_english) == "100%");
  CHECK(percent_text(0.456, in_english) == "46%");
  CHECK(percent_text(0.0023, in_english) == "0.2%");
  CHECK(percent_text(0, in_english) == "0%");
  CHECK(percent_text(1e-9, in_english) == "under 0.001%");
  CHECK(colour_text(Rgbd(0.25), in_english) == "0.25");
  CHECK(colour_text(Rgbd(0.25, 0.5, 1), in_english) == "(0.25, 0.5, 1)");
}

TEST_CASE("what is less than a threshold never reads as equal to it") {
  const Message below{"walk.reflect_threshold", {{"share", Fraction{0.0156}}, {"threshold", Fraction{0.016}}}};
  CHECK_THAT(sentence_of(Scene(), below, in_english),
             contains("only 1.56% of the pixel, less than the threshold of 1.60%"));
  CHECK_THAT(sentence_of(Scene(), below, in_portuguese), contains("1,56%"));
  const Message far{"walk.reflect_threshold", {{"share", Fraction{0.2}}, {"threshold", Fraction{0.5}}}};
  CHECK_THAT(sentence_of(Scene(), far, in_english), contains("only 20% of the pixel, less than the threshold of 50%"));
}

TEST_CASE("numbers are written as the language writes them") {
  CHECK(number_text(-1.23456, in_portuguese) == "\u22121,23");
  CHECK(percent_text(0.0023, in_portuguese) == "0,2%");
  CHECK(percent_text(1e-9, in_portuguese) == "menos de 0,001%");
  CHECK(colour_text(Rgbd(0.25, 0.5, 1), in_portuguese) == "(0,25; 0,5; 1)");
  CHECK(sentence_of(
            Scene(),
            {"walk.found_hit", {{"ray", RayKind::reflect}, {"object", std::string("Polygon 1.5")}, {"distance", 2.5}}},
            in_portuguese) == "O raio refletido encontra Polygon 1.5 \u00e0 dist\u00e2ncia 2,5.");
}

TEST_CASE("every step of every shipped scene has a whole sentence that names how a ray ended") {
  std::vector<Scene> scenes{busy_scene()};
  for (const auto& path : shipped_scenes()) scenes.push_back(read_document(path).scene);
  for (const Scene& scene : scenes) {
    INFO(scene.title);
    const Timeline timeline = record_strip(scene);
    for (int position = 0; position <= timeline.steps(); ++position) {
      const std::string sentence = sentence_of(scene, describe(scene, timeline, position), in_english);
      INFO("step " << position << ": " << sentence);
      REQUIRE(sentence.size() > 10);
      REQUIRE(sentence.back() == '.');
      REQUIRE(sentence.find('{') == std::string::npos);
      REQUIRE(sentence.find("  ") == std::string::npos);
      const Event* event = timeline.just_run(position);
      if (event == nullptr) continue;
      const auto says = [&](const std::string& words) { return sentence.find(words) != std::string::npos; };
      if (const auto* found = std::get_if<Found>(&event->detail)) {
        if (found->object >= 0) REQUIRE(says(scene.objects[static_cast<std::size_t>(found->object)].name));
        // Under a sky rays that leave say where they meet it.
        if (found->ending == Ending::missed) REQUIRE((says("hits nothing") || says("leaves the scene")));
        if (found->ending == Ending::blocked) REQUIRE(says("blocked"));
        if (found->ending == Ending::reached_light) REQUIRE((says("reaches") || says("meets nothing")));
      }
      if (const auto* stub = std::get_if<RayNotFormed>(&event->detail)) {
        const bool by_sky = stub->light == light_of_sky;
        REQUIRE(says(by_sky ? "no shadow ray is formed" : "No "));
        if (stub->why == Ending::depth) REQUIRE(says("deeper than DEPTH " + std::to_string(scene.limits.depth)));
        if (stub->why == Ending::threshold) REQUIRE(says("threshold"));
        if (stub->why == Ending::facing_away && !by_sky) REQUIRE(says("faces away"));
      }
      if (const auto* decided = std::get_if<Decided>(&event->detail); decided != nullptr && decided->why)
        REQUIRE(says("total internal reflection"));
    }
  }
}

TEST_CASE("the transcript numbers every step and shows line, depth and sentence") {
  const State state = classic_state();
  const std::string lines = transcript(state.scene(), *state.walk.timeline, in_english);
  CHECK(std::count(lines.begin(), lines.end(), '\n') == state.walk.timeline->steps());
  for (const int position : {1, 100, state.walk.timeline->steps()}) {
    const std::string step = step_text(state.scene(), *state.walk.timeline, position, in_english);
    const Event& event = *state.walk.timeline->just_run(position);
    CHECK_THAT(step, contains(std::to_string(position)));
    CHECK_THAT(step, contains(std::string(pseudocode_of(event.line).text)));
    CHECK_THAT(step, contains(sentence_of(state.scene(), describe(state.scene(), *state.walk.timeline, position),
                                          in_english)));
    CHECK_THAT(lines, contains(step + "\n"));
    if (event.depth > 0) CHECK_THAT(step, contains("[" + std::to_string(event.depth) + "]"));
  }
}

TEST_CASE("the help names the objects, the modes and the buttons as they are called") {
  for (const Language language : all_languages()) {
    std::string all;
    for (const HelpSection& section : help(language)) {
      CHECK_FALSE(section.title.empty());
      CHECK_FALSE(section.entries.empty());
      for (const HelpEntry& entry : section.entries) {
        CHECK_FALSE(entry.text.empty());
        all += entry.term + "\n";
      }
    }
    for (const std::string_view id :
         {"object.eye", "object.screen", "name.Solid Sphere", "name.Transparent Sphere", "name.Polygon",
          "name.Light Source", "command.mode_move.label", "command.mode_trace.label", "command.mode_help.label",
          "command.step.label", "command.step_back.label", "command.play.label", "command.clear.label",
          "command.tab_tree.label", "command.tab_stack.label", "command.tab_legend.label", "command.tab_image.label",
          "command.tab_cost.label"})
      CHECK_THAT(all, contains(std::string(text(id, language)) + "\n"));
    for (const Ending ending : {Ending::hit, Ending::missed, Ending::blocked, Ending::reached_light})
      CHECK_THAT(all, contains(std::string(text(ending, language)) + "\n"));
  }
}
