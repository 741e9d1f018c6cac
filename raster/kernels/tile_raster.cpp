// One tile from its primitives: spans, depth test, visibility, interpolation; whole batches of fragments go
// on to shade_batch. Two ways lead to the same bits: opaque primitives that overlap are first resolved to the
// span seen in each pixel and every pixel is shaded once; all others are shaded in drawing order.
#include <hwy/cache_control.h>

#include <algorithm>
#include <cstring>

#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/tile_raster.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/placed_pixels-inl.h"
#include "raster/kernels/span_shader-inl.h"
#include "raster/kernels/spans-inl.h"
#include "raster/kernels/visibility-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// How many triangles are asked how much of the tile they cover.
inline constexpr std::size_t kSampledTriangles = 64;

/// Pixels of a triangle below which resolving visibility first costs more than it saves.
inline constexpr std::int64_t kWorthASecondLook = 6;
/// The same where colours go straight to the surface: a pixel that is not shaded saves little there.
inline constexpr std::int64_t kWorthASecondLookDirect = 256;

/// Opaque triangles: what is behind a fragment that passes its tests does not matter.
bool hides_what_is_behind(const BinnedChunk& binned) {
  return binned.key().hides && binned.chunk().topology == Topology::triangles;
}

/// Calls visit(row, first, end) for each span of a primitive in the tile.
template <class Visit>
HWY_INLINE void for_each_span(const PrimitiveChunk& chunk, const PrimitiveRecord& p, const TileArea& tile,
                              Visit&& visit) {
  if (chunk.topology == Topology::points) return point_spans(p, chunk.point_size, tile, visit);
  if (chunk.topology == Topology::lines) return line_spans(p, chunk.line_width, tile, visit);
  TriangleSpans spans;
  if (!triangle_spans(p, tile, spans)) return;
  for (int row = spans.row_begin; row < spans.row_end; ++row) {
    if (spans.first[row] < spans.end[row]) visit(row, spans.first[row], spans.end[row]);
  }
}

class TileRasterizer {
 public:
  TileRasterizer(const TileJob& job, TileWorkspace& workspace)
      : job_(job),
        workspace_(workspace),
        tile_{job.column * kTileWidth, job.row * kTileHeight, job.width, job.height, job.sample},
        shader_(workspace, tile_) {}

  void run() {
    const auto& chunks = *job_.chunks;
    for (std::size_t begin = 0; begin < chunks.size();) {
      std::size_t end = begin;
      if (!chunks[begin]->key().sorted) blend_layers();
      while (end < chunks.size() && hides_what_is_behind(*chunks[end])) ++end;
      if (end > begin && job_.visibility_first && overlaps(begin, end)) {
        draw_visible(begin, end);
      } else {
        end = std::max(end, begin + 1);
        for (std::size_t i = begin; i < end; ++i) draw_in_order(*chunks[i]);
      }
      begin = end;
    }
    blend_layers();
    shader_.flush();
  }

 private:
  /// What was sorted is blended before what was drawn later, and is not.
  void blend_layers() {
    if (workspace_.batch.count > 0 && workspace_.key->sorted) shader_.flush();
    workspace_.layers.blend(workspace_.surface);
  }

  std::span<const std::uint16_t> primitives_of(const BinnedChunk& binned) const {
    return binned.primitives_in(job_.column, job_.row);
  }

  /// Whether the triangles of chunks [begin, end) are likely to cover the tile more than once, with so many
  /// pixels each that the shading saved is worth a second look at each triangle. In the tile a triangle
  /// counts for its area or for half of its bounding box's part there, whichever is less; of many triangles
  /// some dozens are asked. A rule of speed alone; both ways give the same bits.
  bool overlaps(std::size_t begin, std::size_t end) const {
    constexpr std::int64_t kTwoPixels = 2 * kSubpixelUnits * kSubpixelUnits;  // as signed_area counts
    std::size_t triangles = 0;
    for (std::size_t i = begin; i < end; ++i) triangles += primitives_of(*(*job_.chunks)[i]).size();
    const std::size_t step = triangles / kSampledTriangles + 1;
    std::int64_t covered = 0;
    std::size_t next = 0;  // triangle to be asked, from the first of the chunk on
    for (std::size_t i = begin; i < end; ++i) {
      const PrimitiveChunk& chunk = (*job_.chunks)[i]->chunk();
      const std::span<const std::uint16_t> numbers = primitives_of(*(*job_.chunks)[i]);
      for (; next < numbers.size(); next += step) {
        const PrimitiveRecord& p = chunk.primitives[numbers[next]];
        TriangleBox box;
        if (!triangle_box(p, tile_, box)) continue;
        const std::int64_t box_pixels =
            static_cast<std::int64_t>(box.column_end - box.column_begin) * (box.row_end - box.row_begin);
        covered += static_cast<std::int64_t>(step) *
                   std::min(std::abs(signed_area(p)), box_pixels * (kTwoPixels / 2));
      }
      next -= numbers.size();
    }
    const bool direct = (*job_.chunks)[begin]->key().colors != ColorWay::batch;
    const std::int64_t least = direct ? kWorthASecondLookDirect : kWorthASecondLook;
    return 2 * covered > 3 * kTwoPixels * tile_.width * tile_.height &&
           covered > least * kTwoPixels * static_cast<std::int64_t>(triangles);
  }

  /// All shading in drawing order: blending, alpha test, or nothing to gain from resolving visibility first.
  void draw_in_order(const BinnedChunk& binned) {
    const PrimitiveChunk& chunk = binned.chunk();
    const ScissorBox scissor = scissor_in(chunk.state->scissor, tile_);
    const KernelKey& key = binned.key();
    shader_.begin_chunk(binned);
    const bool takes_blocks = chunk.topology == Topology::triangles && key.small != SmallTriangles::spans;
    const bool takes_tiny = takes_blocks && key.small == SmallTriangles::lists && !cuts(scissor, tile_);
    TriangleBlocks blocks(workspace_.surface, tile_, scissor, key, shader_.any_depth());
    TinyCoverage coverage(tile_);
    TinyTriangles tiny(workspace_.surface, tile_);
    if (takes_tiny) tiny.begin_chunk(shader_.tiny_paint());
    const std::span<const std::uint16_t> numbers = primitives_of(binned);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      prefetch(chunk, numbers, i);
      const PrimitiveRecord& p = chunk.primitives[numbers[i]];
      shader_.begin_primitive(p);
      if (takes_tiny) {
        const std::size_t j = i % TinyCoverage::kTriangles;
        if (j == 0) coverage.find(chunk, numbers.subspan(i));
        if (coverage.is_tiny(j)) {
          shader_.add_tiny(tiny, coverage, j);
          continue;
        }
        shader_.draw_tiny(tiny);
      }
      if (takes_blocks && draw_blocks(blocks, p)) continue;
      draw_spans(chunk, p, scissor);
      // A later primitive's depth test must see what the alpha test lets through.
      if (key.late_depth) shader_.flush();
    }
    shader_.draw_tiny(tiny);
    if (takes_blocks) shader_.count(Loop::blocks, blocks.counts());
  }

  void draw_spans(const PrimitiveChunk& chunk, const PrimitiveRecord& p, const ScissorBox& scissor) {
    for_each_span(chunk, p, tile_, [&](int row, int first, int end) HWY_ATTR {
      const int x_begin = std::max(first, scissor.x_begin);
      const int x_end = std::min(end, scissor.x_end);
      ++workspace_.statistics.spans;
      workspace_.statistics.fragments_covered += static_cast<std::uint64_t>(end - first);
      if (x_begin >= x_end || row < scissor.y_begin || row >= scissor.y_end) return;
      shader_.start_span(row, first, end);
      shader_.shade_passing(row, x_begin, x_end);
    });
  }

  /// The records of primitives ahead, of which a vector are read at once, and the vertices of a nearer one,
  /// which stand anywhere in memory.
  static HWY_INLINE void prefetch(const PrimitiveChunk& chunk, std::span<const std::uint16_t> numbers,
                                  std::size_t i) {
    constexpr std::size_t kAhead = 6;
    constexpr std::size_t kFarAhead = kAhead + TinyCoverage::kTriangles;
    if (i + kFarAhead >= numbers.size()) return;
    hwy::Prefetch(&chunk.primitives[numbers[i + kFarAhead]]);
    const PrimitiveRecord& next = chunk.primitives[numbers[i + kAhead]];
    const int stride = record_stride(chunk.state->varyings.count);
    for (const std::uint32_t vertex : next.vertex) hwy::Prefetch(chunk.record(vertex, stride));
  }

  /// @return false when the triangle is too large for that.
  bool draw_blocks(TriangleBlocks& blocks, const PrimitiveRecord& p) {
    TriangleBox box;
    if (!triangle_box(p, tile_, box)) return true;
    if (!box.is_small || box.column_end - box.column_begin > kMostBlockColumns) return false;
    TriangleSpans spans;
    if (triangle_spans(p, tile_, spans)) shader_.shade_blocks(blocks, spans);
    return true;
  }

  /// Visibility before shading: the chunks write depth and marks only; then each visible run is shaded once.
  void draw_visible(std::size_t begin, std::size_t end) {
    shader_.flush();
    workspace_.primitives.clear();
    workspace_.runs.clear();
    workspace_.clock.switch_to(Stage::visibility);
    VisibilityPass pass(workspace_, tile_);
    for (std::size_t i = begin; i < end; ++i) {
      const BinnedChunk& binned = *(*job_.chunks)[i];
      const PrimitiveChunk& chunk = binned.chunk();
      const ScissorBox scissor = scissor_in(chunk.state->scissor, tile_);
      for (const std::uint16_t number : primitives_of(binned)) {
        pass.add(binned, chunk.primitives[number], scissor);
      }
    }
    if (!workspace_.primitives.empty()) {
      pass.resolve();
      collect_runs();
    }
    workspace_.clock.switch_to(Stage::spans);
    if (workspace_.primitives.empty()) return;
    const BinnedChunk* chunk = nullptr;
    for (const TilePrimitive& primitive : workspace_.primitives) {
      if (primitive.first_run < 0) continue;
      if (primitive.chunk != chunk) shader_.begin_chunk(*primitive.chunk);
      chunk = primitive.chunk;
      shade_visible(primitive);
    }
    std::memset(workspace_.surface.visible_span, 0, sizeof(workspace_.surface.visible_span));
  }

  /// Cuts the tile's rows into runs of one span and hands each to its primitive.
  void collect_runs() {
    for (int row = 0; row < tile_.height; ++row) {
      const std::uint32_t* visible = workspace_.surface.visible_span + row * kTileWidth;
      int begin = 0;
      for (int word = 0; word < kTileWidth; word += 64) {
        for (std::uint64_t last = last_columns(visible, word); last != 0; last &= last - 1) {
          const int end = word + __builtin_ctzll(last) + 1;
          add_run(row, begin, end, visible[begin]);
          begin = end;
        }
      }
      add_run(row, begin, tile_.width, visible[begin]);
    }
  }

  void add_run(int row, int begin, int end, std::uint32_t mark) {
    if (mark == 0) return;
    TilePrimitive& primitive = workspace_.primitives[primitive_of(mark)];
    workspace_.runs.push_back({static_cast<std::int16_t>(row), static_cast<std::int16_t>(begin),
                               static_cast<std::int16_t>(end), primitive.first_run});
    primitive.first_run = static_cast<std::int32_t>(workspace_.runs.size()) - 1;
  }

  /// Bit i: the column after column `word` + i is in the frame and has another mark.
  HWY_INLINE std::uint64_t last_columns(const std::uint32_t* visible, int word) const {
    const hn::ScalableTag<std::uint32_t> du;
    std::uint64_t bits = 0;
    for (int i = 0; i < 64; i += static_cast<int>(hn::Lanes(du))) {
      const std::uint32_t* here = visible + word + i;
      const auto differs = hn::Ne(hn::Load(du, here), hn::LoadU(du, here + 1));
      bits |= static_cast<std::uint64_t>(mask_bits(du, differs)) << i;
    }
    const int columns = tile_.width - 1 - word;
    if (columns >= 64) return bits;
    return columns <= 0 ? 0 : bits & ((std::uint64_t{1} << columns) - 1);
  }

  void shade_visible(const TilePrimitive& primitive) {
    shader_.begin_primitive(*primitive.record);
    int started = -1;
    for (std::int32_t i = primitive.first_run; i >= 0; i = workspace_.runs[i].next) {
      const VisibleRun& run = workspace_.runs[i];
      if (run.row != started) shader_.start_span(run.row, primitive.first[run.row], primitive.end[run.row]);
      started = run.row;
      shader_.shade(run.row, run.begin, run.end);
    }
  }

  const TileJob& job_;
  TileWorkspace& workspace_;
  const TileArea tile_;
  SpanShader shader_;
};

/// All primitives in drawing order, for pixels that have places of their own.
void rasterize_placed(const TileJob& job, TileWorkspace& workspace) {
  const TileArea tile{job.column * kTileWidth, job.row * kTileHeight, job.width, job.height, {}};
  SpanShader shader(workspace, tile, job.places);
  const auto blend_layers = [&] {
    if (workspace.batch.count > 0 && workspace.key->sorted) shader.flush();
    workspace.layers.blend(workspace.surface);
  };
  for (const BinnedChunk* binned : *job.chunks) {
    if (!binned->key().sorted) blend_layers();
    const PrimitiveChunk& chunk = binned->chunk();
    const ScissorBox scissor = scissor_in(chunk.state->scissor, tile);
    shader.begin_chunk(*binned);
    for (const std::uint16_t number : binned->primitives_in(job.column, job.row)) {
      const PrimitiveRecord& p = chunk.primitives[number];
      shader.begin_primitive(p);
      placed_primitive(chunk, p, tile, *job.places, [&](int row, const PixelBits& covered) {
        shader.shade_placed(row, covered, scissor);
      });
      if (binned->key().late_depth) shader.flush();
    }
  }
  blend_layers();
  shader.flush();
}

void RasterizeTile(const TileJob& job, TileWorkspace& workspace) {
  if (job.places != nullptr) return rasterize_placed(job, workspace);
  TileRasterizer(job, workspace).run();
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(RasterizeTile);

void rasterize_tile(const TileJob& job, TileWorkspace& workspace) {
  HWY_DYNAMIC_DISPATCH(RasterizeTile)(job, workspace);
}

}  // namespace barrido::raster
#endif
