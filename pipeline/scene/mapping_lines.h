// The intermediate surface of a mapping as lines, for people to see where its seam and poles lie.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "raster/textures/mapping.h"

namespace barrido::scene {

/// Two places a line, in the mapping's space.
struct MappingLines {
  std::vector<glm::dvec3> places;
  std::size_t first_of_seam = 0;  ///< From here on: seams, where a coordinate starts anew, and poles.
};

MappingLines mapping_lines(raster::MappingSurface surface);

}  // namespace barrido::scene
