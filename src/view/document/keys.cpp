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
#include <cmath>
#include <numbers>
#include <optional>
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

/// The `Fields` of the schema that lists each key whose value fits into a line, or gives one of them another value.
class KeyFields : public schema::RowFields<KeyFields> {
 public:
  using schema::RowFields<KeyFields>::key;

  KeyFields(Language language, std::string_view table, std::string prefix, std::vector<KeyText>* list, Wanted* wanted)
      : language_(language), table_(table), prefix_(std::move(prefix)), list_(list), wanted_(wanted) {}

  template <class T, class Kind>
  void key(std::string_view name, T& value, const Kind& kind, std::string_view sentence) {
    row({table_, name, sentence}, prefix_ + std::string(name), kind, value);
  }
  template <class T, class Kind>
  void key(std::string_view name, std::optional<T>& value, const Kind& kind, std::string_view sentence) {
    T one = value.value_or(T{});
    const std::string path = prefix_ + std::string(name);
    const bool is_asked_for = wanted_ != nullptr && wanted_->key == path;
    if (is_asked_for && split(wanted_->text).empty()) {
      wanted_->found = true, wanted_->changed = value.has_value();
      return value.reset();
    }
    const std::size_t before = list_ != nullptr ? list_->size() : 0;
    row({table_, name, sentence}, path, kind, one);
    if (is_asked_for && wanted_->found && wanted_->refused.empty()) {
      wanted_->changed |= !value;
      value = one;
    }
    if (list_ != nullptr && !value)
      for (std::size_t i = before; i < list_->size(); ++i) (*list_)[i].value.clear();
  }
  template <class T>
  void key(std::string_view name, std::optional<T>& value, const schema::Table& /*kind*/) {
    const std::string path = prefix_ + std::string(name);
    const auto is_there = [&](bool there) {
      if (!there) value.reset();
      if (there && !value) value.emplace();
    };
    if constexpr (requires { value->file; }) {
      // It is there with its file.
      word({table_, name, {}}, path, value ? value->file : std::string(), {}, [&](std::string_view file) {
        is_there(!file.empty());
        if (value) value->file = file, value->pixels = nullptr;  // loaded with the change
        return true;
      });
    } else {
      flag({table_, name, {}}, path, value.has_value(), is_there);
    }
    if (!value) return;
    const std::string_view outer = std::exchange(table_, name);
    const std::string outer_prefix = std::exchange(prefix_, path + ".");
    schema::describe(*this, *value);
    table_ = outer, prefix_ = outer_prefix;
  }
  template <class... Kinds>
  void type(std::variant<Kinds...>& value, std::string_view sentence) {
    if constexpr (std::is_same_v<std::variant<Kinds...>, AnySky>) pick_kind(value, sentence);
    std::visit([&](auto& kind) { schema::describe(*this, kind); }, value);
  }
  void check(std::string_view /*key*/, bool holds, std::string_view message, std::string_view hint) {
    if (wanted_ != nullptr && wanted_->changed && !holds) refuse(message, hint);
  }
  template <class Why>
  void check(std::string_view /*key*/, const Why& why, std::string_view hint) {
    if (wanted_ == nullptr || !wanted_->changed) return;
    if (const std::string message(why()); !message.empty()) refuse(message, hint);
  }

 private:
  void refuse(std::string_view message, std::string_view hint) {
    if (!wanted_->refused.empty()) return;
    wanted_->refused = message, wanted_->hint = hint;
  }

  /// A text. `take`: whether it may be that.
  template <class Take>
  void word(const KeyLabel& label, const std::string& path, std::string value, std::vector<std::string_view> words,
            const Take& take) {
    if (list_ != nullptr)
      list_->push_back({path, label.words(language_), label.hint(language_), std::move(value), std::move(words)});
    if (wanted_ == nullptr || wanted_->key != path) return;
    wanted_->found = true;
    const auto given = split(wanted_->text);
    const std::string_view text = given.empty() ? std::string_view() : given.front();
    const bool is_known = words.empty() || std::find(words.begin(), words.end(), text) != words.end();
    if (!is_known || given.size() > 1 || !take(text))
      return refuse(fmt::format("expected {}", words.empty() ? "a word" : schema::quoted_words(words)), {});
    wanted_->changed = true;
  }
  template <class Take>
  void flag(const KeyLabel& label, const std::string& path, bool value, const Take& take) {
    const std::string_view yes = on_or_off.yes, no = on_or_off.no;
    word(label, path, std::string(value ? yes : no), {yes, no}, [&](std::string_view text) {
      take(text == yes);
      return true;
    });
  }
  /// Numbers. `take`: gives them, or says what was expected.
  template <class Take>
  void numbers(const KeyLabel& label, const std::string& path, const std::vector<double>& values, const Take& take) {
    if (list_ != nullptr) {
      std::string text;
      for (const double value : values)
        text += (text.empty() ? "" : " ") + typeset_number(fmt::format("{:.6g}", value), language_);
      list_->push_back({path, label.words(language_), label.hint(language_), text});
    }
    if (wanted_ == nullptr || wanted_->key != path) return;
    wanted_->found = true;
    const auto given = numbers_of(wanted_->text);
    if (!given) return refuse("expected numbers, with spaces between them", {});
    if (const std::optional<schema::Refusal> why = take(*given)) return refuse("expected " + why->expected, why->hint);
    wanted_->changed = true;
  }

  void row(const KeyLabel& label, const std::string& path, const schema::Number& kind, double& value) {
    const bool is_bounded = std::isfinite(value);
    const std::vector<double> now = is_bounded ? std::vector{value} : std::vector<double>{};
    numbers(label, path, now, [&](const std::vector<double>& given) -> std::optional<schema::Refusal> {
      if (given.empty() && !is_bounded) return std::nullopt;
      if (given.size() != 1) return schema::Refusal{kind.expected(), std::string(kind.hint)};
      value = given.front();
      return kind.refusal(value);
    });
  }
  void row(const KeyLabel& label, const std::string& path, const schema::Whole& kind, int& value) {
    numbers(label, path, {static_cast<double>(value)},
            [&](const std::vector<double>& given) -> std::optional<schema::Refusal> {
              if (given.size() != 1 || given.front() != std::floor(given.front()) || given.front() < kind.low ||
                  given.front() > kind.high)
                return schema::Refusal{kind.expected(), {}};
              value = static_cast<int>(given.front());
              return std::nullopt;
            });
  }
  void row(const KeyLabel& label, const std::string& path, const schema::Flag& /*kind*/, bool& value) {
    flag(label, path, value, [&](bool now) { value = now; });
  }
  template <class T>
  void row(const KeyLabel& label, const std::string& path, const schema::Choice<T>& /*kind*/, T& value) {
    word(label, path, std::string(name_of(value)), all_words<T>(), [&](std::string_view text) {
      const std::vector<std::string_view> words = all_words<T>();
      value = static_cast<T>(std::find(words.begin(), words.end(), text) - words.begin());
      return true;
    });
  }
  template <class T>
  void row(const KeyLabel& label, const std::string& path, const schema::Tuple& kind, T& value) {
    std::vector<double> now;
    schema::each_number(value, [&](double& number) { now.push_back(number); });
    numbers(label, path, now, [&](std::vector<double> given) -> std::optional<schema::Refusal> {
      const schema::Refusal refusal{kind.expected(), std::string(kind.number.hint)};
      if (kind.shorthand == schema::Shorthand::grey && given.size() == 1) given.resize(now.size(), given.front());
      if ((kind.shorthand == schema::Shorthand::flat || kind.is_direction) && given.size() + 1 == now.size())
        given.push_back(0);
      if (given.size() != now.size()) return refusal;
      for (const double number : given)
        if (auto why = kind.number.refusal(number)) return why;
      std::size_t next = 0;
      schema::each_number(value, [&](double& number) { number = given[next++]; });
      if constexpr (std::is_same_v<T, Vec3d>)
        if (kind.is_direction && length(value) < 1 / schema::max_magnitude) return refusal;
      return std::nullopt;
    });
  }
  void row(const KeyLabel& label, const std::string& path, const schema::Colour& kind, Rgbd& value) {
    row(label, path, static_cast<const schema::Tuple&>(kind), value);
  }
  template <class T>
  void row(const KeyLabel& label, const std::string& path, const schema::Rows& kind, std::vector<T>& value) {
    constexpr std::size_t most = 100;  // of what is listed
    for (std::size_t i = 0; i < std::min(value.size(), most); ++i)
      row({label, static_cast<int>(i) + 1}, fmt::format("{}.{}", path, i + 1), kind.row, value[i]);
  }
  // What does not fit into a line: names, which have an action of their own, files, transforms, the lists of a mesh.
  template <class Kind, class T>
  void row(const KeyLabel& /*label*/, const std::string& /*path*/, const Kind& /*kind*/, T& /*value*/) {}

  /// One of the kinds that need no file, or the one that it is.
  void pick_kind(AnySky& value, std::string_view sentence) {
    std::vector<std::string_view> words;
    const std::vector<AnySky> kinds = schema::kinds_beside(value, words);
    const auto own = std::visit([](const auto& kind) { return std::string(schema::type_name(kind)); }, value);
    word({table_, "type", sentence}, prefix_ + "type", own, words, [&](std::string_view text) {
      const auto at = static_cast<std::size_t>(std::find(words.begin(), words.end(), text) - words.begin());
      if (kinds[at].index() != value.index()) value = kinds[at];
      return true;
    });
  }

  Language language_;
  std::string_view table_;
  std::string prefix_;
  std::vector<KeyText>* list_;
  Wanted* wanted_;
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
