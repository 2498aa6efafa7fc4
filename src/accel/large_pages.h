#pragma once
// Memory for what searches read here and there.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace raywalk {

/// An allocator that asks for large pages, if the system has such, for what fills at least one. A processor knows by
/// heart where a few thousand pages lie: in pages of 4 KiB, that is less than the tree of a million triangles takes.
template <class Element>
struct InLargePages {
  using value_type = Element;

  InLargePages() = default;
  template <class Other>
  explicit(false) InLargePages(const InLargePages<Other>&) {}

  [[nodiscard]] Element* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(Element)) throw std::bad_array_new_length();
    const std::size_t bytes = count * sizeof(Element);
    void* memory = ::operator new(bytes, alignment_for(bytes));
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    // Where the system refuses, nothing is lost.
    if (bytes >= large_page) static_cast<void>(::madvise(memory, bytes / large_page * large_page, MADV_HUGEPAGE));
#endif
    return static_cast<Element*>(memory);
  }
  void deallocate(Element* memory, std::size_t count) {
    const std::size_t bytes = count * sizeof(Element);
    ::operator delete(memory, bytes, alignment_for(bytes));
  }

  friend bool operator==(const InLargePages&, const InLargePages&) { return true; }

 private:
  static constexpr std::size_t large_page = std::size_t{2} << 20;
  static std::align_val_t alignment_for(std::size_t bytes) {
    return std::align_val_t{bytes < large_page ? alignof(Element) : std::max(alignof(Element), large_page)};
  }
};

template <class Element>
using LargeArray = std::vector<Element, InLargePages<Element>>;

}  // namespace raywalk
