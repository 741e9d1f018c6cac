// The oracle is only as good as its scenes: over the seeds of the oracle test every value of every
// enumeration of the fragment state, every topology and every shape must occur.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "random_scene.h"

namespace barrido::raster::testing {
namespace {

/// Values seen, by what they are values of.
using Seen = std::map<std::string, std::set<int>>;

template <class Value>
void see(Seen& seen, const std::string& what, Value value) {
  seen[what].insert(static_cast<int>(value));
}

void see_unit(Seen& seen, const FragmentState& state, std::size_t index) {
  const TextureUnit& unit = state.texture_units[index];
  if (unit.texture == nullptr) return;
  see(seen, "unit", index);
  see(seen, "kind", texcoord_kind(state, static_cast<int>(index)));
  const std::string kind = unit.texture->is_cube() ? "cube " : "2d ";
  see(seen, kind + "filters and format",
      static_cast<int>(unit.min_filter) * 4 + static_cast<int>(unit.mag_filter) * 2 +
          static_cast<int>(unit.texture->format()));
  see(seen, "anisotropy", unit.max_anisotropy);
  if (!unit.texture->is_cube()) {
    see(seen, "wraps",
        static_cast<int>(unit.texture->options().wrap_s) * 5 +
            static_cast<int>(unit.texture->options().wrap_t));
  }
  see(seen, "environment", unit.env_mode);
  if (unit.env_mode != TextureEnvMode::combine) return;
  see(seen, "combine rgb", unit.combine.rgb.function);
  see(seen, "combine alpha", unit.combine.alpha.function);
  for (std::size_t k = 0; k < 3; ++k) {
    see(seen, "combine source and operand",
        static_cast<int>(unit.combine.rgb.source[k]) * 4 + static_cast<int>(unit.combine.rgb.operand[k]));
  }
}

void see_state(Seen& seen, const FragmentState& state) {
  if (state.depth.test) {
    see(seen, "depth", static_cast<int>(state.depth.compare) * 2 + (state.depth.write ? 1 : 0));
  }
  if (state.alpha_test.enabled) see(seen, "alpha test", state.alpha_test.compare);
  if (state.blend.enabled) {
    see(seen, "source factor", state.blend.src_rgb);
    see(seen, "destination factor", state.blend.dst_rgb);
    see(seen, "source alpha factor", state.blend.src_alpha);
    see(seen, "destination alpha factor", state.blend.dst_alpha);
    see(seen, "equation", state.blend.equation);
  }
  if (state.fog.enabled) see(seen, "fog", state.fog.mode);
  see(seen, "sorted", state.sorted);
  see(seen, "scissor", state.scissor.enabled);
  see(seen, "offset", state.polygon_offset.enabled);
  see(seen, "separate specular", state.separate_specular);
  see(seen, "clamp colors", state.clamp_colors);
  see(seen, "colours", state.varyings.has(Meaning::color) ? 0 : is_lit(state) ? 1 : 2);
  see(seen, "affine",
      state.varyings.affine_count == 0                     ? 0
      : state.varyings.affine_count < state.varyings.count ? 1
                                                           : 2);
  for (std::size_t unit = 0; unit < kMaxTextureUnits; ++unit) see_unit(seen, state, unit);
}

TEST(SceneGenerator, CoversEveryState) {
  const TexturePool pool(2024);
  Seen seen;
  std::set<std::string> shapes;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const RandomScene scene = make_random_scene(seed, pool);
    see(seen, "format", scene.frame.format);
    see(seen, "display",
        static_cast<int>(scene.frame.display.tone_map) * 2 + (scene.frame.display.srgb_encode ? 1 : 0));
    for (const PrimitiveChunk& chunk : scene.chunks) see(seen, "topology", chunk.topology);
    for (const auto& state : scene.states) see_state(seen, *state);
    for (const std::string& text : scene.descriptions) shapes.insert(text.substr(0, text.find(" × ")));
  }
  const std::map<std::string, std::size_t> expected = {{"format", 2},
                                                       {"display", 4},
                                                       {"topology", 3},
                                                       {"depth", 16},
                                                       {"alpha test", 8},
                                                       {"source factor", 15},
                                                       {"destination factor", 15},
                                                       {"source alpha factor", 15},
                                                       {"destination alpha factor", 15},
                                                       {"equation", 5},
                                                       {"fog", 3},
                                                       {"scissor", 2},
                                                       {"sorted", 2},
                                                       {"offset", 2},
                                                       {"separate specular", 2},
                                                       {"clamp colors", 2},
                                                       {"colours", 3},
                                                       {"affine", 3},
                                                       {"unit", 8},
                                                       {"kind", 3},
                                                       {"2d filters and format", 32},
                                                       {"cube filters and format", 32},
                                                       {"anisotropy", 16},
                                                       {"wraps", 25},
                                                       {"environment", 6},
                                                       {"combine rgb", 8},
                                                       {"combine alpha", 6},
                                                       {"combine source and operand", 16}};
  for (const auto& [what, count] : expected) EXPECT_EQ(seen[what].size(), count) << what;
  EXPECT_EQ(shapes.size(), 10u);
}

TEST(SceneGenerator, ASeedMeansTheSameScene) {
  const TexturePool pool(2024);
  const RandomScene a = make_random_scene(17, pool);
  const RandomScene b = make_random_scene(17, pool);
  EXPECT_EQ(a.descriptions, b.descriptions);
  ASSERT_FALSE(a.chunks.empty());
  EXPECT_EQ(a.chunks[0].own_records, b.chunks[0].own_records);
}

}  // namespace
}  // namespace barrido::raster::testing
