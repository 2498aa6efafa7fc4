// What the report for scripts tells while a lesson asks.

#include <nlohmann/json.hpp>

#include <cmath>

#include "gui/bench.h"
#include "gui/report.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

using Json = nlohmann::json;

/// All of the report but the places of things in the window.
Json told_by_report(Bench& bench) {
  const Preview preview;
  Json json = Json::parse(report(bench.state, bench.interface(), preview, LiveCosts{}, 1, {12, 0.25, 1280, 720, true}),
                          nullptr, false);
  for (const char* key : {"items", "objects", "lights", "eye", "window", "revision", "speed", "ui_scale"})
    json.erase(key);
  // How many steps the walk has, and where in it one stands: the transport shows both.
  for (const char* key : {"steps", "position", "cell", "undo", "redo"}) json.erase(key);
  return json;
}

void collect_numbers(const Json& json, const std::string& where, std::vector<std::pair<std::string, double>>& numbers) {
  if (json.is_number()) numbers.emplace_back(where, json.get<double>());
  if (json.is_structured())
    for (const auto& [key, value] : json.items()) collect_numbers(value, where + "/" + key, numbers);
}

}  // namespace

TEST_CASE("the report tells no answer before it is given") {
  Bench bench(classic_with_lessons());
  update(bench.state, action::ShowLessons{true});
  update(bench.state, action::SetLessonOptions{false, true});
  for (const LessonEntry& entry : std::vector(bench.state.lessons.list)) {
    update(bench.state, action::OpenLesson{entry.name});
    for (int i = 0; i < entry.steps; ++i) {
      update(bench.state, action::GoToLessonStep{i});
      const PlayedStep& step = *bench.state.lessons.at();
      CAPTURE(entry.name, step.step->id);
      if (!step.step->question) continue;
      bench.frames(1);
      const Json json = told_by_report(bench);
      REQUIRE(json.is_object());
      CHECK(json["lesson"]["revealed"] == false);
      if (json.contains("structure")) CHECK(json["structure"]["steps"] == 0);
      if (json.contains("bug")) CHECK(json["bug"]["known"] == false);
      const auto* question = std::get_if<NumberQuestion>(&*step.step->question);
      if (question == nullptr) continue;
      const double answer = std::get<double>(value_at(bench.state.lessons.open->played, static_cast<std::size_t>(i),
                                                      step.shown, question->answer.expression)
                                                 .value());
      std::vector<std::pair<std::string, double>> numbers;
      collect_numbers(json, "", numbers);
      for (const auto& [where, number] : numbers) {
        // The number of the lesson's step, how many rays there are so far, and how far the microscope stretches what it
        // shows, are numbers of their own.
        if (where.starts_with("/lesson/") || where == "/rays" || where.starts_with("/walk")) continue;
        if (where == "/magnified") continue;
        INFO(where << " is " << number << ", the answer " << answer);
        CHECK(std::abs(number - answer) > question->tolerance);
      }
    }
    update(bench.state, action::LeaveLesson{});
  }
}
