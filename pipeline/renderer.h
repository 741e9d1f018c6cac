// Draws geometry under a fixed-function state into a frame: the vertex stage, primitive assembly and
// clipping, then the rasterizer. The whole flow is in draw.cpp.
#pragma once

#include <cstdint>
#include <memory>

#include "pipeline/geometry.h"
#include "pipeline/state.h"
#include "raster/framebuffer.h"
#include "raster/rasterizer.h"

namespace barrido::pipeline {

/// Work done, counted exactly; what the course's table of costs asks for (S8).
struct Statistics {
  std::uint64_t draws = 0;
  std::uint64_t vertices = 0;                ///< Transformed, each shared vertex once.
  std::uint64_t primitives_in = 0;           ///< Assembled from the indices.
  std::uint64_t primitives_culled = 0;       ///< Facing away, outside the view, or without area.
  std::uint64_t primitives_clipped = 0;      ///< Crossing a clip plane.
  std::uint64_t illuminations_vertex = 0;    ///< Evaluations of one light at a vertex or centroid.
  std::uint64_t illuminations_fragment = 0;  ///< Evaluations of one light at a fragment.
  std::uint64_t powers = 0;                  ///< Evaluations of x^n.
  std::uint64_t interpolations =
      0;  ///< Quantities × fragments: one addition each in the incremental form (S5).
  raster::RasterStatistics raster;
};

class Renderer {
 public:
  /// The framebuffer must outlive the renderer.
  explicit Renderer(raster::Framebuffer& framebuffer, const raster::RasterizerOptions& options = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  void clear(const raster::ClearValues& values);

  /// Draws as if at once; what `geometry` and the textures point to must stay until finish().
  /// @throws std::out_of_range when an index is not below vertex_count.
  void draw(const State& state, const Geometry& geometry);

  /// Completes all draws: afterwards the framebuffer holds the picture. Drawing may go on.
  void finish();

  const Statistics& statistics() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace barrido::pipeline
