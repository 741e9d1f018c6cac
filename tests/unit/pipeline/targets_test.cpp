// Every instruction set gives the same bits, from vertex records to fragments lit by the model.
#include <bit>
#include <cstring>

#include <gtest/gtest.h>

#include "drawn.h"
#include "pipeline/matrix.h"
#include "random_lighting.h"
#include "raster/base/simd_target.h"
#include "raster/reference/fragment.h"
#include "raster/tiles/tile.h"

namespace barrido::pipeline {
namespace {

const raster::Texture& texture(bool cube) {
  static const std::vector<std::uint8_t> pixels(4, 255);
  static const raster::Pixels8 face{1, 1, pixels};
  static const std::array<raster::Pixels8, 6> faces{face, face, face, face, face, face};
  static const raster::Texture flat = raster::Texture::make_2d(face, {});
  static const raster::Texture sky = raster::Texture::make_cube(faces, {});
  return cube ? sky : flat;
}

State random_state(Random& random) {
  State state;
  state.eye_from_object = product(look_at({0, 0, 2.5}, glm::dvec3(random.vec3(-0.5, 0.5)), {0, 1, 0}),
                                  rotation(random.in(-3, 3), glm::dvec3(random.vec3(-1, 1))));
  state.clip_from_eye =
      random.chance(0.3) ? orthographic(-1, 1, -1, 1, 1, 4) : perspective(1.2, 2.0, 1.0, 4.0);
  state.normalize = random.chance(0.5);
  state.rescale_normal = random.chance(0.3);
  state.depth_clamp = random.chance(0.2);
  for (int i = random.below(4); i > 0; --i) state.clip_planes.push_back(random.vec4(-1, 1));
  state.lighting = random_lighting(random);
  state.lighting.enabled = random.chance(0.9);
  state.shade_model = static_cast<ShadeModel>(random.below(kShadingModeCount));
  state.flat_at = random.chance(0.5) ? FlatAt::centroid : FlatAt::provoking_vertex;
  state.cheap_phong_power = random.chance(0.5) ? CheapPhongPower::pixel : CheapPhongPower::vertex;
  state.color_interpolation =
      random.chance(0.5) ? ColorInterpolation::screen : ColorInterpolation::perspective;
  state.clamp_colors = random.chance(0.5);
  state.fog.enabled = random.chance(0.5);
  state.cull_face = static_cast<CullFace>(random.below(3));
  state.polygon_mode = random.chance(0.2) ? PolygonMode::line : PolygonMode::fill;
  for (std::size_t unit = 0; unit < 2; ++unit) {
    state.texture_units[unit].texture = &texture(random.chance(0.5));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      TexGenCoordinate& rule = state.texture_coordinates[unit].generation[axis];
      rule.enabled = random.chance(0.5);
      rule.mode = static_cast<TexGenMode>(random.below(axis == 2 ? 2 : 5));
      rule.object_plane = rule.eye_plane = random.vec4(-1, 1);
    }
  }
  return state;
}

/// Empty arrays have no address that may be compared.
bool same_bits(const void* a, const void* b, std::size_t bytes) {
  return bytes == 0 || std::memcmp(a, b, bytes) == 0;
}

void expect_same_chunks(const Drawn& a, const Drawn& b) {
  ASSERT_EQ(a.chunks.size(), b.chunks.size());
  for (std::size_t c = 0; c < a.chunks.size(); ++c) {
    const raster::PrimitiveChunk &p = a.chunks[c], &q = b.chunks[c];
    ASSERT_EQ(p.primitives.size(), q.primitives.size());
    ASSERT_EQ(p.flat.size(), q.flat.size());
    ASSERT_EQ(p.own_records.size(), q.own_records.size());
    EXPECT_TRUE(same_bits(p.own_records.data(), q.own_records.data(), p.own_records.size() * sizeof(float)));
    EXPECT_TRUE(same_bits(p.flat.data(), q.flat.data(), p.flat.size() * sizeof(raster::FlatColors)));
    const std::size_t corners = p.topology == raster::Topology::triangles ? 3 : 2;
    for (std::size_t i = 0; i < p.primitives.size(); ++i) {
      const raster::PrimitiveRecord &r = p.primitives[i], &s = q.primitives[i];
      EXPECT_TRUE(same_bits(r.x, s.x, corners * 4) && same_bits(r.y, s.y, corners * 4) &&
                  same_bits(r.vertex, s.vertex, corners * 4) && r.flat_and_facing == s.flat_and_facing);
    }
  }
}

/// Fragments whose varyings are the vertices', lit as the rasterizer would have them lit; and the same one by
/// one, which must be the same bits.
std::vector<float> lit_fragments(const Drawn& drawn) {
  const raster::FragmentState& state = drawn.plan->fragment;
  std::vector<float> colors;
  if (!raster::is_lit(state)) return colors;
  auto workspace = std::make_unique<raster::TileWorkspace>();
  raster::FragmentBatch& batch = workspace->batch;
  batch.state = &state;
  batch.count = raster::kBatchCapacity - 3;
  batch.back_facing = drawn.plan->marks_back_faces;
  for (int i = 0; i < raster::kBatchStride; ++i) {
    const auto vertex = static_cast<std::uint32_t>(i) % drawn.vertices.count;
    for (int v = 0; v < state.varyings.count; ++v) {
      batch.varying[v][i] = drawn.record(vertex)[raster::kRecordVaryings + v];
    }
  }
  const raster::FragmentStage& light = state.stages.front();
  light.kind->vector(light, *workspace);
  for (int i = 0; i < batch.count; ++i) {
    raster::reference::Fragment one;
    one.state = &state;
    one.back_facing = batch.back_facing;
    for (int v = 0; v < state.varyings.count; ++v) one.varying[v] = batch.varying[v][i];
    light.kind->scalar(light, one, nullptr);
    const auto add = [&](float vector, float scalar) {
      EXPECT_EQ(std::bit_cast<std::uint32_t>(vector), std::bit_cast<std::uint32_t>(scalar));
      colors.push_back(vector);
    };
    for (std::size_t c = 0; c < 4; ++c) add(batch.color[c][i], one.color[c]);
    for (std::size_t c = 0; state.separate_specular && c < 3; ++c) add(batch.specular[c][i], one.specular[c]);
  }
  return colors;
}

TEST(Targets, AllGiveTheSameBits) {
  const std::vector<raster::SimdTarget> targets = raster::available_simd_targets();
  ASSERT_GE(targets.size(), 1u);
  Random random(31);
  constexpr std::uint32_t kVertices = 203;
  std::vector<float> positions, normals, colors, texcoords;
  for (std::uint32_t i = 0; i < kVertices; ++i) {
    const auto add = [](std::vector<float>& to, const glm::vec3& v) { to.insert(to.end(), {v.x, v.y, v.z}); };
    add(positions, i % 17 == 0 ? glm::vec3(0) : random.vec3(-1.5, 1.5));
    add(normals, i % 13 == 0 ? glm::vec3(0) : random.vec3(-1, 1));
    add(colors, random.vec3(-0.2, 1.2));
    add(texcoords, random.vec3(-2, 2));
  }
  for (int round = 0; round < 150; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const State state = random_state(random);
    Geometry geometry = geometry_of(positions, static_cast<PrimitiveMode>(random.below(10)));
    if (random.chance(0.8)) geometry.normal = {normals.data(), 3, 3};
    if (random.chance(0.5)) geometry.color = {colors.data(), 3, 3};
    geometry.texcoord[0] = {texcoords.data(), 3, 3};
    geometry.texcoord[1] = {texcoords.data(), 2, 3};
    ASSERT_TRUE(raster::set_simd_target(targets[0]));
    const Drawn expected(state, geometry);
    const std::vector<float> expected_fragments = lit_fragments(expected);
    for (const raster::SimdTarget target : targets) {
      SCOPED_TRACE(raster::name_of(target));
      ASSERT_TRUE(raster::set_simd_target(target));
      const Drawn drawn(state, geometry);
      const std::size_t floats = static_cast<std::size_t>(drawn.vertices.stride) * kVertices;
      for (int side = 0; side < drawn.plan->sides(); ++side) {
        const std::uint32_t first = static_cast<std::uint32_t>(side) * drawn.vertices.capacity;
        ASSERT_TRUE(same_bits(drawn.record(first), expected.record(first), floats * sizeof(float)));
      }
      ASSERT_TRUE(same_bits(drawn.vertices.positions, expected.vertices.positions,
                            kVertices * sizeof(PackedPosition)));
      expect_same_chunks(drawn, expected);
      const std::vector<float> fragments = lit_fragments(drawn);
      ASSERT_EQ(fragments.size(), expected_fragments.size());
      ASSERT_TRUE(same_bits(fragments.data(), expected_fragments.data(), fragments.size() * sizeof(float)));
      if (::testing::Test::HasFailure()) break;
    }
    raster::set_simd_target(raster::SimdTarget::automatic);
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace barrido::pipeline
