// The rasterizer: takes chunks of window-space primitives in drawing order, cuts the frame into tiles, and
// gives every tile to one thread, which draws its primitives in order. So the picture depends neither on the
// number of threads nor on the vector width. Must not know: scenes, lights, files, windows.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "raster/framebuffer.h"
#include "raster/primitive.h"
#include "raster/stage_profile.h"

namespace barrido::raster {

struct RasterizerOptions {
  /// Resolve visibility of opaque primitives before shading them, so that hidden fragments cost a depth test
  /// only. Off: every fragment that passes its depth test in drawing order is shaded. Same bits either way.
  bool visibility_first = true;
  /// Where the time goes, or null: then no clock is read. Must outlive the rasterizer.
  StageProfile* profile = nullptr;
};

struct ClearValues {
  std::array<float, 4> color{0, 0, 0, 0};
  float depth = 1.0f;
};

/// What was done, summed over tiles; exact and independent of the number of threads.
struct RasterStatistics {
  std::uint64_t primitives = 0;         ///< Primitives that reached a tile, once each.
  std::uint64_t spans = 0;              ///< Pieces of scanlines (one primitive, one row of one tile).
  std::uint64_t fragments_covered = 0;  ///< Pixel centres inside primitives.
  std::uint64_t fragments_shaded = 0;   ///< Fragments that were interpolated and shaded.
  /// Quantities interpolated: depth for every covered fragment, 1/w and varyings for every shaded one. One
  /// addition each in the incremental form (S5).
  std::uint64_t interpolations = 0;
  std::uint64_t texel_fetches = 0;  ///< Texels read by the filters.
};

class BinnedChunk;

class Rasterizer {
 public:
  explicit Rasterizer(Framebuffer& framebuffer, const RasterizerOptions& options = {});
  ~Rasterizer();
  Rasterizer(const Rasterizer&) = delete;
  Rasterizer& operator=(const Rasterizer&) = delete;

  /// Forgets all that was submitted; the frame starts from these values.
  void clear(const ClearValues& values);

  /// Sorts a chunk's primitives into tiles. Safe to call from several threads at once.
  std::unique_ptr<BinnedChunk> bin(PrimitiveChunk&& chunk) const;
  /// Appends a chunk to the drawing order.
  void submit(std::unique_ptr<BinnedChunk> chunk);

  /// Draws all that was submitted into the framebuffer. More may be submitted afterwards, on top, when the
  /// framebuffer keeps depth and, for rgba32f, float colours.
  /// @throws std::logic_error when it does not and this is not the first flush after clear().
  void flush();

  const RasterStatistics& statistics() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace barrido::raster
