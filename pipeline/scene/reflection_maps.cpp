#include "pipeline/scene/reflection_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <tbb/parallel_for.h>
#include <glm/geometric.hpp>

#include "pipeline/pictures/transfer.h"
#include "pipeline/scene/cube_directions.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

constexpr int kSourceSize = 16;  ///< Texels a side that a wide lobe gathers from
/// Exponents from this power of two on are served by a level of the map's own mip chain or the map itself.
constexpr int kFirstNarrowLobe = 6;
constexpr int kFirstSharp = 9;

/// A texel of a coarse cube: unit direction, solid angle up to a factor, colour.
struct CoarseTexel {
  float x, y, z;
  float solid_angle;
  std::array<float, 3> color;
};
using CoarseCube = std::vector<CoarseTexel>;

/// Mean of the texels of cell (i, j) of kSourceSize² cells.
std::array<float, 3> cell_mean(const raster::Texture& map, int level, int face, int i, int j) {
  const int side = map.level(level, face).width;
  const auto begin = [&](int cell) { return cell * side / kSourceSize; };
  const auto end = [&](int cell) { return std::max((cell + 1) * side / kSourceSize, begin(cell) + 1); };
  std::array<float, 3> sum{};
  for (int v = begin(j); v < end(j); ++v) {
    for (int u = begin(i); u < end(i); ++u) {
      const std::array<float, 4> texel = map.texel(level, face, u, v);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += texel[c];
    }
  }
  const auto count = static_cast<float>((end(i) - begin(i)) * (end(j) - begin(j)));
  return {sum[0] / count, sum[1] / count, sum[2] / count};
}

CoarseCube coarse(const raster::Texture& map) {
  int level = 0;
  while (level + 1 < map.level_count() && map.level(level + 1).width >= kSourceSize) ++level;
  CoarseCube cube;
  for (int face = 0; face < raster::kCubeFaces; ++face) {
    for (int j = 0; j < kSourceSize; ++j) {
      for (int i = 0; i < kSourceSize; ++i) {
        const glm::vec3 d = cube_direction(face, texel_middle(i, kSourceSize), texel_middle(j, kSourceSize));
        const float squared = glm::dot(d, d);
        const float length = std::sqrt(squared);
        cube.push_back({d.x / length, d.y / length, d.z / length, 1.0f / (squared * length),
                        cell_mean(map, level, face, i, j)});
      }
    }
  }
  return cube;
}

/// Cosine below which max(0, cos)^n is less than a thousandth of its greatest value.
float lobe_edge(int log2_exponent) { return portable_exp2(-10.0f / static_cast<float>(1 << log2_exponent)); }

/// Weighted mean colour around the unit direction d.
std::array<float, 3> gathered(const CoarseCube& cube, const glm::vec3& d, int log2_exponent) {
  const float edge = lobe_edge(log2_exponent);
  float total = 0.0f;
  std::array<float, 3> sum{};
  for (const CoarseTexel& texel : cube) {
    const float cosine = texel.x * d.x + texel.y * d.y + texel.z * d.z;
    if (cosine <= edge) continue;
    float lobe = cosine;
    for (int k = 0; k < log2_exponent; ++k) lobe *= lobe;
    lobe *= texel.solid_angle;
    total += lobe;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += lobe * texel.color[c];
  }
  return {sum[0] / total, sum[1] / total, sum[2] / total};
}

using Faces = std::array<std::vector<std::uint8_t>, raster::kCubeFaces>;

raster::Texture cube_of(const Faces& bytes, int size, raster::Encoding encoding) {
  std::array<raster::Pixels8, raster::kCubeFaces> faces;
  for (std::size_t face = 0; face < faces.size(); ++face) faces[face] = {size, size, bytes[face]};
  raster::TextureOptions options;
  options.encoding = encoding;
  options.mipmaps = false;
  return raster::Texture::make_cube(faces, options);
}

std::uint8_t encoded(float value, raster::Encoding encoding) {
  return encoding == raster::Encoding::srgb ? srgb8_from_linear(value) : byte_from_fraction(value);
}

/// One level of the map as a map of its own, so that it is never sampled finer than that.
raster::Texture level_of(const raster::Texture& map, int level) {
  const raster::Encoding encoding = map.options().encoding;
  const int size = map.level(level).width;
  Faces bytes;
  for (int face = 0; face < raster::kCubeFaces; ++face) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        const std::array<float, 4> texel = map.texel(level, face, i, j);
        std::vector<std::uint8_t>& rgba = bytes[static_cast<std::size_t>(face)];
        for (std::size_t c = 0; c < 3; ++c) rgba.push_back(encoded(texel[c], encoding));
        rgba.push_back(255);
      }
    }
  }
  return cube_of(bytes, size, encoding);
}

raster::Texture make_blurred(const raster::Texture& map, int log2_exponent) {
  if (log2_exponent < kFirstNarrowLobe)
    return blurred_cube(map, log2_exponent, log2_exponent < 3 ? 8 : kSourceSize);
  const int wanted = log2_exponent < kFirstNarrowLobe + 2 ? 2 * kSourceSize : 4 * kSourceSize;
  int level = 0;
  while (level + 1 < map.level_count() && map.level(level + 1).width >= wanted) ++level;
  return level_of(map, level);
}

}  // namespace

raster::Texture blurred_cube(const raster::Texture& map, int log2_exponent, int size) {
  const CoarseCube cube = coarse(map);
  const raster::Encoding encoding = map.options().encoding;
  Faces bytes;
  tbb::parallel_for(0, raster::kCubeFaces, [&](int face) {
    std::vector<std::uint8_t>& rgba = bytes[static_cast<std::size_t>(face)];
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        const glm::vec3 d = cube_direction(face, texel_middle(i, size), texel_middle(j, size));
        const glm::vec3 unit = d / std::sqrt(glm::dot(d, d));
        for (const float c : gathered(cube, unit, log2_exponent)) rgba.push_back(encoded(c, encoding));
        rgba.push_back(255);
      }
    }
  });
  return cube_of(bytes, size, encoding);
}

const raster::Texture& ReflectionMaps::get(const raster::Texture& map, float phong_exponent) {
  int log2_exponent = 0;
  while (log2_exponent < kFirstSharp &&
         phong_exponent > 1.41421356f * static_cast<float>(1 << log2_exponent)) {
    ++log2_exponent;
  }
  if (log2_exponent >= kFirstSharp) return map;
  const auto key = std::make_pair(&map, log2_exponent);
  const auto found = blurred_.find(key);
  if (found != blurred_.end()) return found->second;
  return blurred_.emplace(key, make_blurred(map, log2_exponent)).first->second;
}

}  // namespace barrido::scene
