#include "view/document/keys.h"

#include "scene/schema.h"
#include "scene/schema_rows.h"
#include "text/toml_text.h"
#include "view/state.h"
#include "view/text/key_label.h"
#include "view/text/shown.h"
#include "view/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

namespace raywalk {

namespace {

/// A key that is to be given a value, and what came of it.
struct Wanted {
  std::string_view key, text;
  bool found = false, changed = false;
  std::string refused{}, hint{};
};

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return words;
    text.remove_prefix(begin);
    words.push_back(text.substr(0, text.find_first_of(" \t")));
    text.remove_prefix(words.back().size());
  }
}

std::optional<double> number_of(std::string_view word) {
  // As it is shown, too: with the language's decimal mark and a true minus sign.
  constexpr std::string_view minus = "\u2212";
  std::string points = word.starts_with(minus) ? "-" + std::string(word.substr(minus.size())) : std::string(word);
  std::replace(points.begin(), points.end(), ',', '.');
  const std::optional<double> number = toml_text::read_number(points);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::vector<double>> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view word : split(text)) {
    const auto number = number_of(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// A key of the table at work; of a list, a row of this number from 1.
struct Named {
  std::string_view name, sentence{};
  int row = 0;
};

/// What numbers a key takes.
struct Rules {
  const schema::Number& each;
  std::string expected;
  schema::Shorthand shorthand = schema::Shorthand::none;
  bool is_direction = false, is_whole = false;
};

/// The rows of keys, and the key that is to be set.
class KeyRows {
 public:
  KeyRows(Language language, std::string_view table, std::string prefix, std::vector<KeyText>* list, Wanted* wanted)
      : language_(language), table_(table), prefix_(std::move(prefix)), list_(list), wanted_(wanted) {}

 protected:
  [[nodiscard]] bool is_wanted(const Named& key) const { return wanted_ != nullptr && wanted_->key == path_of(key); }
  [[nodiscard]] std::size_t listed() const { return list_ != nullptr ? list_->size() : 0; }

  void refuse(std::string_view message, std::string_view hint) {
    if (!wanted_->refused.empty()) return;
    wanted_->refused = message, wanted_->hint = hint;
  }
  void refuse_if(std::string_view message, std::string_view hint) {
    if (!message.empty()) refuse(message, hint);
  }
  [[nodiscard]] bool has_changed() const { return wanted_ != nullptr && wanted_->changed; }

  /// Takes a key's value away, if that is what is wanted.
  bool is_taken_away(const Named& key, bool has_value) {
    if (!is_wanted(key) || !split(wanted_->text).empty()) return false;
    wanted_->found = true, wanted_->changed = has_value;
    return true;
  }

  /// A text, one of `words` where there are any: the one that is wanted.
  std::optional<std::string_view> word(const Named& key, std::string_view value, std::vector<std::string_view> words) {
    list(key, std::string(value), words);
    if (!is_wanted(key)) return std::nullopt;
    wanted_->found = true;
    const auto given = split(wanted_->text);
    const std::string_view text = given.empty() ? std::string_view() : given.front();
    const bool is_known = words.empty() || std::find(words.begin(), words.end(), text) != words.end();
    if (!is_known || given.size() > 1) {
      refuse(words.empty() ? "expected a word" : "expected " + schema::quoted_words(words), {});
      return std::nullopt;
    }
    wanted_->changed = true;
    return text;
  }
  std::optional<bool> flag(const Named& key, bool value) {
    const auto text = word(key, value ? on_or_off.yes : on_or_off.no, {on_or_off.yes, on_or_off.no});
    return text ? std::optional(*text == on_or_off.yes) : std::nullopt;
  }
  /// One of these words, by its index.
  std::optional<std::size_t> choice(const Named& key, std::string_view value, std::vector<std::string_view> words) {
    const auto text = word(key, value, words);
    return text ? std::optional<std::size_t>(std::find(words.begin(), words.end(), *text) - words.begin())
                : std::nullopt;
  }
  /// Numbers: changes them to those that are wanted, if they may be that.
  void numbers(const Named& key, std::span<double> values, const Rules& rules) {
    std::string shown;
    // One that is not finite is no limit, and no text.
    for (const double value : values)
      if (std::isfinite(value))
        shown += (shown.empty() ? "" : " ") + typeset_number(fmt::format("{:.6g}", value), language_);
    list(key, shown, {});
    if (!is_wanted(key)) return;
    wanted_->found = true;
    auto given = numbers_of(wanted_->text);
    if (!given) return refuse("expected numbers, with spaces between them", {});
    if (given->empty() && shown.empty()) return;
    if (rules.shorthand == schema::Shorthand::grey && given->size() == 1) given->resize(values.size(), given->front());
    if ((rules.shorthand == schema::Shorthand::flat || rules.is_direction) && given->size() + 1 == values.size())
      given->push_back(0);
    const std::string expected = "expected " + rules.expected;
    if (given->size() != values.size()) return refuse(expected, rules.each.hint);
    double square = 0;
    for (const double number : *given) {
      const auto why = rules.each.refusal(number);
      if (rules.is_whole && (why || number != std::floor(number))) return refuse(expected, {});
      if (why) return refuse("expected " + why->expected, why->hint);
      square += number * number;
    }
    if (rules.is_direction && square < 1 / (schema::max_magnitude * schema::max_magnitude))
      return refuse(expected, rules.each.hint);
    std::copy(given->begin(), given->end(), values.begin());
    wanted_->changed = true;
  }

  /// What follows is of the table that this key has; give it back to `leave`.
  struct Outer {
    std::string_view table;
    std::string prefix;
  };
  [[nodiscard]] Outer enter(std::string_view name) {
    return {std::exchange(table_, name), std::exchange(prefix_, path_of({name}) + ".")};
  }
  void leave(Outer outer) { table_ = outer.table, prefix_ = std::move(outer.prefix); }
  /// What was listed from there on has no value.
  void empty_from(std::size_t first) {
    for (std::size_t i = first; i < listed(); ++i) (*list_)[i].value.clear();
  }

 private:
  [[nodiscard]] std::string path_of(const Named& key) const {
    std::string path = prefix_ + std::string(key.name);
    return key.row == 0 ? path : fmt::format("{}.{}", path, key.row);
  }
  void list(const Named& key, std::string value, std::vector<std::string_view> words) {
    if (list_ == nullptr) return;
    const KeyLabel label(KeyLabel(table_, key.name, key.sentence), key.row);
    list_->push_back({path_of(key), label.words(language_), label.hint(language_), std::move(value), std::move(words)});
  }

  Language language_;
  std::string_view table_;
  std::string prefix_;
  std::vector<KeyText>* list_;
  Wanted* wanted_;
};

/// The `Fields` of the schema that lists each key whose value fits into a line, or gives one of them another value.
class KeyFields : public KeyRows, public schema::RowFields<KeyFields> {
 public:
  using KeyRows::KeyRows, schema::RowFields<KeyFields>::key;

  template <class T, class Kind>
  void key(std::string_view name, T& value, const Kind& kind, std::string_view sentence) {
    row({name, sentence}, kind, value);
  }
  template <class T, class Kind>
  void key(std::string_view name, std::optional<T>& value, const Kind& kind, std::string_view sentence) {
    const Named named{name, sentence};
    if (is_taken_away(named, value.has_value())) return value.reset();
    T one = value.value_or(T{});
    const std::size_t first = listed();
    row(named, kind, one);
    if (is_wanted(named) && has_changed()) value = one;
    if (!value) empty_from(first);
  }
  template <class T>
  void key(std::string_view name, std::optional<T>& value, const schema::Table& /*kind*/) {
    if constexpr (requires { value->file; }) {
      // It is there with its file.
      if (const auto file = word({name}, value ? std::string_view(value->file) : std::string_view(), {})) {
        if (file->empty())
          value.reset();
        else
          value = value.value_or(T{}), value->file = *file, value->pixels = nullptr;  // loaded with the change
      }
    } else if (const auto there = flag({name}, value.has_value())) {
      if (!*there) value.reset();
      if (*there && !value) value.emplace();
    }
    if (!value) return;
    Outer outer = enter(name);
    schema::describe(*this, *value);
    leave(std::move(outer));
  }
  template <class... Kinds>
  void type(std::variant<Kinds...>& value, std::string_view sentence) {
    if constexpr (std::is_same_v<std::variant<Kinds...>, AnySky>) pick_kind(value, sentence);
    std::visit([&](auto& kind) { schema::describe(*this, kind); }, value);
  }
  void check(std::string_view /*key*/, bool holds, std::string_view message, std::string_view hint) {
    if (has_changed() && !holds) refuse(message, hint);
  }
  template <class Why>
  void check(std::string_view /*key*/, const Why& why, std::string_view hint) {
    if (has_changed()) refuse_if(std::string(why()), hint);
  }

 private:
  void row(const Named& key, const schema::Number& kind, double& value) {
    numbers(key, {&value, 1}, {kind, kind.expected()});
  }
  void row(const Named& key, const schema::Whole& kind, int& value) {
    const schema::Number limits{
        .words = {}, .low = static_cast<double>(kind.low), .high = static_cast<double>(kind.high)};
    double number = value;
    numbers(key, {&number, 1}, {limits, kind.expected(), schema::Shorthand::none, false, true});
    value = static_cast<int>(number);
  }
  void row(const Named& key, const schema::Flag& /*kind*/, bool& value) { value = flag(key, value).value_or(value); }
  template <class T>
  void row(const Named& key, const schema::Choice<T>& /*kind*/, T& value) {
    if (const auto chosen = choice(key, name_of(value), all_words<T>())) value = static_cast<T>(*chosen);
  }
  template <class T>
  void row(const Named& key, const schema::Tuple& kind, T& value) {
    std::array<double, 16> all{};
    std::size_t count = 0;
    schema::each_number(value, [&](double& number) { all[count++] = number; });
    numbers(key, std::span(all.data(), count), {kind.number, kind.expected(), kind.shorthand, kind.is_direction});
    count = 0;
    schema::each_number(value, [&](double& number) { number = all[count++]; });
  }
  void row(const Named& key, const schema::Colour& kind, Rgbd& value) {
    row(key, static_cast<const schema::Tuple&>(kind), value);
  }
  template <class T>
  void row(const Named& key, const schema::Rows& kind, std::vector<T>& value) {
    constexpr std::size_t most = 100;  // of what is listed
    for (std::size_t i = 0; i < std::min(value.size(), most); ++i)
      row(Named{key.name, key.sentence, static_cast<int>(i) + 1}, kind.row, value[i]);
  }
  // What does not fit into a line: names, which have an action of their own, files, transforms, the lists of a mesh.
  template <class Kind, class T>
  void row(const Named& /*key*/, const Kind& /*kind*/, T& /*value*/) {}

  /// One of the kinds that need no file, or the one that it is.
  void pick_kind(AnySky& value, std::string_view sentence) {
    std::vector<std::string_view> words;
    const std::vector<AnySky> kinds = schema::kinds_beside(value, words);
    const std::string_view own =
        std::visit([](const auto& kind) { return std::string_view(schema::type_name(kind)); }, value);
    const auto chosen = choice({"type", sentence}, own, words);
    if (chosen && kinds[*chosen].index() != value.index()) value = kinds[*chosen];
  }
};

/// Lists the keys of a thing, or gives one of them another value: then what does so.
class Keys {
 public:
  Keys(const State& state, std::vector<KeyText>* list, Wanted* wanted)
      : scene_(state.scene()), language_(state.appearance.language), list_(list), wanted_(wanted) {}

  std::optional<KeyEdit> of(const Target& target) {
    switch (owner_of(target)) {
      case Owner::object:
        return of_object(target.index);
      case Owner::light:
        return of_light(target.index);
      case Owner::camera_and_scene:
        return of_scene();
    }
    return std::nullopt;
  }

 private:
  template <class T>
  bool changes(std::string_view table, const std::string& prefix, T& value) {
    KeyFields fields(language_, table, prefix, list_, wanted_);
    if (wanted_ != nullptr && wanted_->found) return false;  // of a table before it
    schema::describe(fields, value);
    return wanted_ != nullptr && wanted_->found;
  }

  std::optional<KeyEdit> of_object(int index) {
    const Object& object = scene_.objects[static_cast<std::size_t>(index)];
    ObjectShape shape = object.shape;
    if (std::visit([&](auto& s) { return changes(schema::type_name(s), "", s); }, shape))
      return action::SetShape{index, shape};
    if (std::holds_alternative<Instance>(object.shape)) return std::nullopt;
    Material material = object.material;
    if (changes("material", "material.", material)) return action::SetMaterial{index, material};
    return std::nullopt;
  }

  std::optional<KeyEdit> of_light(int index) {
    Light light = scene_.lights[static_cast<std::size_t>(index)];
    if (changes("light", "", light)) return action::SetLight{index, light};
    return std::nullopt;
  }

  std::optional<KeyEdit> of_scene() {
    Camera camera = scene_.camera;
    if (changes("camera", "", camera) || changes("screen", "screen.", camera.screen))
      return action::SetCamera{with_one_width(camera)};
    Scene scene;  // of its own keys those that fit into a line; the rest may be large
    scene.background = scene_.background, scene.ambient = scene_.ambient, scene.sky = scene_.sky;
    if (changes("scene", "scene.", scene)) return action::SetSurroundings{scene.background, scene.ambient, scene.sky};
    TraceLimits limits = scene_.limits;
    if (changes("limits", "limits.", limits)) return action::SetLimits{limits};
    return std::nullopt;
  }

  /// The picture's width is stated by the angle or by the screen: what was stated last holds.
  [[nodiscard]] Camera with_one_width(Camera camera) const {
    const Camera& before = scene_.camera;
    if (camera.screen.width && !before.screen.width) camera.fov.reset();
    if (!camera.screen.width && before.screen.width)
      camera.fov = FieldOfView{2 * std::atan(before.half_extent()) * 180 / std::numbers::pi};
    return camera;
  }

  const Scene& scene_;
  Language language_;
  std::vector<KeyText>* list_;
  Wanted* wanted_;
};

}  // namespace

bool shows_properties(const State& state) {
  return state.walk.mode == Mode::move && state.plan.selected && exists(state, state.plan.selected) &&
         state.plan.selected.kind != TargetKind::ray;
}

std::string properties_title(const State& state) {
  const Target& target = state.plan.selected;
  const Language language = state.appearance.language;
  switch (owner_of(target)) {
    case Owner::object:
      return object_name(state, target.index);
    case Owner::light:
      return light_name(state, target.index);
    case Owner::camera_and_scene:
      break;
  }
  return fmt::format("{}, {}", text("object.eye", language), text("object.screen", language));
}

Owner owner_of(const Target& target) {
  switch (target.kind) {
    case TargetKind::object:
    case TargetKind::radius:
    case TargetKind::corner:
    case TargetKind::edge:
    case TargetKind::rotation:
      return Owner::object;
    case TargetKind::light:
      return Owner::light;
    case TargetKind::eye:
    case TargetKind::view_direction:
    case TargetKind::screen_height:
    case TargetKind::screen_distance:
    case TargetKind::cell:
    case TargetKind::ray:
    case TargetKind::nothing:
      break;
  }
  return Owner::camera_and_scene;
}

std::vector<KeyText> keys_of(const State& state, const Target& target) {
  std::vector<KeyText> list;
  static_cast<void>(Keys(state, &list, nullptr).of(target));
  return list;
}

Result<KeyEdit> edit_of_key(const State& state, const Target& target, std::string_view key, std::string_view value) {
  Wanted wanted{key, value};
  std::optional<KeyEdit> edit = Keys(state, nullptr, &wanted).of(target);
  if (!wanted.found || !edit) {
    std::string known;
    for (const KeyText& each : keys_of(state, target)) known += (known.empty() ? "" : ", ") + each.key;
    return tl::unexpected(Error{{}, 0, 0, fmt::format("there is no key '{}' here", key), "one of: " + known});
  }
  if (!wanted.refused.empty())
    return tl::unexpected(Error{{}, 0, 0, fmt::format("{}: {}", key, wanted.refused), wanted.hint});
  return std::move(*edit);
}

void action::SetKey::apply(State& state) const {
  const std::size_t gap = setting.find(' ');
  const std::string_view key = std::string_view(setting).substr(0, gap);
  const std::string_view value =
      gap == std::string::npos ? std::string_view() : std::string_view(setting).substr(gap + 1);
  if (!exists(state, target)) return;
  const Result<KeyEdit> edit = edit_of_key(state, target, key, value);
  if (!edit) return complain(state, edit.error().text());
  std::visit([&](const auto& each) { each.apply(state); }, *edit);
}

}  // namespace raywalk
