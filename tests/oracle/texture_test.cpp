// Textured planes in perspective against rays intersected with the plane in double precision (course T2, T3,
// T20).
//
// Tolerance. Positions are rounded to 1/256 pixel, and texture coordinates follow: an error of up to 1/256
// pixel times the derivative of u or v at the pixel. The filter quantises fractions to 1/256 texel.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/matrix.h"
#include "tests/oracle/harness.h"

namespace barrido::oracle {
namespace {

constexpr int kWidth = 240, kHeight = 180;
constexpr double kFocal = 1.2;  // distance of the image plane whose half height is 1
constexpr double kPixelRounding = 1.0 / 256.0;

/// The ground: height −1, from z = −1.2 to −30, u = x·scale, v = −z·scale.
struct Ground {
  double scale;
  DrawnMesh mesh;

  explicit Ground(double texture_scale) : scale(texture_scale) {
    const double near_z = -1.2, far_z = -30.0, half = 45.0;
    for (const glm::dvec2& c : {glm::dvec2(-half, near_z), glm::dvec2(half, near_z), glm::dvec2(half, far_z),
                                glm::dvec2(-half, far_z)}) {
      mesh.add({c.x, -1.0, c.y}, {0, 1, 0}, {c.x * scale, -c.y * scale});
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
  }

  /// (u, v) that the ray through a window position meets.
  glm::dvec2 at(double x, double y) const {
    const double sx = (x / kWidth * 2 - 1) * kWidth / kHeight / kFocal, sy = (y / kHeight * 2 - 1) / kFocal;
    const double depth = -1.0 / sy;  // of the point whose height is −1
    return {sx * depth * scale, depth * scale};
  }
  glm::dvec2 dx(double x, double y) const { return (at(x + 1e-4, y) - at(x - 1e-4, y)) / 2e-4; }
  glm::dvec2 dy(double x, double y) const { return (at(x, y + 1e-4) - at(x, y - 1e-4)) / 2e-4; }
};

pipeline::State ground_state(const raster::Texture& texture) {
  pipeline::State state;
  state.clip_from_eye = pipeline::perspective(2 * std::atan(1 / kFocal), double(kWidth) / kHeight, 0.5, 50.0);
  state.depth.test = true;
  state.clamp_colors = false;
  state.texture_units[0].texture = &texture;
  state.texture_units[0].env_mode = raster::TextureEnvMode::replace;
  return state;
}

raster::Texture texture_of(int width, int height, const std::vector<std::uint8_t>& rgba) {
  raster::TextureOptions options;
  options.mipmaps = false;
  return raster::Texture::make_2d({width, height, rgba}, options);
}

/// Rows of the frame that show the ground well below the horizon, with the pixels in them.
template <class Function>
void for_each_ground_pixel(Function&& function) {
  for (int y = 0; y < kHeight * 45 / 100; ++y) {
    if (y + 0.5 < kHeight * 0.5 * (1 - kFocal / 1.25)) continue;  // nearer than the ground begins
    for (int x = 0; x < kWidth; ++x) function(x, y);
  }
}

double distance_to_integer(double v) { return std::abs(v - std::round(v)); }

TEST(TextureOracle, CheckerBoundariesArePerspectiveCorrect) {  // T3
  const std::vector<std::uint8_t> checker{0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 255};
  const raster::Texture texture = texture_of(2, 2, checker);
  const Ground ground(0.5);
  pipeline::State state = ground_state(texture);
  state.texture_units[0].min_filter = raster::MinFilter::nearest;
  state.texture_units[0].mag_filter = raster::MagFilter::nearest;
  FloatFrame frame(kWidth, kHeight);
  frame.draw(state, ground.mesh.geometry());
  int compared = 0, wrong = 0;
  for_each_ground_pixel([&](int x, int y) {
    const glm::dvec2 uv = ground.at(x + 0.5, y + 0.5) * 2.0;  // in texels
    const glm::dvec2 slack = (glm::abs(ground.dx(x + 0.5, y + 0.5)) + glm::abs(ground.dy(x + 0.5, y + 0.5))) *
                                 2.0 * kPixelRounding +
                             1e-5;
    if (distance_to_integer(uv.x) < slack.x || distance_to_integer(uv.y) < slack.y) return;
    const bool white = (static_cast<int>(std::floor(uv.x)) + static_cast<int>(std::floor(uv.y))) % 2 != 0;
    ++compared;
    if ((frame.at(x, y).r > 0.5) != white) ++wrong;
  });
  EXPECT_GT(compared, 15000);
  EXPECT_EQ(wrong, 0);
}

/// A texture whose red (or green) grows linearly with u (or v): texel i has value i.
raster::Texture gradient_texture() {
  std::vector<std::uint8_t> rgba;
  for (int j = 0; j < 256; ++j) {
    for (int i = 0; i < 256; ++i) {
      rgba.insert(rgba.end(), {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j), 0, 255});
    }
  }
  return texture_of(256, 256, rgba);
}

/// u or v in [0, 1) from a colour that the gradient gave.
double coordinate_of(double color) { return (color * 255.0 + 0.5) / 256.0; }

TEST(TextureOracle, CoordinatesArePerspectiveCorrect) {  // T3
  const raster::Texture texture = gradient_texture();
  const Ground ground(0.2);
  pipeline::State state = ground_state(texture);
  state.texture_units[0].min_filter = raster::MinFilter::linear;
  FloatFrame frame(kWidth, kHeight);
  frame.draw(state, ground.mesh.geometry());
  int compared = 0;
  double worst = 0.0;  // in units of what is allowed
  for_each_ground_pixel([&](int x, int y) {
    const glm::dvec2 uv = ground.at(x + 0.5, y + 0.5);
    const glm::dvec2 allowed =
        (glm::abs(ground.dx(x + 0.5, y + 0.5)) + glm::abs(ground.dy(x + 0.5, y + 0.5))) * kPixelRounding +
        1.5 / 65536.0;  // one step of the filter's fraction, and its rounding
    const glm::dvec4 color = frame.at(x, y);
    for (int k = 0; k < 2; ++k) {
      const double part = uv[k] - std::floor(uv[k]);
      if (part < 0.01 || part > 0.99) continue;  // where the gradient starts again
      ++compared;
      worst = std::max(worst, std::abs(coordinate_of(color[k]) - part) / allowed[k]);
    }
  });
  EXPECT_GT(compared, 30000);
  EXPECT_LE(worst, 1.0);
}

TEST(TextureOracle, AffineCoordinatesAreLinearOnTheScreen) {  // T2
  const raster::Texture texture = gradient_texture();
  const Ground ground(1.0 / 90.0);
  pipeline::State state = ground_state(texture);
  state.texture_units[0].min_filter = raster::MinFilter::linear;
  state.texture_interpolation = pipeline::TextureInterpolation::affine;
  // A wall that leans away, so that nothing of it is clipped: clipping would add vertices of its own.
  DrawnMesh wall;
  wall.add({-1.2, -0.9, -2}, {0, 0, 1}, {0.05, 0.05});
  wall.add({4.0, -3.0, -8}, {0, 0, 1}, {0.95, 0.05});
  wall.add({4.0, 3.0, -8}, {0, 0, 1}, {0.95, 0.95});
  wall.indices = {0, 1, 2};
  FloatFrame frame(kWidth, kHeight);
  frame.draw(state, wall.geometry());
  const OracleMesh mesh(wall.rounded_positions(), wall.indices, glm::dmat4(state.clip_from_eye), kWidth,
                        kHeight);
  const std::vector<glm::dvec2> uv{{0.05, 0.05}, {0.95, 0.05}, {0.95, 0.95}};
  double worst = 0.0, largest_difference = 0.0;
  int compared = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const OracleMesh::Hit hit = mesh.at(x + 0.5, y + 0.5, 0.01);
      if (hit.triangle < 0) continue;
      ++compared;
      const glm::dvec2 affine = mixed(mesh, 0, hit.screen, uv), correct = mixed(mesh, 0, hit.weights, uv);
      const glm::dvec4 color = frame.at(x, y);
      for (int k = 0; k < 2; ++k) worst = std::max(worst, std::abs(coordinate_of(color[k]) - affine[k]));
      largest_difference = std::max(largest_difference, std::abs(affine.x - correct.x));
    }
  }
  EXPECT_GT(compared, 3000);
  // The triangle is 80 pixels wide: 0.9/80/256 = 4.4e-5 a coordinate from rounding, and the filter's step.
  EXPECT_LE(worst, 6e-5);
  EXPECT_GT(largest_difference, 0.1) << "perspective must show in this view";
}

constexpr int kLevels = 9;
constexpr int kBaseSide = 256;

/// Levels told apart by their colour: level l is l/8 in red.
raster::Texture level_texture() {
  std::vector<std::vector<std::uint8_t>> bytes(kLevels);
  std::vector<raster::Pixels8> levels;
  for (int l = 0; l < kLevels; ++l) {
    const int side = kBaseSide >> l;
    std::vector<std::uint8_t>& rgba = bytes[static_cast<std::size_t>(l)];
    for (int i = 0; i < side * side; ++i) {
      rgba.insert(rgba.end(), {static_cast<std::uint8_t>(31 * l), 0, 0, 255});
    }
    levels.push_back({side, side, rgba});
  }
  return raster::Texture::make_2d_levels(levels, {});
}

/// Level of detail at a window position: log2 of the larger of the two sides of the pixel's footprint, in
/// texels of level 0 (OpenGL 1.3, eqs. 3.17 to 3.19).
double analytic_lod(const Ground& ground, double x, double y) {
  const glm::dvec2 dx = ground.dx(x, y) * double(kBaseSide), dy = ground.dy(x, y) * double(kBaseSide);
  return std::log2(std::max(glm::length(dx), glm::length(dy)));
}

/// The renderer evaluates the level once for four pixels; the lod may be that of any of them.
struct LodRange {
  double low, high;
};
LodRange lod_range(const Ground& ground, int x, int y) {
  LodRange range{1e9, -1e9};
  for (int i = x / 4 * 4; i < x / 4 * 4 + 4; ++i) {
    const double lod = analytic_lod(ground, i + 0.5, y + 0.5);
    range = {std::min(range.low, lod), std::max(range.high, lod)};
  }
  return {range.low - 1e-3, range.high + 1e-3};
}

TEST(TextureOracle, NearestLevelFollowsTheFootprint) {  // T20
  const raster::Texture texture = level_texture();
  const Ground ground(0.5);
  pipeline::State state = ground_state(texture);
  state.texture_units[0].min_filter = raster::MinFilter::nearest_mipmap_nearest;
  state.texture_units[0].mag_filter = raster::MagFilter::nearest;
  FloatFrame frame(kWidth, kHeight);
  frame.draw(state, ground.mesh.geometry());
  int compared = 0, wrong = 0;
  std::array<int, kLevels> seen{};
  for_each_ground_pixel([&](int x, int y) {
    const LodRange lod = lod_range(ground, x, y);
    const auto level = [](double l) {
      return std::clamp(static_cast<int>(std::ceil(l + 0.5)) - 1, 0, kLevels - 1);
    };
    if (level(lod.low) != level(lod.high)) return;
    const int got = static_cast<int>(std::round(frame.at(x, y).r * 255.0 / 31.0));
    ++compared;
    ++seen[static_cast<std::size_t>(level(lod.low))];
    if (got != level(lod.low)) ++wrong;
  });
  EXPECT_GT(compared, 15000);
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(std::count_if(seen.begin(), seen.end(), [](int n) { return n > 100; }), 4)
      << "levels in the view";
}

TEST(TextureOracle, TrilinearBlendsByTheFraction) {  // T20
  const raster::Texture texture = level_texture();
  const Ground ground(0.5);
  pipeline::State state = ground_state(texture);
  state.texture_units[0].min_filter = raster::MinFilter::linear_mipmap_linear;
  FloatFrame frame(kWidth, kHeight);
  frame.draw(state, ground.mesh.geometry());
  int compared = 0;
  double worst = 0.0;
  for_each_ground_pixel([&](int x, int y) {
    const LodRange lod = lod_range(ground, x, y);
    if (lod.low < 0.01 || lod.high > kLevels - 1.01) return;
    const double got = frame.at(x, y).r * 255.0 / 31.0;
    ++compared;
    // The fraction has 256 steps and is rounded down, so the lod may come out 1/256 too low.
    worst = std::max({worst, lod.low - 1.0 / 256.0 - got, got - lod.high});
  });
  EXPECT_GT(compared, 15000);
  EXPECT_LE(worst, 0.0);
}

}  // namespace
}  // namespace barrido::oracle
