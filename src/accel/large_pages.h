#pragma once
// Memory for what searches read here and there.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#ifdef MADV_HUGEPAGE
#define RAYWALK_LARGE_PAGES
#endif
#endif

namespace raywalk {

/// An allocator that asks for large pages, if the system has such, for what fills at least one. A processor knows by
/// heart where a few thousand pages lie: in pages of 4 KiB, that is less than the tree of a million triangles takes.
/// Such memory comes from the system itself: what was freed before, and is used again, has small pages already.
template <class Element>
struct InLargePages {
  using value_type = Element;

  InLargePages() = default;
  template <class Other>
  explicit(false) InLargePages(const InLargePages<Other>&) {}

  [[nodiscard]] Element* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / 2 / sizeof(Element)) throw std::bad_array_new_length();
    const std::size_t bytes = count * sizeof(Element);
#ifdef RAYWALK_LARGE_PAGES
    if (bytes >= large_page) return static_cast<Element*>(mapped(bytes));
#endif
    return static_cast<Element*>(::operator new(bytes, std::align_val_t{alignof(Element)}));
  }
  void deallocate(Element* memory, std::size_t count) {
    const std::size_t bytes = count * sizeof(Element);
#ifdef RAYWALK_LARGE_PAGES
    if (bytes >= large_page) return static_cast<void>(::munmap(memory, in_pages(bytes)));
#endif
    ::operator delete(memory, bytes, std::align_val_t{alignof(Element)});
  }

  friend bool operator==(const InLargePages&, const InLargePages&) { return true; }

 private:
#ifdef RAYWALK_LARGE_PAGES
  static constexpr std::size_t large_page = std::size_t{2} << 20;

  static std::size_t in_pages(std::size_t bytes) {
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    return (bytes + page - 1) / page * page;
  }

  /// From the beginning of a large page on.
  static void* mapped(std::size_t bytes) {
    const std::size_t size = in_pages(bytes), all = size + large_page;
    void* const memory = ::mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    char* const first = static_cast<char*>(memory);
    const std::size_t before = (large_page - reinterpret_cast<std::uintptr_t>(first) % large_page) % large_page;
    if (before > 0) ::munmap(first, before);
    ::munmap(first + before + size, all - before - size);
    // Where the system refuses, nothing is lost.
    static_cast<void>(::madvise(first + before, bytes / large_page * large_page, MADV_HUGEPAGE));
    return first + before;
  }
#endif
};

template <class Element>
using LargeArray = std::vector<Element, InLargePages<Element>>;

}  // namespace raywalk
