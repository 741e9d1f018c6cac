// What the inspector's tests share: models of the project, and the pixels of a drawn frame beside stories of
// them.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <string>
#include <vector>

#include "pipeline/gltf/import_gltf.h"
#include "pipeline/inspect/pixel_story.h"
#include "raster/base/simd_target.h"

namespace barrido::inspect {

inline scene::Scene model(const std::string& name) {
  return scene::import_gltf(std::string(BARRIDO_SOURCE_DIR) + "/models/" + name, {});
}

inline std::vector<PixelPosition> random_pixels(const scene::RenderSettings& settings, int count,
                                                unsigned seed) {
  std::mt19937 random(seed);
  std::vector<PixelPosition> pixels;
  for (int i = 0; i < count; ++i) {
    const int x = static_cast<int>(random() % static_cast<unsigned>(settings.width));
    pixels.push_back({x, static_cast<int>(random() % static_cast<unsigned>(settings.height))});
  }
  return pixels;
}

/// Draws a frame and inspects some of its pixels: every story ends in the frame's bits, and its illumination
/// adds up.
inline void expect_exact(const scene::Scene& scene, scene::RenderSettings settings, int count,
                         const std::string& what) {
  scene::SceneRenderer renderer(scene);
  const raster::Framebuffer frame = renderer.render(settings);
#ifdef BARRIDO_SANITIZED
  count = (count + 7) / 8;  // each takes its time there, and thousands have been compared without
#endif
  const std::vector<PixelPosition> pixels = random_pixels(settings, count, 7);
  int wrong = 0;
  for (const PixelStory& story : inspect_pixels(scene, renderer, settings, pixels)) {
    const std::size_t index = static_cast<std::size_t>(story.y) * static_cast<std::size_t>(frame.width()) +
                              static_cast<std::size_t>(story.x);
    bool same = std::bit_cast<std::uint32_t>(story.rgba8) == frame.color8()[index];
    for (std::size_t c = 0; c < 4 && !frame.color_float().empty(); ++c) {
      same = same && std::bit_cast<std::uint32_t>(story.color[c]) ==
                         std::bit_cast<std::uint32_t>(frame.color_float()[index * 4 + c]);
    }
    for (const FragmentStory& fragment : story.fragments) {
      for (const IlluminationStory& light : fragment.illuminations) same = same && light.exact;
      if (fragment.from_products) same = same && fragment.from_products->exact;
    }
    if (!same && ++wrong <= 3) ADD_FAILURE() << what << "\n" << story_text(story);
  }
  EXPECT_EQ(wrong, 0) << what;
}

}  // namespace barrido::inspect
