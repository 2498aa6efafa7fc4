#pragma once
// The placement of names in the plan. Included only by the files of this folder that draw it.

#include "view/plan/painter.h"

#include <limits>
#include <string>
#include <vector>

namespace raywalk {

/// A filled drawing of an object, and the box around it.
struct DrawnBody {
  DisplayItem item;
  PixelRect box;
  Colour fill;
};

[[nodiscard]] std::vector<DrawnBody> drawn_bodies(const DisplayList& list);

/// A thing with a name to be placed on or beside it.
struct Labelled {
  std::string text;
  Vec2d at;                            ///< middle of the thing, pixels
  Vec2d half;                          ///< half its extent
  bool above = false;                  ///< preferably above
  Target body{};                       ///< the filled drawing that the label may be placed on, if it fits
  bool solid = false;                  ///< no ray runs through the body, and through letters on it
  bool wanted = false;                 ///< shown even where it hides others
  std::optional<PolygonItem> strip{};  ///< what a leader leads to, if that is narrower than the extent
};

/// A typeset name, in one line or two.
struct NameLines {
  std::vector<std::string> lines;
  Vec2d half;  ///< half its extent, pixels
};

/// The name in one line, and in two if it has a space to break at.
[[nodiscard]] std::vector<NameLines> letterings(const std::string& text, double size);
void draw_letters(Painter& painter, const Vec2d& middle, const NameLines& letters, Colour colour,
                  std::optional<Colour> halo = {});

struct LabelPlace {
  Vec2d at{0.0};  ///< its middle
  NameLines letters;
  bool on_body = false;
  std::optional<std::array<Vec2d, 2>> leader{};           ///< from the name to its body, if ambiguous or far away
  double cost = std::numeric_limits<double>::infinity();  ///< in pixels; lower is better
  double blocked = 0;  ///< fraction outside of the pane, on symbols, on handles, or on other names
  double hidden = 0;   ///< fraction covered or covering, 1: all of it; more if its line misleads

  [[nodiscard]] PixelRect box() const { return {at - letters.half, at + letters.half}; }
};

/// False if there is no room: the name would lie over another or over a symbol, or seem to be that of another thing.
[[nodiscard]] bool is_shown(const Labelled& thing, const LabelPlace& place);

/// A place for each name, chosen jointly.
[[nodiscard]] std::vector<LabelPlace> place_labels(const Painter& painter, const std::vector<DrawnBody>& bodies,
                                                   const std::vector<Labelled>& things);

}  // namespace raywalk
