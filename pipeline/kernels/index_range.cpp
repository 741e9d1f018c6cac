// Minimum and maximum of index arrays on vectors.
#include "pipeline/index_range.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/kernels/index_range.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

IndexRange FindIndexRange(std::span<const std::uint32_t> indices) {
  const hn::ScalableTag<std::uint32_t> d;
  const std::size_t lanes = hn::Lanes(d);
  auto smallest = hn::Set(d, indices[0]);
  auto largest = smallest;
  std::size_t i = 0;
  for (; i + lanes <= indices.size(); i += lanes) {
    const auto v = hn::LoadU(d, indices.data() + i);
    smallest = hn::Min(smallest, v);
    largest = hn::Max(largest, v);
  }
  IndexRange range{hn::GetLane(hn::MinOfLanes(d, smallest)), hn::GetLane(hn::MaxOfLanes(d, largest))};
  for (; i < indices.size(); ++i) {
    range.smallest = range.smallest < indices[i] ? range.smallest : indices[i];
    range.largest = range.largest > indices[i] ? range.largest : indices[i];
  }
  return range;
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace barrido::pipeline {

HWY_EXPORT(FindIndexRange);

IndexRange index_range(std::span<const std::uint32_t> indices) {
  constexpr std::size_t kGrain = std::size_t{1} << 16;
  if (indices.size() <= kGrain) return HWY_DYNAMIC_DISPATCH(FindIndexRange)(indices);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, indices.size(), kGrain), IndexRange{indices[0], indices[0]},
      [&](const tbb::blocked_range<std::size_t>& part, IndexRange so_far) {
        const IndexRange r = HWY_DYNAMIC_DISPATCH(FindIndexRange)(indices.subspan(part.begin(), part.size()));
        return IndexRange{std::min(so_far.smallest, r.smallest), std::max(so_far.largest, r.largest)};
      },
      [](IndexRange a, IndexRange b) {
        return IndexRange{std::min(a.smallest, b.smallest), std::max(a.largest, b.largest)};
      });
}

}  // namespace barrido::pipeline
#endif
