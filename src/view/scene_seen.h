#pragma once
// The scene with a few of its values chosen otherwise.

#include "scene/scene.h"

#include <optional>
#include <utility>

namespace raywalk {

/// A scene as it is drawn or walked. Where nothing is chosen otherwise it is the one it was made of, and no copy: that
/// may hold a million objects. It must not outlive that scene.
class SceneSeen {
 public:
  explicit SceneSeen(const Scene& own) : own_(&own) {}

  void set(const Camera& camera) { put(&Scene::camera, camera); }
  void set(const RenderChoices& choices) { put(&Scene::render, choices); }
  void set(const TraceLimits& limits) { put(&Scene::limits, limits); }

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
