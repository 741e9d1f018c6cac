// Memory of one frame's vertices: handed out from large blocks that are kept from frame to frame, because
// fresh pages cost as much as the vertex stage itself. Nothing is freed before the frame is finished.
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include "raster/base/memory.h"

namespace barrido::pipeline {

class FrameMemory {
 public:
  /// Uninitialised room for `count` elements, aligned to 64 bytes, valid until reset().
  template <class T>
  T* allocate(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T> && alignof(T) <= kAlignment);
    return static_cast<T*>(allocate_bytes(count * sizeof(T)));
  }

  /// Takes back everything that was handed out. Several blocks become one that would have held it all.
  void reset();

 private:
  static constexpr std::size_t kAlignment = 64;
  /// The first block suits small frames; further ones are large enough for huge pages.
  static constexpr std::size_t kFirstBlockBytes = std::size_t{1} << 20;
  static constexpr std::size_t kNextBlockBytes = std::size_t{8} << 20;

  using Block = raster::UnclearedArray<std::byte>;

  void* allocate_bytes(std::size_t size);
  void add_block(std::size_t size);

  std::vector<Block> blocks_;   // the last one is in use
  std::size_t used_bytes_ = 0;  // of the last block
};

}  // namespace barrido::pipeline
