#include "view/action_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <optional>
#include <span>
#include <sstream>
#include <utility>

namespace raywalk {

namespace {

class ActionWriter {
 public:
  explicit ActionWriter(std::string_view word) : line_(word) {}
  [[nodiscard]] std::string take() { return std::move(line_); }

  void operator()(int value) { add(fmt::format("{}", value)); }
  void operator()(double value, Number = Number::finite) { add(fmt::format("{}", value)); }
  void operator()(const std::string& text) { add(text); }
  void operator()(const std::string& path, FilePath) { add(path); }
  void operator()(bool value, Either words) { add(value ? words.yes : words.no); }
  void operator()(bool value, Flag flag) {
    if (value) add(flag.word);
  }
  void operator()(Line value) { add(fmt::format("{}", static_cast<int>(value) + 1)); }
  void operator()(const std::optional<Line>& value) { value ? (*this)(*value) : add("none"); }
  template <Worded E>
  void operator()(E value) {
    for (const auto& [each, word] : words_of<E>)
      if (each == value) add(word);
  }
  template <Worded E>
  void operator()(const std::optional<E>& value) {
    if (value) (*this)(*value);
  }
  template <class Value>
  void operator()(const Value&, Unwritten) {}
  template <class Value>
    requires(std::is_class_v<Value> && !Worded<Value>)
  void operator()(const Value& value) {
    each_field(*this, value);
  }

 private:
  void add(std::string_view word) { line_.append(" ").append(word); }

  std::string line_;
};

class ActionReader {
 public:
  /// `text`: the line after the word.
  explicit ActionReader(std::string_view text) : text_(text) {}

  /// What was wrong; leftover text is an error too.
  [[nodiscard]] std::string error() {
    if (error_.empty() && !peek().empty()) fail("nothing more");
    return error_;
  }

  void operator()(int& value) {
    double number = 0;
    const std::string_view before = text_;
    if (!parse(number) || number != std::floor(number) || std::abs(number) > 1e9) {
      text_ = before;
      return fail("a whole number");
    }
    value = static_cast<int>(number);
  }
  void operator()(double& value, Number = Number::finite) {
    if (!parse(value)) fail("a number");
  }
  void operator()(std::string& text) {
    static_cast<void>(peek());
    text = text_;
    text_ = {};
    if (text.empty()) fail("a text");
  }
  void operator()(std::string& path, FilePath) { (*this)(path); }
  void operator()(bool& value, Either words) {
    const Word<bool> both[] = {{true, words.yes}, {false, words.no}};
    choose(value, std::span(both));
  }
  void operator()(bool& value, Flag flag) {
    value = peek() == flag.word;
    if (value) static_cast<void>(next());
  }
  void operator()(Line& value) {
    int row = 0;
    (*this)(row);
    if (row < 1 || row > all_lines_count) return fail(fmt::format("a line's number from 1 to {}", all_lines_count));
    value = static_cast<Line>(row - 1);
  }
  void operator()(std::optional<Line>& value) {
    value.reset();
    if (peek() == "none") return static_cast<void>(next());
    (*this)(value.emplace());
  }
  template <Worded E>
  void operator()(E& value) {
    choose(value, std::span(words_of<E>));
  }
  template <Worded E>
  void operator()(std::optional<E>& value) {
    E found{};
    if (try_choice(found, std::span(words_of<E>))) value = found;
  }
  template <class Value>
  void operator()(Value&, Unwritten) {}
  template <class Value>
    requires(std::is_class_v<Value> && !Worded<Value>)
  void operator()(Value& value) {
    each_field(*this, value);
  }

 private:
  static constexpr std::string_view blanks = " \t\r";

  std::string_view peek() {
    const std::size_t begin = text_.find_first_not_of(blanks);
    text_ = begin == std::string_view::npos ? std::string_view() : text_.substr(begin);
    return text_.substr(0, text_.find_first_of(blanks));
  }
  std::string_view next() {
    const std::string_view word = peek();
    text_ = text_.substr(word.size());
    return word;
  }
  bool parse(double& value) {
    // Not strtod, whose decimal point depends on the user's locale.
    std::istringstream in{std::string(peek())};
    in.imbue(std::locale::classic());
    if (!(in >> value) || !(in >> std::ws).eof()) return false;
    static_cast<void>(next());
    return true;
  }
  template <class Words>
  void choose(auto& value, Words words) {
    if (try_choice(value, words)) return;
    std::string expected;
    for (const auto& [each, word] : words) expected += (expected.empty() ? "" : ", ") + std::string(word);
    fail("one of " + expected);
  }
  template <class Words>
  bool try_choice(auto& value, Words words) {
    for (const auto& [each, word] : words)
      if (peek() == word) {
        value = each;
        static_cast<void>(next());
        return true;
      }
    return false;
  }
  void fail(const std::string& expected) {
    if (!error_.empty()) return;
    const std::string_view found = peek();
    error_ = (found.empty() ? "the line ends" : "'" + std::string(found) + "' stands") + " where " + expected +
             " was expected";
  }

  std::string_view text_;
  std::string error_;
};

/// Lists the arguments of an action: words to choose from, or what stands there in capitals.
class ArgumentLister {
 public:
  explicit ArgumentLister(std::string_view word) : line_(word) {}
  [[nodiscard]] std::string take() { return std::move(line_); }

  void operator()(const int& /*value*/) { add("INTEGER"); }
  void operator()(const double& /*value*/, Number = Number::finite) { add("NUMBER"); }
  void operator()(const std::string& /*text*/) { add("TEXT"); }
  void operator()(const std::string& /*path*/, FilePath) { add("FILE"); }
  void operator()(const bool& /*value*/, Either words) { add(fmt::format("{}|{}", words.yes, words.no)); }
  void operator()(const bool& /*value*/, Flag flag) { add(fmt::format("[{}]", flag.word)); }
  void operator()(const Line& /*value*/) { add("LINE"); }
  void operator()(const std::optional<Line>& /*value*/) { add("LINE|none"); }
  template <Worded E>
  void operator()(const E& /*value*/) {
    add(choices<E>());
  }
  template <Worded E>
  void operator()(const std::optional<E>& /*value*/) {
    add("[" + choices<E>() + "]");
  }
  template <class Value>
  void operator()(const Value&, Unwritten) {}
  template <class Value>
    requires(std::is_class_v<Value> && !Worded<Value>)
  void operator()(const Value& value) {
    each_field(*this, value);
  }

 private:
  template <Worded E>
  static std::string choices() {
    std::string all;
    for (const auto& [each, word] : words_of<E>) all += (all.empty() ? "" : "|") + std::string(word);
    return all;
  }
  void add(std::string_view argument) { line_.append(" ").append(argument); }

  std::string line_;
};

std::string_view trimmed(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = line.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
}

tl::unexpected<Error> wrong(std::string message, std::string hint) {
  return tl::unexpected(Error{{}, 0, 0, std::move(message), std::move(hint)});
}

template <class A>
Action read_fields(ActionReader& reader) {
  A value{};
  each_field(reader, value);
  return value;
}

template <class A>
std::string list_fields() {
  ArgumentLister lister(word_of<A>());
  const A value{};
  each_field(lister, value);
  return lister.take();
}

/// Reads an action, by its word.
struct ActionRow {
  std::string_view word;  ///< "": it cannot be written
  Action (*read)(ActionReader& reader);
  std::string (*list)();
};
template <class Actions = std::make_index_sequence<std::variant_size_v<Action>>>
struct ActionTable;
template <std::size_t... Is>
struct ActionTable<std::index_sequence<Is...>> {
  static constexpr std::array rows{ActionRow{word_of<std::variant_alternative_t<Is, Action>>(),
                                             &read_fields<std::variant_alternative_t<Is, Action>>,
                                             &list_fields<std::variant_alternative_t<Is, Action>>}...};
};

}  // namespace

std::string write_action(const Action& action) {
  return std::visit(
      []<class A>(const A& each) {
        if (word_of<A>().empty()) return std::string();
        ActionWriter writer(word_of<A>());
        each_field(writer, each);
        return writer.take();
      },
      action);
}

Result<Action> parse_action(std::string_view line) {
  const std::string_view whole = trimmed(line);
  const std::string_view word = whole.substr(0, whole.find_first_of(" \t"));
  const auto& rows = ActionTable<>::rows;
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const ActionRow& r) { return r.word == word; });
  if (word.empty() || row == rows.end())
    return wrong("'" + std::string(word) + "' is no action", "such as: step forward, press 120 80 left");
  ActionReader reader(whole.substr(word.size()));
  Action action = row->read(reader);
  if (const std::string error = reader.error(); !error.empty()) return wrong(std::string(word) + ": " + error, {});
  return action;
}

std::string demo_help() {
  std::vector<std::string> lines;
  for (const ActionRow& row : ActionTable<>::rows)
    if (!row.word.empty()) lines.push_back(row.list());
  std::sort(lines.begin(), lines.end());
  std::string text = fmt::format(
      "A demo file has an action a line; lines that begin with # say nothing. a|b: one of these words, [a]: may be\n"
      "left out, LINE: a line of the pseudocode by its number, 1 to {} and for path tracing to {}, FILE: a path,\n"
      "TEXT: the rest of the line. Places are in pixels of the plan.\n\n",
      line_count, line_count + path_line_count);
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

Result<std::vector<Action>> parse_demo(std::string_view text, const std::string& file_name) {
  std::vector<Action> actions;
  int number = 0;
  while (!text.empty()) {
    ++number;
    const std::string_view line = trimmed(text.substr(0, text.find('\n')));
    text = text.substr(std::min(text.size(), text.find('\n')) + (text.find('\n') == std::string_view::npos ? 0 : 1));
    if (line.empty() || line.front() == '#') continue;
    Result<Action> action = parse_action(line);
    if (!action) {
      Error error = action.error();
      error.file = file_name;
      error.line = number;
      return tl::unexpected(error);
    }
    actions.push_back(std::move(*action));
  }
  return actions;
}

}  // namespace raywalk
