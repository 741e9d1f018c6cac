// Any draws into a small frame, by the renderer with its vector kernels; the primitives it assembled must
// keep the rasterizer's conditions, and the scalar reference must make the same bits of them.
#include <cmath>
#include <deque>
#include <stdexcept>

#include "frame_difference.h"
#include "pipeline/assembled_frame.h"
#include "pipeline/renderer.h"
#include "raster/base/simd_target.h"
#include "raster/reference/reference_rasterizer.h"
#include "scene_choices.h"

namespace barrido::fuzz {
namespace {

/// What raster/fragments/primitive.h asks of every chunk.
void check_chunk(const raster::PrimitiveChunk& chunk) {
  constexpr std::int32_t kReach = raster::kGuardBandPixels * raster::kSubpixelUnits;
  const int corners = static_cast<int>(chunk.topology) + 1;
  const int numbers = raster::kRecordVaryings + chunk.state->varyings.count;
  const int stride = raster::record_stride(chunk.state->varyings.count);
  for (const raster::PrimitiveRecord& primitive : chunk.primitives) {
    for (int corner = 0; corner < corners; ++corner) {
      require(std::abs(primitive.x[corner]) < kReach && std::abs(primitive.y[corner]) < kReach,
              "a vertex is outside the guard band");
      const float* record = chunk.record(primitive.vertex[corner], stride);
      for (int k = 0; k < numbers; ++k) {
        require(std::fabs(record[k]) <= raster::kMaxRecordValue,
                "a number of a vertex is too large, or none");
      }
    }
  }
}

raster::Framebuffer draw_reference(const raster::FramebufferOptions& options,
                                   const pipeline::AssembledFrame& assembled) {
  std::vector<const raster::PrimitiveChunk*> chunks;
  for (const pipeline::AssembledDraw& draw : assembled.draws) {
    for (const pipeline::AssembledChunk& chunk : draw.chunks) {
      check_chunk(*chunk.chunk);
      chunks.push_back(chunk.chunk);
    }
  }
  raster::Framebuffer frame(options);
  raster::reference::rasterize(chunks, assembled.clear, frame);
  return frame;
}

void any_draw(Input& input, std::deque<OwnedGeometry>& geometries, pipeline::Renderer& renderer) {
  any_geometry(input, geometries.emplace_back());
  const pipeline::State state = any_state(input);
  try {
    renderer.draw(state, geometries.back().geometry);
  } catch (const std::invalid_argument&) {
  } catch (const std::out_of_range&) {
  }
}

}  // namespace

void run_scene(Bytes bytes) {
  Input input(bytes);
  raster::set_simd_target(input.flag() ? raster::SimdTarget::automatic : raster::SimdTarget::scalar);
  raster::RasterizerOptions options;
  options.visibility_first = input.flag();
  const raster::FramebufferOptions frame_options = any_frame(input);
  raster::Framebuffer frame(frame_options);
  pipeline::AssembledFrame assembled;
  std::deque<OwnedGeometry> geometries;
  pipeline::Renderer renderer(frame, options, &assembled);
  renderer.clear(any_clear(input));
  for (int draws = 0; draws < 4 && !input.is_empty(); ++draws) any_draw(input, geometries, renderer);
  const raster::Framebuffer expected = draw_reference(frame_options, assembled);
  renderer.finish();
  raster::set_simd_target(raster::SimdTarget::automatic);
  const std::string difference = raster::testing::describe_difference(expected, frame);
  require(difference.empty(), "not what the reference draws: " + difference);
}

}  // namespace barrido::fuzz
