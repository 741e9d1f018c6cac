// Scene pairs from a seed, grouped by the feature of the fixed-function pipeline that they exercise. The same
// seed is the same scene everywhere. Knows no renderer.
#pragma once

#include <span>

#include "tests/kernels/random_bits.h"
#include "tests/osmesa/scene_pair.h"

namespace barrido::crosscheck {

using raster::testing::RandomBits;

/// What a feature must keep. Differences are in 1/255; a channel counts as different when it exceeds what the
/// pixel is allowed.
struct Gate {
  int interior = 1;           ///< Largest difference allowed at interior pixels, for each layer drawn there.
  double interior_ppm = 1e6;  ///< Interior pixels that may differ at all, per million, and layer.
  double edge_ppm = 50;       ///< Pixels within one pixel of an edge that may exceed `interior`, per million.
  double tie_ppm = 2000;      ///< The same for pixels near a discrete decision (texel, level, face, depth).
  double depth = 4e-7;        ///< Largest difference of interior depths.
  /// softpipe chooses levels of detail and draws points and lines by coarser rules of its own: there the
  /// feature is reported and not held.
  bool held_by_softpipe = true;
  bool held = true;
};

struct Feature {
  const char* name;
  void (*generate)(RandomBits& random, ScenePair& pair);
  Gate gate;
};

std::span<const Feature> features();
/// The same with the gates for an OpenGL whose GL_RENDERER is given.
std::vector<Feature> features_against(const std::string& renderer);
ScenePair make_pair(const Feature& feature, std::uint64_t seed);

}  // namespace barrido::crosscheck
