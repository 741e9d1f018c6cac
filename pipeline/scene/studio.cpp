#include "pipeline/scene/studio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "pipeline/scene/cube_directions.h"
#include "pipeline/scene/transfer.h"

namespace barrido::scene {
namespace {

constexpr int kStudioSize = 64;

float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// A rectangular light: 1 inside, falling to 0 at a soft edge. `axis` points to its middle; the half sides
/// are tangents of angles.
struct SoftBox {
  glm::vec3 axis;
  float half_width;
  float half_height;
  float brightness;
};

constexpr float kSoftEdge = 0.08f;

float light_of(const SoftBox& box, const glm::vec3& direction) {
  const glm::vec3 axis = box.axis / std::sqrt(glm::dot(box.axis, box.axis));
  const float along = glm::dot(direction, axis);
  if (along <= 0.0f) return 0.0f;
  const glm::vec3 across = glm::cross(glm::vec3(0, 1, 0), axis);
  const glm::vec3 right = across / std::sqrt(glm::dot(across, across));
  const glm::vec3 up = glm::cross(axis, right);
  const float x = std::abs(glm::dot(direction, right)) / along;
  const float y = std::abs(glm::dot(direction, up)) / along;
  return box.brightness * (1.0f - smooth_step(box.half_width - kSoftEdge, box.half_width + kSoftEdge, x)) *
         (1.0f - smooth_step(box.half_height - kSoftEdge, box.half_height + kSoftEdge, y));
}

/// Linear light from a unit direction: a dark floor, walls that brighten towards the ceiling, two lights.
float studio_light(const glm::vec3& d) {
  constexpr SoftBox kKeyBox{{-0.62f, 0.62f, 0.48f}, 0.55f, 0.40f, 0.75f};
  constexpr SoftBox kFillBox{{0.93f, 0.12f, 0.35f}, 0.22f, 0.75f, 0.45f};
  const float floor = 0.10f + 0.10f * smooth_step(-1.0f, 0.0f, d.y);
  const float wall = 0.34f + 0.30f * smooth_step(0.0f, 0.9f, d.y);
  const float room = floor + (wall - floor) * smooth_step(-0.12f, 0.10f, d.y);
  return std::min(room + light_of(kKeyBox, d) + light_of(kFillBox, d), 1.0f);
}

}  // namespace

raster::Texture make_studio(raster::Encoding encoding) {
  std::array<std::vector<std::uint8_t>, raster::kCubeFaces> bytes;
  std::array<raster::Pixels8, raster::kCubeFaces> faces;
  for (int face = 0; face < raster::kCubeFaces; ++face) {
    std::vector<std::uint8_t>& rgba = bytes[static_cast<std::size_t>(face)];
    rgba.reserve(std::size_t{4} * kStudioSize * kStudioSize);
    for (int j = 0; j < kStudioSize; ++j) {
      for (int i = 0; i < kStudioSize; ++i) {
        const glm::vec3 d = cube_direction(face, texel_middle(i, kStudioSize), texel_middle(j, kStudioSize));
        const std::uint8_t grey = srgb8_from_linear(studio_light(d / std::sqrt(glm::dot(d, d))));
        rgba.insert(rgba.end(), {grey, grey, grey, 255});
      }
    }
    faces[static_cast<std::size_t>(face)] = {kStudioSize, kStudioSize, rgba};
  }
  raster::TextureOptions options;
  options.encoding = encoding;
  return raster::Texture::make_cube(faces, options);
}

}  // namespace barrido::scene
