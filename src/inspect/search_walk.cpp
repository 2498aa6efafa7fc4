#include "inspect/search_walk.h"

#include "inspect/retraced_ray.h"
#include "scene/names.h"

namespace raywalk {

template <class T>
struct SearchWalks::PreparedScene {
  std::shared_ptr<const World<T>> world;
  RayGenerator<T> camera;
};

SearchWalks::SearchWalks(const Scene& scene, std::shared_ptr<const Timeline> timeline, Precision precision,
                         WorldCache* worlds, int most_here)
    : timeline_(std::move(timeline)) {
  for (const Object& object : scene.objects) object_names_.push_back(object.name);
  translated_names_ = scene.translated;
  WorldCache own;
  WorldCache& all = worlds != nullptr ? *worlds : own;
  switch (precision) {
    case Precision::float_:
      fill<float>(scene, all);
      break;
    case Precision::double_:
      fill<double>(scene, all);
      break;
  }
  if (too_large() || primitives_ > most_here) return;
  const auto structures = std::make_shared<WatchedStructures>(scene, precision, all);
  for (std::size_t i = 0; i < watched_count; ++i) builds_[i] = structures->build(i);
  structures_ = structures;
}

template <class T>
void SearchWalks::fill(const Scene& scene, WorldCache& worlds) {
  const auto world = worlds.of<T>(scene);
  prepared_ = std::make_shared<const PreparedScene<T>>(world, camera_of<T>(scene, *timeline_));
  const Primitives<T>& primitives = world->accelerator.primitives();
  primitives_ = primitives.size();
  if (too_large()) return;
  const PrimitiveBounds<T> boxes(primitives, true);
  bounded_ = static_cast<int>(boxes.bounded.size());
  unbounded_ = static_cast<int>(boxes.unbounded.size());
}

Precision SearchWalks::precision() const { return prepared_.index() == 0 ? Precision::float_ : Precision::double_; }

std::shared_ptr<const SearchWalks> SearchWalks::take(std::array<WatchedBuild, watched_count> builds) const {
  const auto with = std::make_shared<SearchWalks>(*this);
  with->builds_ = std::move(builds);
  with->taken_ = true;
  return with;
}

std::string SearchWalks::name(int primitive, Language language) const {
  return std::visit(
      [&](const auto& prepared) {
        const auto& world = *prepared->world;
        const auto shown = [&](const std::string& own) { return shown_name(translated_names_, own, language); };
        std::string name = shown(object_names_[static_cast<std::size_t>(world.object(primitive))]);
        const auto piece = world.piece(primitive);
        if (!piece.member.empty()) name += " / " + shown(piece.member);
        if (piece.triangle >= 0) name += " #" + std::to_string(piece.triangle);
        return name;
      },
      prepared_);
}

Bounds<double> SearchWalks::box(int primitive) const {
  return std::visit(
      [&](const auto& prepared) { return wide(prepared->world->accelerator.primitives().box(primitive)); }, prepared_);
}

std::optional<AnySearchedRay> SearchWalks::searched(int ray) const {
  const RayRecord& record = timeline_->rays()[static_cast<std::size_t>(ray)];
  if (too_large() || !record.formed) return std::nullopt;
  return std::visit(
      [&]<class T>(const std::shared_ptr<const PreparedScene<T>>& prepared) -> std::optional<AnySearchedRay> {
        const auto twins = retraced_ray(*prepared->world, prepared->camera, *timeline_, ray);
        if (!twins) return std::nullopt;
        SearchedRay<T> asked;
        asked.naive = prepared->world->numerics == Numerics::naive;
        asked.ray = asked.naive ? twins->naive.plain() : twins->robust;
        asked.shadow = record.kind == RayKind::shadow;
        const auto& formed = std::get<RayFormed>(timeline_->event(record.formed_at - 1).detail);
        asked.t_far = asked.shadow && formed.light_at_end ? T(1) : infinity<T>;
        return asked;
      },
      prepared_);
}

std::shared_ptr<const RaySearches> SearchWalks::found(int ray, const AnySearchedRay& asked,
                                                      WatchedSearches searches) const {
  auto all = std::make_shared<RaySearches>();
  all->ray = ray;
  all->kind = timeline_->rays()[static_cast<std::size_t>(ray)].kind;
  std::visit([&](const auto& one) { all->origin = wide(one.ray.origin), all->direction = wide(one.ray.direction); },
             asked);
  all->in = std::move(searches);
  return all;
}

std::shared_ptr<const RaySearches> SearchWalks::search(int ray) const {
  const auto asked = structures_ ? searched(ray) : std::nullopt;
  return asked ? found(ray, *asked, structures_->search(*asked)) : nullptr;
}

}  // namespace raywalk
