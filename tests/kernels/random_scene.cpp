#include "random_scene.h"

#include "random_geometry.h"

namespace barrido::raster::testing {
namespace {

FramebufferOptions random_frame(RandomBits& random) {
  FramebufferOptions frame;
  frame.width = random.pick({1, 3, 17, 127, 128, 129, 150, 260, 300});
  frame.height = random.pick({1, 2, 31, 32, 33, 50, 71, 100});
  frame.format = random.pick({ColorFormat::rgba8, ColorFormat::rgba32f});
  frame.keep_float = random.chance(80);
  frame.keep_depth = random.chance(90);
  frame.display.exposure_scale = random.pick({1.0f, 0.3f, 2.5f});
  frame.display.tone_map = random.pick({ToneMap::clamp, ToneMap::reinhard});
  frame.display.srgb_encode = random.chance(50);
  return frame;
}

/// Moves the first vertices of a chunk from its own records to shared ones.
void share_some_records(RandomBits& random, RandomScene& scene, PrimitiveChunk& chunk) {
  const auto stride = static_cast<std::size_t>(record_stride(chunk.state->varyings.count));
  const int vertices = static_cast<int>(chunk.own_records.size() / stride);
  const int shared = random.chance(30) ? 0 : random.between(0, vertices);
  const auto boundary = chunk.own_records.begin() + static_cast<std::ptrdiff_t>(stride) * shared;
  scene.shared_records.push_back(std::make_unique<std::vector<float>>(chunk.own_records.begin(), boundary));
  chunk.own_records.erase(chunk.own_records.begin(), boundary);
  chunk.shared_records = scene.shared_records.back()->data();
  chunk.shared_count = static_cast<std::uint32_t>(shared);
}

}  // namespace

RandomScene make_random_scene(std::uint64_t seed, const TexturePool& textures, const SceneOptions& options) {
  RandomBits random(seed);
  RandomScene scene;
  scene.frame = random_frame(random);
  if (options.simple) scene.frame.format = ColorFormat::rgba8;
  scene.clear = {random.color(0.0f, 1.0f), random.pick({1.0f, 1.0f, 0.5f, 0.0f})};
  // Tenths are half-way between two bytes.
  if (random.chance(50)) {
    for (float& channel : scene.clear.color) channel = static_cast<float>(random.between(0, 10)) * 0.1f;
  }
  const bool mostly_opaque = random.chance(60);
  for (int states = random.between(1, 6); states > 0; --states) {
    const bool opaque = random.chance(mostly_opaque ? 85 : 20);
    const auto [width, height] = std::pair(scene.frame.width, scene.frame.height);
    scene.states.push_back(std::make_unique<FragmentState>(
        options.simple ? random_simple_state(random, width, height)
                       : random_state(random, textures, opaque, width, height)));
    for (int chunks = random.between(1, 3); chunks > 0; --chunks) {
      PrimitiveChunk chunk;
      chunk.state = scene.states.back().get();
      const std::string shape =
          fill_random_geometry(random, {scene.frame.width, scene.frame.height, options.hostile}, chunk);
      share_some_records(random, scene, chunk);
      scene.descriptions.push_back(shape + " " + describe(*chunk.state));
      scene.chunks.push_back(std::move(chunk));
    }
  }
  return scene;
}

}  // namespace barrido::raster::testing
