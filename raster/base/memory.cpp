#include "raster/base/memory.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace barrido::raster {
namespace {

constexpr std::size_t kCacheLine = 64;
constexpr std::size_t kHugePage = std::size_t{2} << 20;

bool takes_huge_pages(std::size_t bytes) { return bytes >= kHugePage; }

std::align_val_t alignment(std::size_t bytes) {
  return std::align_val_t{takes_huge_pages(bytes) ? kHugePage : kCacheLine};
}

}  // namespace

void* allocate_array(std::size_t bytes) {
  void* memory = ::operator new(bytes, alignment(bytes));
#ifdef __linux__
  // Only whole huge pages are asked for, and a refusal changes nothing but the speed.
  if (takes_huge_pages(bytes)) madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
  return memory;
}

void free_array(void* memory, std::size_t bytes) { ::operator delete(memory, alignment(bytes)); }

}  // namespace barrido::raster
