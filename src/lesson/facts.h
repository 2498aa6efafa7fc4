#pragma once
// Resolves the names in a lesson's formulas. Internal to `lesson`; lessons/README.md lists them for authors.

#include "lesson/play.h"

#include <string_view>
#include <vector>

namespace raywalk {

/// The names at one position of a step's walk: those of the line that has just run, "ray." and "parent." of its ray,
/// and the names of pictures; and the counting functions.
class Facts : public Scope {
 public:
  Facts(const PlayedLesson& played, std::size_t index, int position)
      : played_(played), index_(index), position_(position) {}

  [[nodiscard]] Outcome name(std::string_view name) const override;
  [[nodiscard]] Outcome call(std::string_view function, const std::vector<Expression>& arguments) const override;

 private:
  [[nodiscard]] const PlayedStep& step() const { return played_.steps[index_]; }
  [[nodiscard]] const Timeline& timeline() const { return step().walk->timeline; }
  [[nodiscard]] const Scene& scene() const { return step().walk->document.scene; }
  [[nodiscard]] Outcome of_ray(std::string_view name, int ray) const;
  [[nodiscard]] const Rendering* rendering_of(std::string_view picture) const;
  [[nodiscard]] Outcome of_picture(const Rendering& picture, std::string_view name) const;
  [[nodiscard]] Outcome gather(std::string_view function, const std::vector<Expression>& arguments) const;
  [[nodiscard]] Outcome of_pictures(std::string_view function, const std::vector<Expression>& arguments) const;
  [[nodiscard]] Outcome of_pixel(const std::vector<Expression>& arguments) const;
  [[nodiscard]] Outcome of_search(const std::vector<Expression>& arguments) const;

  const PlayedLesson& played_;
  std::size_t index_;
  int position_;
};

/// A fact of the line that leads to `position` of a timeline; nothing if it has none of this name. Empty for a name
/// that no line has.
[[nodiscard]] std::optional<Value> event_fact(const Scene& scene, const Timeline& timeline, int position,
                                              std::string_view name);

}  // namespace raywalk
