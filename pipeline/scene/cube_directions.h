// Directions of a cube map's texels (OpenGL 1.3, table 3.19), for those who make and read cube maps.
#pragma once

#include <glm/vec3.hpp>

namespace barrido::scene {

/// Unnormalised direction of (s, t) ∈ [−1, 1]² on `face` (+X −X +Y −Y +Z −Z); its largest component is ±1.
inline glm::vec3 cube_direction(int face, float s, float t) {
  switch (face) {
    case 0:
      return {1.0f, -t, -s};
    case 1:
      return {-1.0f, -t, s};
    case 2:
      return {s, 1.0f, t};
    case 3:
      return {s, -1.0f, -t};
    case 4:
      return {s, -t, 1.0f};
    default:
      return {-s, -t, -1.0f};
  }
}

/// Coordinate in (−1, 1) of the middle of texel `i` of `size`.
inline float texel_middle(int i, int size) {
  return (static_cast<float>(2 * i + 1)) / static_cast<float>(size) - 1.0f;
}

}  // namespace barrido::scene
