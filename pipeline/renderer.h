// Draws geometry under a fixed-function state into a frame: the vertex stage, primitive assembly and
// clipping, then the rasterizer. The whole flow is in draw.cpp.
#pragma once

#include <cstdint>
#include <memory>

#include "pipeline/geometry.h"
#include "pipeline/state.h"
#include "raster/rasterizer.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::pipeline {

/// Work done, counted exactly; what the course's table of costs asks for (S8).
struct Statistics {
  std::uint64_t draws = 0;
  std::uint64_t vertices = 0;  ///< Transformed, each shared vertex once.
  /// Points, lines and triangles assembled from the indices: a quad is two triangles, an outlined one four
  /// lines.
  std::uint64_t primitives_in = 0;
  /// Of those: facing away, outside the view, or covering no pixel's centre.
  std::uint64_t primitives_culled = 0;
  std::uint64_t primitives_clipped = 0;      ///< Of those: cut by a clip plane, and still seen.
  std::uint64_t illuminations_vertex = 0;    ///< Evaluations of one light at a vertex or centroid.
  std::uint64_t illuminations_fragment = 0;  ///< Evaluations of one light at a fragment; after finish().
  std::uint64_t powers = 0;                  ///< Evaluations of x^n; after finish().
  std::uint64_t interpolations =
      0;  ///< Quantities × fragments: one addition each in the incremental form (S5).
  std::uint64_t displaced_vertices = 0;   ///< Made by displacement before the draws,
  std::uint64_t displaced_triangles = 0;  ///< and the triangles between them.
  raster::RasterStatistics raster;
};

struct AssembledFrame;

class Renderer {
 public:
  /// The framebuffer must outlive the renderer, and so must `kept`, in which draws are remembered as they
  /// go to the rasterizer; null: none are. See pipeline/assembled_frame.h.
  explicit Renderer(raster::Framebuffer& framebuffer, const raster::RasterizerOptions& options = {},
                    AssembledFrame* kept = nullptr);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Forgets all that was drawn since the last finish(); the frame starts from these values.
  void clear(const raster::ClearValues& values);

  /// Draws as if at once; what `geometry` and the textures point to must stay until finish().
  /// @throws std::out_of_range when an index is not below vertex_count, std::invalid_argument when the state
  /// or the arrays are impossible; nothing is drawn then.
  void draw(const State& state, const Geometry& geometry);

  /// Completes all draws: afterwards the framebuffer holds the picture. Drawing may go on, on top of it,
  /// under the conditions of raster::Rasterizer::flush().
  void finish();

  /// Sums since the renderer was made. Those of fragments are up to date after finish().
  const Statistics& statistics() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace barrido::pipeline
