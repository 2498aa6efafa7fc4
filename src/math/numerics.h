#pragma once

#include "math/words.h"

namespace raywalk {

/// How intersections are computed and rays spawned.
enum class Numerics {
  robust,  ///< error bounds, and exact arithmetic where they leave a doubt; a ray knows the surface it starts on
  naive,   ///< as textbooks give it, for study (shape/naive.h); a ray starts a fixed epsilon off the surface
};
template <>
inline constexpr Word<Numerics> words_of<Numerics>[] = {{Numerics::robust, "robust"}, {Numerics::naive, "naive"}};

/// How far off the surface naive rays start, along its normal, in scene units: what many tracers use. Too small in one
/// place of a scene and too large in another: no single number suits all.
inline constexpr double default_epsilon = 1e-4;

}  // namespace raywalk
