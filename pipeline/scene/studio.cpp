#include "pipeline/scene/studio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <tbb/parallel_for.h>
#include <glm/geometric.hpp>

#include "pipeline/pictures/transfer.h"
#include "pipeline/scene/cube_directions.h"

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

/// A soft box with what does not depend on the direction looked in.
class SoftLight {
 public:
  explicit SoftLight(const SoftBox& box) : box_(box), axis_(box.axis / length(box.axis)) {
    const glm::vec3 across = glm::cross(glm::vec3(0, 1, 0), axis_);
    right_ = across / length(across);
    up_ = glm::cross(axis_, right_);
  }

  float from(const glm::vec3& direction) const {
    const float along = glm::dot(direction, axis_);
    if (along <= 0.0f) return 0.0f;
    const float x = std::abs(glm::dot(direction, right_)) / along;
    const float y = std::abs(glm::dot(direction, up_)) / along;
    return box_.brightness * inside(box_.half_width, x) * inside(box_.half_height, y);
  }

 private:
  static float length(const glm::vec3& v) { return std::sqrt(glm::dot(v, v)); }
  static float inside(float half_side, float x) {
    return 1.0f - smooth_step(half_side - kSoftEdge, half_side + kSoftEdge, x);
  }

  SoftBox box_;
  glm::vec3 axis_, right_, up_;
};

constexpr SoftBox kKeyBox{{-0.62f, 0.62f, 0.48f}, 0.55f, 0.40f, 0.75f};
constexpr SoftBox kFillBox{{0.93f, 0.12f, 0.35f}, 0.22f, 0.75f, 0.45f};

/// Linear light from a unit direction: a dark floor, walls that brighten towards the ceiling, two lights.
class StudioLight {
 public:
  float from(const glm::vec3& d) const {
    const float floor = 0.10f + 0.10f * smooth_step(-1.0f, 0.0f, d.y);
    const float wall = 0.34f + 0.30f * smooth_step(0.0f, 0.9f, d.y);
    const float room = floor + (wall - floor) * smooth_step(-0.12f, 0.10f, d.y);
    return std::min(room + key_.from(d) + fill_.from(d), 1.0f);
  }

 private:
  SoftLight key_{kKeyBox}, fill_{kFillBox};
};

}  // namespace

raster::Texture make_studio(raster::Encoding encoding) {
  const StudioLight light;
  std::array<std::vector<std::uint8_t>, raster::kCubeFaces> bytes;
  std::array<raster::Pixels8, raster::kCubeFaces> faces;
  tbb::parallel_for(0, raster::kCubeFaces, [&](int face) {
    std::vector<std::uint8_t>& rgba = bytes[static_cast<std::size_t>(face)];
    rgba.reserve(std::size_t{4} * kStudioSize * kStudioSize);
    for (int j = 0; j < kStudioSize; ++j) {
      for (int i = 0; i < kStudioSize; ++i) {
        const glm::vec3 d = cube_direction(face, texel_middle(i, kStudioSize), texel_middle(j, kStudioSize));
        const std::uint8_t grey = srgb8_from_linear(light.from(d / std::sqrt(glm::dot(d, d))));
        rgba.insert(rgba.end(), {grey, grey, grey, 255});
      }
    }
    faces[static_cast<std::size_t>(face)] = {kStudioSize, kStudioSize, rgba};
  });
  raster::TextureOptions options;
  options.encoding = encoding;
  return raster::Texture::make_cube(faces, options);
}

}  // namespace barrido::scene
