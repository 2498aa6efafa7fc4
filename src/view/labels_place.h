#pragma once
// Where names stand in the plan. Included by the files of this folder that draw it, and by nobody else.

#include "view/painter.h"

#include <limits>
#include <string>
#include <vector>

namespace raywalk::detail {

/// A filled drawing of an object, and the box around it.
struct Body {
  DisplayItem item;
  Box box;
  Colour fill;
};

[[nodiscard]] std::vector<Body> drawn_bodies(const DisplayList& list);

/// A thing that wants its name beside it, or on it.
struct Labelled {
  std::string text;
  Vec2d at;            ///< middle of the thing, pixels
  Vec2d half;          ///< half its extent
  bool above = false;  ///< rather above than below
  Target body{};       ///< the filled drawing that the label may stand on, when it fits
  bool solid = false;  ///< no ray runs through the body, and so through letters on it
  bool wanted = true;  ///< shown wherever there is some room, also where it hides others
};

/// A name as it is set, in one line or two.
struct Lettering {
  std::vector<std::string> lines;
  Vec2d half;  ///< half its extent, pixels
};

/// The name in one line, and in two where it has a space to break it at.
[[nodiscard]] std::vector<Lettering> letterings(const std::string& text, double size);
void draw_letters(Painter& painter, const Vec2d& middle, const Lettering& letters, Colour colour);

struct LabelPlace {
  Vec2d at{0.0};  ///< its middle
  Lettering letters;
  bool on_body = false;
  double cost = std::numeric_limits<double>::infinity();  ///< pixels; the less the better
  double hidden = 0;  ///< of it what it covers and what covers it, 1: all of it; more where its line misleads

  [[nodiscard]] Box box() const { return {at - letters.half, at + letters.half}; }
};

/// Where there is room for none a name would only hide others, or seem to be theirs.
[[nodiscard]] bool is_shown(const Labelled& thing, const LabelPlace& place);

/// A place for each name, chosen with an eye to the others'.
[[nodiscard]] std::vector<LabelPlace> place_labels(const Painter& painter, const std::vector<Body>& bodies,
                                                   const std::vector<Labelled>& things);

/// The line from a name to its body, where it could be taken for another's or stands far from it; none needed else.
[[nodiscard]] std::optional<std::array<Vec2d, 2>> leader_of(const Painter& painter, const std::vector<Body>& bodies,
                                                            const Labelled& thing, const LabelPlace& place);

}  // namespace raywalk::detail
