// The frame and the geometry of a draw out of bytes.
#include "scene_choices.h"

namespace barrido::fuzz {
namespace {

constexpr int kMaxVertices = 24;

/// Vertices from the bytes, `components` floats each, with a gap between them now and then.
struct Array {
  int components = 0;
  int stride = 0;
  std::size_t begin = 0;

  pipeline::Attribute view(const std::vector<float>& numbers) const {
    if (components == 0) return {};
    return {numbers.data() + begin, components, stride};
  }
};

Array any_array(Input& input, int vertices, int low, int high, std::vector<float>& numbers) {
  Array array{input.between(low, high), 0, numbers.size()};
  array.stride = array.components + (input.byte() < 32 ? 1 : 0);
  for (int i = 0; i < vertices * array.stride; ++i) numbers.push_back(input.number());
  return array;
}

void any_indices(Input& input, int vertices, std::vector<std::uint32_t>& indices) {
  const int count = input.between(1, 2 * kMaxVertices);
  for (int i = 0; i < count; ++i) {
    const std::uint8_t byte = input.byte();
    indices.push_back(byte == 255 ? input.bits32() : byte % static_cast<std::uint32_t>(vertices));
  }
}

}  // namespace

raster::FramebufferOptions any_frame(Input& input) {
  raster::FramebufferOptions frame;
  frame.width = input.pick({1, 7, 16, 33, 40, 129, 150});
  frame.height = input.pick({1, 5, 16, 33, 40});
  frame.format = input.one_of_first<raster::ColorFormat>(2);
  frame.keep_float = input.flag();
  frame.keep_depth = input.flag();
  frame.display.exposure_scale = input.flag() ? 1.0f : input.number();
  frame.display.tone_map = input.one_of_first<raster::ToneMap>(2);
  frame.display.srgb_encode = input.flag();
  return frame;
}

raster::ClearValues any_clear(Input& input) {
  raster::ClearValues clear;
  for (float& channel : clear.color) channel = input.number();
  clear.depth = input.flag() ? 1.0f : input.fraction();
  return clear;
}

void any_geometry(Input& input, OwnedGeometry& owned) {
  pipeline::Geometry& geometry = owned.geometry;
  geometry.mode = input.one_of_first<pipeline::PrimitiveMode>(10);
  const int vertices = input.between(1, kMaxVertices);
  geometry.vertex_count = static_cast<std::uint32_t>(vertices);
  const Array position = any_array(input, vertices, 2, 4, owned.numbers);
  Array normal, color, tangent, bitangent;
  std::array<Array, raster::kMaxTextureUnits> texcoord;
  if (input.flag()) normal = any_array(input, vertices, 3, 3, owned.numbers);
  if (input.flag()) color = any_array(input, vertices, 3, 4, owned.numbers);
  if (input.byte() < 96) tangent = any_array(input, vertices, 3, 4, owned.numbers);
  if (input.byte() < 48) bitangent = any_array(input, vertices, 3, 3, owned.numbers);
  for (Array& array : texcoord) {
    if (input.byte() < 96) array = any_array(input, vertices, 2, 4, owned.numbers);
  }
  if (input.flag()) any_indices(input, vertices, owned.indices);
  for (int c = 0; c < 4; ++c) {
    geometry.constant_color[c] = input.number();
    geometry.constant_texcoord[0][c] = input.number();
  }
  geometry.position = position.view(owned.numbers);
  geometry.normal = normal.view(owned.numbers);
  geometry.color = color.view(owned.numbers);
  geometry.tangent = tangent.view(owned.numbers);
  geometry.bitangent = bitangent.view(owned.numbers);
  for (std::size_t unit = 0; unit < texcoord.size(); ++unit)
    geometry.texcoord[unit] = texcoord[unit].view(owned.numbers);
  geometry.indices = owned.indices;
}

}  // namespace barrido::fuzz
