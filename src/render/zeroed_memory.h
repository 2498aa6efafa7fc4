#pragma once

#include <cstdlib>
#include <limits>
#include <new>
#include <utility>

namespace raywalk {

/// An allocator whose values are all bits 0 until they are written: the system hands out such pages when they are first
/// touched, so that a large picture that is cancelled early has cost no time. For types whose value 0 is all bits 0.
template <class Value>
struct ZeroedMemory {
  using value_type = Value;

  ZeroedMemory() = default;
  template <class Other>
  explicit(false) ZeroedMemory(const ZeroedMemory<Other>&) {}

  [[nodiscard]] Value* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(Value)) throw std::bad_array_new_length();
    if (auto* memory = static_cast<Value*>(std::calloc(count, sizeof(Value)))) return memory;
    throw std::bad_alloc();
  }
  void deallocate(Value* memory, std::size_t) { std::free(memory); }

  template <class Other>
  void construct(Other*) {}  // is 0 already
  template <class Other, class... Arguments>
  void construct(Other* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) Other(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const ZeroedMemory&, const ZeroedMemory&) { return true; }
};

}  // namespace raywalk
