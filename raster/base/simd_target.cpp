#include "raster/base/simd_target.h"

#include <hwy/highway.h>

namespace barrido::raster {
namespace {

struct NamedTarget {
  SimdTarget target;
  std::int64_t highway;
  std::string_view name;
};

constexpr NamedTarget kTargets[] = {
    {SimdTarget::scalar, HWY_EMU128, "scalar"}, {SimdTarget::neon, HWY_NEON, "neon"},
    {SimdTarget::sse4, HWY_SSE4, "sse4"},       {SimdTarget::avx2, HWY_AVX2, "avx2"},
    {SimdTarget::avx512, HWY_AVX3, "avx512"},
};

std::int64_t usable_targets() { return (hwy::SupportedTargets() | HWY_EMU128) & HWY_TARGETS; }

SimdTarget chosen = SimdTarget::automatic;

}  // namespace

std::vector<SimdTarget> available_simd_targets() {
  std::vector<SimdTarget> available;
  for (const NamedTarget& entry : kTargets) {
    if ((usable_targets() & entry.highway) != 0) available.push_back(entry.target);
  }
  return available;
}

bool set_simd_target(SimdTarget target) {
  if (target == SimdTarget::automatic) {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    chosen = target;
    return true;
  }
  for (const NamedTarget& entry : kTargets) {
    if (entry.target != target || (usable_targets() & entry.highway) == 0) continue;
    hwy::GetChosenTarget().Update(entry.highway);
    chosen = target;
    return true;
  }
  return false;
}

SimdTarget simd_target() {
  return chosen == SimdTarget::automatic ? available_simd_targets().back() : chosen;
}

std::string_view name_of(SimdTarget target) {
  for (const NamedTarget& entry : kTargets) {
    if (entry.target == target) return entry.name;
  }
  return "auto";
}

}  // namespace barrido::raster
