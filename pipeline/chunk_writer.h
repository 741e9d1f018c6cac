// Builds the rasterizer's chunks from assembled primitives: records, flat colours, and the vertices that
// clipping makes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/assembly_input.h"
#include "pipeline/clip.h"
#include "pipeline/flat_colors.h"
#include "raster/fragments/primitive.h"

namespace barrido::pipeline {

/// A vertex as a primitive refers to it: window position in 1/256 pixel and number in the chunk.
struct WindowVertex {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::uint32_t number = 0;
};

/// The corners of a primitive that is clipped (or those that a closing edge lies between): their numbers (all
/// of the side that is seen) and w.
struct ClipCorners {
  int count = 0;
  std::array<std::uint32_t, 4> vertex{};
  std::array<double, 4> w{};
};

class ChunkWriter {
 public:
  /// `expected` primitives are likely to be added.
  ChunkWriter(const AssemblyInput& input, std::uint32_t expected, AssemblyCounts& counts);
  ChunkWriter(const ChunkWriter&) = delete;
  ChunkWriter& operator=(const ChunkWriter&) = delete;

  /// Makes room for what one primitive may become. Must be called before flat_and_facing() and add().
  void make_room(int primitives) {
    if (chunk_->primitives.size() + static_cast<std::size_t>(primitives) >
        static_cast<std::size_t>(raster::kMaxChunkPrimitives)) {
      finish_chunk();
      begin_chunk();
    }
  }

  /// The word of that name for a primitive of the mode.
  std::uint32_t flat_and_facing(std::uint32_t primitive, bool back) {
    const bool marked = back && input_.plan.marks_back_faces;
    source_ = primitive;
    return flat_.index_of(primitive, back) | (marked ? raster::kBackFacing : 0u);
  }

  /// Adds what the primitive of the last flat_and_facing() is made of.
  void add(const raster::PrimitiveRecord& primitive) {
    chunk_->primitives.push_back(primitive);
    if (input_.with_sources) sources_.back().push_back(source_);
  }

  /// Appends a vertex of the chunk's own, a mixture of corners. @return its number.
  std::uint32_t add_vertex(const ClipVertex& vertex, const ClipCorners& corners);

  /// All chunks; afterwards the writer is used up.
  std::vector<raster::PrimitiveChunk> take();
  /// After take(): for each chunk the primitives' sources; empty unless asked for.
  std::vector<std::vector<std::uint32_t>> take_sources() { return std::move(sources_); }

 private:
  void begin_chunk();
  void finish_chunk();

  const AssemblyInput& input_;
  std::uint32_t expected_;
  FlatColorTable flat_;
  std::vector<raster::PrimitiveChunk> chunks_;
  raster::PrimitiveChunk* chunk_ = nullptr;
  std::uint32_t source_ = 0;
  std::vector<std::vector<std::uint32_t>> sources_;
};

}  // namespace barrido::pipeline
