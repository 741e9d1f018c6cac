#include "raster/sample_tile.h"

#include "raster/adaptive_tile.h"
#include "raster/tiles/pixel_places.h"

namespace barrido::raster {
namespace {

/// One drawing of the tile.
void draw(const SampledTile& tile) {
  TileWorkspace& w = tile.workspace;
  w.clock.switch_to(Stage::clear);
  clear_tile(w.surface, tile.clear.color.data(), tile.clear.depth);
  w.clock.switch_to(Stage::spans);
  if (!tile.job.chunks->empty()) rasterize_tile(tile.job, w);
  w.clock.switch_to(Stage::resolve);
}

/// All pixels of the tile, each at its place for sample `number` of the frame.
void set_places(const SampledTile& tile, int number, const PlaceWeights& weights) {
  const JitterSettings& jitter = *tile.settings.jitter;
  const PlaceCell cell = place_cell(number, jitter.count, jitter.filter.radius);
  const std::uint32_t key = hash_of(static_cast<std::uint32_t>(number), jitter.seed);
  TilePlaces& places = *tile.workspace.places;
  places.reach = tile.settings.reach();
  for (int row = 0; row < tile.job.height; ++row) {
    places.wanted[row] = PixelBits::of(0, tile.job.width);
    const int y = tile.job.row * kTileHeight + row;
    for (int column = 0; column < tile.job.width; ++column) {
      const int at = row * kTileWidth + column;
      const SamplePlace place = place_in(cell, tile.job.column * kTileWidth + column, y, key);
      places.set(at, place);
      if (weights.differ()) places.weight[at] = weights.at(place);
    }
  }
}

void add_jittered(const SampledTile& tile) {
  TileWorkspace& w = tile.workspace;
  if (!w.places) w.places = std::make_unique<TilePlaces>();
  const PlaceWeights weights(tile.settings.jitter->filter);
  tile.job.places = w.places.get();
  for (std::size_t i = 0; i < tile.settings.samples.size(); ++i) {
    w.clock.switch_to(Stage::spans);
    set_places(tile, tile.settings.jitter->first + static_cast<int>(i), weights);
    draw(tile);
    add_sample(w.surface, tile.job, tile.settings, 1.0f, weights.differ() ? w.places->weight : nullptr,
               tile.frame.display, *w.sums);
  }
}

}  // namespace

void add_samples(const SampledTile& tile) {
  if (tile.settings.adaptive) return add_adaptive_samples(tile);
  if (tile.settings.jitter) return add_jittered(tile);
  for (const Sample& sample : tile.settings.samples) {
    tile.job.sample = sample.place;
    draw(tile);
    add_sample(tile.workspace.surface, tile.job, tile.settings, sample.weight, nullptr, tile.frame.display,
               *tile.workspace.sums);
  }
}

}  // namespace barrido::raster
