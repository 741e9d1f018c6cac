// Memory for the large arrays, frames and textures: begins at a cache line, so that whole lines can be
// written past the caches, and asks for huge pages, which cost less to get and miss the translation buffer
// less.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace barrido::raster {

/// Room for `bytes`, not cleared, aligned to 64 bytes (large arrays to more). @throws std::bad_alloc
void* allocate_array(std::size_t bytes);
void free_array(void* memory, std::size_t bytes);

template <class T>
struct ArrayAllocator {
  using value_type = T;

  ArrayAllocator() = default;
  template <class U>
  ArrayAllocator(const ArrayAllocator<U>&) {}  // NOLINT(google-explicit-constructor): as allocators are
  T* allocate(std::size_t count) { return static_cast<T*>(allocate_array(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) { free_array(memory, count * sizeof(T)); }
  friend bool operator==(const ArrayAllocator&, const ArrayAllocator&) { return true; }
};

/// The same, whose new elements are left as the memory is.
template <class T>
struct UnclearedAllocator : ArrayAllocator<T> {
  static_assert(std::is_trivially_default_constructible_v<T>);
  template <class U>
  struct rebind {  // NOLINT(readability-identifier-naming): as allocators have it
    using other = UnclearedAllocator<U>;
  };

  UnclearedAllocator() = default;
  template <class U>
  UnclearedAllocator(const UnclearedAllocator<U>&) {}  // NOLINT(google-explicit-constructor)
  template <class U>
  void construct(U* element) {
    ::new (static_cast<void*>(element)) U;
  }
  template <class U, class... Arguments>
  void construct(U* element, Arguments&&... arguments) {
    ::new (static_cast<void*>(element)) U(std::forward<Arguments>(arguments)...);
  }
};

template <class T>
using PixelArray = std::vector<T, ArrayAllocator<T>>;
template <class T>
using UnclearedArray = std::vector<T, UnclearedAllocator<T>>;

}  // namespace barrido::raster
