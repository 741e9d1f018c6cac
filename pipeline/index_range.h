// The one pass over a draw's indices: which vertices it uses.
#pragma once

#include <cstdint>
#include <span>

namespace barrido::pipeline {

struct IndexRange {
  std::uint32_t smallest = 0;
  std::uint32_t largest = 0;
};

/// Smallest and largest of at least one index.
IndexRange index_range(std::span<const std::uint32_t> indices);

}  // namespace barrido::pipeline
