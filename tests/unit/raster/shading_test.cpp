// The stages between the varyings and the fragment operations: flat and varying colours, clamping, secondary
// colour, texture units that are off, fog by a literal table; and λ from planes whose slopes are known.
#include "raster/reference/shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "random_texels.h"
#include "raster/reference/level_of_detail.h"
#include "tests/kernels/compile_stages.h"

namespace barrido::raster::reference {
namespace {

TEST(Fog, LiteralTable) {
  const struct {
    FogMode mode;
    float density, start, end, distance;
    double expected;
  } table[] = {
      {FogMode::linear, 1, 2, 10, 2, 1.0},        {FogMode::linear, 1, 2, 10, 10, 0.0},
      {FogMode::linear, 1, 2, 10, 4, 0.75},       {FogMode::linear, 1, 2, 10, 0, 1.0},
      {FogMode::linear, 1, 2, 10, 11, 0.0},       {FogMode::exp, 0.5f, 0, 1, 0, 1.0},
      {FogMode::exp, 0.5f, 0, 1, 2, 0.36787944},  {FogMode::exp, 0.25f, 0, 1, 12, 0.04978707},
      {FogMode::exp2, 0.5f, 0, 1, 2, 0.36787944}, {FogMode::exp2, 0.5f, 0, 1, 3, 0.10539922},
      {FogMode::exp2, 0.5f, 0, 1, 1e20f, 0.0},    {FogMode::linear, 1, 3, 3, 3, 0.0},
  };
  for (const auto& row : table) {
    const FogState fog{true, row.mode, row.density, row.start, row.end, {0, 0, 0, 0}};
    EXPECT_NEAR(fog_fraction(fog, row.distance), row.expected, 2e-7) << row.distance;
  }
}

/// One fragment of a state with colour (4 varyings), secondary colour (3), fog (1) and coordinates (2).
struct Fragment {
  FragmentState state;
  reference::Fragment fragment;

  explicit Fragment(std::initializer_list<Varying> varyings = {{Meaning::color, 4},
                                                               {Meaning::specular, 3},
                                                               {Meaning::fog, 1},
                                                               {Meaning::texcoord, 2, 1}}) {
    for (const Varying& varying : varyings) state.varyings.add(varying);
    fragment.state = &state;
  }
  Color shade(const std::array<float, 10>& varyings, std::span<const FragmentStage> before = {}) {
    raster::testing::compile_stages(state, before);
    std::copy(varyings.begin(), varyings.end(), fragment.varying);
    return shade_fragment(fragment);
  }
};

TEST(Shading, ColoursAreClampedOnlyWhenAsked) {
  Fragment f;
  EXPECT_EQ(f.shade({2, -1, 0.5f, 1}), (Color{1, 0, 0.5f, 1}));
  f.state.clamp_colors = false;
  EXPECT_EQ(f.shade({2, -1, 0.5f, 1}), (Color{2, -1, 0.5f, 1}));
}

TEST(Shading, SecondaryColourIsAddedToRgb) {
  Fragment f;
  EXPECT_EQ(f.shade({0.5f, 0.5f, 0.5f, 0.25f, 0.25f, 0.75f, 2}), (Color{0.5f, 0.5f, 0.5f, 0.25f}));
  f.state.separate_specular = true;
  EXPECT_EQ(f.shade({0.5f, 0.5f, 0.5f, 0.25f, 0.25f, 0.75f, 2}), (Color{0.75f, 1, 1, 0.25f}));
  f.state.clamp_colors = false;
  EXPECT_EQ(f.shade({0.5f, 0.5f, 0.5f, 0.25f, 0.25f, 0.75f, 2}), (Color{0.75f, 1.25f, 2.5f, 0.25f}));
}

TEST(Shading, FogLeavesAlpha) {
  Fragment f;
  f.state.fog = {true, FogMode::linear, 1, 0, 4, {0, 1, 0.5f, 0.125f}};
  EXPECT_EQ(f.shade({1, 0, 0.5f, 0.75f, 0, 0, 0, -3}), (Color{0.25f, 0.75f, 0.5f, 0.75f}));
  f.state.fog.enabled = false;
  EXPECT_EQ(f.shade({1, 0, 0.5f, 0.75f, 0, 0, 0, -3}), (Color{1, 0, 0.5f, 0.75f}));
}

TEST(Shading, FlatColoursStayWhenNoVaryingCarriesThem) {
  Fragment f({});
  f.state.separate_specular = true;
  f.fragment.color = {0.25f, 0.25f, 0.25f, 0.25f};
  f.fragment.specular = {0.5f, 0.5f, 0.5f};
  EXPECT_EQ(f.shade({9, 9, 9, 9, 9, 9, 9}), (Color{0.75f, 0.75f, 0.75f, 0.25f}));
}

TEST(Shading, LightWritesTheColours) {
  static constexpr StageKind kHalf{
      .name = "half",
      .reads = set_of(Meaning::normal),
      .writes = set_of(Meaning::color),
      .scalar =
          [](const FragmentStage& stage, reference::Fragment& fragment, ShadingTrace*) {
            const float gain = *static_cast<const float*>(stage.parameters);
            for (std::size_t c = 0; c < 4; ++c) fragment.color[c] = gain * fragment.varying[c];
          },
      .story = "halves"};
  const float gain = 0.5f;
  const FragmentStage light{.kind = &kHalf, .parameters = &gain};
  Fragment f;
  EXPECT_EQ(f.shade({1, 0.5f, 0.25f, 2}, {&light, 1}), (Color{0.5f, 0.25f, 0.125f, 1}));
}

TEST(Shading, AUnitWithoutCoordinatesIsOff) {
  const auto rgba = raster::testing::random_rgba(4, 4, 1);
  const Texture texture = Texture::make_2d({4, 4, rgba}, {});
  Fragment f({{Meaning::color, 4}});
  f.state.texture_units[1].texture = &texture;
  f.state.texture_units[1].env_mode = TextureEnvMode::replace;
  EXPECT_EQ(f.shade({1, 1, 1, 1}), (Color{1, 1, 1, 1}));
  EXPECT_FALSE(is_active(f.state, 0));
  EXPECT_FALSE(is_active(f.state, 1));
  f.state.varyings.add({Meaning::texcoord, 2, 1});
  EXPECT_NE(f.shade({1, 1, 1, 1}), (Color{1, 1, 1, 1}));
  EXPECT_TRUE(is_active(f.state, 1));
}

/// Quantities of a span from pixel 10 to 20: depth, q, then three coordinates.
SpanQuantities coordinates_along(SpanQuantity q, SpanQuantity s, SpanQuantity t, SpanQuantity r = {}) {
  return {10, 20, {SpanQuantity{}, q, s, t, r}};
}

TEST(LevelOfDetail, TexelsPerPixel) {
  const auto rgba = raster::testing::random_rgba(64, 32, 1);
  const Texture texture = Texture::make_2d({64, 32, rgba}, {});
  FragmentState state;
  state.texture_units[0].texture = &texture;
  state.varyings.add({Meaning::texcoord, 2});
  const SpanQuantity one{1.0f, 0.0f, 0.0f};
  // 4 texels a pixel along x, 2 along y: the larger counts.
  const auto affine = coordinates_along(one, {0.1f, 0.0625f, 0.0f}, {0.2f, 0.0f, 0.0625f});
  EXPECT_EQ(level_of_detail(state, 0, affine, 12), 2.0f);
  state.varyings.affine_count = 2;
  EXPECT_EQ(level_of_detail(state, 0, affine, 12), 2.0f);
  state.varyings.affine_count = 0;
  // Constant coordinates: as small as λ gets. No numbers: as large.
  EXPECT_EQ(level_of_detail(state, 0, coordinates_along(one, {1, 0, 0}, {1, 0, 0}), 12), -63.0f);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NEAR(level_of_detail(state, 0, coordinates_along(one, {1, nan, 0}, {1, 0, nan}), 12), 49.83f, 0.01f);
}

TEST(LevelOfDetail, PerspectiveFollowsTheQuotientRule) {
  const auto rgba = raster::testing::random_rgba(64, 64, 1);
  const Texture texture = Texture::make_2d({64, 64, rgba}, {});
  FragmentState state;
  state.texture_units[0].texture = &texture;
  const SpanQuantity q{0.5f, 0.01f, -0.02f};
  const SpanQuantity s{0.3f, 0.03f, 0.01f};
  const SpanQuantity t{0.2f, -0.01f, 0.05f};
  // The same at q and at the third coordinate of a projective texture.
  for (const TexcoordKind kind : {TexcoordKind::plain, TexcoordKind::projective}) {
    state.varyings = {};
    state.varyings.add({Meaning::texcoord, floats_of(kind)});
    for (const int x : {10, 11, 12, 15, 16, 19, 20}) {
      const double center = std::min(std::max((x & ~3) + 1.5, 10.0), 20.0) - 10.0;
      const auto u_at = [&](double dx, double dy) {
        return (0.3 + 0.03 * (center + dx) + 0.01 * dy) / (0.5 + 0.01 * (center + dx) - 0.02 * dy) * 64.0;
      };
      const auto v_at = [&](double dx, double dy) {
        return (0.2 - 0.01 * (center + dx) + 0.05 * dy) / (0.5 + 0.01 * (center + dx) - 0.02 * dy) * 64.0;
      };
      const double h = 1e-6;
      const double along_x = std::hypot((u_at(h, 0) - u_at(0, 0)) / h, (v_at(h, 0) - v_at(0, 0)) / h);
      const double along_y = std::hypot((u_at(0, h) - u_at(0, 0)) / h, (v_at(0, h) - v_at(0, 0)) / h);
      const auto along = coordinates_along(kind == TexcoordKind::plain ? q : SpanQuantity{7, 7, 7}, s, t, q);
      EXPECT_NEAR(level_of_detail(state, 0, along, x), std::log2(std::max(along_x, along_y)), 1e-4) << x;
    }
  }
}

TEST(LevelOfDetail, CubeFacesSpanTwoUnits) {
  const auto face = raster::testing::random_rgba(16, 16, 1);
  std::array<Pixels8, kCubeFaces> faces;
  faces.fill({16, 16, face});
  const Texture cube = Texture::make_cube(faces, {});
  FragmentState state;
  state.texture_units[0].texture = &cube;
  state.varyings.add({Meaning::texcoord, 3});
  // On face −Z, ma = −2 and constant: 0.5·(dx 1)/2 · 16 = 4 texels a pixel.
  const auto along = coordinates_along({1, 0, 0}, {-1.0f, 1.0f, 0.0f}, {0, 0, 0.25f}, {-2, 0, 0});
  EXPECT_EQ(level_of_detail(state, 0, along, 10), 2.0f);
}

}  // namespace
}  // namespace barrido::raster::reference
