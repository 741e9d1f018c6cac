// Random scenes for the rasterizer: chunks of every topology and shape under random states, into frames of
// every format and of sizes that are not multiples of tiles. A seed gives the same scene everywhere.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "random_state.h"
#include "raster/fragments/primitive.h"
#include "raster/rasterizer.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::raster::testing {

struct RandomScene {
  FramebufferOptions frame;
  ClearValues clear;
  std::vector<std::unique_ptr<FragmentState>> states;
  std::vector<std::unique_ptr<std::vector<float>>> shared_records;
  std::vector<PrimitiveChunk> chunks;
  std::vector<std::string> descriptions;  ///< One a chunk.
};

struct SceneOptions {
  /// Some vertices carry numbers at the limits of what the rasterizer accepts, 1/w of any sign among them.
  bool hostile = false;
  /// Only states whose fragments go straight to an 8-bit surface.
  bool simple = false;
};

RandomScene make_random_scene(std::uint64_t seed, const TexturePool& textures,
                              const SceneOptions& options = {});

}  // namespace barrido::raster::testing
