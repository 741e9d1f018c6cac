// Layers that fill the screen: quads parallel to it, and ground planes in perspective.
#include <random>

#include "pipeline/matrix.h"
#include "raster/base/portable_math.h"
#include "tests/bench/workloads.h"

namespace barrido::bench {
namespace {

constexpr double kPi = 3.14159265358979323846;

void blend_constantly(pipeline::State& state) {
  using raster::BlendFactor;
  state.blend.enabled = true;
  state.blend.src_rgb = state.blend.src_alpha = BlendFactor::constant_alpha;
  state.blend.dst_rgb = state.blend.dst_alpha = BlendFactor::one_minus_constant_alpha;
  state.blend.constant = {0, 0, 0, 0.6f};
}

glm::vec4 layer_color(int layer, int corner) {
  const float step = static_cast<float>(layer) / 8.0f;
  return {0.2f + 0.8f * ((corner & 1) != 0 ? 1.0f - step : step), (corner & 2) != 0 ? 0.9f : 0.3f,
          0.5f + 0.4f * step, 1.0f};
}

/// Two triangles over corners 0 … 3, which stand at (low, low), (high, low), (low, high), (high, high).
const std::vector<std::uint32_t> kQuad{0, 1, 2, 2, 1, 3};

/// A checker of 64 texels a field with noise on it.
raster::Texture noisy_checker(int side) {
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4);
  std::mt19937 random(1);
  const int field = std::max(1, side / 16);
  for (int y = 0, at = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x, at += 4) {
      const unsigned base = ((x / field + y / field) & 1) != 0 ? 200 : 60;
      for (int c = 0; c < 4; ++c) {
        texels[static_cast<std::size_t>(at + c)] = static_cast<std::uint8_t>(base + random() % 40);
      }
    }
  }
  return raster::Texture::make_2d({side, side, texels}, {});
}

}  // namespace

ScenePair screen_layers(const Scale& scale, int layers, Coloring coloring, bool blended) {
  ScenePair scene;
  scene.width = scale.width;
  scene.height = scale.height;
  scene.clear.color = {0.1f, 0.2f, 0.3f, 1.0f};
  for (int layer = 0; layer < layers; ++layer) {
    DrawCall& draw = scene.draws.emplace_back();
    draw.state.depth.test = true;
    if (coloring == Coloring::flat) draw.state.shade_model = pipeline::ShadeModel::flat;
    if (blended) blend_constantly(draw.state);
    const float z = 0.9f - 1.8f * static_cast<float>(layer) / static_cast<float>(std::max(1, layers - 1));
    for (int corner = 0; corner < 4; ++corner) {
      draw.mesh.position.emplace_back((corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f, z,
                                      1.0f);
      draw.mesh.color.push_back(layer_color(layer, coloring == Coloring::flat ? 1 : corner));
    }
    draw.mesh.indices = kQuad;
  }
  return scene;
}

ScenePair ground_layers(const Scale& scale, const GroundOptions& options) {
  ScenePair scene;
  scene.width = scale.width;
  scene.height = scale.height;
  scene.clear.color = {0.1f, 0.2f, 0.3f, 1.0f};
  scene.textures.push_back(std::make_unique<raster::Texture>(noisy_checker(options.texture_side)));
  const double aspect = static_cast<double>(scale.width) / scale.height;
  for (int place = 0; place < options.layers; ++place) {
    const int layer = options.front_to_back ? options.layers - 1 - place : place;
    DrawCall& draw = scene.draws.emplace_back();
    draw.state.depth.test = true;
    if (options.blended) blend_constantly(draw.state);
    draw.state.clip_from_eye = pipeline::perspective(60.0 * kPi / 180.0, aspect, 0.1, 100.0);
    draw.state.eye_from_object = pipeline::rotation(40.0 * kPi / 180.0, {1, 0, 0});
    raster::TextureUnit& unit = draw.state.texture_units[0];
    unit.texture = scene.textures[0].get();
    unit.min_filter = options.min_filter;
    unit.mag_filter = options.mag_filter;
    unit.max_anisotropy = options.max_anisotropy;
    // The topmost ray falls 10° below the horizon: it meets the ground 5.67 heights away.
    const float height = 1.8f - 0.1f * static_cast<float>(layer);
    const float reach_x = 9.0f * height;
    for (int corner = 0; corner < 4; ++corner) {
      const float x = (corner & 1) != 0 ? reach_x : -reach_x;
      const float z = (corner & 2) != 0 ? -6.5f * height : height;
      const float shift = static_cast<float>(layer);
      draw.mesh.position.emplace_back(x, -height, z, 1.0f);
      draw.mesh.color.push_back(layer_color(layer, corner));
      draw.mesh.texcoord[0].emplace_back(x / (1.5f * height) + 0.13f * shift,
                                         z / (1.5f * height) + 0.29f * shift, 0.0f, 1.0f);
    }
    draw.mesh.indices = kQuad;
  }
  return scene;
}

}  // namespace barrido::bench
