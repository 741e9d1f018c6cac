// The plain pipeline and the vector kernels give the same bits, on every instruction set.
#include <bit>
#include <functional>
#include <memory>

#include <gtest/gtest.h>

#include "pipeline/cheap_phong.h"
#include "pipeline/reference/illumination.h"
#include "pipeline/reference/vertices.h"
#include "pipeline/triangle_block.h"
#include "random_lighting.h"
#include "raster/base/simd_target.h"

namespace barrido::pipeline {
namespace {

void expect_bits(float vector, float scalar, const char* what, int i) {
  ASSERT_EQ(std::bit_cast<std::uint32_t>(vector), std::bit_cast<std::uint32_t>(scalar))
      << what << " " << i << ": " << vector << " and " << scalar;
}

void on_every_target(const std::function<void(Random& random)>& compare) {
  for (const raster::SimdTarget target : raster::available_simd_targets()) {
    SCOPED_TRACE(raster::name_of(target));
    ASSERT_TRUE(raster::set_simd_target(target));
    Random random(41);
    for (int round = 0; round < 200 && !::testing::Test::HasFailure(); ++round) {
      SCOPED_TRACE("round " + std::to_string(round));
      compare(random);
    }
  }
  raster::set_simd_target(raster::SimdTarget::automatic);
}

/// Mostly ordinary, sometimes zero, tiny or huge.
float any_number(Random& random) {
  if (random.chance(0.9)) return random.in(-3, 3);
  const float odd[] = {0.0f, -0.0f, 1e-20f, 1e11f, -1e11f, 1.0f};
  return odd[random.below(6)];
}

struct Lit {
  int count = 37;
  alignas(64) BatchArray normal[3], position[3], color[4], lit[7], dots[2 * 5 + 3], visibility[5];
  std::vector<const float*> shares;
  SurfacePoints points;

  Lit(Random& random, std::size_t lights) {
    const auto fill = [&](auto& arrays, const auto& number) {
      for (auto& array : arrays) {
        for (float& value : array) value = number();
      }
    };
    fill(normal, [&] { return any_number(random); });
    fill(position, [&] { return any_number(random); });
    fill(color, [&] { return random.in(0, 1); });
    fill(visibility, [&] { return random.chance(0.5) ? random.in(0, 1) : 1.0f; });
    if (random.chance(0.5)) {
      for (std::size_t i = 0; i < lights; ++i) shares.push_back(visibility[i]);
    }
    points = {count,
              {normal[0], normal[1], normal[2]},
              {position[0], position[1], position[2]},
              {color[0], color[1], color[2], color[3]},
              random.chance(0.5),
              random.chance(0.5),
              shares};
  }
  reference::SurfacePoint at(int i, std::vector<float>& share) const {
    share.clear();
    for (const float* column : shares) share.push_back(column[i]);
    return {{normal[0][i], normal[1][i], normal[2][i]},
            {position[0][i], position[1][i], position[2][i]},
            {color[0][i], color[1][i], color[2][i], color[3][i]},
            points.normalize,
            points.back,
            share};
  }
  LitColors out() { return {{lit[0], lit[1], lit[2], lit[3]}, {lit[4], lit[5], lit[6]}}; }
  void expect(const reference::LitColor& color_at, bool separate, int i) const {
    for (std::size_t c = 0; c < 4; ++c) expect_bits(lit[c][i], color_at.primary[c], "primary", i);
    for (std::size_t c = 0; separate && c < 3; ++c) {
      expect_bits(lit[4 + c][i], color_at.secondary[c], "secondary", i);
    }
  }
};

TEST(Reference, IlluminationAndCheapPhong) {
  on_every_target([](Random& random) {
    const Lighting lighting = random_lighting(random);
    Illumination model = compile_illumination(lighting, nullptr);
    if (random.chance(0.5)) model.cheap_phong_power = CheapPhongPower::vertex;
    const auto lit = std::make_unique<Lit>(random, model.lights.size());
    std::vector<float> share;
    illuminate(model, lit->points, lit->out());
    for (int i = 0; i < lit->count; ++i) {
      lit->expect(reference::illuminate(model, lit->at(i, share)), model.separate_specular, i);
    }
    const auto varyings = static_cast<std::size_t>(cheap_phong_varyings(model));
    std::vector<float*> columns;
    for (std::size_t k = 0; k < varyings; ++k) columns.push_back(lit->dots[k]);
    cheap_phong_dots(model, lit->points, columns);
    const std::vector<const float*> read(columns.begin(), columns.end());
    cheap_phong_colors(model, {lit->count, lit->points.back, read, lit->points.color, lit->shares},
                       lit->out());
    std::vector<float> dots(varyings);
    for (int i = 0; i < lit->count; ++i) {
      const reference::SurfacePoint point = lit->at(i, share);
      reference::cheap_phong_dots(model, point, dots);
      for (std::size_t k = 0; k < varyings; ++k) expect_bits(lit->dots[k][i], dots[k], "product", i);
      lit->expect(reference::cheap_phong_color(model, dots, point), model.separate_specular, i);
    }
  });
}

VertexTransform random_transform(Random& random) {
  VertexTransform t;
  for (glm::mat4* m : {&t.clip_from_object, &t.eye_from_object}) {
    for (int c = 0; c < 4; ++c) (*m)[c] = random.vec4(-1, 1);
  }
  for (int c = 0; c < 3; ++c) t.eye_normal_from_object[c] = random.vec3(-1, 1);
  t.normalize = random.chance(0.5);
  t.unit_w = random.chance(0.3);
  t.unit_eye_w = random.chance(0.3);
  t.depth_clamp = random.chance(0.3);
  t.plane_count = random.below(4);
  for (glm::vec4& plane : t.planes) plane = random.vec4(-1, 1);
  t.window_scale = random.vec3(10, 4000);
  t.window_offset = random.vec3(-10, 4000);
  return t;
}

TextureCoordinates random_rules(Random& random) {
  TextureCoordinates rules;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    TexGenCoordinate& rule = rules.generation[axis];
    rule.enabled = random.chance(0.7);
    rule.mode = static_cast<TexGenMode>(random.below(axis == 3 ? 2 : axis == 2 ? 4 : 5));
    if (axis == 2 && rule.mode == TexGenMode::sphere_map) rule.mode = TexGenMode::normal_map;
    rule.object_plane = random.vec4(-1, 1);
    rule.eye_plane = random.vec4(-1, 1);
  }
  if (random.chance(0.5)) {
    for (int c = 0; c < 4; ++c) rules.matrix[c] = random.vec4(-1, 1);
  }
  return rules;
}

TEST(Reference, VerticesAndTextureCoordinates) {
  on_every_target([](Random& random) {
    const VertexTransform t = random_transform(random);
    const TextureCoordinates rules = random_rules(random);
    const auto batch = std::make_unique<VertexBatch>();
    batch->count = 37;
    std::vector<glm::vec4> objects, given;
    std::vector<glm::vec3> normals;
    for (int i = 0; i < kVertexBatch; ++i) {
      objects.emplace_back(any_number(random), any_number(random), any_number(random), any_number(random));
      if (random.chance(0.02)) objects.back()[random.below(4)] = std::numeric_limits<float>::quiet_NaN();
      normals.emplace_back(any_number(random), any_number(random), any_number(random));
      given.push_back(random.vec4(-2, 2));
      for (int c = 0; c < 4; ++c) {
        batch->object[c][i] = objects.back()[c];
        batch->coordinate[0][c][i] = given.back()[c];
        if (c < 3) batch->normal[c][i] = normals.back()[c];
      }
    }
    std::vector<PackedPosition> positions(kVertexBatch);
    project_positions(t, *batch, positions.data());
    transform_to_eye(t, *batch, true);
    transform_normals(t, *batch);
    generate_coordinates(rules, *batch, batch->coordinate[0]);
    for (int i = 0; i < batch->count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const reference::ProjectedVertex vertex = reference::project(t, objects[at]);
      ASSERT_EQ(positions[at].x, vertex.position.x) << i;
      ASSERT_EQ(positions[at].y, vertex.position.y) << i;
      expect_bits(batch->depth[i], vertex.depth, "depth", i);
      expect_bits(batch->q[i], vertex.q, "q", i);
      const reference::EyeVertex eye = reference::to_eye(t, vertex.object);
      const glm::vec3 normal = reference::eye_normal(t, normals[at]);
      const glm::vec4 coordinate =
          reference::generate_coordinates(rules, {vertex.object, eye.eye, eye.point, normal}, given[at]);
      for (int c = 0; c < 4; ++c) {
        expect_bits(batch->eye[c][i], eye.eye[c], "eye", i);
        expect_bits(batch->coordinate[0][c][i], coordinate[c], "coordinate", i);
        if (c == 3) break;
        expect_bits(batch->point[c][i], eye.point[c], "point", i);
        expect_bits(batch->normal[c][i], normal[c], "normal", i);
      }
    }
  });
}

TEST(Reference, ClassesOfTriangles) {
  std::size_t visible = 0, clipped = 0, back = 0;
  on_every_target([&](Random& random) {
    const auto block = std::make_unique<TriangleBlock>();
    block->count = kTriangleBlock - random.below(3);
    const int size = random.chance(0.6) ? 700 : 100000;  // in 1/256 pixel
    for (int i = 0; i < kTriangleBlock; ++i) {
      const int x = random.below(200000) - 100000, y = random.below(200000) - 100000;
      for (auto& corners : block->position) {
        const auto packed = [&](int base) {
          return static_cast<std::uint32_t>(base + random.below(size)) << kOutcodeBits;
        };
        corners[i] = {packed(x), packed(y)};
        if (random.chance(0.1)) corners[i].x |= 1u << random.below(8);
        if (random.chance(0.05)) corners[i].y |= 1u << random.below(8);
      }
    }
    const CullRule rule{random.chance(0.7), random.chance(0.7), random.chance(0.5)};
    const TriangleClasses classes = classify_triangles(*block, rule);
    for (int i = 0; i < block->count; ++i) {
      const reference::TriangleClass one =
          reference::classify({block->position[0][i], block->position[1][i], block->position[2][i]}, rule);
      ASSERT_EQ((classes.visible >> i & 1) != 0, one.visible) << i;
      ASSERT_EQ((classes.clipped >> i & 1) != 0, one.clipped) << i;
      ASSERT_EQ((classes.back >> i & 1) != 0, one.back) << i;
      visible += one.visible;
      clipped += one.clipped;
      back += one.back;
    }
  });
  EXPECT_GT(visible, 1000u);
  EXPECT_GT(clipped, 1000u);
  EXPECT_GT(back, 300u);
}

}  // namespace
}  // namespace barrido::pipeline
