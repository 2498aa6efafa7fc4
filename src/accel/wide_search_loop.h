#pragma once
// The loop of a WideSearch, to be compiled for each width and kind of ray.

#include "accel/wide_search.h"

#include <algorithm>
#include <bit>

namespace raywalk {

struct SearchLoop {
  /// `Tests` has `hold`, `meet` and `sift` for `Terms`, see accel/lane_tests.h.
  template <class Tests, bool nearest_first, bool watched, class Terms>
  [[gnu::always_inline]] static inline bool run(WideSearch<Terms>& search, typename WideSearch<Terms>::Far t_far) {
    std::size_t waiting = search.waiting_;
    [[maybe_unused]] Bounds<float> box;
    std::uint64_t entered = search.nodes_;
    const WideNode* const nodes = search.tree_.nodes();
    auto* const stack = search.stack_.data();
    if constexpr (nearest_first && !watched) {
      // Often all that waits does so in vain.
      while (waiting > 0 && beyond(stack[waiting - 1].entry.t(), t_far)) --waiting;
      if (waiting == 0) {
        search.waiting_ = 0;
        return false;
      }
    }
    typename Tests::Held held;
    Tests::hold(search.terms_, t_far, held);
    while (waiting > 0) {
      TreeChild at = stack[--waiting].child;
      if constexpr (watched) box = search.boxes_[waiting];
      // A box met before t_far is still met, unless t_far has become shorter.
      if (nearest_first && beyond(stack[waiting].entry.t(), t_far)) {
        if constexpr (watched) search.record_->skipped(box);
        continue;
      }
      while (!at.is_leaf()) {
        const WideNode& node = nodes[at.index()];
        ++entered;
        alignas(32) BoxEntry entries[tree_width];
        unsigned met = Tests::meet(held, node, entries);
        if constexpr (watched) tell(*search.record_, node, met);
        if (met == 0) break;
        // The nearest child is next; the others go onto the stack, nearer ones on top if hits shorten the ray.
        const auto first = static_cast<unsigned>(std::countr_zero(met));
        if (!watched && (met & (met - 1)) == 0) {  // a single one
          at = node.children[first];
          continue;
        }
        const std::size_t before = waiting;
        BoxEntry next = entries[first];
        while ((met &= met - 1) != 0) {
          const BoxEntry other = entries[std::countr_zero(met)];
          const BoxEntry waits = nearest_first ? std::max(next, other) : next;
          if constexpr (!watched) search.tree_.fetch(node.children[waits.lane()]);
          next = nearest_first ? std::min(next, other) : other;
          std::size_t place = waiting++;
          if constexpr (nearest_first)
            for (; place > before && stack[place - 1].entry < waits; --place) {
              stack[place] = stack[place - 1];
              if constexpr (watched) search.boxes_[place] = search.boxes_[place - 1];
            }
          stack[place] = {node.children[waits.lane()], waits};
          if constexpr (watched) search.boxes_[place] = node.box(waits.lane());
        }
        at = node.children[next.lane()];
        if constexpr (watched) box = node.box(next.lane());
      }
      if (!at.is_leaf()) continue;  // nothing of the node was met
      if constexpr (watched) search.record_->opened(box, at.count());
      const unsigned all = (1U << at.count()) - 1;
      if (at.is_pack()) {
        const TrianglePack& pack = search.tree_.pack(at.index());
        unsigned certain = 0;
        const unsigned candidates = Tests::template sift<!nearest_first>(held, pack, at.count(), certain);
        search.found_ = {pack.ids, &pack, candidates, all & ~candidates, certain};
        if (!watched && candidates == 0) {
          search.passed_over_ += at.count();
          continue;
        }
      } else {
        search.found_ = {search.tree_.listed(at.index()), nullptr, all, 0, 0};
      }
      search.waiting_ = waiting;
      search.nodes_ = entered;
      return true;
    }
    search.waiting_ = 0;
    search.nodes_ = entered;
    return false;
  }

 private:
  /// Whether a box entered at `in`, up to rounding, lies beyond t_far.
  template <class Far>
  static bool beyond(float in, Far t_far) {
    return static_cast<Far>(in * (1 - 8 * std::numeric_limits<float>::epsilon())) > t_far;
  }

  static void tell(SearchRecord& record, const WideNode& node, unsigned met) {
    record.entered(node.whole(), false, node.count);
    for (unsigned lane = 0; lane < node.count; ++lane)
      if ((met >> lane & 1U) == 0) record.skipped(node.box(lane));
  }
};

}  // namespace raywalk
