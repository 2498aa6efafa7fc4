#pragma once
// The loop of a PacketSearch, to be compiled for each width.

#include "accel/packet_search.h"

#include <bit>

namespace raywalk {

struct PacketLoop {
  /// `Tests`: see accel/searches_at_width.h.
  template <class Tests, bool nearest_first>
  [[gnu::always_inline]] static inline bool run(PacketSearch& search) {
    const RayPacket& packet = search.packet_;
    const float t_far = packet.latest();
    const WideNode* const nodes = search.tree_.nodes();
    auto* const stack = search.stack_.data();
    std::size_t waiting = search.waiting_;
    // Puts the boxes of a node that some ray may meet onto the stack, nearer ones on top if hits shorten rays.
    const auto enter = [&](std::uint32_t index, unsigned rays) __attribute__((always_inline)) {
      const WideNode& node = nodes[index];
      search.nodes_ += bit_count(rays);
      alignas(32) BoxEntry entries[tree_width];
      const std::size_t before = waiting;
      for (unsigned met = Tests::meet(packet, t_far, node, entries); met != 0; met &= met - 1) {
        const BoxEntry entry = entries[std::countr_zero(met)];
        search.tree_.fetch(node.children[entry.lane()]);
        std::size_t place = waiting++;
        if constexpr (nearest_first)
          for (; place > before && stack[place - 1].entry < entry; --place) stack[place] = stack[place - 1];
        stack[place] = {index, entry, rays};
      }
    };
    if (!search.begun_) enter(0, packet.members);
    search.begun_ = true;
    while (waiting > 0 && t_far >= 0) {
      const auto top = stack[--waiting];
      const WideNode& node = nodes[top.node];
      const unsigned rays = Tests::rays_that_meet(packet, node, top.entry.lane(), top.rays);
      if (rays == 0) continue;
      const TreeChild child = node.children[top.entry.lane()];
      if (!child.is_leaf()) {
        enter(child.index(), rays);
        continue;
      }
      search.all_ = (1U << child.count()) - 1;
      if (child.is_pack()) {
        search.pack_ = &search.tree_.pack(child.index());
        search.ids_ = search.pack_->ids;
        sift<Tests>(search, rays, child.count());
        if (search.rays_ == 0) continue;
      } else {
        search.pack_ = nullptr;
        search.ids_ = search.tree_.listed(child.index());
        search.rays_ = rays;
        search.candidates_.fill(static_cast<std::uint8_t>(search.all_));
      }
      search.waiting_ = waiting;
      return true;
    }
    search.waiting_ = 0;
    return false;
  }

 private:
  /// Finds out which of `rays` may hit what of the pack: ray by ray or triangle by triangle, whichever takes fewer
  /// steps.
  template <class Tests>
  [[gnu::always_inline]] static inline void sift(PacketSearch& search, unsigned rays, unsigned count) {
    const RayPacket& packet = search.packet_;
    const unsigned asking = bit_count(rays);
    search.rays_ = 0;
    if (asking * Tests::groups_of_triangles > count * Tests::groups_of_rays) {
      search.candidates_.fill(0);
      for (unsigned lane = 0; lane < count; ++lane) {
        const unsigned hits = Tests::rays_that_may_hit(packet, *search.pack_, lane, rays);
        search.rays_ |= hits;
        for (unsigned bits = hits; bits != 0; bits &= bits - 1)
          search.candidates_[static_cast<unsigned>(std::countr_zero(bits))] |= static_cast<std::uint8_t>(1U << lane);
      }
    } else {
      for (unsigned bits = rays; bits != 0; bits &= bits - 1) {
        const auto ray = static_cast<unsigned>(std::countr_zero(bits));
        const unsigned candidates = Tests::sift(packet, ray, *search.pack_, count);
        search.candidates_[ray] = static_cast<std::uint8_t>(candidates);
        search.rays_ |= unsigned{candidates != 0} << ray;
      }
    }
    search.passed_over_ += count * (asking - bit_count(search.rays_));
  }

  /// Not every processor has an instruction for it.
  static unsigned bit_count(unsigned rays) {
    rays -= rays >> 1 & 0x5555U;
    rays = (rays & 0x3333U) + (rays >> 2 & 0x3333U);
    return ((rays + (rays >> 4)) & 0x0f0fU) * 0x0101U >> 8 & 0x1fU;
  }
};

}  // namespace raywalk
