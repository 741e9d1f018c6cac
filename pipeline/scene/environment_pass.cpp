#include "pipeline/scene/environment_pass.h"

#include <cmath>
#include <cstring>
#include <vector>

#include <glm/geometric.hpp>

#include "pipeline/matrix.h"
#include "pipeline/scene/cube_directions.h"
#include "pipeline/scene/draw_state.h"
#include "pipeline/scene/view.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

constexpr float kCubeCorners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                      {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
constexpr std::uint32_t kCubeTriangles[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,
                                              1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3};
constexpr double kParallelFovDeg = 45.0;

}  // namespace

void draw_backdrop(pipeline::Renderer& renderer, const Backdrop& backdrop, const View& view, double aspect,
                   bool clamp_colors) {
  if (backdrop.map == nullptr) return;
  pipeline::State state;
  // The cube stands still in eye space; its corners are directions.
  state.clip_from_eye = is_parallel(view) ? pipeline::perspective(radians(kParallelFovDeg), aspect, 0.1, 0.0)
                                          : view.clip_from_eye;
  state.depth_clamp = true;
  state.viewport.depth_near = state.viewport.depth_far = 1.0f;
  // Behind all that was drawn, also where that is as deep as can be.
  state.depth = {true, false, view.clear_depth > 1.0f ? raster::Compare::less : raster::Compare::less_equal};
  state.clamp_colors = clamp_colors;
  state.texture_units[0].texture = backdrop.map;
  state.texture_units[0].min_filter =
      backdrop.map->level_count() > 1 ? raster::MinFilter::linear_mipmap_linear : raster::MinFilter::linear;
  state.texture_units[0].env_mode = raster::TextureEnvMode::replace;
  state.texture_coordinates[0].matrix = backdrop.map_from_eye;
  pipeline::Geometry cube;
  cube.vertex_count = 8;
  cube.position = {&kCubeCorners[0][0], 3, 3};
  cube.texcoord[0] = cube.position;
  cube.indices = kCubeTriangles;
  renderer.draw(state, cube);
}

View cube_face_view(int face, const glm::dvec3& center, const Sphere& bounds) {
  const glm::dvec3 forward = cube_direction(face, 0.0f, 0.0f);
  const glm::dvec3 up = glm::dvec3(cube_direction(face, 0.0f, 1.0f)) - forward;
  const glm::dvec3 offset = bounds.center - center;
  const double far_plane = (std::sqrt(glm::dot(offset, offset)) + bounds.radius) * 1.05;
  return {scene::eye_from_world(center, forward, up),
          pipeline::perspective(radians(90.0), 1.0, bounds.radius * 0.002, far_plane)};
}

raster::Texture cube_of_frames(std::span<const raster::Framebuffer> frames, raster::Encoding encoding) {
  std::array<std::vector<std::uint8_t>, raster::kCubeFaces> bytes;
  std::array<raster::Pixels8, raster::kCubeFaces> faces;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const raster::Framebuffer& frame = frames[face];
    const std::size_t row_bytes = static_cast<std::size_t>(frame.width()) * 4;
    bytes[face].resize(row_bytes * static_cast<std::size_t>(frame.height()));
    for (int y = 0; y < frame.height(); ++y) {  // window rows, bottom first: t grows upwards
      std::memcpy(bytes[face].data() + static_cast<std::size_t>(y) * row_bytes,
                  frame.color8().data() + frame.index(0, y), row_bytes);
    }
    faces[face] = {frame.width(), frame.height(), bytes[face]};
  }
  raster::TextureOptions options;
  options.encoding = encoding;
  return raster::Texture::make_cube(faces, options);
}

void add(pipeline::Statistics& sum, const pipeline::Statistics& more) {
  sum.draws += more.draws;
  sum.vertices += more.vertices;
  sum.primitives_in += more.primitives_in;
  sum.primitives_culled += more.primitives_culled;
  sum.primitives_clipped += more.primitives_clipped;
  sum.illuminations_vertex += more.illuminations_vertex;
  sum.illuminations_fragment += more.illuminations_fragment;
  sum.powers += more.powers;
  sum.interpolations += more.interpolations;
  sum.raster.primitives += more.raster.primitives;
  sum.raster.spans += more.raster.spans;
  sum.raster.fragments_covered += more.raster.fragments_covered;
  sum.raster.fragments_shaded += more.raster.fragments_shaded;
  sum.raster.texel_fetches += more.raster.texel_fetches;
  sum.raster.mapped += more.raster.mapped;
  sum.raster.patterns += more.raster.patterns;
  sum.raster.noise += more.raster.noise;
}

}  // namespace barrido::scene
