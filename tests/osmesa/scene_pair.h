// A scene that is drawn twice, by Barrido and by OSMesa: draws with the memory they refer to. Only plain data
// and the structs of the pipeline; knows neither renderer.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/geometry.h"
#include "pipeline/state.h"
#include "raster/rasterizer.h"
#include "raster/textures/texture.h"

namespace barrido::crosscheck {

/// Vertex arrays that own their memory; an empty array is absent.
struct Mesh {
  pipeline::PrimitiveMode mode = pipeline::PrimitiveMode::triangles;
  std::vector<glm::vec4> position;
  int position_components = 3;
  std::vector<glm::vec3> normal;
  std::vector<glm::vec4> tangent;  ///< w: orientation of the bitangent, where that is absent
  std::vector<glm::vec3> bitangent;
  std::vector<glm::vec4> color;
  std::array<std::vector<glm::vec4>, 2> texcoord;
  std::array<int, 2> texcoord_components{2, 2};
  std::vector<std::uint32_t> indices;

  /// Views of the arrays; valid as long as the mesh stays where it is.
  pipeline::Geometry geometry() const;
  std::size_t element_count() const { return indices.empty() ? position.size() : indices.size(); }
  std::size_t vertex(std::size_t element) const { return indices.empty() ? element : indices[element]; }
};

struct DrawCall {
  pipeline::State state;
  Mesh mesh;
};

struct ScenePair {
  std::string feature;
  std::uint64_t seed = 0;
  int width = 128;
  int height = 96;
  raster::ClearValues clear;
  std::vector<std::unique_ptr<raster::Texture>> textures;
  std::vector<DrawCall> draws;
};

/// What a renderer leaves: top row first, RGBA bytes and depth.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::array<std::uint8_t, 4>> color;
  std::vector<float> depth;
};

/// Colours of 16 bits: 257 is 1/255.
struct DeepPicture {
  std::vector<std::array<std::uint16_t, 4>> color;
};

Picture draw_with_barrido(const ScenePair& pair);

}  // namespace barrido::crosscheck
