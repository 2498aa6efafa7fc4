#pragma once
// The live equation: the arithmetic of the line that has just run, with this ray's numbers in it, as the trace has
// them.

#include "view/state.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

struct EquationRow {
  enum class Kind {
    formula,  ///< letters only: what is computed
    numbers,  ///< the same with this ray's numbers
    note,     ///< why, in words
    term,     ///< of a sum of light, with its colour
    total,    ///< what the terms come to, with its colour
  };
  Kind kind = Kind::formula;
  std::string text;
  std::vector<double> values{};  ///< the numbers that stand in `text`, in their order, unrounded
  std::optional<Rgbd> light{};   ///< of a term and of the total: linear
};

struct EquationPanel {
  std::string title;  ///< the line of pseudocode
  std::vector<EquationRow> rows;
};

/// At position 0 there are no rows.
[[nodiscard]] EquationPanel equation_panel(const State& state);

/// A number as the panel writes it: four significant digits.
[[nodiscard]] std::string equation_number(double value, Language language);

/// What stands beside the hit of the ray in hand: its t, its angle to the normal. Empty before the hit is known.
struct HitNotes {
  std::string t;      ///< "t = 4.213"
  std::string angle;  ///< of a ray that met a surface: "θ = 31.2°"
};
[[nodiscard]] HitNotes hit_notes(const State& state);

/// What stands beside the place where a reflect or refract ray has just been formed: the angles of both rays to the
/// normal there, degrees. The angles of a refract ray are those of the trace's own law of Snell.
struct BendNotes {
  Vec3d at{0.0};                    ///< in the scene
  Vec3d normal{0.0};                ///< unit length, on the side that the ray came from
  Vec3d back{0.0}, out{0.0};        ///< unit directions: to where the ray came from, and where it goes
  std::string angle_in, angle_out;  ///< "θ₁ = 45.4°"
};
[[nodiscard]] std::optional<BendNotes> bend_notes(const State& state);

}  // namespace raywalk
