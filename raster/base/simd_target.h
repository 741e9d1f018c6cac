// Run-time choice of the instruction set. Every kernel is compiled once per target by Highway; all targets
// give the same bits, so the choice is one of speed alone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace barrido::raster {

enum class SimdTarget { automatic, scalar, sse4, avx2, avx512, neon };

/// Targets this program was compiled with and this processor can run; never empty, slowest first.
std::vector<SimdTarget> available_simd_targets();

/// Uses `target` for all kernels from now on; not to be called while a frame is being drawn.
/// @return false (and nothing changes) when the target is not available here.
bool set_simd_target(SimdTarget target);

/// The target in use.
SimdTarget simd_target();

/// "scalar", "sse4", "avx2", "avx512", "neon" or "auto".
std::string_view name_of(SimdTarget target);

}  // namespace barrido::raster
