// What the commands are called in English, and what they do.

#include "gui/command_text.h"
#include "view/text.h"

namespace raywalk {

CommandText english(Command command) {
  switch (command) {
    case Command::new_scene:
      return {english(TextId::menu_new), "start a new scene"};
    case Command::open:
      return {english(TextId::menu_open), "open a scene file"};
    case Command::save:
      return {english(TextId::menu_save), "write the scene to its file"};
    case Command::save_as:
      return {english(TextId::menu_save_as), "write the scene to another file"};
    case Command::quit:
      return {english(TextId::menu_quit), "close the window"};
    case Command::undo:
      return {english(TextId::button_undo), "take the last change back"};
    case Command::redo:
      return {english(TextId::button_redo), "make the change again that was taken back"};
    case Command::remove:
      return {english(TextId::button_remove), "remove what is selected"};
    case Command::deselect:
      return {english(TextId::button_close), "select nothing; back to the code"};
    case Command::select_next:
      return {"Select next", "select the next thing"};
    case Command::select_previous:
      return {"Select previous", "select the thing before"};
    case Command::edit_properties:
      return {english(TextId::properties), "type the numbers of what is selected; Tab goes from one to the next"};
    case Command::add_solid_sphere:
      return {english(TextId::solid_sphere), "add a solid sphere"};
    case Command::add_transparent_sphere:
      return {english(TextId::transparent_sphere), "add a transparent sphere"};
    case Command::add_polygon:
      return {english(TextId::polygon), "add a polygon"};
    case Command::add_light:
      return {english(TextId::light_source), "add a light source"};
    case Command::mode_move:
      return {english(TextId::mode_move), "arrange the scene: drag, add, change"};
    case Command::mode_trace:
      return {english(TextId::mode_trace), "walk the rays through the scene"};
    case Command::mode_help:
      return {english(TextId::mode_help), "read what everything is and does"};
    case Command::step:
      return {english(TextId::button_step), "one step on: a line, a ray or a pixel, as is chosen beside the speed"};
    case Command::step_back:
      return {english(TextId::button_back), "go one step back"};
    case Command::step_ray:
      return {"Next ray", "go on to where the next ray is formed"};
    case Command::step_ray_back:
      return {"Previous ray", "go back to where the ray before was formed"};
    case Command::step_pixel:
      return {"Next pixel", "go on until the pixel has its final shade"};
    case Command::step_pixel_back:
      return {"Previous pixel", "go back to where the pixel before had its final shade"};
    case Command::step_over:
      return {"Step over", "go one line on, and through all of the SHADE that it calls"};
    case Command::step_back_over:
      return {"Back over", "go one line back; from the end of a SHADE to before its call"};
    case Command::step_out:
      return {"Step out", "go on until the SHADE under way has returned"};
    case Command::step_back_out:
      return {"Back out", "go back to before the call of the SHADE under way"};
    case Command::run_on:
      return {"Run on", "go on to the next breakpoint, or to the end"};
    case Command::run_back:
      return {"Run back", "go back to the breakpoint before, or to the start"};
    case Command::break_here:
      return {"Breakpoint here", "let the walk come to rest before the line that runs next; once more: no longer"};
    case Command::breakpoints:
      return {"Breakpoints, go to step\u2026", "where the walk comes to rest, and a step to go to"};
    case Command::play:
      return {english(TextId::button_auto), "go on by itself; once more: pause. Minus and plus change its speed"};
    case Command::clear:
      return {english(TextId::button_clear), "wipe all rays and start over"};
    case Command::first:
      return {"To the start", "go to before the first step"};
    case Command::last:
      return {"To the end", "go to after the last step"};
    case Command::slower:
      return {"Slower", "halve the speed of AUTO"};
    case Command::faster:
      return {"Faster", "double the speed of AUTO"};
    case Command::grain_line:
      return {english(TextId::grain_line), "a step is one line of the code"};
    case Command::grain_ray:
      return {english(TextId::grain_ray), "a step goes on to the next ray"};
    case Command::grain_pixel:
      return {english(TextId::grain_pixel), "a step goes on to the next pixel"};
    case Command::tab_image:
      return {english(TextId::tab_image), "the picture that EYE sees"};
    case Command::tab_tree:
      return {english(TextId::tab_tree), "which ray led to which, for this pixel"};
    case Command::tab_stack:
      return {english(TextId::tab_stack), "the calls that wait for each other"};
    case Command::tab_legend:
      return {english(TextId::tab_legend), "what the lines and signs mean"};
    case Command::tab_cost:
      return {english(TextId::tab_cost), "settings tried against each other"};
    case Command::tab_equation:
      return {"Equation", "what the line has computed, with the numbers of this ray"};
    case Command::zoom_in:
      return {"Zoom in", "show less of the plan, larger"};
    case Command::zoom_out:
      return {"Zoom out", "show more of the plan, smaller"};
    case Command::fit:
      return {english(TextId::button_fit), "show the whole scene"};
    case Command::lines:
      return {"Lines in space", "show the scene as lines in space, or the plan again"};
    case Command::ghosts:
      return {"What was cut off", "rays that depth and threshold forbade"};
    case Command::tweens:
      return {"Rays in motion", "let each ray grow as it is formed, or show it at once"};
    case Command::predict:
      return {"Predict", "before each ray, an arrow where it will go or a click on what it will meet"};
    case Command::save_predictions:
      return {"Save predictions...", "write down all guesses of this sitting and how far off they were"};
    case Command::export_walk:
      return {"Export...", "write the walk as a picture, a film, slides or a transcript"};
    case Command::walk_strip:
      return {"Back to SCREEN", "walk the pixels of SCREEN again, in place of one of the picture"};
    case Command::reset_view:
      return {"Original view", "look from where it was looked from at first"};
    case Command::use_camera:
      return {"Use as the scene's camera", "put EYE where the picture is seen from now"};
    case Command::image_settings:
      return {"Settings", "how the picture is made, and heat maps of what it costs"};
    case Command::heat:
      return {"Heat map", "show what each pixel costs: rays, tests, time; then the picture again"};
    case Command::cost_knobs:
      return {"Knobs", "what the next try is made with"};
    case Command::cost_try:
      return {"Try", "trace it so, count the cost, measure the error"};
    case Command::cost_ladder:
      return {"Ladder", "try 1, 4, 16 and 64 samples"};
    case Command::cost_forget:
      return {"Forget", "forget everything that was tried"};
    case Command::cost_next:
      return {"Next as A", "show the next try as A"};
    case Command::cost_against:
      return {"Next as B", "compare with the next try"};
    case Command::cost_kind:
      return {"Split", "two pictures, or their difference"};
    case Command::cost_axis:
      return {"Rays", "error against rays, tests or time"};
    case Command::cost_split_left:
      return {"Split left", "move it left"};
    case Command::cost_split_right:
      return {"Split right", "move it right"};
    case Command::cost_page:
      return {"Effects", "what each effect adds, or the tries again"};
    case Command::tab_microscope:
      return {"Microscope", "a hit down to its last digits: what naive numerics make of it"};
    case Command::magnify:
      return {"Magnify", "look closer at the hit"};
    case Command::diminish:
      return {"Magnify less", "see more around the hit"};
    case Command::to_numbers:
      return {"To floats", "as close as numbers are"};
    case Command::to_scene:
      return {"To scene", "no magnification"};
    case Command::numerics_robust:
      return {"Robust", "the scene is traced with error bounds and exact arithmetic"};
    case Command::numerics_naive:
      return {"Naive", "the scene is traced as books print it, rays leaving surfaces by epsilon"};
    case Command::precision_double:
      return {"Double", "walk and picture in numbers of 53 bits"};
    case Command::precision_float:
      return {"Float", "walk and picture in numbers of 24 bits"};
    case Command::tab_structure:
      return {"Structure", "search for this ray box by box, and see what BVH, grid and trees spare"};
    case Command::structure_next:
      return {"Next box", "one step on in the search or the build"};
    case Command::structure_back:
      return {"Box before", "one step back in the search or the build"};
    case Command::structure_last:
      return {"Last box", "to the end of the search or the build"};
    case Command::structure_first:
      return {"First box", "to the start of the search or the build"};
    case Command::structure_kind:
      return {"Next structure", "search in the next kind of structure"};
    case Command::structure_page:
      return {"Search or build", "how the structure was built, or its search again"};
    case Command::turn_left:
      return {"Turn left", "turn the picture or the lines to the left"};
    case Command::turn_right:
      return {"Turn right", "turn the picture or the lines to the right"};
    case Command::turn_up:
      return {"Turn up", "turn the picture or the lines upwards"};
    case Command::turn_down:
      return {"Turn down", "turn the picture or the lines downwards"};
    case Command::shift_left:
      return {"Move left", "move the picture or the lines to the left"};
    case Command::shift_right:
      return {"Move right", "move the picture or the lines to the right"};
    case Command::shift_up:
      return {"Move up", "move the picture or the lines upwards"};
    case Command::shift_down:
      return {"Move down", "move the picture or the lines downwards"};
    case Command::approach:
      return {"Nearer", "come nearer"};
    case Command::recede:
      return {"Farther", "go farther away"};
    case Command::theme:
      return {english(TextId::theme), "dark, or light and large for a projector"};
    case Command::language:
      return {english(TextId::language), "speak the next language: English, Portugu\u00eas"};
    case Command::scale_up:
      return {"Larger", "make letters and buttons larger"};
    case Command::scale_down:
      return {"Smaller", "make letters and buttons smaller"};
    case Command::scale_reset:
      return {"Usual size", "letters and buttons as they were at first"};
    case Command::exchange:
      return {"Swap plan and pane", "let the plan and this pane change places"};
    case Command::full_screen:
      return {"Full screen", "fill the screen, or no longer"};
    case Command::lessons:
      return {"Lessons", "learn step by step: predict, then see"};
    case Command::bugs:
      return {"Spot the bug", "a tracer is broken: find the line at fault"};
    case Command::bug_surprise:
      return {"Surprise me", "hunt a bug that is not found yet"};
    case Command::bug_mark:
      return {"Mark this line", "mark the line that has just run; once more: is it the one?"};
    case Command::bug_cure:
      return {"See the cure", "give up: which line it was, what was wrong, and the cure"};
    case Command::bug_mend:
      return {"Mend the bug", "trace without the bug that has been found, or with it again"};
    case Command::menu:
      return {"Menus", "open the first menu, then the next; arrows and Enter choose"};
  }
  return {};
}

}  // namespace raywalk
