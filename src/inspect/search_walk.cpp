#include "inspect/search_walk.h"

#include "inspect/retraced_ray.h"
#include "scene/names.h"

#include <algorithm>

namespace raywalk {

std::size_t watched_index(AcceleratorKind kind) {
  const auto at = std::find(watched_accelerators.begin(), watched_accelerators.end(), kind);
  return at == watched_accelerators.end() ? 0 : static_cast<std::size_t>(at - watched_accelerators.begin());
}

template <class T>
struct SearchWalks::PreparedScene {
  PreparedScene(const Scene& scene, const Timeline& recorded) : world(scene), camera(camera_of<T>(scene, recorded)) {}

  World<T> world;
  RayGenerator<T> camera;
  std::vector<WatchedAccelerator<T>> accelerators;  ///< by place in watched_accelerators

  template <class AnyRay>
  [[nodiscard]] WatchedSearch search(std::size_t index, const AnyRay& ray, bool shadow, T t_far) const {
    const WatchedAccelerator<T>& accelerator = accelerators[index];
    SearchRecord record(wide(ray.origin), wide(ray.direction), static_cast<double>(t_far));
    WatchedSearch search;
    if (shadow)
      static_cast<void>(accelerator.occluded(ray, t_far, search.counts, world.shadow_roles, record));
    else
      static_cast<void>(accelerator.closest(ray, t_far, search.counts, record));
    search.events = record.events();
    search.complete = record.complete();
    if (const auto& found = record.nearest()) search.primitive = found->primitive, search.t = found->t;
    return search;
  }
};

SearchWalks::SearchWalks(const Scene& scene, std::shared_ptr<const Timeline> timeline, Precision precision)
    : timeline_(std::move(timeline)) {
  for (const Object& object : scene.objects) object_names_.push_back(object.name);
  translated_names_ = scene.translated;
  switch (precision) {
    case Precision::float_:
      fill<float>(scene);
      break;
    case Precision::double_:
      fill<double>(scene);
      break;
  }
}

template <class T>
void SearchWalks::fill(const Scene& scene) {
  const auto prepared = std::make_shared<PreparedScene<T>>(scene, *timeline_);
  prepared_ = prepared;
  const Primitives<T>& primitives = prepared->world.accelerator.primitives();
  primitives_ = primitives.size();
  if (too_large()) return;
  const PrimitiveBounds<T> boxes(primitives);
  bounded_ = static_cast<int>(boxes.bounded.size());
  unbounded_ = static_cast<int>(boxes.unbounded.size());
  for (std::size_t i = 0; i < watched_count; ++i) {
    const WatchedAccelerator<T>& built =
        prepared->accelerators.emplace_back(primitives, watched_accelerators[i], max_steps);
    const BuildRecord& record = built.build();
    builds_[i] = {record.steps, record.steps_made == record.steps.size(), built.nodes(max_nodes), built.statistics()};
  }
}

std::string SearchWalks::name(int primitive, Language language) const {
  return std::visit(
      [&](const auto& prepared) {
        const auto shown = [&](const std::string& own) { return shown_name(translated_names_, own, language); };
        std::string name = shown(object_names_[static_cast<std::size_t>(prepared->world.object(primitive))]);
        const auto piece = prepared->world.piece(primitive);
        if (!piece.member.empty()) name += " / " + shown(piece.member);
        if (piece.triangle >= 0) name += " #" + std::to_string(piece.triangle);
        return name;
      },
      prepared_);
}

Bounds<double> SearchWalks::box(int primitive) const {
  return std::visit([&](const auto& prepared) { return wide(prepared->world.accelerator.primitives().box(primitive)); },
                    prepared_);
}

std::shared_ptr<const RaySearches> SearchWalks::search(int ray) const {
  const RayRecord& record = timeline_->rays()[static_cast<std::size_t>(ray)];
  if (too_large() || !record.formed) return nullptr;
  return std::visit(
      [&]<class T>(const std::shared_ptr<const PreparedScene<T>>& prepared) -> std::shared_ptr<const RaySearches> {
        const auto twins = retraced_ray(prepared->world, prepared->camera, *timeline_, ray);
        if (!twins) return nullptr;
        const bool shadow = record.kind == RayKind::shadow;
        const auto& formed = std::get<RayFormed>(timeline_->event(record.formed_at - 1).detail);
        const T t_far = shadow && formed.light_at_end ? T(1) : infinity<T>;
        auto searches = std::make_shared<RaySearches>();
        searches->ray = ray;
        searches->kind = record.kind;
        const bool naive = prepared->world.numerics == Numerics::naive;
        const Ray<T> line = naive ? twins->naive.plain() : twins->robust;
        searches->origin = wide(line.origin), searches->direction = wide(line.direction);
        for (std::size_t i = 0; i < watched_count; ++i)
          searches->in[i] = naive ? prepared->search(i, twins->naive, shadow, t_far)
                                  : prepared->search(i, twins->robust, shadow, t_far);
        return searches;
      },
      prepared_);
}

}  // namespace raywalk
