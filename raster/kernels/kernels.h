// The vector kernels, each compiled for every instruction set and called through the one in use
// (simd_target.h).
#pragma once

#include "raster/tiles/tile.h"

namespace barrido::raster {

/// Draws the job's chunks into workspace.surface.
void rasterize_tile(const TileJob& job, TileWorkspace& workspace);

/// Shades all fragments of workspace.batch, writes them to workspace.surface and empties the batch.
void shade_batch(TileWorkspace& workspace);

/// Quantities that are interpolated for a shaded fragment: the varyings, and q where it divides any.
inline std::uint64_t quantities_a_fragment(const VaryingList& varyings) {
  return static_cast<std::uint64_t>(varyings.count + (varyings.count > varyings.affine_count ? 1 : 0));
}

/// Mip levels of every fragment of the batch for `unit`, by the level of detail of `group_count` groups of
/// pixels; the same for all when the unit's filters do not depend on it.
void find_levels(const LodGroups& groups, int group_count, int unit, const FragmentBatch& batch,
                 SampleLevels& levels);

/// Width of the box in the unit's coordinates that a pixel of each fragment covers, for a unit with a
/// procedure: extent[coordinate][fragment]. Whole vectors.
void find_extents(const LodGroups& groups, int group_count, int unit, const FragmentBatch& batch,
                  float (*extent)[kBatchStride]);

/// The unit's points become two coordinates, in place, by its mapping.
void map_coordinates(FragmentBatch& batch, int unit);

/// The unit's two coordinates are changed tile by tile, in place.
void change_tiles(FragmentBatch& batch, int unit);

/// The pattern's value in [0, 1] at every point. @return how often noise was evaluated.
std::uint64_t pattern_values(const Pattern& pattern, const ProcedurePoints& points, float* value);

/// Samples `unit`'s texture for every fragment of the batch: texel[channel][fragment] in [0, 1].
/// @return texels read.
std::uint64_t sample_texture(const FragmentBatch& batch, int unit, const SampleLevels& levels,
                             float (*texel)[kBatchStride]);

/// The texels of `unit` for every fragment of the batch, of its picture or procedure, into workspace.texel;
/// counted in the statistics.
void sample_unit(TileWorkspace& workspace, int unit);

/// Multiplies the batch's secondary colours by the texels.
void multiply_secondary(FragmentBatch& batch, const float (*texel)[kBatchStride]);

/// The same for a filter that follows the shape of the pixels' footprints (has_wide_filter).
std::uint64_t sample_wide(const LodGroups& groups, int group_count, const FragmentBatch& batch, int unit,
                          float (*texel)[kBatchStride]);

/// Samples `unit`'s texture and multiplies the batch's colours by the texels: TextureEnvMode::modulate.
/// @return texels read.
std::uint64_t modulate_by_texture(FragmentBatch& batch, int unit, const SampleLevels& levels);

/// Texture environment of `unit` on the batch's colours; `primary` is the colour before the first unit.
/// Pictures need it for neither TextureEnvMode::replace, whose texels are sampled straight into the colours,
/// nor modulate.
void combine_texture(FragmentBatch& batch, int unit, const float (*texel)[kBatchStride],
                     const float (*primary)[kBatchStride]);

/// Primary and secondary colours as texturing finds them: what illumination wrote, the flat colour, or the
/// interpolated one; clamped to [0, 1] when the state says so.
void start_colors(const KernelKey& key, FragmentBatch& batch);

/// Adds the secondary colour to the primary.
void add_secondary(FragmentBatch& batch);

void apply_fog(FragmentBatch& batch);

/// Alpha test, blending and stores: from the batch's colours to the surface.
void write_fragments(const KernelKey& key, FragmentBatch& batch, TileSurface& surface);

/// Sets every pixel of the tile; the colour is four floats of any size.
void clear_tile(TileSurface& tile, const float* color, float depth);

/// Finished pixels of a tile, rows of kTileWidth, window row 0 of the tile first.
struct TilePixels {
  const std::uint32_t* color8;
  const float* depth;
};

/// Where they go: the frame's pixel of the tile's row 0, column 0. The next row of the tile stands `pitch`
/// elements before it, since frames hold their top row first. `depth` may be null.
struct FramePixels {
  std::uint32_t* color8;
  float* depth;
  std::ptrdiff_t pitch;
};

/// Copies the tile's first `width` columns and `height` rows into the frame, past the caches.
void store_tile(const TilePixels& tile, int width, int height, const FramePixels& frame);

/// Adds a tile that was drawn for one sample to the sums (docs/arithmetic.md, "Samples"). `weights`: null, or
/// one a pixel in place of `weight`.
void add_sample(const TileSurface& tile, const TileJob& job, const SampleSettings& settings, float weight,
                const float* weights, const DisplayTransform& display, TileSums& sums);

/// The sums become pixels of the tile: in its colours as floats where its format has them; in its bytes where
/// they are what is shown already; and its depth.
void resolve_samples(const TileSums& sums, const TileJob& job, const SampleSettings& settings,
                     TileSurface& tile);

/// What is shown of a row of float pixels (docs/arithmetic.md, "Display"), to `out` in whole vectors.
void display_row(const PixelRow& pixels, const DisplayTransform& display, std::uint32_t* out);

/// The float pixels themselves, R, G, B, A each, to `out`.
void store_float_row(const PixelRow& pixels, float* out);

}  // namespace barrido::raster
