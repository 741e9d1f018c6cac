// One tile while it is drawn: its pixels, and the working memory of the thread that draws it. Shared by the
// kernels.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "raster/base/stage_profile.h"
#include "raster/fragments/fragment_batch.h"
#include "raster/tiles/binning.h"
#include "raster/tiles/framebuffer.h"
#include "raster/tiles/pixel_layers.h"
#include "raster/tiles/raster_statistics.h"
#include "raster/tiles/samples.h"
#include "raster/tiles/tile_places.h"

namespace barrido::raster {

/// Colour, depth and, for the visibility pass, the mark of the span that is seen in each pixel. Rows of
/// kTileWidth, window row 0 of the tile first. Only the colour array of the frame's format is in use.
struct TileSurface {
  ColorFormat format = ColorFormat::rgba8;
  alignas(64) std::uint32_t color8[kTilePixels + kSurfacePadding];
  alignas(64) float color_float[4][kTilePixels + kSurfacePadding];
  alignas(64) float depth[kTilePixels + kSurfacePadding];
  alignas(64) std::uint32_t visible_span[kTilePixels + kSurfacePadding];
};

/// Depth over the window, z(x, y) = base + ddx·(x − x0) + ddy·(y − y0).
struct DepthPlane {
  double x0, y0, base, ddx, ddy;

  /// At a place in the window, rounded once.
  float at(double x, double y) const { return static_cast<float>((base + ddx * (x - x0)) + ddy * (y - y0)); }
};

/// A triangle of the draws whose visibility is being resolved, in one tile. Row r, relative to the tile,
/// covers columns [first[r], end[r]) before the scissor: interpolation is anchored at `first`
/// (docs/arithmetic.md).
struct TilePrimitive {
  const BinnedChunk* chunk;
  const PrimitiveRecord* record;
  DepthPlane depth;
  int row_begin, row_end;                   ///< Rows that the scissor leaves.
  std::int32_t first_run;                   ///< Head of its list of visible runs, or -1.
  std::uint8_t scissor_begin, scissor_end;  ///< Columns that the scissor leaves.
  std::uint8_t first[kTileHeight + kTilePadding];
  std::uint8_t end[kTileHeight + kTilePadding];
};

/// What stands in TileSurface::visible_span: number of the primitive, then row; 0 is nothing. Greater marks
/// were drawn later.
constexpr std::uint32_t span_mark(std::size_t primitive, int row) {
  return static_cast<std::uint32_t>(primitive * kTileHeight + static_cast<std::size_t>(row) + 1);
}
constexpr std::size_t primitive_of(std::uint32_t mark) { return (mark - 1) / kTileHeight; }

/// A run of pixels of one row in which one span is seen.
struct VisibleRun {
  std::int16_t row;
  std::int16_t begin;
  std::int16_t end;
  std::int32_t next;  ///< Next run of the same primitive, or -1.
};

/// Quantities that the footprint of a texture unit depends on: two coordinates and what they are divided by;
/// the three of a cube map; or those of a point, what they are divided by, and a normal.
inline constexpr int kPointQuantities = 4;
inline constexpr int kMostLodQuantities = 7;

/// What a texture unit's level of detail depends on, for every group of four pixels of a row (columns 4n … 4n
/// + 3 of the tile) that fragments of the batch come from, run by run: the quantities at the group's centre,
/// with their screen derivatives.
struct LodGroups {
  alignas(64) float value[kMostLodQuantities][kBatchStride];
  alignas(64) float dx[kMostLodQuantities][kBatchStride];
  alignas(64) float dy[kMostLodQuantities][kBatchStride];
};

/// Groups that `count` pixels from column x on come from.
constexpr int lod_groups_in(int x, int count) { return ((x + count - 1) >> 2) - (x >> 2) + 1; }

/// What a loop over small triangles has done.
struct LoopCounts {
  std::uint64_t spans = 0, covered = 0, shaded = 0;
};

/// 1/w of a fragment counts as at least this.
inline constexpr float kSmallestQ = 1e-30f;

/// Sums of a tile's samples: of colours multiplied by alpha times weights, the fourth of alpha times weights.
struct TileSums {
  alignas(64) float color[4][kTilePixels + kTilePadding];
  alignas(64) float weight[kTilePixels + kTilePadding];  ///< Where weights differ from pixel to pixel.
  alignas(64) float depth[kTilePixels + kTilePadding];   ///< Of the nearest.
};

struct TileWorkspace {
  TileSurface surface;
  // Only where pixels have more than one sample, or places of their own.
  std::unique_ptr<TileSums> sums;
  std::unique_ptr<TilePlaces> places;
  FragmentBatch batch;
  const KernelKey* key = nullptr;  ///< Of the batch's fragments.
  LodGroups lod_groups[kMaxTextureUnits];
  int lod_group_count = 0;  ///< The same for all units.
  /// Levels and results of the texture unit that is being sampled.
  SampleLevels levels;
  alignas(64) float texel[4][kBatchStride];
  alignas(64) float extent[3][kBatchStride];  ///< Of procedures; see ProcedurePoints.
  /// Primary colours, for texture environments that ask for them after the first unit.
  alignas(64) float primary[4][kBatchStride];
  PixelLayers layers;
  std::vector<TilePrimitive> primitives;
  std::vector<VisibleRun> runs;
  std::vector<const BinnedChunk*> chunks;
  RasterStatistics statistics;
  StageClock clock;
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
  SamplePlace sample;  ///< Where pixels are sampled,
  const TilePlaces* places =
      nullptr;  ///< … unless null, each at a place of its own. Chunks must go by batches.
};

}  // namespace barrido::raster
