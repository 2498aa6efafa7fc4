#include "trace/photon_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace raywalk {

/// A photon's place while the tree is built: moved about in place of the photon itself.
struct PlacedPhoton {
  std::array<float, 3> at;
  std::uint32_t index;
};

namespace {

constexpr std::size_t few = 8;  // photons that are a list and no tree

/// A total order, so that the tree is the same whatever the library's nth_element does.
struct Before {
  std::size_t axis;
  bool operator()(const PlacedPhoton& a, const PlacedPhoton& b) const {
    return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.index < b.index;
  }
};

std::size_t widest_axis(const std::vector<PlacedPhoton>& places, std::size_t begin, std::size_t end) {
  std::array<float, 3> least = places[begin].at, most = least;
  for (std::size_t i = begin; i < end; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], places[i].at[axis]);
      most[axis] = std::max(most[axis], places[i].at[axis]);
    }
  std::size_t widest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (most[axis] - least[axis] > most[widest] - least[widest]) widest = axis;
  return widest;
}

/// The k nearest candidates so far, the farthest on top. A heap of its own: the library's may order equal ones, and so
/// add up their powers, in another way elsewhere.
class NearestHeap {
 public:
  struct Entry {
    double squared;
    std::size_t photon;
    bool operator<(const Entry& other) const {
      return squared != other.squared ? squared < other.squared : photon < other.photon;
    }
  };

  explicit NearestHeap(std::size_t most) : most_(most) { entries_.reserve(most); }
  [[nodiscard]] bool full() const { return entries_.size() == most_; }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] const Entry& farthest() const { return entries_.front(); }

  void add(const Entry& entry) {
    if (!full()) {
      entries_.push_back(entry);
      rise(entries_.size() - 1);
    } else if (entry < entries_.front()) {
      entries_.front() = entry;
      sink();
    }
  }

 private:
  void rise(std::size_t at) {
    while (at > 0 && entries_[(at - 1) / 2] < entries_[at]) {
      std::swap(entries_[(at - 1) / 2], entries_[at]);
      at = (at - 1) / 2;
    }
  }
  void sink() {
    std::size_t at = 0;
    for (;;) {
      std::size_t larger = 2 * at + 1;
      if (larger >= entries_.size()) return;
      if (larger + 1 < entries_.size() && entries_[larger] < entries_[larger + 1]) ++larger;
      if (!(entries_[at] < entries_[larger])) return;
      std::swap(entries_[at], entries_[larger]);
      at = larger;
    }
  }

  std::size_t most_;
  std::vector<Entry> entries_;
};

/// Photons on surfaces that face elsewhere, around a corner or on the other side, tell nothing about the light here.
bool is_on_same_side(const Photon& photon, const std::optional<Vec3d>& normal) {
  constexpr double half = 0.5;  // cosine of 60 degrees
  return !normal || dot(Vec3d(photon.normal), *normal) > half;
}

double squared_distance(const Photon& photon, const Vec3d& point) {
  const Vec3d apart = Vec3d(photon.position) - point;
  return dot(apart, apart);
}

}  // namespace

PhotonMap::PhotonMap(const StoredPhotons& stored, const Stop& stop) {
  const std::vector<Photon>& photons = stored.photons;
  std::vector<PlacedPhoton> places(photons.size());
  for (std::size_t i = 0; i < photons.size(); ++i) {
    const Vec3<float>& at = photons[i].position;
    places[i] = {{at.x, at.y, at.z}, static_cast<std::uint32_t>(i)};
  }
  axes_.resize(photons.size());
  sort(0, places.size(), places, stop);
  photons_.reserve(photons.size());
  for (const PlacedPhoton& place : places) photons_.push_back(photons[place.index]);
  if (stored.incidents.empty()) return;
  incidents_.reserve(photons.size());
  for (const PlacedPhoton& place : places) incidents_.push_back(stored.incidents[place.index]);
}

void PhotonMap::sort(std::size_t begin, std::size_t end, std::vector<PlacedPhoton>& places, const Stop& stop) {
  stop.check();
  const auto at = [&](std::size_t i) { return places.begin() + static_cast<std::ptrdiff_t>(i); };
  if (end - begin <= few) {
    std::sort(at(begin), at(end), [](const PlacedPhoton& a, const PlacedPhoton& b) { return a.index < b.index; });
    return;
  }
  const std::size_t axis = widest_axis(places, begin, end), middle = begin + (end - begin) / 2;
  std::nth_element(at(begin), at(middle), at(end), Before{axis});
  axes_[middle] = static_cast<std::uint8_t>(axis);
  sort(begin, middle, places, stop);
  sort(middle + 1, end, places, stop);
}

/// Calls take(photon, its squared distance) for each that may be within; `take` may shrink `squared`. The nearer side
/// of each split first.
template <class Take>
void PhotonMap::search(const Vec3d& point, double& squared, Take&& take) const {
  struct Range {
    std::size_t begin, end;
    double squared;  // at least as far away
  };
  constexpr std::size_t deepest = 64;
  std::array<Range, deepest> waiting;
  std::size_t count = 0;
  waiting[count++] = {0, photons_.size(), 0};
  while (count > 0) {
    const Range range = waiting[--count];
    if (range.squared > squared) continue;
    if (range.end - range.begin <= few) {
      for (std::size_t i = range.begin; i < range.end; ++i) take(i, squared_distance(photons_[i], point));
      continue;
    }
    const std::size_t middle = range.begin + (range.end - range.begin) / 2;
    const int axis = axes_[middle];
    const double beyond = point[axis] - static_cast<double>(photons_[middle].position[axis]);
    take(middle, squared_distance(photons_[middle], point));
    const Range below{range.begin, middle, 0}, above{middle + 1, range.end, 0};
    Range far = beyond < 0 ? above : below;
    far.squared = beyond * beyond;
    Range near = beyond < 0 ? below : above;
    near.squared = range.squared;
    waiting[count++] = far;
    waiting[count++] = near;
  }
}

PhotonsNear PhotonMap::nearest(const Vec3d& point, const std::optional<Vec3d>& normal, int k, double radius,
                               const PhotonAnswer& answer) const {
  NearestHeap heap(static_cast<std::size_t>(k));
  double squared = radius * radius;
  search(point, squared, [&](std::size_t i, double apart) {
    if (!(apart <= squared) || !is_on_same_side(photons_[i], normal)) return;
    heap.add({apart, i});
    if (heap.full()) squared = heap.farthest().squared;
  });
  PhotonsNear found;
  found.squared_radius = squared;
  for (const NearestHeap::Entry& entry : heap.entries()) {
    if (heap.full() && entry.photon == heap.farthest().photon) continue;  // it marks the edge
    found.power += Rgbd(photons_[entry.photon].power);
    ++found.count;
  }
  if (answer && !incidents_.empty())
    for (const NearestHeap::Entry& entry : heap.entries())
      if (!heap.full() || entry.photon != heap.farthest().photon)
        found.answered += answer(photons_[entry.photon], incidents_[entry.photon]);
  return found;
}

PhotonsNear PhotonMap::within(const Vec3d& point, const std::optional<Vec3d>& normal, double radius,
                              const PhotonAnswer& answer) const {
  PhotonsNear found;
  found.squared_radius = radius * radius;
  search(point, found.squared_radius, [&](std::size_t i, double apart) {
    if (!(apart <= found.squared_radius) || !is_on_same_side(photons_[i], normal)) return;
    found.power += Rgbd(photons_[i].power);
    ++found.count;
    if (answer && !incidents_.empty()) found.answered += answer(photons_[i], incidents_[i]);
  });
  return found;
}

double photon_density(double squared_radius, bool flat) {
  return 1 / (flat ? 2 * std::sqrt(squared_radius) : std::numbers::pi * squared_radius);
}

}  // namespace raywalk
