#include "pipeline/frame_memory.h"

#include <algorithm>

namespace barrido::pipeline {

void* FrameMemory::allocate_bytes(std::size_t size) {
  const std::size_t rounded = (size + kAlignment - 1) / kAlignment * kAlignment;
  if (blocks_.empty() || used_bytes_ + rounded > blocks_.back().size()) {
    add_block(std::max(rounded, blocks_.empty() ? kFirstBlockBytes : kNextBlockBytes));
  }
  void* result = blocks_.back().data() + used_bytes_;
  used_bytes_ += rounded;
  return result;
}

void FrameMemory::add_block(std::size_t size) {
  blocks_.emplace_back(size);
  used_bytes_ = 0;
}

void FrameMemory::reset() {
  used_bytes_ = 0;
  if (blocks_.size() < 2) return;
  std::size_t total = 0;
  for (const Block& block : blocks_) total += block.size();
  blocks_.clear();
  add_block(total);
}

}  // namespace barrido::pipeline
