#include "accel/primitives.h"

#include <algorithm>
#include <bit>
#include <functional>

namespace raywalk {

namespace {

/// Equal boxes have equal keys; different ones rarely do.
template <class T>
std::uint64_t key_of(const Bounds<T>& box) {
  std::uint64_t key = 0;
  for (const Vec3<T>* corner : {&box.min, &box.max})
    for (int axis = 0; axis < 3; ++axis) {
      const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>((*corner)[axis]) + 0.0);  // -0 is 0
      key = (key ^ bits) * 0x9e3779b97f4a7c15U;
      key ^= key >> 29;
    }
  return key;
}

}  // namespace

template <class T>
void Primitives<T>::move(int first, int end, const Motion& motion) {
  if (first == end || motion.empty()) return;
  for (int id = first; id < std::min(end, shape_count()); ++id) plain_[static_cast<std::size_t>(id)] = Plain::moving;
  triangles_move_ = triangles_move_ || end > shape_count();
  if (motion_of_.size() < static_cast<std::size_t>(end)) motion_of_.resize(static_cast<std::size_t>(end), none);
  std::fill(motion_of_.begin() + first, motion_of_.begin() + end, static_cast<std::int32_t>(motions_.size()));
  motions_.push_back(motion);
}

template <class T>
Bounds<T> Primitives<T>::box(int id) const {
  Bounds<T> box = id < shape_count() ? bounds(own(id)) : bounds(triangles_[id - shape_count()]);
  // The largest of the numbers that a hit is computed from, which may cancel: its rounding is in proportion to them.
  Vec3<T> size = largest_coordinates(box);
  if (const ObjectTransform<T>* transform = transform_of(id)) {
    const Affine<T>&out = transform->to_world, &in = transform->to_object;
    const Vec3<T> own = size;
    box = image_of(out, box);
    size = largest_coordinates(box);
    if (box.bounded()) size = absolute(out.move) + term_sizes(out, own + absolute(in.move) + term_sizes(in, size));
  }
  if (const Motion* motion = motion_of(id); motion && !box.empty()) {
    const Bounds<T> rest = box;
    Bounds<T> offsets;
    box = {};
    const auto include = [&](double time) {
      const Vec3<T> offset(offset_at(*motion, time));
      box.include({rest.min + offset, rest.max + offset});
      offsets.include(offset);
    };
    include(open_);
    include(close_);
    for (const MotionKey& key : *motion)
      if (open_ < key.time && key.time < close_) include(key.time);
    size += largest_coordinates(offsets);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const T pad = 8 * std::numeric_limits<T>::epsilon() * size[axis];
    box.min[axis] -= pad;
    box.max[axis] += pad;
  }
  return box;
}

template <class T>
bool Primitives<T>::equal(int a, int b) const {
  const Motion *motion_a = motion_of(a), *motion_b = motion_of(b);
  if (motion_a && motion_b ? *motion_a != *motion_b : motion_a != motion_b) return false;
  const int shapes = shape_count();
  if (a >= shapes || b >= shapes) return a >= shapes && b >= shapes && triangles_.equal(a - shapes, b - shapes);
  const ObjectTransform<T>*transform_a = transform_of(a), *transform_b = transform_of(b);
  const bool same_place =
      transform_a && transform_b ? transform_a->to_world == transform_b->to_world : transform_a == transform_b;
  return same_place && own(a) == own(b);
}

template <class T>
void Primitives<T>::find_equals(const std::vector<Bounds<T>>& boxes, const Stop& stop) {
  // Equal primitives have equal boxes, so only those with the same key are compared.
  std::vector<std::pair<std::uint64_t, std::int32_t>> order;
  order.reserve(boxes.size());
  const int count = static_cast<int>(boxes.size());
  for (int id = 0; id < count; ++id) order.emplace_back(key_of(boxes[static_cast<std::size_t>(id)]), id);
  stop.sort(order.begin(), order.end(), std::less<>());
  std::vector<std::int32_t> different;  // of the current key, the lowest id of each distinct primitive
  for (std::size_t i = 0; i < order.size(); ++i) {
    stop.check();
    const auto [key, id] = order[i];
    const bool is_new_key = i == 0 || key != order[i - 1].first;
    if (is_new_key) different.clear();
    const auto same = std::find_if(different.begin(), different.end(), [&](int other) { return equal(id, other); });
    if (same == different.end()) {
      different.push_back(id);
      continue;
    }
    any_equal_ = true;
    if (first_equal_.empty()) {
      for (int each = 0; each < count; ++each) first_equal_.push_back(each);
    }
    first_equal_[static_cast<std::size_t>(id)] = *same;
  }
}

template class Primitives<float>;
template class Primitives<double>;

}  // namespace raywalk
