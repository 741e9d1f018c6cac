// The rasterizer: takes chunks of window-space primitives in drawing order, cuts the frame into tiles, and
// gives every tile to one thread, which draws its primitives in order. So the picture depends neither on the
// number of threads nor on the vector width. Must not know: scenes, lights, files, windows.
#pragma once

#include <memory>
#include <vector>

#include "raster/base/stage_profile.h"
#include "raster/fragments/primitive.h"
#include "raster/tiles/framebuffer.h"
#include "raster/tiles/raster_statistics.h"
#include "raster/tiles/samples.h"

namespace barrido::raster {

struct RasterizerOptions {
  /// Resolve visibility of opaque primitives before shading them, so that hidden fragments cost a depth test
  /// only. Off: every fragment that passes its depth test in drawing order is shaded. Same bits either way.
  bool visibility_first = true;
  /// Where the time goes, or null: then no clock is read. Must outlive the rasterizer.
  StageProfile* profile = nullptr;
  /// Null: one sample a pixel, at its centre. Must outlive the rasterizer.
  const SampleSettings* samples = nullptr;
};

class BinnedChunk;

class Rasterizer {
 public:
  explicit Rasterizer(Framebuffer& framebuffer, const RasterizerOptions& options = {});
  ~Rasterizer();
  Rasterizer(const Rasterizer&) = delete;
  Rasterizer& operator=(const Rasterizer&) = delete;

  /// Forgets all that was submitted; the frame starts from these values.
  void clear(const ClearValues& values);

  /// Sorts a chunk's primitives into tiles. Safe to call from several threads at once.
  std::unique_ptr<BinnedChunk> bin(PrimitiveChunk&& chunk) const;
  /// Appends a chunk to the drawing order.
  void submit(std::unique_ptr<BinnedChunk> chunk);

  /// Draws all that was submitted into the framebuffer. More may be submitted afterwards, on top, when the
  /// framebuffer keeps depth and, for rgba32f, float colours.
  /// @throws std::logic_error when it does not, or pixels have several samples, and this is not the first
  /// flush after clear().
  void flush();

  const RasterStatistics& statistics() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace barrido::raster
