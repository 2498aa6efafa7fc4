#include "accel/watched.h"

#include "accel/search.h"

namespace raywalk {

namespace {

/// The renderer's query, which alone decides; its steps are recorded.
template <class T, class Base>
class WatchedQuery : public Base {
 public:
  template <class... Arguments>
  explicit WatchedQuery(SearchRecord& record, Arguments&&... arguments)
      : Base(std::forward<Arguments>(arguments)...), record_(record) {}
  /// `roles`, by primitive: for a shadow ray.
  void set_roles(const std::vector<ShadowRole>& roles) { roles_ = &roles; }

  bool test(const Primitives<T>& primitives, int id) {
    const std::uint64_t before = this->counts().primitives;
    const bool over = Base::test(primitives, id);
    if (this->counts().primitives != before) tell(primitives, id);
    return over;
  }
  /// A primitive that was ruled out together with others.
  void rule_out(const Primitives<T>& primitives, int id) {
    this->count(0, 1);
    tell(primitives, id);
  }
  [[nodiscard]] SearchRecord& record() const { return record_; }

 private:
  /// The result of the test, repeated without counting: the query keeps only the nearest.
  void tell(const Primitives<T>& primitives, int id) {
    const auto intersection = primitives.intersect(id, this->ray_, this->t_max_);
    const bool filters = roles_ != nullptr && role_of(*roles_, id) == ShadowRole::filters;
    record_.tested(id, intersection ? std::optional(static_cast<double>(intersection->t)) : std::nullopt, filters);
  }

  SearchRecord& record_;
  const std::vector<ShadowRole>* roles_ = nullptr;
};

}  // namespace

template <class T>
struct WatchedAccelerator<T>::Structure {
  AnyStructure<T> any;
};

template <class T>
WatchedAccelerator<T>::WatchedAccelerator(const Primitives<T>& primitives, AcceleratorKind kind, std::size_t max_steps,
                                          const Stop& stop)
    : primitives_(primitives), build_{.most = max_steps} {
  const PrimitiveBounds<T> boxes(primitives_, kind != AcceleratorKind::bvh, stop);
  if (kind != AcceleratorKind::none) unbounded_ = boxes.unbounded;
  structure_ = std::make_shared<const Structure>(Structure{build_structure(kind, boxes, primitives_, {stop, &build_})});
}

template <class T>
template <class AnyRay, class Query>
void WatchedAccelerator<T>::search(const AnyRay& ray, Query& query) const {
  for (const int id : unbounded_)
    if (query.test(primitives_, id)) return;
  std::visit([&](const auto& structure) { structure.search(ray, primitives_, query); }, structure_->any);
}

template <class T>
template <class AnyRay>
std::optional<Hit<T>> WatchedAccelerator<T>::closest(const AnyRay& ray, T t_max, TestCounts& counts,
                                                     SearchRecord& record) const {
  using Query = ClosestQuery<T, AnyPrimitive, AnyRay>;
  WatchedQuery<T, Query> query(record, ray, t_max, counts, AnyPrimitive{});
  search(ray, query);
  record.ended(SearchEnd::all_seen);
  return query.nearest();
}

template <class T>
template <class AnyRay>
bool WatchedAccelerator<T>::occluded(const AnyRay& ray, T t_max, TestCounts& counts,
                                     const std::vector<ShadowRole>& roles, SearchRecord& record) const {
  const auto watch = [&](auto& query) {
    search(ray, query);
    record.ended(query.found() ? SearchEnd::blocked : SearchEnd::all_seen);
    return query.found();
  };
  if (roles.empty()) {
    WatchedQuery<T, OcclusionQuery<T, AnyRay>> query(record, ray, t_max, counts);
    return watch(query);
  }
  std::vector<int> filters;
  WatchedQuery<T, FilteredOcclusionQuery<T, AnyRay>> query(record, ray, t_max, counts, roles, filters);
  query.set_roles(roles);
  return watch(query);
}

template <class T>
std::vector<StructureNode> WatchedAccelerator<T>::nodes(std::size_t most) const {
  std::vector<StructureNode> nodes;
  std::visit([&](const auto& structure) { structure.list_nodes(nodes, most); }, structure_->any);
  return nodes;
}

template <class T>
AcceleratorStatistics WatchedAccelerator<T>::statistics() const {
  return std::visit([](const auto& structure) { return structure.statistics(); }, structure_->any);
}

template class WatchedAccelerator<float>;
template class WatchedAccelerator<double>;

/// Instantiates the searches for one kind of ray.
#define RAYWALK_WATCHED(T, AnyRay)                                                                                \
  template std::optional<Hit<T>> WatchedAccelerator<T>::closest(const AnyRay<T>&, T, TestCounts&, SearchRecord&)  \
      const;                                                                                                      \
  template bool WatchedAccelerator<T>::occluded(const AnyRay<T>&, T, TestCounts&, const std::vector<ShadowRole>&, \
                                                SearchRecord&) const;
RAYWALK_WATCHED(float, Ray)
RAYWALK_WATCHED(double, Ray)
RAYWALK_WATCHED(float, NaiveRay)
RAYWALK_WATCHED(double, NaiveRay)
#undef RAYWALK_WATCHED

}  // namespace raywalk
