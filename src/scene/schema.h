#pragma once
// The schema of a scene: every key of its file once (here and in scene/schema_*.h), in the order of writing, with the
// kind of its value and a description. The default of a key is that of its struct member.
//
// `Fields` visits each table: one kind of Fields reads it from TOML (io/scene_reader.h), one makes the tree for writing
// (io/scene_values.cpp), one the reference of the format (io/key_reference.cpp). It is called with
//   about(sentence)                         what it is; first of all
//   key(name, member, kind, sentence)       a key that may be left out; tables bring their sentence with them
//   required(name, member, kind, sentence)  one that may not
//   left_out(name, member, value)           what it is where it is left out, if that depends on keys before it
//   without(name, message, hint)            one that others have and this one has not, told where it is given
//   type(variant, sentence)                 the key `type`, which says what further keys there are
//   together(optional)                      members that stand in this very table, all or none of them
//   check(name, holds, message, hint)       a rule over several members, told at this key when it is broken
//   check(name, why, hint)                  the same; `why()` takes its time, and is "" or the message
//   complete(value)                         all keys of a value are told that needs more than its keys
// A new key needs a member of its struct and a line here.

#include "scene/schema_kinds.h"
#include "scene/schema_lights.h"
#include "scene/schema_materials.h"
#include "scene/schema_shapes.h"
#include "scene/schema_view.h"

#include <variant>

namespace raywalk::schema {

// --- The scene

template <class Fields>
void describe(Fields& f, Object& object) {
  f.about("What rays meet; as many as you like.");
  f.required("name", object.name, own_name, "Every light, object and group needs a name of its own.");
  f.type(object.shape, "What shape it has, which says what further keys it has.");
  f.key("transform", object.transform, transform_steps,
        "How it is moved, turned and stretched; the first step is done first.");
  f.key("motion", object.motion, motion_keys,
        "Where it is at a time, seen from where it stands; it moves straight from key to key.");
  if (std::holds_alternative<Instance>(object.shape))
    return f.without("material", "an instance has the materials of the objects in its group (expected none of its own)",
                     "give the material to the objects of [[group]]");
  f.key("material", object.material, table);
  f.check(
      "material", [&] { return why_no_walk_inside(object); },
      "light is scattered inside of what transmits: leave scattering out, or take a closed, bounded shape");
}

template <class Fields>
void describe(Fields& f, Group& group) {
  f.about("Objects that instances put into the scene, as often as you like; it is not seen by itself.");
  f.required("name", group.name, own_name, "What instances call it.");
  f.key("object", group.objects, tables);
  f.complete(group);
}

template <class Fields>
void describe(Fields& f, Scene& scene) {
  f.about("What stands at the top of the file.");
  f.key("title", scene.title, text, "What the scene is called.");
  f.key("description", scene.description, text, "One line about what there is to see.");
  f.key("translated", scene.translated, names,
        "Names that are shown in the language of the window, by [name] of its texts; others are shown as they are.");
  f.key("background", scene.background, light_colour, "What a ray brings back that hits nothing.");
  f.key("sky", scene.sky, table);
  f.key("ambient", scene.ambient, light_colour, "Light from everywhere, multiplied by each material's ambient.");
  f.required("camera", scene.camera, table);
  f.key("screen", scene.camera.screen, table);
  ImageTable image{scene.image, scene.encoding};
  f.key("image", image, table);
  scene.image = image.size;
  scene.encoding = image.encoding;
  f.key("limits", scene.limits, table);
  f.key("render", scene.render, table);
  f.key("group", scene.groups, tables);
  f.key("light", scene.lights, tables);
  f.key("object", scene.objects, tables);
}

// --- Ink

template <class Fields>
void describe(Fields& f, PenStroke& stroke) {
  f.about("A line by hand.");
  f.required("points", stroke.points, pen_points, "What the pen went through.");
}

template <class Fields>
void describe(Fields& f, InkArrow& arrow) {
  f.about("A straight arrow.");
  f.required("from", arrow.from, place, "Where it begins.");
  f.required("to", arrow.to, place, "Its tip.");
}

template <class Fields>
void describe(Fields& f, InkText& note) {
  f.about("A few words.");
  f.required("at", note.at, place, "Where they begin.");
  f.required("text", note.text, ink_text, "What they say.");
}

template <class Fields>
void describe(Fields& f, Ruler& ruler) {
  f.about("A line that says its length.");
  f.required("from", ruler.from, place, "One of its ends.");
  f.required("to", ruler.to, place, "The other end.");
}

template <class Fields>
void describe(Fields& f, Protractor& protractor) {
  f.about("Two arms that say the angle between them.");
  f.required("vertex", protractor.vertex, place, "Where the arms meet.");
  f.required("from", protractor.from, place, "The end of one arm.");
  f.required("to", protractor.to, place, "The end of the other arm.");
}

template <class Fields>
void describe(Fields& f, InkMark& mark) {
  f.about(
      "What is drawn over the plan with Ink; as much as you like. It is no part of the scene, and no ray meets it.");
  f.type(mark.shape, "What kind of mark it is, which says what further keys it has.");
  f.key("colour", mark.colour, ink_colours, "Plain is dark on a light plan and light on a dark one.");
}

/// All that a file holds.
struct SceneFile {
  Scene scene;
  Ink ink;
  friend bool operator==(const SceneFile&, const SceneFile&) = default;
};

template <class Fields>
void describe(Fields& f, SceneFile& file) {
  describe(f, file.scene);
  f.key("ink", file.ink, tables);
}

}  // namespace raywalk::schema
