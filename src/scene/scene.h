#pragma once

#include "image/image.h"
#include "image/srgb.h"
#include "math/motion.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/object_shape.h"
#include "scene/render_choices.h"
#include "scene/sky.h"
#include "scene/transform_step.h"

#include <optional>
#include <string>
#include <vector>

namespace raywalk {

struct Object {
  std::string name;  ///< unique among the objects and lights of a scene, not empty
  ObjectShape shape;
  Material material;                       ///< an instance uses those of its group's objects instead
  std::vector<TransformStep> transform{};  ///< applied to the shape in this order; together not singular
  Motion motion{};                         ///< of the transformed shape
  friend bool operator==(const Object&, const Object&) = default;
};

/// Objects that a scene may use many times, by instances. Not visible by itself.
struct Group {
  std::string name;             ///< unique in the scene
  std::vector<Object> objects;  ///< possibly instances of groups defined before this one
  friend bool operator==(const Group&, const Group&) = default;
};

/// What instances of a group share. Computed once, so that nested groups cost no more than their content.
struct GroupContent {
  explicit GroupContent(Group from);
  Group group;
  double entries;      ///< objects and triangles when all instances are expanded
  int nesting;         ///< 1 where no object is an instance
  Bounds<double> box;  ///< of all objects at rest
};

/// Objects and triangles of a list when all instances are expanded.
[[nodiscard]] double entries_of(const std::vector<Object>& objects);

/// How far a render of this scene goes, unless the command line says otherwise.
struct TraceLimits {
  int depth = 5;         ///< the deepest SHADE; the primary ray's has depth 1. >= 1
  double threshold = 0;  ///< a ray whose throughput (largest channel) is below this is not formed; >= 0
  friend bool operator==(const TraceLimits&, const TraceLimits&) = default;
};

/// A scene as a person describes it: plain values, in double, right-handed, z towards the reader of the plan.
struct Scene {
  // What a compiler writes by itself, but once: it takes half a second in every file that copies a scene.
  Scene();
  Scene(const Scene&);
  Scene(Scene&&) noexcept;
  Scene& operator=(const Scene&);
  Scene& operator=(Scene&&) noexcept;
  ~Scene();
  std::string title;
  std::string description;
  Camera camera;
  ImageSize image;  ///< default size of a 3-D render
  Encoding encoding = Encoding::srgb;
  TraceLimits limits;
  RenderChoices render{};
  Rgbd background{0.0};  ///< radiance of what a ray meets that hits nothing; under a sky, below its horizon
  std::optional<Sky> sky{};
  Rgbd ambient{1.0};  ///< ambient light, multiplied by each material's ka
  std::vector<Group> groups;
  std::vector<Light> lights;
  std::vector<Object> objects;
  /// Names that are shown in the language of the window (scene/names.h); all others are shown as they are.
  std::vector<std::string> translated{};
  friend bool operator==(const Scene&, const Scene&);
};

/// Every material used by some surface of the scene, with its object: also those of instanced groups and of mesh files.
struct MaterialUse {
  const Object* object;
  const Material* material;
};
[[nodiscard]] std::vector<MaterialUse> material_uses(const Scene& scene);

/// Why paths cannot walk inside of an object that scatters light there: its shape encloses nothing, or has no end and
/// absorbs nothing, so that they might never leave. Empty when they can, or need not.
[[nodiscard]] std::string why_no_walk_inside(const Object& object);

/// The first object, in the scene or in an instanced group, that moves while the shutter is open; null for none.
[[nodiscard]] const Object* first_moving_object(const Scene& scene);

/// Whether the strip of `scene` is exactly the middle row of its image: eye, look-at and the middle of lights in z = 0,
/// directional lights without z, up along z, and every surface that meets z = 0 with a normal whose z is exactly 0.
/// Empty when planar; otherwise the reason in words, naming the object.
[[nodiscard]] std::string why_not_planar(const Scene& scene);
[[nodiscard]] inline bool is_planar(const Scene& scene) { return why_not_planar(scene).empty(); }

}  // namespace raywalk
