#pragma once
// The scene with a few values overridden.

#include "scene/scene.h"

#include <optional>
#include <utility>

namespace raywalk {

/// A scene as it is drawn or walked. Without overrides it refers to the original and is not a copy, as that may have a
/// million objects. It must not outlive the original.
class SceneSeen {
 public:
  explicit SceneSeen(const Scene& own) : own_(&own) {}

  void set(const Camera& camera) { put(&Scene::camera, camera); }
  void set(const RenderChoices& choices) { put(&Scene::render, choices); }
  void set(const TraceLimits& limits) { put(&Scene::limits, limits); }
  void set(Scene scene) { changed_ = std::move(scene); }

  [[nodiscard]] const Scene& operator*() const { return changed_ ? *changed_ : *own_; }
  [[nodiscard]] const Scene* operator->() const { return &**this; }

 private:
  template <class Value>
  void put(Value Scene::* member, Value value) {
    if ((**this).*member == value) return;
    if (!changed_) changed_ = *own_;
    (*changed_).*member = std::move(value);
  }

  const Scene* own_;
  std::optional<Scene> changed_;
};

}  // namespace raywalk
