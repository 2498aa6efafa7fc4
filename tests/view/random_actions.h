// Random actions of every kind: their fields are visited, so that a new action is drawn without a word here.
#pragma once

#include "fixtures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace raywalk::test {

/// Many of them make no sense where they come. Paths are in `folder`.
class RandomActions {
 public:
  RandomActions(unsigned seed, std::string folder) : engine_(seed), folder_(std::move(folder)) {}

  /// Each kind of action in turn, in random order, and between them as many of the pointer; while something is asked,
  /// any of them.
  Action next(const State& state) {
    state_ = &state;
    const bool asked = state.document.question || state.document.prompt != PathPrompt::none;
    // The light of patches would make every walk after it slow: random_test.cpp deals that one.
    static const std::vector<std::size_t> dealt =
        kinds_that([]<class A>(const A&) { return !std::is_same_v<A, action::SetLightWays>; });
    if (asked) return whole(0, 3) == 0 ? Action(action::CancelPrompt{}) : draw(dealt[index(dealt.size())]);
    if (flip()) return pointer();
    if (deck_.empty()) {
      deck_.resize(dealt.size());
      std::iota(deck_.begin(), deck_.end(), std::size_t{0});
      std::shuffle(deck_.begin(), deck_.end(), engine_);
    }
    const std::size_t kind = dealt[deck_.back()];
    deck_.pop_back();
    return draw(kind);
  }
  /// One of the edits that carry a whole value.
  Action next_edit(const State& state) {
    state_ = &state;
    static const std::vector<std::size_t> edits = kinds_that(
        []<class A>(const A&) { return requires(A a) { a.continues; } && !std::is_same_v<A, action::SetLightWays>; });
    return draw(edits[index(edits.size())]);
  }

  bool flip() { return whole(0, 1) == 1; }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }

  // The fields of actions.
  void operator()(int& value) {
    // Mostly about as many as the scene has of anything.
    const int reach = whole(0, 7);
    value = reach < 6 ? whole(-1, 6) : reach < 7 ? whole(-5, 60) : whole(-5, 3000);
  }
  void operator()(double& value, Number = Number::finite) {
    const int reach = whole(0, 3);
    value = reach < 2 ? real(-0.1, 1) : reach < 3 ? real(-6, 6) : real(-20, 1500);
  }
  void operator()(Vec2d& value) {
    const int reach = whole(0, 3);
    if (reach < 2) {
      value = pixels();
      return;
    }
    value = reach < 3 ? Vec2d(real(-1, 1), real(-1, 1)) : Vec2d(real(-6, 6), real(-6, 6));
  }
  void operator()(std::string& text) {
    text = one_of<std::string>({"", "Mirror", "Glass", "Name 1", "Name 2", "en", "pt", "xx", "01-ray-casting",
                                "05-refraction", "no such lesson"});
  }
  void operator()(std::string& path, FilePath) {
    path = one_of<std::string>({"", folder_ + "/scene.toml", folder_ + "/other.toml", folder_ + "/scene",
                                folder_ + "/none/scene.toml", folder_ + "/table.csv", folder_ + "/walk.svg",
                                folder_ + "/walk.txt", folder_ + "/walk.gif", folder_ + "/walk.png"});
  }
  void operator()(bool& value, Either) { value = flip(); }
  void operator()(bool& value, Flag) { value = flip(); }
  void operator()(Line& line) { line = static_cast<Line>(whole(0, all_lines_count - 1)); }
  template <Worded E>
  void operator()(E& value) {
    value = one_of<Word<E>>(std::span<const Word<E>>(words_of<E>)).first;
  }
  template <class Value>
  void operator()(std::optional<Value>& value) {
    value.reset();
    if (flip()) (*this)(value.emplace());
  }
  template <class Value>
    requires(std::is_class_v<Value> && !Worded<Value>)
  void operator()(Value& value) {
    each_field(*this, value);
  }

  // Whole values.
  void operator()(bool& value, Unwritten) { value = flip(); }
  void operator()(std::optional<int>& value, Unwritten) {
    value.reset();
    if (flip()) value = whole(-1, 12);
  }
  void operator()(Rgbd& colour, Unwritten) { colour = Rgbd(real(-0.1, 1)); }
  void operator()(std::optional<Sky>& sky, Unwritten) {
    sky.reset();
    if (flip()) return;
    sky = Sky{GradientSky{Rgbd(real(-0.1, 1)), Rgbd(real(0, 2))}, point(), real(-90, 400)};
    if (flip()) sky->kind = OvercastSky{Rgbd(real(-0.1, 2))};
  }
  void operator()(TraceLimits& limits, Unwritten) { limits = {whole(-1, 6), real(-0.1, 0.2)}; }
  void operator()(Material& material, Unwritten) {
    material.diffuse = Rgbd(real(-0.05, 1));
    material.reflection = Rgbd(flip() ? real(0, 1) : 0.0);
    material.transmission = Rgbd(flip() ? real(0, 1) : 0.0);
    material.ior = real(0.5, 2.5);
    material.dielectric = flip();
  }
  void operator()(ObjectShape& shape, Unwritten) {
    switch (whole(0, 2)) {
      case 0:
        shape = Sphere<double>{point(), real(-0.2, 2)};
        return;
      case 1:
        shape = Plane<double>{point(), point()};
        return;
      default:
        shape = Prism<double>{{plan(point()), plan(point()), plan(point()), plan(point())}, real(-0.1, 2)};
    }
  }
  void operator()(Light& light, Unwritten) {
    light = {"Any", Rgbd(real(-0.2, 2)), PointLight{point(), {1, 0, 0}}};
    if (flip()) light.kind = DirectionalLight{point()};
  }
  void operator()(Camera& camera, Unwritten) {
    camera = state_->scene().camera;
    camera.eye = point();
    if (flip()) camera.look_at = point();
    if (flip()) camera.screen.cells = whole(0, 40);
  }
  void operator()(Breakpoints& breakpoints, Unwritten) {
    if (flip()) breakpoints.depth = whole(-1, 9);
    if (flip()) breakpoints.pixel = whole(-1, 40);
    breakpoints.total_internal_reflection = flip();
    if (flip()) breakpoints.object = "Mirror";
  }

 private:
  double real(double low, double high) {
    // Now and then something that no window would send.
    if (whole(0, 199) == 0) return std::numeric_limits<double>::quiet_NaN();
    if (whole(0, 199) == 0) return std::numeric_limits<double>::infinity();
    if (whole(0, 199) == 0) return flip() ? 1e300 : -1e300;
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  std::size_t index(std::size_t size) { return std::uniform_int_distribution<std::size_t>(0, size - 1)(engine_); }
  template <class Value>
  Value one_of(std::span<const Value> values) {
    return values[index(values.size())];
  }
  template <class Value>
  Value one_of(std::initializer_list<Value> values) {
    return one_of(std::span<const Value>(values.begin(), values.size()));
  }
  Vec2d pixels() {
    if (flip()) {
      // Somewhere that can be taken hold of.
      Target there;
      each_field(*this, there);
      if (exists(*state_, there)) return pixels_of(*state_, there);
    }
    return {real(-20, 820), real(-20, 620)};
  }
  Vec3d point() { return {real(-6, 6), real(-6, 6), whole(0, 5) == 0 ? real(-1, 1) : 0.0}; }
  Action pointer() {
    action::Modifiers modifiers{whole(0, 3) == 0, whole(0, 5) == 0, false};
    switch (whole(0, 8)) {
      case 0:
      case 1:
      case 2:
      case 3:
        return action::PointerMoved{pixels(), modifiers};
      case 4:
      case 5:
      case 6:
        return action::PointerPressed{pixels(), static_cast<action::Button>(whole(0, 5) / 3), modifiers,
                                      whole(0, 4) == 0};
      default:
        return action::PointerReleased{pixels(), modifiers};
    }
  }

  template <class A>
  Action draw_one() {
    A action{};
    each_field(*this, action);
    return action;
  }
  Action draw(std::size_t kind) {
    return [&]<class... As>(Types<As...>) {
      using Draw = Action (RandomActions::*)();
      constexpr Draw all[] = {&RandomActions::draw_one<As>...};
      return (this->*all[kind])();
    }(AllActions());
  }
  template <class Test>
  static std::vector<std::size_t> kinds_that(Test test) {
    std::vector<std::size_t> kinds;
    [&]<class... As>(Types<As...>) {
      std::size_t kind = 0;
      ((test(As{}) ? kinds.push_back(kind++) : void(++kind)), ...);
    }(AllActions());
    return kinds;
  }

  std::mt19937 engine_;
  std::string folder_;
  std::vector<std::size_t> deck_;
  const State* state_ = nullptr;  ///< of the action that is being drawn
};

}  // namespace raywalk::test
