#include "view/action_text.h"

#include "text/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

namespace raywalk {

namespace {

/// What stands in a text for each kind of field that an action may have. The kinds are few, the actions many: each
/// action's fields are compiled for this class alone, and reading, writing and listing are three of it.
class Fields {
 public:
  void operator()(int& value) { whole(value); }
  void operator()(double& value, Number = Number::finite) { number(value); }
  void operator()(std::string& value) { text(value); }
  void operator()(std::string& value, FilePath) { path(value); }
  void operator()(bool& value, Either words) { either(value, words); }
  void operator()(bool& value, Flag word) { flag(value, word); }
  void operator()(Line& value) { line(value); }
  void operator()(std::optional<Line>& value) { maybe_line(value); }
  template <Worded E>
  void operator()(E& value) {
    std::optional<std::size_t> index = index_of(value);
    choice(word_array<E>, index, true);
    if (index) value = words_of<E>[*index].first;
  }
  template <Worded E>
  void operator()(std::optional<E>& value) {
    std::optional<std::size_t> index;
    if (value) index = index_of(*value);
    choice(word_array<E>, index, false);
    if (index) value = words_of<E>[*index].first;
  }
  template <class Value>
  void operator()(Value&, Unwritten) {}
  template <class Value>
    requires(std::is_class_v<Value> && !Worded<Value>)
  void operator()(Value& value) {
    each_field(*this, value);
  }

 protected:
  using Names = std::span<const std::string_view>;

  Fields() = default;
  Fields(const Fields&) = default;
  Fields& operator=(const Fields&) = default;
  ~Fields() = default;

 private:
  virtual void whole(int& value) = 0;
  virtual void number(double& value) = 0;
  virtual void text(std::string& value) = 0;
  virtual void path(std::string& value) = 0;
  virtual void either(bool& value, Either words) = 0;
  virtual void flag(bool& value, Flag word) = 0;
  virtual void line(Line& value) = 0;
  virtual void maybe_line(std::optional<Line>& value) = 0;
  /// One of these words, by its index; left out only where none is `needed`.
  virtual void choice(Names words, std::optional<std::size_t>& index, bool needed) = 0;
};

class ActionWriter final : public Fields {
 public:
  explicit ActionWriter(std::string_view word) : line_(word) {}
  [[nodiscard]] std::string take() { return std::move(line_); }

 private:
  void whole(int& value) override { add(fmt::format("{}", value)); }
  void number(double& value) override { add(fmt::format("{}", value)); }
  void text(std::string& value) override { add(value); }
  void path(std::string& value) override { add(value); }
  void either(bool& value, Either words) override { add(value ? words.yes : words.no); }
  void flag(bool& value, Flag word) override {
    if (value) add(word.word);
  }
  void line(Line& value) override { add(fmt::format("{}", static_cast<int>(value) + 1)); }
  void maybe_line(std::optional<Line>& value) override { value ? line(*value) : add("none"); }
  void choice(Names words, std::optional<std::size_t>& index, bool /*needed*/) override {
    if (index) add(words[*index]);
  }

  void add(std::string_view word) { line_.append(" ").append(word); }

  std::string line_;
};

class ActionReader final : public Fields {
 public:
  /// `text`: the line after the word.
  explicit ActionReader(std::string_view text) : text_(text) {}

  /// What was wrong; leftover text is an error too.
  [[nodiscard]] std::string error() {
    if (error_.empty() && !peek().empty()) fail("nothing more");
    return error_;
  }

 private:
  static constexpr std::string_view blanks = " \t\r";

  void whole(int& value) override {
    double found = 0;
    const std::string_view before = text_;
    if (!parse(found) || found != std::floor(found) || std::abs(found) > 1e9) {
      text_ = before;
      return fail("a whole number");
    }
    value = static_cast<int>(found);
  }
  void number(double& value) override {
    if (!parse(value)) fail("a number");
  }
  void text(std::string& value) override {
    static_cast<void>(peek());
    value = text_;
    text_ = {};
    if (value.empty()) fail("a text");
  }
  void path(std::string& value) override { text(value); }
  void either(bool& value, Either words) override {
    const std::string_view both[] = {words.yes, words.no};
    std::optional<std::size_t> index;
    choice(both, index, true);
    if (index) value = *index == 0;
  }
  void flag(bool& value, Flag word) override {
    value = peek() == word.word;
    if (value) static_cast<void>(next());
  }
  void line(Line& value) override {
    int row = 0;
    whole(row);
    if (row < 1 || row > all_lines_count) return fail(fmt::format("a line's number from 1 to {}", all_lines_count));
    value = static_cast<Line>(row - 1);
  }
  void maybe_line(std::optional<Line>& value) override {
    value.reset();
    if (peek() == "none") return static_cast<void>(next());
    line(value.emplace());
  }
  void choice(Names words, std::optional<std::size_t>& index, bool needed) override {
    index.reset();
    const auto found = std::find(words.begin(), words.end(), peek());
    if (found != words.end()) {
      index = static_cast<std::size_t>(found - words.begin());
      static_cast<void>(next());
    } else if (needed) {
      fail(fmt::format("one of {}", fmt::join(words, ", ")));
    }
  }

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
    const std::optional<double> number = toml_text::read_number(peek());
    if (!number || !std::isfinite(*number)) return false;
    value = *number;
    static_cast<void>(next());
    return true;
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
class ArgumentLister final : public Fields {
 public:
  explicit ArgumentLister(std::string_view word) : line_(word) {}
  [[nodiscard]] std::string take() { return std::move(line_); }

 private:
  void whole(int& /*value*/) override { add("INTEGER"); }
  void number(double& /*value*/) override { add("NUMBER"); }
  void text(std::string& /*value*/) override { add("TEXT"); }
  void path(std::string& /*value*/) override { add("FILE"); }
  void either(bool& /*value*/, Either words) override { add(fmt::format("{}|{}", words.yes, words.no)); }
  void flag(bool& /*value*/, Flag word) override { add(fmt::format("[{}]", word.word)); }
  void line(Line& /*value*/) override { add("LINE"); }
  void maybe_line(std::optional<Line>& /*value*/) override { add("LINE|none"); }
  void choice(Names words, std::optional<std::size_t>& /*index*/, bool needed) override {
    const std::string all = fmt::format("{}", fmt::join(words, "|"));
    add(needed ? all : "[" + all + "]");
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

/// What the text form knows of a kind of action.
struct ActionRow {
  std::string_view word;  ///< "": it cannot be written
  Action (*read)(Fields& reader);
  void (*show)(const Action* action, Fields& to);  ///< without an action: one that is as it comes
};
template <class A>
constexpr ActionRow row_of{word_of<A>(),
                           [](Fields& reader) {
                             A value{};
                             each_field(reader, value);
                             return Action(std::move(value));
                           },
                           [](const Action* action, Fields& to) {
                             A same = action != nullptr ? *action->as<A>() : A{};
                             each_field(to, same);
                           }};
constexpr auto action_rows = []<class... As>(Types<As...>) {
  return std::array<ActionRow, sizeof...(As)>{row_of<As>...};
}(AllActions());

}  // namespace

std::string write_action(const Action& action) {
  const ActionRow& row = action_rows[action.kind()];
  if (row.word.empty()) return {};
  ActionWriter writer(row.word);
  row.show(&action, writer);
  return writer.take();
}

Result<Action> parse_action(std::string_view line) {
  const std::string_view whole = trimmed(line);
  const std::string_view word = whole.substr(0, whole.find_first_of(" \t"));
  const auto row =
      std::find_if(action_rows.begin(), action_rows.end(), [&](const ActionRow& r) { return r.word == word; });
  if (word.empty() || row == action_rows.end())
    return wrong("'" + std::string(word) + "' is no action", "such as: step forward, press 120 80 left");
  ActionReader reader(whole.substr(word.size()));
  Action action = row->read(reader);
  if (const std::string error = reader.error(); !error.empty()) return wrong(std::string(word) + ": " + error, {});
  return action;
}

std::string demo_help() {
  std::vector<std::string> lines;
  for (const ActionRow& row : action_rows) {
    if (row.word.empty()) continue;
    ArgumentLister lister(row.word);
    row.show(nullptr, lister);
    lines.push_back(lister.take());
  }
  std::sort(lines.begin(), lines.end());
  std::string text = fmt::format(
      "A demo file has an action a line; lines that begin with # say nothing. a|b: one of these words, [a]: may be\n"
      "left out, LINE: a line of the pseudocode by its number: of rays 1 to {}, then those of paths, photons, "
      "radiosity,\n"
      "beams, cones and pencils, to {}, FILE: a path, TEXT: the rest of the line. Places are in pixels of the "
      "plan.\n\n",
      line_count, all_lines_count);
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
