#pragma once
// The live equation: the arithmetic of the line that has just run, with the ray's numbers from the trace.

#include "view/state.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

struct EquationRow {
  enum class Kind {
    formula,  ///< symbolic
    numbers,  ///< the same with the ray's numbers
    note,     ///< an explanation
    term,     ///< of a sum of radiance, with its colour
    total,    ///< the sum of the terms, with its colour
  };
  Kind kind = Kind::formula;
  std::string text;
  std::vector<double> values{};  ///< the numbers in `text`, in order, unrounded
  std::optional<Rgbd> light{};   ///< of a term and of the total: linear
};

struct EquationPanel {
  std::string title;  ///< the line of pseudocode, as the panel of code shows it
  std::vector<EquationRow> rows;
};

/// At position 0 there are no rows.
[[nodiscard]] EquationPanel equation_panel(const State& state);

/// A number in the format of the panel: four significant digits.
[[nodiscard]] std::string equation_number(double value, Language language);

/// Of the angle that has this cosine, which rounding may have put beyond 1.
[[nodiscard]] double angle_of_cosine(double cosine);

/// The notes beside the hit of the current ray: its t, its angle to the normal. Empty before the hit is known.
struct HitNotes {
  std::string t;      ///< "t = 4.213"
  std::string angle;  ///< of a ray that hit a surface: "θ = 31.2°"
};
[[nodiscard]] HitNotes hit_notes(const State& state);

/// The notes where a reflect or refract ray has just been formed: the angles of both rays to the normal, in degrees.
/// Those of a refract ray come from the trace's own Snell's law. Of a ray that total internal reflection does not let
/// out only the first.
struct BendNotes {
  Vec3d at{0.0};                    ///< in the scene
  Vec3d normal{0.0};                ///< that the hit was shaded with: facing the ray, unless it is fixed
  Vec3d back{0.0}, out{0.0};        ///< unit directions: back along the ray, and of the new ray
  double in_length = 0;             ///< of the ray that was bent, in scene units
  double out_length = 0;            ///< of the new one, also where it is yet to be found; infinite if it has no end
  std::string angle_in, angle_out;  ///< "θ₁ = 45.4°"; empty: there is none
};
[[nodiscard]] std::optional<BendNotes> bend_notes(const State& state);

}  // namespace raywalk
