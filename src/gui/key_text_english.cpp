// The list of keys in English.

#include "gui/key_text.h"

namespace raywalk {

std::string_view english(KeyText id) {
  switch (id) {
    case KeyText::steps:
      return "one step on \u00b7 back";
    case KeyText::rays:
      return "to the next ray \u00b7 the ray before";
    case KeyText::pixels:
      return "to the end of the pixel \u00b7 of the pixel before";
    case KeyText::over:
      return "over the SHADE that a line calls \u00b7 back over it";
    case KeyText::out:
      return "out of the SHADE under way \u00b7 back to before its call";
    case KeyText::run:
      return "on to the next breakpoint \u00b7 back to the one before";
    case KeyText::breaks:
      return "a breakpoint before the next line \u00b7 all breakpoints, and go to a step";
    case KeyText::ends:
      return "to the start \u00b7 to the end";
    case KeyText::auto_clear:
      return "AUTO, and pause \u00b7 CLEAR";
    case KeyText::speed:
      return "AUTO slower \u00b7 faster";
    case KeyText::grain:
      return "Trace: a step is a line \u00b7 a ray \u00b7 a pixel";
    case KeyText::modes:
      return "Move \u00b7 Trace \u00b7 Help";
    case KeyText::lessons:
      return "the lessons";
    case KeyText::bugs:
      return "spot the bug: the list \u00b7 a surprise \u00b7 this line is at fault \u00b7 the cure \u00b7 mended or "
             "not";
    case KeyText::equation:
      return "the live equation: the numbers of the line that has just run";
    case KeyText::tabs:
      return "3-D image \u00b7 ray tree \u00b7 stack \u00b7 legend";
    case KeyText::cost:
      return "Cost \u00b7 its knobs \u00b7 try \u00b7 try a ladder \u00b7 forget";
    case KeyText::cost_views:
      return "Cost: next as A \u00b7 as B \u00b7 split or difference \u00b7 against what \u00b7 the split left \u00b7 "
             "right";
    case KeyText::cost_effects:
      return "Cost: what each effect adds, or the tries";
    case KeyText::microscope:
      return "Microscope \u00b7 magnify \u00b7 less \u00b7 to single floats \u00b7 the whole scene";
    case KeyText::numerics:
      return "naive numerics \u00b7 robust ones \u00b7 float \u00b7 double";
    case KeyText::structure:
      return "Structure: BVH, grid, octree and kd-tree, step by step \u00b7 the next kind \u00b7 how it is built";
    case KeyText::structure_steps:
      return "Structure: next box \u00b7 back \u00b7 to the end \u00b7 to the start";
    case KeyText::exchange:
      return "the plan and the pane change places";
    case KeyText::zoom:
      return "fit the whole scene in \u00b7 zoom in \u00b7 out";
    case KeyText::lines:
      return "lines in space, and the plan \u00b7 from a pixel of the picture back to SCREEN";
    case KeyText::ghosts:
      return "the rays that depth and threshold cut off";
    case KeyText::tweens:
      return "rays that grow when they are formed, or stand there at once";
    case KeyText::predict:
      return "predict each ray before it is shown \u00b7 save the predictions";
    case KeyText::turn:
      return "the 3-D picture or the lines: turn left \u00b7 right \u00b7 up \u00b7 down";
    case KeyText::shift:
      return "the same: move left \u00b7 right \u00b7 up \u00b7 down";
    case KeyText::approach:
      return "the same: nearer \u00b7 farther \u00b7 as at first";
    case KeyText::image:
      return "3-D picture: its camera for the scene \u00b7 settings \u00b7 heat maps";
    case KeyText::add:
      return "Move: add a solid sphere \u00b7 a transparent sphere \u00b7 a polygon \u00b7 a light";
    case KeyText::select:
      return "Move: select the next thing \u00b7 the one before";
    case KeyText::edit:
      return "Move: type its numbers \u00b7 remove it";
    case KeyText::undo:
      return "undo \u00b7 redo";
    case KeyText::files:
      return "new \u00b7 open \u00b7 save \u00b7 save as \u00b7 export \u00b7 quit";
    case KeyText::theme:
      return "dark theme or the projector's";
    case KeyText::language:
      return "English or Portuguese";
    case KeyText::scale:
      return "letters larger \u00b7 smaller \u00b7 as at first";
    case KeyText::menus:
      return "the menus \u00b7 the full screen";
    case KeyText::arrows:
      return "Move: nudge what is selected; with Shift in larger steps";
    case KeyText::while_dragging:
      return "along one axis, round lengths and angles \u00b7 on the grid";
    case KeyText::wheel:
      return "zoom; drag the empty plan to move it";
    case KeyText::mouse:
      return "turn \u00b7 move \u00b7 walk the rays of that pixel";
    case KeyText::escape:
      return "takes a drag back, closes what is open, ends AUTO";
    case KeyText::name_while_dragging:
      return "Shift \u00b7 Ctrl, while dragging";
    case KeyText::name_wheel:
      return "mouse wheel";
    case KeyText::name_mouse:
      return "3-D: drag \u00b7 Shift or right button \u00b7 click";
  }
  return {};
}

}  // namespace raywalk
