// Colours of flat polygons (S1): that of the provoking vertex, or the model evaluated once at the centroid.
// Centroids are collected and lit many at a time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "pipeline/assembly_input.h"
#include "raster/fragments/primitive.h"

namespace barrido::pipeline {

class FlatColorTable {
 public:
  /// Colours go into the tables of the chunks that are started with begin_chunk().
  FlatColorTable(const AssemblyInput& input, AssemblyCounts& counts);

  /// Starts the table of a chunk, which must stay where it is until end_chunk().
  void begin_chunk(raster::PrimitiveChunk& chunk);
  /// Completes the chunk's table.
  void end_chunk();

  /// Place of a primitive's colours in the chunk's table; the same for all its triangles or edges. `back`:
  /// seen from behind, and lit so.
  std::uint32_t index_of(std::uint32_t primitive, bool back) {
    if (!input_.plan.origin.flat) return 0;
    if (primitive == last_primitive_ && back == last_back_) return last_index_;
    return add(primitive, back);
  }

 private:
  /// Centroids of one side that wait to be lit.
  struct Centroids {
    int count = 0;
    std::array<std::uint32_t, kVertexBatch> index{};
    alignas(64) BatchArray position[3];
    alignas(64) BatchArray normal[3];
    alignas(64) BatchArray color[4];
    alignas(64) BatchArray lit[7];
  };

  std::uint32_t add(std::uint32_t primitive, bool back);
  void add_centroid(std::uint32_t primitive, bool back, std::uint32_t index);
  void light(int side);

  static constexpr std::uint32_t kNoPrimitive = 0xffffffffu;

  const AssemblyInput& input_;
  AssemblyCounts& counts_;
  raster::PrimitiveChunk* chunk_ = nullptr;
  std::uint32_t last_primitive_ = kNoPrimitive;
  bool last_back_ = false;
  std::uint32_t last_index_ = 0;
  std::unique_ptr<std::array<Centroids, 2>>
      centroids_;  // front and back; only where polygons are lit at them
};

}  // namespace barrido::pipeline
