#include "lesson/facts.h"

#include "inspect/search_walk.h"
#include "lesson/staging.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace raywalk {

namespace {

double number_of(std::uint64_t count) { return static_cast<double>(count); }

/// The number of objects, with an instance counted as its group's.
double bodies_of(const std::vector<Object>& objects) {
  double bodies = 0;
  for (const Object& object : objects) {
    const auto* instance = std::get_if<Instance>(&object.shape);
    bodies += instance != nullptr && instance->content ? bodies_of(instance->content->group.objects) : 1;
  }
  return bodies;
}

/// Outward; where a surface is shaded, the one that it is shaded with.
Vec3d normal_met(const RayRecord& ray) { return ray.ending == Ending::hit ? ray.outward_shading_normal() : ray.normal; }

/// The angle of incidence, in degrees.
double incidence(const RayRecord& ray) {
  const double cosine = std::abs(dot(normalize(ray.direction), normal_met(ray)));
  return std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace

Outcome Facts::name(std::string_view name) const {
  const std::size_t dot = name.find('.');
  const std::string_view first = name.substr(0, dot);
  const std::string_view rest = dot == std::string_view::npos ? "" : name.substr(dot + 1);
  if (const auto picture = step().pictures.find(first); picture != step().pictures.end()) {
    const Result<Rendering>& rendering = picture->second->rendering();
    return rendering ? of_picture(*rendering, rest) : wrong(rendering.error().message);
  }
  if (first == "ray" || first == "parent") {
    int ray = timeline().current_ray(position_);
    if (ray >= 0 && first == "parent") ray = timeline().rays()[static_cast<std::size_t>(ray)].parent;
    return of_ray(rest, ray);
  }
  if (name == "bodies") return bodies_of(scene().objects);
  if (name == "steps") return static_cast<double>(timeline().steps());
  if (const auto fact = event_fact(scene(), timeline(), position_, name)) return *fact;
  return wrong(fmt::format("\"{}\" is no name that formulas know; lessons/README.md lists them", name));
}

Outcome Facts::of_ray(std::string_view name, int index) const {
  const RayRecord none;
  const RayRecord& ray = index < 0 ? none : timeline().rays()[static_cast<std::size_t>(index)];
  const bool found = index >= 0 && ray.found_at <= position_, met = found && ray.object >= 0;
  const auto known = [](bool is, Value value) { return is ? Outcome(std::move(value)) : Outcome(Nothing{}); };
  const auto named = [](const auto& list, int i) {
    return i < 0 ? Value(Nothing{}) : Value(list[static_cast<std::size_t>(i)].name);
  };
  if (name == "kind") return known(index >= 0, std::string(name_of(ray.kind)));
  if (name == "formed") return known(index >= 0, ray.formed);
  if (name == "depth") return known(index >= 0, static_cast<double>(ray.depth));
  if (name == "ending") return known(found, std::string(name_of(ray.ending)));
  if (name == "object") return known(met, named(scene().objects, met ? ray.object : -1));
  if (name == "light") return known(index >= 0, named(scene().lights, ray.light));
  if (name == "origin") return known(index >= 0, ray.origin);
  if (name == "direction") return known(index >= 0, ray.direction);
  // Until its hits are searched, a shadow ray ends at its light.
  const bool has_light = index >= 0 && ray.light >= 0 && !ray.endless;
  const Vec3d end = found ? ray.end : ray.origin + ray.direction;
  if (name == "end") return known(met || has_light, end);
  if (name == "normal") return known(met, normal_met(ray));
  if (name == "share") return known(index >= 0, ray.throughput);
  if (name == "passed") return known(found, ray.transmittance);
  if (name == "length") return known(met || has_light, length(end - ray.origin));
  if (name == "incidence") return known(met, met ? incidence(ray) : 0.0);
  return wrong(fmt::format("a ray has no \"{}\"", name));
}

Outcome Facts::of_picture(const Rendering& picture, std::string_view name) const {
  const Statistics& done = picture.statistics;
  const auto& film = picture.film_of<double>();
  if (name == "rays")
    return std::accumulate(done.rays.begin(), done.rays.end(), 0.0,
                           [](double sum, std::uint64_t n) { return sum + number_of(n); });
  if (name == "pixels") return static_cast<double>(film.size().width) * film.size().height;
  if (name == "primary") return number_of(done.formed(RayKind::primary));
  if (name == "shadow") return number_of(done.formed(RayKind::shadow));
  if (name == "reflect") return number_of(done.formed(RayKind::reflect));
  if (name == "refract") return number_of(done.formed(RayKind::refract));
  if (name == "hit") return number_of(done.ends(Ending::hit));
  if (name == "missed") return number_of(done.ends(Ending::missed));
  if (name == "blocked") return number_of(done.ends(Ending::blocked));
  if (name == "reached_light") return number_of(done.ends(Ending::reached_light));
  if (name == "stopped_by_depth") return number_of(done.ends(Ending::depth));
  if (name == "stopped_by_threshold") return number_of(done.ends(Ending::threshold));
  if (name == "totally_reflected") return number_of(done.ends(Ending::total_internal_reflection));
  if (name == "nodes") return number_of(done.tests.nodes);
  if (name == "tests") return number_of(done.tests.primitives);
  if (name == "draws") return number_of(done.random_draws());
  if (name == "mean") {
    Vec3d sum(0.0);
    for (const Rgbd& pixel : film.pixels()) sum += pixel;
    return sum / static_cast<double>(film.pixels().size());
  }
  return wrong(fmt::format("a picture has no \"{}\"", name));
}

Outcome Facts::call(std::string_view function, const std::vector<Expression>& arguments) const {
  if (function == "scene") {
    const Outcome path = arguments.size() == 1 ? arguments[0].evaluate(*this) : Outcome(Nothing{});
    const std::string* text = path ? std::get_if<std::string>(&*path) : nullptr;
    if (text == nullptr) return wrong("scene takes a path in quotes, such as scene(\"limits.depth\")");
    return scene_value(step().walk->document.text, *text);
  }
  if (function == "at") {
    const Outcome id = arguments.size() == 2 ? arguments[0].evaluate(*this) : Outcome(Nothing{});
    const std::string* text = id ? std::get_if<std::string>(&*id) : nullptr;
    if (text == nullptr) return wrong("at takes the id of a step in quotes, and a formula");
    for (std::size_t i = 0; i < played_.steps.size(); ++i)
      if (played_.steps[i].step->id == *text) return arguments[1].evaluate(Facts(played_, i, played_.steps[i].shown));
    return wrong(fmt::format("at: there is no step \"{}\" that was reached", *text));
  }
  if (function == "rms" || function == "same") return of_pictures(function, arguments);
  if (function == "pixel") return of_pixel(arguments);
  if (function == "searched") return of_search(arguments);
  return gather(function, arguments);
}

/// count, so_far and walk count the lines for which a condition holds: of the pixel, of the pixel up to here, of the
/// whole walk. most is the greatest value in the pixel; sum, first and last take the lines for which the first argument
/// holds.
Outcome Facts::gather(std::string_view function, const std::vector<Expression>& arguments) const {
  const bool counts = function == "count" || function == "so_far" || function == "walk";
  const bool selects = function == "first" || function == "last" || function == "sum";
  if (!counts && !selects && function != "most")
    return wrong(fmt::format("\"{}\" is no function that formulas know; lessons/README.md lists them", function));
  if (arguments.size() != (selects ? 2U : 1U))
    return wrong(fmt::format("{} takes {}", function, selects ? "a condition and a formula" : "one formula"));
  const int pixel = timeline().current_pixel(position_);
  int first = 0, last = timeline().steps();
  if (function != "walk") {
    if (pixel < 0) return Nothing{};
    const PixelRecord& record = timeline().pixels()[static_cast<std::size_t>(pixel)];
    first = record.begun_at - 1;
    last = function == "so_far" ? position_ : record.done_at;
  }
  double number = 0;
  bool any = false;
  Value kept = Nothing{};
  for (int position = first + 1; position <= last; ++position) {
    const Facts here(played_, index_, position);
    const Outcome outcome = arguments[0].evaluate(here);
    if (!outcome) return outcome;
    if (function == "most") {
      if (const double* value = std::get_if<double>(&*outcome); value != nullptr && (!any || *value > number)) {
        number = *value;
        any = true;
      }
      continue;
    }
    if (!holds(*outcome)) continue;
    if (counts) {
      ++number;
      continue;
    }
    const Outcome value = arguments[1].evaluate(here);
    if (!value || function == "first") return value;
    kept = *value;
    if (const double* term = std::get_if<double>(&*value)) number += *term;
  }
  if (counts || function == "sum") return number;
  if (function == "most" && any) return number;
  return kept;
}

/// Null if the step has no such picture, or it cannot be rendered.
const Rendering* Facts::rendering_of(std::string_view picture) const {
  const auto found = step().pictures.find(picture);
  if (found == step().pictures.end()) return nullptr;
  const Result<Rendering>& rendering = found->second->rendering();
  return rendering ? &*rendering : nullptr;
}

Outcome Facts::of_pictures(std::string_view function, const std::vector<Expression>& arguments) const {
  std::vector<const Film<double>*> films;
  for (const Expression& argument : arguments) {
    const Outcome name = argument.evaluate(*this);
    if (!name) return name;
    const std::string* text = std::get_if<std::string>(&*name);
    const Rendering* picture = text == nullptr ? nullptr : rendering_of(*text);
    if (picture == nullptr)
      return wrong(fmt::format("{} takes the names of two pictures of the step, in quotes", function));
    films.push_back(&picture->film_of<double>());
  }
  if (films.size() != 2 || !(films[0]->size() == films[1]->size()))
    return wrong(fmt::format("{} takes two pictures of one size", function));
  const auto &a = films[0]->pixels(), &b = films[1]->pixels();
  if (function == "same") return a == b;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i] - b[i], a[i] - b[i]) / 3;
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// pixel("name", column, row): a pixel of a picture, from 0.
Outcome Facts::of_pixel(const std::vector<Expression>& arguments) const {
  std::vector<Value> values;
  for (const Expression& argument : arguments) {
    Outcome value = argument.evaluate(*this);
    if (!value) return value;
    values.push_back(std::move(*value));
  }
  if (values.size() == 3) {
    const auto* name = std::get_if<std::string>(&values[0]);
    const auto *column = std::get_if<double>(&values[1]), *row = std::get_if<double>(&values[2]);
    const Rendering* picture = name == nullptr || column == nullptr || row == nullptr ? nullptr : rendering_of(*name);
    if (picture != nullptr) {
      const auto& film = picture->film_of<double>();
      if (*column >= 0 && *row >= 0 && *column < film.size().width && *row < film.size().height)
        return film.at(static_cast<int>(*column), static_cast<int>(*row));
    }
  }
  return wrong("pixel takes the name of a picture of the step, and a column and a row that it has");
}

/// searched("bvh", "tests"): the cost of the line's ray in an accelerator; or "nodes".
Outcome Facts::of_search(const std::vector<Expression>& arguments) const {
  std::vector<std::string> words;
  for (const Expression& argument : arguments) {
    const Outcome value = argument.evaluate(*this);
    if (!value) return value;
    if (const auto* word = std::get_if<std::string>(&*value)) words.push_back(*word);
  }
  if (words.size() == 2 && step().walk->searches != nullptr)
    for (const AcceleratorKind kind : watched_accelerators) {
      if (name_of(kind) != words[0] || (words[1] != "tests" && words[1] != "nodes")) continue;
      const int ray = timeline().current_ray(position_);
      const auto searches = ray >= 0 ? step().walk->searches->search(ray) : nullptr;
      if (searches == nullptr) return Nothing{};
      const TestCounts& counts = searches->in[watched_index(kind)].counts;
      return number_of(words[1] == "tests" ? counts.primitives : counts.nodes);
    }
  return wrong(
      "searched takes bvh, grid, octree, kdtree or none, and tests or nodes, where a step shows \"structure\"");
}

}  // namespace raywalk
