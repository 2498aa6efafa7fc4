// The English texts of things, buttons, menus, questions, properties and notices.

#include "view/text.h"

namespace raywalk {

std::string_view english(TextId id) {
  switch (id) {
    case TextId::solid_sphere:
      return "Solid Sphere";
    case TextId::transparent_sphere:
      return "Transparent Sphere";
    case TextId::polygon:
      return "Polygon";
    case TextId::light_source:
      return "Light Source";
    case TextId::short_solid_sphere:
      return "Solid";
    case TextId::short_transparent_sphere:
      return "Glass";
    case TextId::short_polygon:
      return "Polygon";
    case TextId::short_light_source:
      return "Light";
    case TextId::plane:
      return "Floor";
    case TextId::eye:
      return "EYE";
    case TextId::screen:
      return "SCREEN";
    case TextId::untitled:
      return "Untitled";
    case TextId::new_scene_title:
      return "A new scene";
    case TextId::drag_move:
      return "{0}: drag to move it";
    case TextId::drag_eye:
      return "EYE: drag to move the eye and the screen";
    case TextId::drag_view_direction:
      return "Drag to turn the view";
    case TextId::drag_screen_height:
      return "Drag to make SCREEN longer or shorter";
    case TextId::drag_screen_distance:
      return "Drag to move SCREEN nearer to EYE or farther away";
    case TextId::drag_radius:
      return "{0}: drag to change the radius";
    case TextId::drag_corner:
      return "{0}: drag to move this corner; Delete removes it";
    case TextId::drag_edge:
      return "{0}: drag to move it; a double click adds a corner here";
    case TextId::drag_rotation:
      return "{0}: drag to turn it";
    case TextId::cell_number:
      return "Pixel {0} of SCREEN";
    case TextId::cell_with_shade:
      return "Pixel {0} of SCREEN: final shade {1}";
    case TextId::ray_from:
      return "{0} from {1}";
    case TextId::ray_of_cell:
      return "{0} of pixel {1}";
    case TextId::ray_of_pixel:
      return "{0} of the image's pixel";
    case TextId::mode_move:
      return "Move";
    case TextId::mode_trace:
      return "Trace";
    case TextId::mode_help:
      return "Help";
    case TextId::tab_image:
      return "3-D image";
    case TextId::tab_tree:
      return "Ray tree";
    case TextId::tab_stack:
      return "Stack";
    case TextId::tab_legend:
      return "Legend";
    case TextId::tab_cost:
      return "Cost";
    case TextId::button_step:
      return "STEP";
    case TextId::button_back:
      return "BACK";
    case TextId::button_auto:
      return "AUTO";
    case TextId::button_pause:
      return "PAUSE";
    case TextId::button_clear:
      return "CLEAR";
    case TextId::button_fit:
      return "Fit";
    case TextId::button_undo:
      return "Undo";
    case TextId::button_redo:
      return "Redo";
    case TextId::button_add:
      return "Add";
    case TextId::button_remove:
      return "Remove";
    case TextId::button_close:
      return "Close";
    case TextId::grain:
      return "One step is";
    case TextId::grain_line:
      return "a line";
    case TextId::grain_ray:
      return "a ray";
    case TextId::grain_pixel:
      return "a pixel";
    case TextId::speed:
      return "Speed";
    case TextId::speed_unit:
      return "steps a second";
    case TextId::theme:
      return "Theme";
    case TextId::theme_dark:
      return "Dark";
    case TextId::theme_projector:
      return "Projector";
    case TextId::ui_scale:
      return "Size";
    case TextId::language:
      return "Language";
    case TextId::menu_file:
      return "File";
    case TextId::menu_edit:
      return "Edit";
    case TextId::menu_view:
      return "View";
    case TextId::menu_new:
      return "New";
    case TextId::menu_open:
      return "Open...";
    case TextId::menu_recent:
      return "Open recent";
    case TextId::menu_save:
      return "Save";
    case TextId::menu_save_as:
      return "Save as...";
    case TextId::menu_quit:
      return "Quit";
    case TextId::path_label:
      return "File";
    case TextId::answer_save:
      return "Save";
    case TextId::answer_discard:
      return "Don't save";
    case TextId::answer_recover:
      return "Recover";
    case TextId::answer_throw_away:
      return "Throw away";
    case TextId::answer_later:
      return "Later";
    case TextId::answer_overwrite:
      return "Replace it";
    case TextId::answer_cancel:
      return "Cancel";
    case TextId::ask_unsaved_new:
      return "{0} has changes that are not saved. Save them before starting a new scene?";
    case TextId::ask_unsaved_open:
      return "{0} has changes that are not saved. Save them before opening {1}?";
    case TextId::ask_unsaved_quit:
      return "{0} has changes that are not saved. Save them before leaving?";
    case TextId::ask_unsaved_lesson:
      return "Your own scene comes back now. Keep a copy of the lesson's scene, as you changed it?";
    case TextId::ask_recover:
      return "Raywalk ended on {1} before the changes to {0} were saved. Recover them? Later asks again at the next "
             "start.";
    case TextId::ask_recover_other:
      return "Raywalk ended on {1} before the changes to {0} were saved. Recover them in place of {2}, which you "
             "opened "
             "now? Later asks again at the next start.";
    case TextId::ask_overwrite:
      return "{0} exists already. Replace it?";
    case TextId::properties:
      return "Properties";
    case TextId::nothing_selected:
      return "Click on something in the plan to see its numbers here.";
    case TextId::name:
      return "Name";
    case TextId::material:
      return "Material";
    case TextId::ambient:
      return "Ambient (ka)";
    case TextId::diffuse:
      return "Diffuse (kd)";
    case TextId::specular:
      return "Specular (ks)";
    case TextId::shininess:
      return "Shininess (s)";
    case TextId::reflection:
      return "Reflection (kr)";
    case TextId::transmission:
      return "Transmission (kt)";
    case TextId::ior:
      return "Index of refraction";
    case TextId::dielectric:
      return "Dielectric (Fresnel)";
    case TextId::priority:
      return "Priority";
    case TextId::filtered_shadow:
      return "Filtered shadow";
    case TextId::emission:
      return "Emission";
    case TextId::checker:
      return "Checker";
    case TextId::position:
      return "Position";
    case TextId::direction:
      return "Direction";
    case TextId::centre:
      return "Centre";
    case TextId::radius:
      return "Radius";
    case TextId::height:
      return "Height in 3-D";
    case TextId::corner:
      return "Corner {0}";
    case TextId::radii:
      return "Radii";
    case TextId::lowest:
      return "Lowest";
    case TextId::highest:
      return "Highest";
    case TextId::capped:
      return "Capped";
    case TextId::smooth:
      return "Smooth";
    case TextId::normal:
      return "Normal";
    case TextId::strength:
      return "Strength";
    case TextId::attenuation:
      return "Attenuation (c, l, q)";
    case TextId::view_angle:
      return "View angle";
    case TextId::look_at:
      return "Looks at";
    case TextId::screen_distance:
      return "Distance of SCREEN";
    case TextId::screen_width:
      return "Length of SCREEN";
    case TextId::screen_cells:
      return "Pixels of SCREEN";
    case TextId::background:
      return "Background";
    case TextId::ambient_light:
      return "Ambient light";
    case TextId::depth_limit:
      return "Deepest SHADE (depth)";
    case TextId::threshold:
      return "Least share (threshold)";
    case TextId::saved_as:
      return "Saved as {0}";
    case TextId::opened:
      return "Opened {0}";
    case TextId::recovered:
      return "Recovered {0}. It is not saved yet.";
    case TextId::refused:
      return "Not done: {0}";
    case TextId::refused_number:
      return "Not taken: a number from {0} to {1} is expected";
    case TextId::refused_name_empty:
      return "Not done: a name cannot be empty";
    case TextId::refused_name_taken:
      return "Not done: there is already something called {0}";
    case TextId::refused_last_corners:
      return "Not done: a polygon needs at least three corners";
    case TextId::camera_is_the_scenes:
      return "The picture is seen by the scene's camera already: turn it first";
    case TextId::camera_taken:
      return "The scene's camera stands where the picture was seen from";
    case TextId::nothing_to_undo:
      return "Nothing to undo";
    case TextId::nothing_to_redo:
      return "Nothing to redo";
    case TextId::select_first:
      return "Click on an object or a light first";
    case TextId::too_many_steps:
      return "The trace is too long to walk: it is shown only down to DEPTH {0}";
    case TextId::export_endings:
      return "{0}: the ending says what is written: .png the window, .gif a film of it, .svg the plan, .html slides, "
             ".txt "
             "or .json all steps";
    case TextId::too_many_slides:
      return "a page has at most {0} steps: walk one pixel, or go less deep";
    case TextId::save_elsewhere:
      return "This scene comes with Raywalk, and lessons use it: save your own under another name or in another folder";
    case TextId::autosave_failed:
      return "The work could not be autosaved: {0}";
  }
  return {};
}

}  // namespace raywalk
