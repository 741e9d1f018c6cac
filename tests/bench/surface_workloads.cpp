// Curved surfaces: a wavy grid that reflects a cube map, and lit ellipsoids of many triangles.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "pipeline/matrix.h"
#include "raster/base/portable_math.h"
#include "tests/bench/workloads.h"

namespace barrido::bench {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Indices of two triangles for each cell of a grid with `columns` × `rows` cells, vertices row by row.
std::vector<std::uint32_t> grid_triangles(int columns, int rows) {
  std::vector<std::uint32_t> indices;
  const auto pitch = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
    for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(columns); ++column) {
      const std::uint32_t a = row * pitch + column;
      const std::uint32_t c = a + pitch;
      indices.insert(indices.end(), {a, a + 1, c, c, a + 1, c + 1});
    }
  }
  return indices;
}

raster::Texture striped_cube(int side) {
  std::array<std::vector<std::uint8_t>, raster::kCubeFaces> texels;
  std::vector<raster::Pixels8> faces;
  for (int face = 0; face < raster::kCubeFaces; ++face) {
    auto& out = texels[static_cast<std::size_t>(face)];
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const int stripe = ((x >> 4) ^ (y >> 4)) & 1;
        out.push_back(static_cast<std::uint8_t>(x * 255 / side));
        out.push_back(static_cast<std::uint8_t>(y * 255 / side));
        out.push_back(static_cast<std::uint8_t>(stripe * 120 + face * 20));
        out.push_back(255);
      }
    }
    faces.push_back({side, side, out});
  }
  raster::TextureOptions options;
  options.wrap_s = options.wrap_t = raster::Wrap::clamp_to_edge;
  options.seamless = false;  // as OpenGL 1.x, which the peer draws
  return raster::Texture::make_cube(std::span<const raster::Pixels8, raster::kCubeFaces>(faces), options);
}

/// Sine and cosine of a fraction of a turn.
glm::dvec2 on_circle(double turn) {
  const double angle = 2.0 * kPi * turn;
  return {std::cos(angle), std::sin(angle)};
}

void light(pipeline::State& state, int lights) {
  state.lighting.enabled = true;
  state.lighting.lights.clear();
  for (int i = 0; i < lights; ++i) {
    pipeline::Light& l = state.lighting.lights.emplace_back();
    const float share = 1.0f / static_cast<float>(lights);
    const glm::dvec2 around = on_circle(static_cast<double>(i) / lights);
    l.position = {0.4082 * around.x - 0.4082 * around.y, 0.4082 * around.x + 0.4082 * around.y, 0.8165, 0};
    l.ambient = glm::vec4(0.15f * share, 0.15f * share, 0.15f * share, 1);
    l.diffuse = l.specular = glm::vec4(share, share, share, 1);
  }
  pipeline::Material& m = state.lighting.front;
  m.ambient = m.diffuse = {0.8f, 0.3f, 0.2f, 1.0f};
  m.specular = {0.6f, 0.6f, 0.6f, 1.0f};
  m.shininess = 32.0f;
}

/// Normals of egg-box bumps, `side`² texels, eight bumps along each side.
raster::Texture bumpy_normals(int side) {
  std::vector<std::uint8_t> rgba;
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::lround(127.5 * value + 127.5));
  };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 u = on_circle(8.0 * x / side), v = on_circle(8.0 * y / side);
      const glm::dvec3 n = glm::normalize(glm::dvec3(0.5 * u.y * v.x, 0.5 * u.x * v.y, 1.0));
      rgba.insert(rgba.end(), {byte(n.x), byte(n.y), byte(n.z), 255});
    }
  }
  return raster::Texture::make_2d({side, side, rgba}, {});
}

void add_normal_map(ScenePair& scene, int side) {
  scene.textures.push_back(std::make_unique<raster::Texture>(bumpy_normals(side)));
  raster::TextureUnit& unit = scene.draws.back().state.texture_units[0];
  unit.role = raster::TextureRole::normal;
  unit.texture = scene.textures.back().get();
  unit.min_filter = raster::MinFilter::linear_mipmap_linear;
}

/// Layers across a slanted axis; the coordinates are the positions.
void cut_of_marble(DrawCall& draw) {
  raster::TextureUnit& unit = draw.state.texture_units[0];
  unit.procedure = &raster::kSolidPattern;
  unit.pattern.kind = raster::PatternKind::marble;
  unit.pattern.octaves = 6;
  unit.pattern.turbulence = 1.5f;
  unit.pattern.colors = {{{0.1f, 0.12f, 0.16f, 1}, {0.9f, 0.88f, 0.84f, 1}}};
  draw.state.texture_coordinates[0].matrix = pipeline::rotation(0.5, {1, 0, 1});
  draw.mesh.texcoord[0] = draw.mesh.position;
  draw.mesh.texcoord_components[0] = 3;
}

}  // namespace

ScenePair reflecting_grid(const Scale& scale, raster::MinFilter min_filter) {
  constexpr int kColumns = 64;
  constexpr int kRows = 36;
  ScenePair scene;
  scene.width = scale.width;
  scene.height = scale.height;
  scene.clear.color = {0, 0, 0, 1};
  scene.textures.push_back(std::make_unique<raster::Texture>(striped_cube(512)));
  DrawCall& draw = scene.draws.emplace_back();
  const double aspect = static_cast<double>(scale.width) / scale.height;
  draw.state.depth.test = true;
  draw.state.clip_from_eye = pipeline::perspective(60.0 * kPi / 180.0, aspect, 0.1, 100.0);
  draw.state.normalize = true;
  raster::TextureUnit& unit = draw.state.texture_units[0];
  unit.texture = scene.textures[0].get();
  unit.min_filter = min_filter;
  unit.env_mode = raster::TextureEnvMode::replace;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pipeline::TexGenCoordinate& rule = draw.state.texture_coordinates[0].generation[axis];
    rule.enabled = true;
    rule.mode = pipeline::TexGenMode::reflection_map;
  }
  for (int row = 0; row <= kRows; ++row) {
    for (int column = 0; column <= kColumns; ++column) {
      const double u = static_cast<double>(column) / kColumns;
      const double v = static_cast<double>(row) / kRows;
      const double half_height = 2.0 * std::tan(30.0 * kPi / 180.0) * 1.001;
      draw.mesh.position.emplace_back((2 * u - 1) * half_height * aspect, (2 * v - 1) * half_height, -2.0, 1);
      const glm::dvec2 wave_u = on_circle(3 * u);
      const glm::dvec2 wave_v = on_circle(2 * v);
      draw.mesh.normal.emplace_back(0.35 * wave_u.y, 0.35 * wave_v.x, 1.0);
    }
  }
  draw.mesh.indices = grid_triangles(kColumns, kRows);
  return scene;
}

ScenePair ellipsoid(const Scale& scale, const EllipsoidOptions& options) {
  ScenePair scene;
  scene.width = scale.width;
  scene.height = scale.height;
  scene.clear.color = {0, 0, 0, 1};
  DrawCall& draw = scene.draws.emplace_back();
  const double aspect = static_cast<double>(scale.width) / scale.height;
  constexpr double kDistance = 10.0;
  draw.state.depth.test = true;
  draw.state.clip_from_eye = pipeline::perspective(20.0 * kPi / 180.0, aspect, 1.0, 20.0);
  draw.state.eye_from_object = glm::mat4(1.0f);
  draw.state.eye_from_object[3] = glm::vec4(0, 0, -kDistance, 1);
  draw.state.normalize = true;
  draw.state.cull_face = pipeline::CullFace::back;
  draw.state.shade_model = options.shading;
  light(draw.state, options.lights);
  draw.state.lighting.local_viewer = options.shading == pipeline::ShadeModel::phong;
  // A circle of radius r seen from distance d has the silhouette r·d/√(d² − r²) there; the flattened depth
  // makes it nearly r itself.
  const double half_height = kDistance * std::tan(10.0 * kPi / 180.0);
  const glm::dvec3 radii(options.silhouette * half_height * aspect, options.silhouette * half_height,
                         options.silhouette * half_height);
  const glm::dmat3 tilt(pipeline::rotation(0.6, {1, 0, 0.3}));
  for (int stack = 0; stack <= options.stacks; ++stack) {
    const glm::dvec2 down = on_circle(0.5 * stack / options.stacks);
    for (int slice = 0; slice <= options.slices; ++slice) {
      const glm::dvec2 around = on_circle(static_cast<double>(slice % options.slices) / options.slices);
      const glm::dvec3 unit = tilt * glm::dvec3(down.y * around.y, down.x, down.y * around.x);
      draw.mesh.position.emplace_back(unit * radii, 1.0);
      draw.mesh.normal.emplace_back(glm::normalize(unit / radii));
      if (options.normal_map_side == 0) continue;
      const glm::dvec3 along = glm::normalize(tilt * glm::dvec3(around.x, 0.0, -around.y) * radii);
      draw.mesh.tangent.emplace_back(along, 1.0);
      draw.mesh.texcoord[0].emplace_back(2.0 * slice / options.slices, 1.0 * stack / options.stacks, 0, 1);
    }
  }
  if (options.normal_map_side != 0) add_normal_map(scene, options.normal_map_side);
  // Rows run downwards, so the grid's triangles face inwards: turn them. At the poles one of two is a
  // point's.
  const std::vector<std::uint32_t> inwards = grid_triangles(options.slices, options.stacks);
  const auto row = [&](std::uint32_t vertex) { return static_cast<int>(vertex) / (options.slices + 1); };
  for (std::size_t i = 0; i < inwards.size(); i += 3) {
    const std::uint32_t a = inwards[i], b = inwards[i + 2], c = inwards[i + 1];
    const bool at_top = row(a) + row(b) + row(c) == 1;
    const bool at_bottom = row(a) + row(b) + row(c) == 3 * options.stacks - 1;
    const bool is_first = i % 6 == 0;
    if ((at_top && is_first) || (at_bottom && !is_first)) continue;
    draw.mesh.indices.insert(draw.mesh.indices.end(), {a, b, c});
  }
  if (options.marble) cut_of_marble(draw);
  return scene;
}

}  // namespace barrido::bench
