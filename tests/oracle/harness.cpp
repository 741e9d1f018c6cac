#include "tests/oracle/harness.h"

namespace barrido::oracle {

void DrawnMesh::add(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& texcoord) {
  for (int k = 0; k < 3; ++k) {
    positions.push_back(static_cast<float>(position[k]));
    normals.push_back(static_cast<float>(normal[k]));
  }
  texcoords.push_back(static_cast<float>(texcoord.x));
  texcoords.push_back(static_cast<float>(texcoord.y));
}

pipeline::Geometry DrawnMesh::geometry() const {
  pipeline::Geometry geometry;
  geometry.vertex_count = static_cast<std::uint32_t>(positions.size() / 3);
  geometry.position = {positions.data(), 3, 3};
  geometry.normal = {normals.data(), 3, 3};
  geometry.texcoord[0] = {texcoords.data(), 2, 2};
  geometry.indices = indices;
  return geometry;
}

std::vector<glm::dvec3> DrawnMesh::vectors(const std::vector<float>& values) {
  std::vector<glm::dvec3> result;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
    result.emplace_back(values[i], values[i + 1], values[i + 2]);
  }
  return result;
}

namespace {

raster::FramebufferOptions float_options(int width, int height) {
  raster::FramebufferOptions options;
  options.width = width;
  options.height = height;
  options.format = raster::ColorFormat::rgba32f;
  options.keep_float = true;
  return options;
}

}  // namespace

FloatFrame::FloatFrame(int width, int height) : frame_(float_options(width, height)) {}

void FloatFrame::draw(const pipeline::State& state, const pipeline::Geometry& geometry) {
  pipeline::Renderer renderer(frame_);
  renderer.clear({});
  renderer.draw(state, geometry);
  renderer.finish();
}

glm::dvec4 FloatFrame::at(int x, int window_y) const {
  const float* c = frame_.color_float().data() + frame_.index(x, window_y) * 4;
  return {c[0], c[1], c[2], c[3]};
}

void set_lighting(pipeline::State& state, const OracleModel& model) {
  state.lighting = lighting_of(model);
  state.clamp_colors = false;
}

}  // namespace barrido::oracle
