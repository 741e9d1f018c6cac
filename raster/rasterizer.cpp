// The frame from its chunks: bins them on submission, then gives each tile to one thread. Enters: chunks in
// drawing order. Leaves: pixels in the framebuffer, the same whatever the number of threads.
#include "raster/rasterizer.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "raster/kernels/kernels.h"
#include "raster/sample_tile.h"
#include "raster/tiles/binning.h"

namespace barrido::raster {
namespace {

/// The pixels of a tile's row.
PixelRow pixel_row(const TileSurface& tile, int row, int count) {
  const int at = row * kTileWidth;
  return {{tile.color_float[0] + at, tile.color_float[1] + at, tile.color_float[2] + at,
           tile.color_float[3] + at},
          count};
}

void add(RasterStatistics& sum, const RasterStatistics& part) {
  sum.spans += part.spans;
  sum.fragments_covered += part.fragments_covered;
  for (std::size_t loop = 0; loop < kLoopCount; ++loop) {
    sum.shaded_in[loop] += part.shaded_in[loop];
    sum.fragments_shaded += part.shaded_in[loop];
  }
  sum.interpolations += part.interpolations + part.fragments_covered;
  sum.texel_fetches += part.texel_fetches;
  sum.mapped += part.mapped;
  sum.patterns += part.patterns;
  sum.noise += part.noise;
  sum.sorted_fragments += part.sorted_fragments;
  sum.crowded_fragments += part.crowded_fragments;
}

}  // namespace

struct Rasterizer::Implementation {
  Framebuffer& frame;
  RasterizerOptions options;
  TileGrid grid;
  SampleReach reach;
  ClearValues clear_values;
  bool starts_clear = true;  ///< The next flush starts from clear_values, else from the framebuffer.
  std::vector<std::unique_ptr<BinnedChunk>> chunks;
  tbb::enumerable_thread_specific<std::unique_ptr<TileWorkspace>> workspaces;
  RasterStatistics statistics;

  Implementation(Framebuffer& f, const RasterizerOptions& o)
      : frame(f), options(o), grid(f.width(), f.height()) {
    if (options.samples != nullptr) reach = options.samples->reach();
  }

  TileWorkspace& workspace() {
    auto& local = workspaces.local();
    if (!local) {
      local = std::make_unique<TileWorkspace>();
      local->surface.format = frame.options().format;
    }
    return *local;
  }

  /// Whether the framebuffer holds all that a tile needs to go on from it.
  bool can_continue() const {
    return options.samples == nullptr && !frame.depth().empty() &&
           (!is_float() || !frame.color_float().empty());
  }

  bool is_float() const { return frame.options().format == ColorFormat::rgba32f; }

  void load_tile(TileSurface& tile, const TileJob& job) const {
    for (int row = 0; row < job.height; ++row) {
      const std::size_t at = frame.index(job.column * kTileWidth, job.row * kTileHeight + row);
      const auto count = static_cast<std::size_t>(job.width);
      if (is_float()) {
        for (std::size_t i = 0; i < count * 4; ++i) {
          tile.color_float[i % 4][static_cast<std::size_t>(row) * kTileWidth + i / 4] =
              frame.color_float()[at * 4 + i];
        }
      } else {
        std::memcpy(tile.color8 + row * kTileWidth, frame.color8().data() + at,
                    count * sizeof(std::uint32_t));
      }
      std::memcpy(tile.depth + row * kTileWidth, frame.depth().data() + at, count * sizeof(float));
    }
  }

  /// Float pixels become bytes, which are stored as those of any tile are.
  void store(TileSurface& tile, const TileJob& job) const {
    if (is_float()) resolve(tile, job);
    store_bytes(tile, job);
  }

  void store_bytes(const TileSurface& tile, const TileJob& job) const {
    const std::size_t at = frame.index(job.column * kTileWidth, job.row * kTileHeight);
    store_tile({tile.color8, tile.depth}, job.width, job.height,
               {frame.color8().data() + at, frame.depth().empty() ? nullptr : frame.depth().data() + at,
                grid.frame_width});
  }

  void resolve(TileSurface& tile, const TileJob& job) const {
    for (int row = 0; row < job.height; ++row) {
      const PixelRow pixels = pixel_row(tile, row, job.width);
      display_row(pixels, frame.options().display, tile.color8 + row * kTileWidth);
    }
    store_floats(tile, job);
  }

  void store_floats(const TileSurface& tile, const TileJob& job) const {
    if (frame.color_float().empty()) return;
    for_each_row_of(job, [&](int row, std::size_t at) {
      store_float_row(pixel_row(tile, row, job.width), frame.color_float().data() + at * 4);
    });
  }

  void draw_tile(int tile) {
    TileWorkspace& w = workspace();
    w.clock.start(options.profile, Stage::clear);
    w.chunks.clear();
    TileJob job;
    job.column = tile % grid.columns;
    job.row = tile / grid.columns;
    job.width = std::min(kTileWidth, grid.frame_width - job.column * kTileWidth);
    job.height = std::min(kTileHeight, grid.frame_height - job.row * kTileHeight);
    for (const auto& chunk : chunks) {
      if (!chunk->primitives_in(job.column, job.row).empty()) w.chunks.push_back(chunk.get());
    }
    if (!starts_clear && w.chunks.empty()) return w.clock.stop();
    job.chunks = &w.chunks;
    job.visibility_first = options.visibility_first;
    if (options.samples != nullptr) {
      draw_samples(job, w);
    } else if (starts_clear) {
      clear_tile(w.surface, clear_values.color.data(), clear_values.depth);
      draw_and_store(job, w);
    } else {
      load_tile(w.surface, job);
      draw_and_store(job, w);
    }
    w.clock.stop();
  }

  void draw_and_store(const TileJob& job, TileWorkspace& w) const {
    w.clock.switch_to(Stage::spans);
    rasterize_tile(job, w);
    w.clock.switch_to(Stage::resolve);
    store(w.surface, job);
  }

  /// The tile once for each sample, and their sums.
  void draw_samples(TileJob& job, TileWorkspace& w) {
    const SampleSettings& settings = *options.samples;
    if (!w.sums) w.sums = std::make_unique<TileSums>();
    start_sums(job, *w.sums);
    add_samples({job, w, settings, clear_values, frame.options()});
    if (!settings.is_last) return keep_sums(job, *w.sums);
    resolve_samples(*w.sums, job, settings, w.surface);
    if (is_float() && settings.order == FilterOrder::light) return store(w.surface, job);
    if (is_float()) store_floats(w.surface, job);
    store_bytes(w.surface, job);
  }

  void start_sums(const TileJob& job, TileSums& sums) const {
    const SampleSettings& settings = *options.samples;
    if (settings.is_first) {
      for (auto& channel : sums.color) std::fill(std::begin(channel), std::end(channel), 0.0f);
      std::fill(std::begin(sums.weight), std::end(sums.weight), 0.0f);
      std::fill(std::begin(sums.depth), std::end(sums.depth), settings.background_depth);
      return;
    }
    for_each_row_of(job, [&](int row, std::size_t at) {
      const auto to = static_cast<std::size_t>(row * kTileWidth);
      for (std::size_t i = 0; i < static_cast<std::size_t>(job.width); ++i) {
        for (std::size_t c = 0; c < 4; ++c) sums.color[c][to + i] = settings.sums->color[4 * (at + i) + c];
        if (settings.sums_weights()) sums.weight[to + i] = settings.sums->weight[at + i];
        sums.depth[to + i] = settings.sums->depth[at + i];
      }
    });
  }

  void keep_sums(const TileJob& job, const TileSums& sums) const {
    FrameSums& kept = *options.samples->sums;
    for_each_row_of(job, [&](int row, std::size_t at) {
      const auto from = static_cast<std::size_t>(row * kTileWidth);
      for (std::size_t i = 0; i < static_cast<std::size_t>(job.width); ++i) {
        for (std::size_t c = 0; c < 4; ++c) kept.color[4 * (at + i) + c] = sums.color[c][from + i];
        if (options.samples->sums_weights()) kept.weight[at + i] = sums.weight[from + i];
        kept.depth[at + i] = sums.depth[from + i];
      }
    });
  }

  /// Calls visit(row, at) with each row of the tile and where the frame has its first pixel.
  template <class Visit>
  void for_each_row_of(const TileJob& job, const Visit& visit) const {
    for (int row = 0; row < job.height; ++row) {
      visit(row, frame.index(job.column * kTileWidth, job.row * kTileHeight + row));
    }
  }
};

Rasterizer::Rasterizer(Framebuffer& framebuffer, const RasterizerOptions& options)
    : implementation_(std::make_unique<Implementation>(framebuffer, options)) {}
Rasterizer::~Rasterizer() = default;

void Rasterizer::clear(const ClearValues& values) {
  implementation_->chunks.clear();
  implementation_->clear_values = values;
  implementation_->starts_clear = true;
}

std::unique_ptr<BinnedChunk> Rasterizer::bin(PrimitiveChunk&& chunk) const {
  const StageClock clock(implementation_->options.profile, Stage::binning);
  const Implementation& r = *implementation_;
  return std::make_unique<BinnedChunk>(std::move(chunk), r.grid, r.frame.options().format, r.reach,
                                       r.options.samples != nullptr && r.options.samples->has_places());
}

void Rasterizer::submit(std::unique_ptr<BinnedChunk> chunk) {
  implementation_->statistics.primitives += chunk->chunk().primitives.size();
  implementation_->chunks.push_back(std::move(chunk));
}

void Rasterizer::flush() {
  Implementation& r = *implementation_;
  if (!r.starts_clear && !r.can_continue()) {
    throw std::logic_error(
        "drawing on top of a finished frame needs its depth and float colours kept, and one sample a pixel");
  }
  tbb::parallel_for(tbb::blocked_range<int>(0, r.grid.count(), 1),
                    [&r](const tbb::blocked_range<int>& tiles) {
                      for (int tile = tiles.begin(); tile < tiles.end(); ++tile) r.draw_tile(tile);
                    });
  for (auto& workspace : r.workspaces) {
    add(r.statistics, workspace->statistics);
    workspace->statistics = {};
  }
  r.chunks.clear();
  r.starts_clear = false;
}

const RasterStatistics& Rasterizer::statistics() const { return implementation_->statistics; }

}  // namespace barrido::raster
