// The module's own `new` and `delete`, which the linker gives to it and to the library within it alone. They
// take memory from malloc as the C++ library does, so that what one has taken the other may give back.
#include "pipeline/gltf/draco_module/allowance.h"

#include <malloc.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace barrido::draco_module {
namespace {

constexpr std::size_t kUnlimited = SIZE_MAX;
thread_local std::size_t bytes_left = kUnlimited;

[[maybe_unused]] void* take(std::size_t bytes) noexcept {
  if (bytes > bytes_left) return nullptr;
  void* memory = std::malloc(std::max<std::size_t>(bytes, 1));
  if (memory != nullptr && bytes_left != kUnlimited) {
    bytes_left -= std::min(bytes_left, ::malloc_usable_size(memory));
  }
  return memory;
}

[[maybe_unused]] void give_back(void* memory) noexcept {
  if (memory != nullptr && bytes_left != kUnlimited) {
    bytes_left += std::min(kUnlimited - 1 - bytes_left, ::malloc_usable_size(memory));
  }
  std::free(memory);
}

}  // namespace

Allowance::Allowance(std::size_t bytes) { bytes_left = std::min(bytes, kUnlimited - 1); }
Allowance::~Allowance() { bytes_left = kUnlimited; }

}  // namespace barrido::draco_module

#ifndef BARRIDO_ADDRESS_SANITIZER
// NOLINTBEGIN(misc-new-delete-overloads): the others end up in these
void* operator new(std::size_t bytes) {
  void* memory = barrido::draco_module::take(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* operator new[](std::size_t bytes) { return operator new(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return barrido::draco_module::take(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return barrido::draco_module::take(bytes);
}
void operator delete(void* memory) noexcept { barrido::draco_module::give_back(memory); }
void operator delete[](void* memory) noexcept { barrido::draco_module::give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { barrido::draco_module::give_back(memory); }
void operator delete[](void* memory, std::size_t) noexcept { barrido::draco_module::give_back(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  barrido::draco_module::give_back(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
  barrido::draco_module::give_back(memory);
}
// NOLINTEND(misc-new-delete-overloads)
#endif
