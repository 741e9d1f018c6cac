#include "tests/osmesa/scene_pair.h"

#include <cstring>

#include "pipeline/renderer.h"

namespace barrido::crosscheck {
namespace {

template <class Vector>
pipeline::Attribute view(const std::vector<Vector>& array, int components) {
  if (array.empty()) return {};
  return {&array[0].x, components, static_cast<int>(sizeof(Vector) / sizeof(float))};
}

}  // namespace

pipeline::Geometry Mesh::geometry() const {
  pipeline::Geometry g;
  g.mode = mode;
  g.vertex_count = static_cast<std::uint32_t>(position.size());
  g.position = view(position, position_components);
  g.normal = view(normal, 3);
  g.tangent = view(tangent, 4);
  g.bitangent = view(bitangent, 3);
  g.color = view(color, 4);
  for (std::size_t unit = 0; unit < texcoord.size(); ++unit) {
    g.texcoord[unit] = view(texcoord[unit], texcoord_components[unit]);
  }
  g.indices = indices;
  return g;
}

Picture draw_with_barrido(const ScenePair& pair) {
  raster::FramebufferOptions options;
  options.width = pair.width;
  options.height = pair.height;
  raster::Framebuffer frame(options);
  pipeline::Renderer renderer(frame);
  renderer.clear(pair.clear);
  for (const DrawCall& draw : pair.draws) renderer.draw(draw.state, draw.mesh.geometry());
  renderer.finish();
  Picture picture{pair.width, pair.height, {}, {}};
  picture.depth.assign(frame.depth().begin(), frame.depth().end());
  picture.color.resize(frame.color8().size());
  std::memcpy(picture.color.data(), frame.color8().data(), frame.color8().size() * 4);
  return picture;
}

}  // namespace barrido::crosscheck
