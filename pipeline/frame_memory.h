// Memory of one frame's vertices: handed out from large blocks that are kept from frame to frame, because
// fresh pages cost as much as the vertex stage itself. Nothing is freed before the frame is finished.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

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
  static constexpr std::size_t kMinBlockBytes = std::size_t{1} << 20;

  struct Deleter {
    void operator()(std::byte* p) const { ::operator delete[](p, std::align_val_t{kAlignment}); }
  };
  struct Block {
    std::unique_ptr<std::byte[], Deleter> bytes;
    std::size_t size = 0;
  };

  void* allocate_bytes(std::size_t size);
  void add_block(std::size_t size);

  std::vector<Block> blocks_;   // the last one is in use
  std::size_t used_bytes_ = 0;  // of the last block
};

}  // namespace barrido::pipeline
