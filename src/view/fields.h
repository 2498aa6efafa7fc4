#pragma once
// What an action is made of (view/action.h): its word, its fields, its traits. Each stands once, in the struct; demo
// files, the check for finite numbers and the random test visit the fields:
//
//     struct Zoom {
//       static constexpr std::string_view word = "zoom";
//       Vec2d at;
//       double factor;
//       static void fields(auto& f, auto& a) { f(a.at), f(a.factor, Number::positive); }
//       static constexpr Traits traits{.keeps_drag = true};
//       void apply(State& state) const;
//     };
//
// No word: it has no text form. No fields: it has none. No traits: those of Traits{}. A short one does it in place,
// `void apply(auto& state) const { state.band.shown = on; }`, or `commit(state, ...)` to change the scene: State is not
// complete here, and a template waits until it is, and until view/document/document.h is known.

#include "math/vec.h"
#include "math/words.h"
#include "render/heat.h"
#include "scene/scene.h"
#include "study/workbench.h"

#include <string_view>
#include <type_traits>

namespace raywalk {

struct State;

/// A list of types.
template <class... Ts>
struct Types {};

/// What an action leaves as it is, and when it has an effect.
struct Traits {
  bool keeps_drag = false;          ///< else it ends a drag
  bool keeps_tween = false;         ///< else it ends a tween
  bool always = false;              ///< also while a question or a path prompt is open
  bool answers_question = false;    ///< while a question is open
  bool answers_prompt = false;      ///< while a path prompt is open
  bool postpones_recovery = false;  ///< while it is asked whether to recover an autosave: asks at the next start
  bool of_own_scene = false;        ///< concerns the user's own scene: ends a bug hunt first
};

template <class A>
[[nodiscard]] constexpr Traits traits_of(const A& action) {
  if constexpr (requires { action.traits(); })
    return action.traits();
  else if constexpr (requires { A::traits; })
    return A::traits;
  else
    return {};
}

template <class A>
[[nodiscard]] constexpr std::string_view word_of() {
  if constexpr (requires { A::word; })
    return A::word;
  else
    return {};
}

// How a field is written or checked, where its type does not say: the second argument of `f`.

/// A bool as one of two words.
struct Either {
  std::string_view yes, no;
};
inline constexpr Either on_or_off{"on", "off"}, forward_or_back{"forward", "back"}, float_or_double{"float", "double"};
/// A bool as a word that is there or not.
struct Flag {
  std::string_view word;
};
/// Whether a number that is not finite makes the action void: `any` does not.
enum class Number { finite, positive, not_negative, any };
/// The path of a file to read or write.
struct FilePath {};
/// Not part of the text form, and checked by the rules of the scene format: a whole material or shape.
struct Unwritten {};

/// Visits the fields of an action, or of a value that is made of several.
template <class F, class A>
void each_field(F& f, A& a) {
  if constexpr (requires { std::remove_const_t<A>::fields(f, a); }) std::remove_const_t<A>::fields(f, a);
}
template <class F, class V>
  requires std::is_same_v<std::remove_const_t<V>, Vec2d>
void each_field(F& f, V& v) {
  f(v.x), f(v.y);
}
template <class F, class S>
  requires std::is_same_v<std::remove_const_t<S>, ImageSize>
void each_field(F& f, S& size) {
  f(size.width), f(size.height);
}
template <class F, class S>
  requires std::is_same_v<std::remove_const_t<S>, study::Setup>
void each_field(F& f, S& s) {
  f(s.samples), f(s.sampler), f(s.light_grid), f(s.depth), f(s.threshold), f(s.single_precision, float_or_double);
  f(s.accelerator), f(s.tolerance), f(s.numerics), f(s.epsilon);
}

}  // namespace raywalk
