// One tile while it is drawn: its pixels, and the working memory of the thread that draws it. Shared by the
// kernels.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/binning.h"
#include "raster/fragment_batch.h"
#include "raster/framebuffer.h"
#include "raster/rasterizer.h"
#include "raster/tile_grid.h"

namespace barrido::raster {

/// Colour, depth and, for the visibility pass, the number of the span that is seen in each pixel. Rows of
/// kTileWidth, window row 0 of the tile first. Only the colour array of the frame's format is in use.
struct TileSurface {
  ColorFormat format = ColorFormat::rgba8;
  alignas(64) std::uint32_t color8[kTilePixels + kTilePadding];
  alignas(64) float color_float[4][kTilePixels + kTilePadding];
  alignas(64) float depth[kTilePixels + kTilePadding];
  alignas(64) std::uint32_t visible_span[kTilePixels + kTilePadding];
};

/// One scanline's piece of one primitive; columns relative to the tile. `first` and `last` are those before
/// the scissor: interpolation is anchored at `first` (docs/arithmetic.md).
struct SpanRecord {
  std::uint32_t primitive;  ///< Position in TileWorkspace::primitives.
  std::int16_t row;
  std::int16_t first;
  std::int16_t last;
};

/// A primitive of the batch of draws whose visibility is being resolved.
struct TilePrimitive {
  const PrimitiveChunk* chunk;
  const PrimitiveRecord* record;
  std::int32_t first_run;  ///< Head of its list of visible runs, or -1.
};

/// A run of pixels of one row in which one span is seen.
struct VisibleRun {
  std::uint32_t span;
  std::int16_t begin;
  std::int16_t end;
  std::int32_t next;  ///< Next run of the same primitive, or -1.
};

struct TileWorkspace {
  TileSurface surface;
  FragmentBatch batch;
  /// Results of the texture unit that is being sampled.
  alignas(64) float texel[4][kBatchStride];
  /// Primary colours, for texture environments that ask for them after the first unit.
  alignas(64) float primary[4][kBatchStride];
  std::vector<SpanRecord> spans;
  std::vector<TilePrimitive> primitives;
  std::vector<VisibleRun> runs;
  std::vector<const BinnedChunk*> chunks;
  RasterStatistics statistics;
};

/// What the tile kernel is asked to do.
struct TileJob {
  int column = 0;  ///< Of the tile in the grid.
  int row = 0;
  int width = 0;  ///< Pixels of the tile that lie in the frame.
  int height = 0;
  const std::vector<const BinnedChunk*>* chunks =
      nullptr;  ///< In drawing order; only those that touch the tile.
  bool visibility_first = true;
};

}  // namespace barrido::raster
