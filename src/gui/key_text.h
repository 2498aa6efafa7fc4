#pragma once
// What the keys of the list do, and the names of what is no single key: a family of view/text.h.

#include <string_view>

namespace raywalk {

enum class KeyText {
  // What a row of keys does, in their order.
  steps,
  rays,
  pixels,
  over,
  out,
  run,
  breaks,
  ends,
  auto_clear,
  speed,
  grain,
  modes,
  lessons,
  bugs,
  equation,
  tabs,
  cost,
  cost_views,
  cost_effects,
  microscope,
  numerics,
  structure,
  structure_steps,
  exchange,
  zoom,
  lines,
  ghosts,
  tweens,
  predict,
  turn,
  shift,
  approach,
  image,
  add,
  select,
  edit,
  undo,
  files,
  theme,
  language,
  scale,
  menus,
  arrows,
  while_dragging,
  wheel,
  mouse,
  escape,
  // The left side of the last ones.
  name_while_dragging,
  name_wheel,
  name_mouse,
};

[[nodiscard]] std::string_view english(KeyText id);
[[nodiscard]] std::string_view portuguese(KeyText id);

}  // namespace raywalk
