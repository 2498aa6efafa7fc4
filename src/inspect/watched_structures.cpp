#include "inspect/watched_structures.h"

#include <algorithm>

namespace raywalk {

namespace {

template <class T, class AnyRay>
WatchedSearch search_in(const WatchedAccelerator<T>& accelerator, const World<T>& world, const AnyRay& ray,
                        const SearchedRay<T>& asked) {
  SearchRecord record(wide(ray.origin), wide(ray.direction), static_cast<double>(asked.t_far));
  WatchedSearch search;
  if (asked.shadow)
    static_cast<void>(accelerator.occluded(ray, asked.t_far, search.counts, world.shadow_roles, record));
  else
    static_cast<void>(accelerator.closest(ray, asked.t_far, search.counts, record));
  search.events = record.events();
  search.complete = record.complete();
  if (const auto& found = record.nearest()) search.primitive = found->primitive, search.t = found->t;
  return search;
}

}  // namespace

std::size_t watched_index(AcceleratorKind kind) {
  const auto at = std::find(watched_accelerators.begin(), watched_accelerators.end(), kind);
  return at == watched_accelerators.end() ? 0 : static_cast<std::size_t>(at - watched_accelerators.begin());
}

WatchedStructures::WatchedStructures(const Scene& scene, Precision precision, WorldCache& worlds) {
  switch (precision) {
    case Precision::float_:
      in_ = InPrecision<float>{worlds.of<float>(scene), {}};
      break;
    case Precision::double_:
      in_ = InPrecision<double>{worlds.of<double>(scene), {}};
      break;
  }
}

WatchedBuild WatchedStructures::build(std::size_t index) {
  return std::visit(
      [&](auto& in) {
        const auto& built =
            in.accelerators.emplace_back(in.world->accelerator.primitives(), watched_accelerators[index], max_steps);
        const BuildRecord& record = built.build();
        return WatchedBuild{record.steps, record.steps_made == record.steps.size(), built.nodes(max_nodes),
                            built.statistics()};
      },
      in_);
}

WatchedSearches WatchedStructures::search(const AnySearchedRay& ray) const {
  WatchedSearches searches;
  std::visit(
      [&]<class T>(const SearchedRay<T>& asked) {
        const auto* in = std::get_if<InPrecision<T>>(&in_);
        for (std::size_t i = 0; in != nullptr && i < in->accelerators.size(); ++i)
          searches[i] = asked.naive ? search_in(in->accelerators[i], *in->world, NaiveRay<T>(asked.ray), asked)
                                    : search_in(in->accelerators[i], *in->world, asked.ray, asked);
      },
      ray);
  return searches;
}

}  // namespace raywalk
