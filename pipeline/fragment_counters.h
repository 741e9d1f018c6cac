// Counts of work done inside per-fragment illumination (S8). Threads count in cells of their own, so that
// counting does not slow drawing down; the sums are exact.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace barrido::pipeline {

class FragmentCounters {
 public:
  /// Safe to call from any thread.
  void add(std::uint64_t illuminations, std::uint64_t powers) {
    static std::atomic<std::size_t> next_cell{0};
    thread_local const std::size_t cell = next_cell.fetch_add(1, std::memory_order_relaxed) % kCells;
    cells_[cell].illuminations.fetch_add(illuminations, std::memory_order_relaxed);
    cells_[cell].powers.fetch_add(powers, std::memory_order_relaxed);
  }

  std::uint64_t illuminations() const { return sum(&Cell::illuminations); }
  std::uint64_t powers() const { return sum(&Cell::powers); }

 private:
  static constexpr std::size_t kCells = 32;
  struct alignas(64) Cell {
    std::atomic<std::uint64_t> illuminations{0};
    std::atomic<std::uint64_t> powers{0};
  };

  std::uint64_t sum(std::atomic<std::uint64_t> Cell::*count) const {
    std::uint64_t total = 0;
    for (const Cell& cell : cells_) total += (cell.*count).load(std::memory_order_relaxed);
    return total;
  }

  std::array<Cell, kCells> cells_;
};

}  // namespace barrido::pipeline
