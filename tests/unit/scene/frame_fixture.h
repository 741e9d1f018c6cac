// Frames of small scenes and their pixels, for tests that look at pictures.
#pragma once

#include <array>

#include "pipeline/scene/render_scene.h"
#include "tests/unit/scene/scene_fixture.h"

namespace barrido::scene::testing {

using Pixel = std::array<int, 4>;

/// The origin from 5 in front of it.
inline RenderSettings front_view() {
  RenderSettings settings;
  settings.width = settings.height = 64;
  settings.camera.position = glm::vec3(0, 0, 5);
  settings.camera.focal_point = glm::vec3(0, 0, 0);
  settings.background_color = glm::vec4(0, 0, 0, 1);
  return settings;
}

inline Pixel pixel_of(const raster::Framebuffer& frame, int x, int window_y) {
  const std::uint32_t packed = frame.color8()[frame.index(x, window_y)];
  return {static_cast<int>(packed & 255), static_cast<int>(packed >> 8 & 255),
          static_cast<int>(packed >> 16 & 255), static_cast<int>(packed >> 24)};
}

inline Pixel middle(const Scene& scene, const RenderSettings& settings) {
  SceneRenderer renderer(scene);
  return pixel_of(renderer.render(settings), settings.width / 2, settings.height / 2);
}

inline Material unlit(const glm::vec4& color, AlphaMode mode = AlphaMode::opaque) {
  Material material;
  material.unlit = true;
  material.base_color = color;
  material.alpha_mode = mode;
  return material;
}

inline Material matte(const glm::vec3& color) {
  Material material;
  material.base_color = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  return material;
}

}  // namespace barrido::scene::testing
