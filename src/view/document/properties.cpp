#include "view/document/properties.h"

#include "scene/schema.h"
#include "view/action.h"
#include "view/state.h"
#include "view/text/shown.h"
#include "view/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>

namespace raywalk {

namespace {

/// The `Fields` of the schema that makes a row of each key that can have one.
class Describer {
 public:
  /// `table` names what is shown, for labels that differ from those of the same key elsewhere.
  Describer(PropertyRows& rows, std::string_view table) : rows_(rows), table_(table) {}

  /// Makes the rows of `value`. Whether it was changed to something that breaks no rule of the schema.
  template <class T>
  static bool changes(PropertyRows& rows, std::string_view table, T& value) {
    Describer describer(rows, table);
    schema::describe(describer, value);
    return describer.is_changed_ && describer.holds_;
  }
  /// The same of what stands in a table of that name.
  template <class T>
  static bool changes_inside(PropertyRows& rows, std::string_view table, T& value) {
    rows.enter(table);
    const bool now = changes(rows, table, value);
    rows.leave();
    return now;
  }

  void about(std::string_view /*sentence*/) {}
  template <class T, class Kind>
  void key(std::string_view name, T& value, const Kind& kind, std::string_view sentence) {
    is_changed_ |= row({table_, name, sentence}, kind, value);
  }
  template <class T, class Kind>
  void key(std::string_view name, std::optional<T>& value, const Kind& kind, std::string_view sentence) {
    const std::string set = std::string(name) + "_set";
    switch_on({table_, set, sentence}, value);
    if (value) key(name, *value, kind, sentence);
  }
  template <class T>
  void key(std::string_view name, std::optional<T>& value, const schema::Table& /*kind*/) {
    if constexpr (requires { value->file; }) {
      // It is there with its file.
      std::string file = value ? value->file : std::string();
      if (rows_.file({table_, name}, file)) {
        is_changed_ = true;
        if (!value) value.emplace();
        value->file = file;
        value->pixels = nullptr;  // loaded with the change
        if (file.empty()) value.reset();
      }
    } else {
      switch_on({table_, name}, value);
    }
    if (!value) return;
    const std::string_view outer = std::exchange(table_, name);
    rows_.enter(name);
    schema::describe(*this, *value);
    rows_.leave();
    table_ = outer;
  }
  // The tables of a scene and of an object have rows of their own.
  template <class T>
  void key(std::string_view /*name*/, T& /*value*/, const schema::Table& /*kind*/) {}
  template <class T>
  void key(std::string_view /*name*/, T& /*value*/, const schema::Tables& /*kind*/) {}
  template <class T, class Kind, class... Sentence>
  void required(std::string_view name, T& value, const Kind& kind, const Sentence&... sentence) {
    key(name, value, kind, sentence...);
  }
  template <class... Kinds>
  void type(std::variant<Kinds...>& value, std::string_view sentence) {
    if constexpr (std::is_same_v<std::variant<Kinds...>, AnySky>) pick_kind(value, sentence);
    std::visit([&](auto& kind) { schema::describe(*this, kind); }, value);
  }
  template <class T>
  void together(std::optional<T>& value) {
    if (value) schema::describe(*this, *value);
  }
  void check(std::string_view /*key*/, bool holds, std::string_view message, std::string_view hint) {
    if (is_changed_ && !holds) breaks(message, hint);
  }
  template <class Why>
  void check(std::string_view /*key*/, const Why& why, std::string_view hint) {
    if (!is_changed_) return;
    if (const std::string message(why()); !message.empty()) breaks(message, hint);
  }
  template <class T>
  void left_out(std::string_view /*name*/, const T& /*value*/, const T& /*usual*/) {}
  void without(std::string_view /*name*/, std::string_view /*message*/, std::string_view /*hint*/) {}
  template <class T>
  void complete(const T& /*value*/) {}

 private:
  using Key = PropertyRows::Key;

  bool row(const Key& key, const schema::Number& kind, double& value) { return rows_.number(key, value, kind); }
  bool row(const Key& key, const schema::Whole& kind, int& value) { return rows_.whole(key, value, kind); }
  bool row(const Key& key, const schema::Flag& /*kind*/, bool& value) { return rows_.flag(key, value); }
  template <class T>
  bool row(const Key& key, const schema::Choice<T>& /*kind*/, T& value) {
    auto chosen = static_cast<std::size_t>(value);
    if (!rows_.choice(key, chosen, all_words<T>())) return false;
    value = static_cast<T>(chosen);
    return true;
  }
  bool row(const Key& key, const schema::Colour& kind, Rgbd& value) { return rows_.colour(key, value, kind); }
  template <class T>
  bool row(const Key& key, const schema::Tuple& kind, T& value) {
    std::array<double, 16> all{};
    std::size_t count = 0;
    schema::each_number(value, [&](double& number) { all[count++] = number; });
    if (!rows_.numbers(key, std::span(all.data(), count), kind)) return false;
    count = 0;
    schema::each_number(value, [&](double& number) { number = all[count++]; });
    if constexpr (std::is_same_v<T, Vec3d>)
      if (kind.is_direction) {
        if (const auto usable = schema::usable_direction(value))
          value = *usable;
        else
          breaks("expected " + kind.expected(), {});
      }
    return true;
  }
  template <class T>
  bool row(const Key& key, const schema::Rows& kind, std::vector<T>& value) {
    bool is_changed = false;
    int number = 0;
    for (T& each : value) is_changed |= row({key.table, key.name, key.sentence, ++number}, kind.row, each);
    return is_changed;
  }
  // What has no row: names, files, transforms, and the lists of a mesh.
  template <class Kind, class T>
  bool row(const Key& /*key*/, const Kind& /*kind*/, T& /*value*/) {
    return false;
  }

  /// One of the kinds that need no file, or the one that it is.
  void pick_kind(AnySky& value, std::string_view sentence) {
    std::vector<std::string_view> words;
    std::vector<AnySky> kinds;
    std::size_t chosen = 0;
    const auto offer = [&]<class Kind>(const Kind& kind) {
      const bool own = std::holds_alternative<Kind>(value);
      if constexpr (requires { kind.file; })
        if (!own) return;
      if (own) chosen = kinds.size();
      words.emplace_back(schema::type_name(kind));
      kinds.emplace_back(kind);
    };
    [&]<class... Kinds>(const std::variant<Kinds...>* /*all*/) { (offer(Kinds{}), ...); }(&value);
    if (!rows_.choice({table_, "type", sentence}, chosen, words)) return;
    is_changed_ = true;
    value = kinds[chosen];
  }

  /// A flag: whether there is a value.
  template <class T>
  void switch_on(const Key& key, std::optional<T>& value) {
    bool is_there = value.has_value();
    if (!rows_.flag(key, is_there)) return;
    is_changed_ = true;
    value.reset();
    if (is_there) value.emplace();
  }

  void breaks(std::string_view message, std::string_view hint) {
    holds_ = false;
    rows_.broken(message, hint);
  }

  PropertyRows& rows_;
  std::string_view table_;
  bool is_changed_ = false, holds_ = true;
};

enum class Owner { object, light, camera_and_scene };

/// A handle belongs to its object.
Owner owner_of(const Target& target) {
  switch (target.kind) {
    case TargetKind::object:
    case TargetKind::radius:
    case TargetKind::corner:
    case TargetKind::edge:
    case TargetKind::rotation:
      return Owner::object;
    case TargetKind::light:
    case TargetKind::light_radius:
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

std::optional<PropertyEdit> object_rows(const State& state, int index, PropertyRows& rows) {
  const Object& object = state.scene().objects[static_cast<std::size_t>(index)];
  std::optional<PropertyEdit> edit;
  if (std::string name = shown_name(state, object.name); rows.name(name))
    edit = action::Rename{{TargetKind::object, index}, name};
  ObjectShape shape = object.shape;
  if (std::visit([&](auto& s) { return Describer::changes(rows, schema::type_name(s), s); }, shape))
    edit = action::SetShape{index, shape};
  if (std::holds_alternative<Instance>(object.shape)) return edit;
  rows.heading("property.material");
  Material material = object.material;
  if (Describer::changes_inside(rows, "material", material)) edit = action::SetMaterial{index, material};
  return edit;
}

std::optional<PropertyEdit> light_rows(const State& state, int index, PropertyRows& rows) {
  std::optional<PropertyEdit> edit;
  Light light = state.scene().lights[static_cast<std::size_t>(index)];
  if (std::string name = shown_name(state, light.name); rows.name(name))
    edit = action::Rename{{TargetKind::light, index}, name};
  if (Describer::changes(rows, "light", light)) edit = action::SetLight{index, light};
  return edit;
}

std::optional<PropertyEdit> scene_rows(const State& state, PropertyRows& rows) {
  std::optional<PropertyEdit> edit;
  const Camera& before = state.scene().camera;
  Camera camera = before;
  const bool changed = Describer::changes(rows, "camera", camera),
             resized = Describer::changes_inside(rows, "screen", camera.screen);
  if (changed || resized) {
    // What is now stated begins as it was without; the picture's width is stated by the angle or by the screen.
    if (camera.focus && !before.focus) camera.focus = before.focus_distance();
    if (camera.screen.width && !before.screen.width) {
      camera.screen.width = before.screen_width();
      camera.fov.reset();
    } else if (!camera.screen.width && before.screen.width) {
      camera.fov = FieldOfView{2 * std::atan(before.half_extent()) * 180 / std::numbers::pi};
    }
    edit = action::SetCamera{camera};
  }
  rows.heading("scene.settings");
  Scene scene;  // of its own keys those that have rows; the rest may be large
  scene.background = state.scene().background;
  scene.ambient = state.scene().ambient;
  scene.sky = state.scene().sky;
  if (Describer::changes_inside(rows, "scene", scene))
    edit = action::SetSurroundings{scene.background, scene.ambient, scene.sky};
  TraceLimits limits = state.scene().limits;
  if (Describer::changes_inside(rows, "limits", limits)) edit = action::SetLimits{limits};
  return edit;
}

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

std::optional<PropertyEdit> property_rows(const State& state, const Target& target, PropertyRows& rows) {
  switch (owner_of(target)) {
    case Owner::object:
      return object_rows(state, target.index, rows);
    case Owner::light:
      return light_rows(state, target.index, rows);
    case Owner::camera_and_scene:
      break;
  }
  return scene_rows(state, rows);
}

}  // namespace raywalk
