#include "pipeline/scene/reflection_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "pipeline/scene/cube_directions.h"
#include "pipeline/scene/transfer.h"

namespace barrido::scene {
namespace {

constexpr int kSourceSize = 16;  ///< Texels a side that a wide lobe gathers from
/// Exponents from this power of two on are served by a level of the map's own mip chain or the map itself.
constexpr int kFirstNarrowLobe = 6;
constexpr int kFirstSharp = 9;

/// A coarse cube as separate arrays, so that the compiler can use vectors.
struct CoarseCube {
  std::vector<float> x, y, z;  ///< Unit directions
  std::vector<float> weight;   ///< Solid angle, up to a factor
  std::array<std::vector<float>, 3> color;
};

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
        cube.x.push_back(d.x / length);
        cube.y.push_back(d.y / length);
        cube.z.push_back(d.z / length);
        cube.weight.push_back(1.0f / (squared * length));
        const std::array<float, 3> color = cell_mean(map, level, face, i, j);
        for (std::size_t c = 0; c < 3; ++c) cube.color[c].push_back(color[c]);
      }
    }
  }
  return cube;
}

/// Sum of a[i]·b[i] in eight interleaved partial sums: an order that vectors can follow.
float dot_product(const std::vector<float>& a, const std::vector<float>& b) {
  std::array<float, 8> partial{};
  for (std::size_t i = 0; i + 8 <= a.size(); i += 8) {
    for (std::size_t lane = 0; lane < 8; ++lane) partial[lane] += a[i + lane] * b[i + lane];
  }
  float sum = 0.0f;
  for (const float value : partial) sum += value;
  return sum;
}

/// Weighted mean colour around the unit direction d. `lobe` is scratch memory.
std::array<float, 3> gathered(const CoarseCube& cube, const glm::vec3& d, int log2_exponent,
                              std::vector<float>& lobe) {
  const std::size_t count = cube.x.size();
  lobe.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float cosine = cube.x[i] * d.x + cube.y[i] * d.y + cube.z[i] * d.z;
    lobe[i] = cosine > 0.0f ? cosine : 0.0f;
  }
  for (int k = 0; k < log2_exponent; ++k) {
    for (float& value : lobe) value *= value;
  }
  const float total = dot_product(lobe, cube.weight);
  for (std::size_t i = 0; i < count; ++i) lobe[i] *= cube.weight[i];
  return {dot_product(lobe, cube.color[0]) / total, dot_product(lobe, cube.color[1]) / total,
          dot_product(lobe, cube.color[2]) / total};
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
  std::vector<float> lobe;
  for (int face = 0; face < raster::kCubeFaces; ++face) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        const glm::vec3 d = cube_direction(face, texel_middle(i, size), texel_middle(j, size));
        const glm::vec3 unit = d / std::sqrt(glm::dot(d, d));
        std::vector<std::uint8_t>& rgba = bytes[static_cast<std::size_t>(face)];
        for (const float c : gathered(cube, unit, log2_exponent, lobe)) rgba.push_back(encoded(c, encoding));
        rgba.push_back(255);
      }
    }
  }
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
