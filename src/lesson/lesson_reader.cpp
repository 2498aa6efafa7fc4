#include "io/toml_table.h"
#include "lesson/lesson.h"
#include "text/languages.h"
#include "text/spelling.h"
#include "text/text_file.h"
#include "text/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace raywalk {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_bytes = std::size_t{1} << 20;
constexpr std::int64_t max_pixels = 4096, max_samples = 4096, max_seed = 1'000'000'000;

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

/// Reads keys from one table, and keeps the first error of the file.
class LessonReader {
 public:
  explicit LessonReader(const std::string& file_name) : file_(file_name) {}

  Result<Lesson> read(const toml::table& root) {
    Lesson lesson;
    known(root, "the lesson", {"step", "says"});
    lesson.says = sayings(root);
    const toml::node* node = root.get("step");
    const toml::array* steps = node != nullptr ? node->as_array() : nullptr;
    if (steps == nullptr || steps->empty() || !steps->is_array_of_tables()) {
      fail(node != nullptr ? line_of(*node) : 1, "the lesson has no steps (expected at least one [[step]])",
           "lessons/README.md shows a lesson");
    } else {
      for (const toml::node& each : *steps) {
        LessonStep step = read_step(*each.as_table());
        const auto same = std::find_if(lesson.steps.begin(), lesson.steps.end(),
                                       [&](const LessonStep& other) { return other.id == step.id; });
        if (same != lesson.steps.end())
          fail(
              step.line,
              fmt::format("id: \"{}\" is the step of line {} already (expected an id of its own)", step.id, same->line),
              "");
        lesson.steps.push_back(std::move(step));
      }
      if (!lesson.steps.front().scene)
        fail(lesson.steps.front().line, "the first step has no scene (expected scene = \"classic\" or another)", "");
    }
    if (error_) return tl::unexpected(*error_);
    return lesson;
  }

 private:
  void fail(int line, std::string message, std::string hint) {
    if (!error_) error_ = Error{file_, line, 0, std::move(message), std::move(hint)};
  }

  void known(const toml::table& table, const std::string& place, const std::vector<std::string_view>& keys) {
    for (const auto& [key, node] : table) {
      if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
      const std::string meant = nearest_word(key.str(), keys);
      fail(line_of(node), fmt::format("unknown key \"{}\" in {} (expected {})", key.str(), place, one_of(keys)),
           meant.empty() ? "lessons/README.md explains every key" : "did you mean \"" + meant + "\"?");
    }
  }

  std::optional<std::string> text(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    if (const auto* string = node->as_string()) return string->get();
    fail(line_of(*node), fmt::format("{}: not a text (expected one in quotes)", key), "");
    return std::nullopt;
  }

  std::optional<double> number(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    if (const auto value = node->value<double>(); value && node->is_number()) return value;
    fail(line_of(*node), fmt::format("{}: not a number (expected one without quotes)", key), "");
    return std::nullopt;
  }

  std::optional<bool> yes_or_no(const toml::table& table, std::string_view key, const char* hint) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    if (const auto on = node->value_exact<bool>()) return on;
    fail(line_of(*node), fmt::format("{}: expected true or false", key), hint);
    return std::nullopt;
  }

  std::optional<int> whole(const toml::table& table, std::string_view key, std::int64_t low, std::int64_t high) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    return whole(*node, key, low, high);
  }
  std::optional<int> whole(const toml::node& node, std::string_view key, std::int64_t low, std::int64_t high) {
    const auto* integer = node.as_integer();
    if (integer != nullptr && integer->get() >= low && integer->get() <= high) return static_cast<int>(integer->get());
    fail(line_of(node), fmt::format("{}: expected a whole number from {} to {}", key, low, high), "");
    return std::nullopt;
  }

  std::optional<Formula> formula_of(const toml::node& node, std::string_view key) {
    const auto* string = node.as_string();
    if (string == nullptr) {
      fail(line_of(node), fmt::format("{}: not a formula (expected one in quotes)", key),
           "single quotes leave double ones free: 'object == \"Floor\"'");
      return std::nullopt;
    }
    auto expression = Expression::parse(string->get());
    if (expression) return Formula{string->get(), *expression, line_of(node)};
    fail(line_of(node), std::string(key) + ": " + expression.error(), "lessons/README.md lists what formulas know");
    return std::nullopt;
  }
  std::optional<Formula> formula(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    return node == nullptr ? std::nullopt : formula_of(*node, key);
  }
  std::vector<Formula> formulas(const toml::table& table, std::string_view key) {
    std::vector<Formula> list;
    const toml::node* node = table.get(key);
    if (node == nullptr) return list;
    const toml::array* array = node->as_array();
    if (array == nullptr) fail(line_of(*node), fmt::format("{}: not a list (expected formulas in [ ])", key), "");
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i)
      if (auto each = formula_of(*array->get(i), key)) list.push_back(std::move(*each));
    return list;
  }

  /// says.half = 'CLAIM', or a list of them, or what else the word means: says.half = { means = "..." }.
  std::vector<Saying> sayings(const toml::table& table) {
    std::vector<Saying> list;
    const toml::node* node = table.get("says");
    if (node == nullptr) return list;
    const toml::table* words = node->as_table();
    if (words == nullptr) fail(line_of(*node), "says: expected words with their claims", "says.half = 'a == b / 2'");
    if (words == nullptr) return list;
    for (const auto& [word, value] : *words) {
      Saying saying{std::string(word.str()), {}, "", line_of(value)};
      const std::string key = "says." + saying.word;
      if (const toml::table* other = value.as_table()) {
        known(*other, key, {"means"});
        saying.means = text(*other, "means").value_or("");
        if (saying.means.empty())
          fail(saying.line, key + ": expected a claim, or { means = \"what the word stands for here\" }", "");
      } else if (value.is_array()) {
        saying.claims = formulas(*words, word.str());
      } else if (auto claim = formula_of(value, key)) {
        saying.claims.push_back(std::move(*claim));
      }
      list.push_back(std::move(saying));
    }
    return list;
  }

  std::string changes(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return "";
    if (node->is_table()) return text_of(*node->as_table());
    fail(line_of(*node), fmt::format("{}: expected keys of the scene with their values", key),
         "write it as set.limits.depth = 2");
    return "";
  }

  std::optional<LessonPixel> pixel(const toml::table& table) {
    const toml::node* node = table.get("pixel");
    if (node == nullptr) return std::nullopt;
    const toml::array* both = node->as_array();
    if (both == nullptr) {
      const auto cell = whole(*node, "pixel", 0, max_pixels);
      return cell ? std::optional(LessonPixel{*cell, -1}) : std::nullopt;
    }
    if (both->size() != 2) {
      fail(line_of(*node), "pixel: expected a cell of SCREEN, or [column, row] of the picture", "all count from 0");
      return std::nullopt;
    }
    const auto column = whole(*both->get(0), "pixel", 0, max_pixels),
               row = whole(*both->get(1), "pixel", 0, max_pixels);
    return column && row ? std::optional(LessonPixel{*column, *row}) : std::nullopt;
  }

  std::optional<Fault> fault(const toml::table& table) {
    const auto word = text(table, "fault");
    if (!word) return std::nullopt;
    if (const auto known = named<Fault>(*word)) return known;
    const std::vector<std::string_view> names = all_words<Fault>();
    const std::string meant = nearest_word(*word, names);
    fail(line_of(*table.get("fault")), fmt::format("fault: \"{}\" is not known (expected {})", *word, one_of(names)),
         meant.empty() ? "lessons/README.md says what each of them breaks" : "did you mean \"" + meant + "\"?");
    return std::nullopt;
  }

  std::optional<LessonQuestion> question(const toml::table& step) {
    const toml::node* node = step.get("predict");
    if (node == nullptr) return std::nullopt;
    const toml::table* table = node->as_table();
    const int line = line_of(*node);
    const auto has = [&](std::string_view key) { return table->contains(key) ? 1 : 0; };
    if (table == nullptr || has("arrow") + has("number") + has("choices") + has("line") != 1) {
      fail(line, "predict: expected one of arrow = DEGREES, number = FORMULA, choices = [FORMULAS] and line = TEXT",
           "");
      return std::nullopt;
    }
    known(*table, "predict", {"arrow", "number", "tolerance", "theory", "unit", "choices", "line"});
    if (auto answer = text(*table, "line")) return LineQuestion{std::move(*answer)};
    if (const auto degrees = number(*table, "arrow")) {
      if (!(*degrees > 0 && *degrees <= 90)) fail(line, "arrow: expected degrees above 0, at most 90", "");
      return ArrowQuestion{*degrees};
    }
    if (auto answer = formula(*table, "number")) {
      const double tolerance = number(*table, "tolerance").value_or(0);
      if (!(tolerance >= 0)) fail(line, "tolerance: expected a number that is 0 or more", "");
      return NumberQuestion{std::move(*answer), tolerance, text(*table, "unit").value_or(""),
                            formula(*table, "theory")};
    }
    ChoiceQuestion choice{formulas(*table, "choices")};
    constexpr std::size_t least = 2, most = 9;  // each has a number key
    if (choice.choices.size() < least || choice.choices.size() > most)
      fail(line, "choices: expected 2 to 9 of them", "");
    return choice;
  }

  PictureRequest picture(const toml::table& table) {
    known(table, "a picture", {"name", "size", "samples", "seed", "accelerator", "set"});
    PictureRequest request;
    request.line = line_of(table);
    request.name = text(table, "name").value_or("");
    if (request.name.empty()) fail(request.line, "a picture has no name (expected name = \"...\")", "");
    if (const toml::node* size = table.get("size")) {
      const toml::array* both = size->as_array();
      if (both == nullptr || both->size() != 2) {
        fail(line_of(*size), "size: expected [width, height]", "");
      } else {
        const auto width = whole(*both->get(0), "size", 1, max_pixels),
                   height = whole(*both->get(1), "size", 1, max_pixels);
        if (width && height) request.size = ImageSize{*width, *height};
      }
    }
    request.samples = whole(table, "samples", 1, max_samples).value_or(1);
    if (const auto seed = whole(table, "seed", 0, max_seed)) request.seed = static_cast<std::uint64_t>(*seed);
    if (const auto word = text(table, "accelerator")) {
      const auto known = named<AcceleratorKind>(*word);
      if (!known)
        fail(request.line,
             fmt::format("accelerator: \"{}\" is not known (expected {})", *word, one_of(all_words<AcceleratorKind>())),
             "");
      request.accelerator = known.value_or(request.accelerator);
    }
    request.changes = changes(table, "set");
    return request;
  }

  LessonBeside pane(const toml::table& table, std::string_view key) {
    const auto word = text(table, key);
    if (!word) return LessonBeside::unchanged;
    if (const auto known = named<LessonBeside>(*word)) return *known;
    fail(line_of(*table.get(key)),
         fmt::format("{}: \"{}\" is not known (expected {})", key, *word, one_of(all_words<LessonBeside>())), "");
    return LessonBeside::unchanged;
  }

  LessonStep read_step(const toml::table& table) {
    known(table, "[[step]]",
          {"id", "scene", "set", "remove", "pixel", "fault", "run", "reveal", "predict", "check", "says", "picture",
           "show", "then", "large", "breakpoints", "extra", "zoom", "pencils"});
    LessonStep step;
    step.line = line_of(table);
    step.id = text(table, "id").value_or("");
    if (step.id.empty()) fail(step.line, "a step has no id (expected id = \"...\")", "the words are found by it");
    step.scene = text(table, "scene");
    step.changes = changes(table, "set");
    if (const toml::node* names = table.get("remove")) {
      const toml::array* array = names->as_array();
      if (array == nullptr) fail(line_of(*names), "remove: expected a list of names", "");
      for (std::size_t i = 0; array != nullptr && i < array->size(); ++i)
        step.removed.push_back(array->get(i)->value_or(std::string()));
    }
    step.breakpoints =
        yes_or_no(table, "breakpoints", "false: those of the student do not stop the walk").value_or(true);
    step.extra = yes_or_no(table, "extra", "true: the step is not one of a presenter's five minutes").value_or(false);
    step.zoom = yes_or_no(table, "zoom", "true: in Focus the plan shows the ray in question large").value_or(false);
    step.pencils = yes_or_no(table, "pencils", "true: pencils are drawn once the answer stands there").value_or(false);
    step.pixel = pixel(table);
    step.fault = fault(table);
    step.run = formula(table, "run");
    step.reveal = formula(table, "reveal");
    step.question = question(table);
    if (step.reveal && !step.question) fail(step.line, "reveal stands without predict (expected both, or run)", "");
    step.checks = formulas(table, "check");
    step.says = sayings(table);
    if (const toml::node* pictures = table.get("picture")) {
      const toml::array* array = pictures->as_array();
      if (array == nullptr || !array->is_array_of_tables()) {
        fail(line_of(*pictures), "picture: expected tables [[step.picture]]", "");
      } else {
        for (const toml::node& each : *array) step.pictures.push_back(picture(*each.as_table()));
      }
    }
    step.pane = pane(table, "show");
    step.then = pane(table, "then");
    if (step.then != LessonBeside::unchanged && !step.question)
      fail(line_of(*table.get("then")), "then stands without predict (expected both, or show)", "");
    step.large = yes_or_no(table, "large", "true: what is shown at last has the plan's place").value_or(false);
    return step;
  }

  std::string file_;
  std::optional<Error> error_;
};

}  // namespace

std::vector<std::string> lesson_names(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (fs::exists(entry->path() / "lesson.toml", ignored)) names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Result<Lesson> parse_lesson(std::string_view text, const std::string& file_name) {
  if (const auto checked = toml_text::check(text, file_name, "a lesson"); !checked)
    return tl::unexpected(checked.error());
  const toml::parse_result parsed = toml::parse(text, file_name);
  if (!parsed) {
    const toml::parse_error& error = parsed.error();
    return tl::unexpected(Error{file_name, static_cast<int>(error.source().begin.line),
                                static_cast<int>(error.source().begin.column), std::string(error.description()),
                                "the file is TOML, as scenes are; a string needs quotes at both ends"});
  }
  return LessonReader(file_name).read(parsed.table());
}

Language Lesson::told_in(Language language) const {
  return words.contains(language.code()) ? language : language.others().english();
}

Result<Lesson> read_lesson(const std::string& folder) {
  const fs::path path(folder);
  const std::string file = (path / "lesson.toml").string();
  const auto text = read_text(file, max_bytes);
  if (!text) return tl::unexpected(text.error());
  auto lesson = parse_lesson(*text, file);
  if (!lesson) return lesson;
  lesson->folder = folder;
  lesson->name = (path.has_filename() ? path : path.parent_path()).filename().string();
  for (const std::string& code : language_codes_in(folder, ".md")) {
    const std::string words_file = (path / (code + ".md")).string();
    const auto words = read_text(words_file, max_bytes).and_then([&](const std::string& words_text) {
      return parse_words(words_text, words_file);
    });
    if (!words) return tl::unexpected(words.error());
    lesson->words.emplace(code, *words);
  }
  return lesson;
}

}  // namespace raywalk
