// What drawing costs, in counts that are exact on every machine.
#pragma once

#include <array>
#include <cstdint>

namespace barrido::raster {

/// The loops that shade fragments.
enum class Loop : std::uint8_t { batch, spans, blocks, lists };
inline constexpr int kLoopCount = 4;

/// What was done, summed over tiles; exact and independent of the number of threads.
struct RasterStatistics {
  std::uint64_t primitives = 0;         ///< Primitives that reached a tile, once each.
  std::uint64_t spans = 0;              ///< Pieces of scanlines (one primitive, one row of one tile).
  std::uint64_t fragments_covered = 0;  ///< Pixel centres inside primitives.
  std::uint64_t fragments_shaded = 0;   ///< Fragments that were interpolated and shaded.
  std::array<std::uint64_t, kLoopCount> shaded_in{};  ///< The same by loop (kernel_key.h).
  /// Quantities interpolated: depth for every covered fragment, 1/w and varyings for every shaded one. One
  /// addition each in the incremental form (S5).
  std::uint64_t interpolations = 0;
  std::uint64_t texel_fetches = 0;     ///< Texels read by the filters.
  std::uint64_t mapped = 0;            ///< Fragments whose coordinates a mapping made.
  std::uint64_t patterns = 0;          ///< Fragments whose texels a procedure made,
  std::uint64_t noise = 0;             ///< and evaluations of noise for them.
  std::uint64_t sorted_fragments = 0;  ///< Fragments that were put in order by depth.
  /// Of those: blended before all others of their pixel were known, which were too many (kMaxPixelLayers).
  std::uint64_t crowded_fragments = 0;
};

}  // namespace barrido::raster
