#include "raster/reference/cube_face.h"

#include <cmath>

namespace barrido::raster::reference {

CubeFace select_cube_face(const float (&direction)[3]) {
  const float x = std::fabs(direction[0]);
  const float y = std::fabs(direction[1]);
  const float z = std::fabs(direction[2]);
  if (x >= y && x >= z) {
    return direction[0] < 0.0f ? CubeFace{1, {2, 1.0f}, {1, -1.0f}, {0, -1.0f}}
                               : CubeFace{0, {2, -1.0f}, {1, -1.0f}, {0, 1.0f}};
  }
  if (y >= z) {
    return direction[1] < 0.0f ? CubeFace{3, {0, 1.0f}, {2, -1.0f}, {1, -1.0f}}
                               : CubeFace{2, {0, 1.0f}, {2, 1.0f}, {1, 1.0f}};
  }
  return direction[2] < 0.0f ? CubeFace{5, {0, -1.0f}, {1, -1.0f}, {2, -1.0f}}
                             : CubeFace{4, {0, 1.0f}, {1, -1.0f}, {2, 1.0f}};
}

}  // namespace barrido::raster::reference
