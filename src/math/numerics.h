#pragma once

#include <array>
#include <string_view>

namespace raywalk {

/// How crossings are computed and surfaces left.
enum class Numerics {
  robust,  ///< error bounds, and exact arithmetic where they leave a doubt; a ray knows the surface that it leaves
  naive,   ///< as books print it, to be studied (shape/naive.h); a ray leaves a surface by a fixed epsilon
};
inline constexpr std::array all_numerics{Numerics::robust, Numerics::naive};

[[nodiscard]] constexpr std::string_view numerics_name(Numerics numerics) {
  switch (numerics) {
    case Numerics::robust:
      return "robust";
    case Numerics::naive:
      return "naive";
  }
  return "";
}

/// How far naive rays start from the surface that they leave, along its normal, in scene units: what many tracers take.
/// Too little at one place of a scene and too much at another: no such number is right for all.
inline constexpr double usual_epsilon = 1e-4;

}  // namespace raywalk
