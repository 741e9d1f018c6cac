// A frame of many samples as plainly as possible: for each sample a whole frame whose geometry is moved the
// other way, then sums and one division a pixel (docs/arithmetic.md, "Samples"). Knows no tiles of samples.
#pragma once

#include <span>

#include "raster/fragments/primitive.h"
#include "raster/reference/arithmetic.h"
#include "raster/tiles/framebuffer.h"
#include "raster/tiles/samples.h"

namespace barrido::raster::reference {

/// What the samples of a pixel add up to.
struct SampleSum {
  Color color{0, 0, 0, 0};  ///< Premultiplied colours times weights; the fourth of alphas times weights.
  float weight = 0.0f;      ///< Of all samples.
  float depth = 1.0f;       ///< Nearest.
};

/// `color` and `depth` are what a drawing of the sample leaves; `display` counts where the order says so.
void add_sample(const Color& color, float depth, float weight, const SampleSettings& settings,
                const DisplayTransform* display, SampleSum& sum);

/// The pixel's straight colour.
Color resolved(const SampleSum& sum, const SampleSettings& settings);

/// As rasterize() of reference_rasterizer.h, for all of the settings' samples.
void rasterize_samples(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
                       const SampleSettings& settings, Framebuffer& framebuffer);

}  // namespace barrido::raster::reference
