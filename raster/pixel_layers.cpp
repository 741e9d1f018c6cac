#include "raster/tiles/pixel_layers.h"

#include "raster/reference/arithmetic.h"
#include "raster/reference/fragment_operations.h"
#include "raster/tiles/tile.h"

namespace barrido::raster {
namespace {

using Color = std::array<float, 4>;

Color read_pixel(const TileSurface& surface, std::size_t pixel) {
  if (surface.format == ColorFormat::rgba8) return reference::unpack_rgba8(surface.color8[pixel]);
  Color color{};
  for (std::size_t c = 0; c < 4; ++c) color[c] = surface.color_float[c][pixel];
  return color;
}

void write_pixel(TileSurface& surface, std::size_t pixel, const Color& color) {
  if (surface.format == ColorFormat::rgba8) {
    surface.color8[pixel] = reference::pack_rgba8(color);
    return;
  }
  for (std::size_t c = 0; c < 4; ++c) surface.color_float[c][pixel] = color[c];
}

void blend_pixel(const FragmentState& state, const Color& source, TileSurface& surface, std::size_t pixel) {
  const Color before = read_pixel(surface, pixel);
  Color color = reference::blend(state.blend, source, before);
  for (std::size_t c = 0; c < 4; ++c) {
    if (!state.color_mask[c]) color[c] = before[c];
  }
  write_pixel(surface, pixel, color);
}

}  // namespace

/// Takes the last of the pixel's list out of it.
std::int32_t PixelLayers::take_farthest(std::size_t pixel) {
  std::int32_t* link = &nearest_[pixel];
  while (layers_[static_cast<std::size_t>(*link)].next >= 0) {
    link = &layers_[static_cast<std::size_t>(*link)].next;
  }
  const std::int32_t farthest = *link;
  *link = -1;
  return farthest;
}

void PixelLayers::add(std::size_t pixel, const FragmentState& state, const Color& color, float depth,
                      TileSurface& surface, RasterStatistics& statistics) {
  if (nearest_.empty()) {
    nearest_.assign(kTilePixels, -1);
    counts_.assign(kTilePixels, 0);
  }
  ++statistics.sorted_fragments;
  const std::int32_t place = free_ >= 0 ? free_ : static_cast<std::int32_t>(layers_.size());
  if (free_ < 0) layers_.emplace_back();
  free_ = -1;
  std::int32_t* link = &nearest_[pixel];
  while (*link >= 0 && layers_[static_cast<std::size_t>(*link)].depth < depth) {
    link = &layers_[static_cast<std::size_t>(*link)].next;
  }
  layers_[static_cast<std::size_t>(place)] = {&state, color, depth, *link};
  *link = place;
  if (counts_[pixel] < kMaxPixelLayers) {
    ++counts_[pixel];
    return;
  }
  ++statistics.crowded_fragments;
  free_ = take_farthest(pixel);
  const Layer& farthest = layers_[static_cast<std::size_t>(free_)];
  blend_pixel(*farthest.state, farthest.color, surface, pixel);
}

void PixelLayers::blend(TileSurface& surface) {
  if (layers_.empty()) return;
  std::array<const Layer*, kMaxPixelLayers> order{};
  for (std::size_t pixel = 0; pixel < nearest_.size(); ++pixel) {
    std::size_t count = 0;
    for (std::int32_t i = nearest_[pixel]; i >= 0; i = layers_[static_cast<std::size_t>(i)].next) {
      order[count++] = &layers_[static_cast<std::size_t>(i)];
    }
    while (count-- > 0) blend_pixel(*order[count]->state, order[count]->color, surface, pixel);
    nearest_[pixel] = -1;
    counts_[pixel] = 0;
  }
  layers_.clear();
  free_ = -1;
}

void keep_layers(TileWorkspace& workspace) {
  const FragmentBatch& batch = workspace.batch;
  const FragmentState& state = *batch.state;
  TileSurface& surface = workspace.surface;
  for (int r = 0; r < batch.run_count; ++r) {
    const FragmentRun& run = batch.runs[r];
    for (int i = run.begin; i < run.end; ++i) {
      const auto pixel = static_cast<std::size_t>(run.y * kTileWidth + run.x + (i - run.begin));
      Color color{batch.color[0][i], batch.color[1][i], batch.color[2][i], batch.color[3][i]};
      const AlphaTest& alpha = state.alpha_test;
      if (alpha.enabled && !reference::compare(alpha.compare, color[3], alpha.reference)) continue;
      if (workspace.key->late_depth) surface.depth[pixel] = batch.depth[i];
      if (surface.format == ColorFormat::rgba8) {
        for (float& channel : color) channel = reference::clamp_to_unit(channel);
      }
      workspace.layers.add(pixel, state, color, batch.depth[i], surface, workspace.statistics);
    }
  }
}

}  // namespace barrido::raster
