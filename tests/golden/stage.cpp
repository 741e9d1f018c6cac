#include "tests/golden/stage.h"

#include "raster/base/portable_math.h"

namespace barrido::golden {
namespace {

raster::FramebufferOptions usual_frame() {
  raster::FramebufferOptions options;
  options.width = kWidth;
  options.height = kHeight;
  return options;
}

template <class Vector>
pipeline::Attribute view(const std::vector<Vector>& array, int components) {
  if (array.empty()) return {};
  return {&array[0].x, components, static_cast<int>(sizeof(Vector) / sizeof(float))};
}

}  // namespace

Stage::Stage() : Stage(usual_frame()) {}

Stage::Stage(const raster::FramebufferOptions& options)
    : frame_(options), renderer_(std::make_unique<pipeline::Renderer>(frame_)) {
  clear({0.15f, 0.15f, 0.15f, 1});
}

void Stage::clear(const glm::vec4& color, float depth) {
  renderer_->clear({.color = {color.r, color.g, color.b, color.a}, .depth = depth});
}

void Stage::draw(const State& state, Shape shape) {
  const Shape& kept = shapes_.emplace_back(std::move(shape));
  pipeline::Geometry geometry;
  geometry.mode = kept.mode;
  geometry.vertex_count = static_cast<std::uint32_t>(kept.position.size());
  geometry.position = view(kept.position, 4);
  geometry.normal = view(kept.normal, 3);
  geometry.tangent = view(kept.tangent, 3);
  geometry.bitangent = view(kept.bitangent, 3);
  geometry.color = view(kept.color, 4);
  geometry.texcoord[0] = view(kept.texcoord, kept.texcoord_components);
  geometry.texcoord[1] = geometry.texcoord[0];
  geometry.indices = kept.indices;
  renderer_->draw(state, geometry);
}

const raster::Texture* Stage::keep(raster::Texture texture) {
  return &textures_.emplace_back(std::move(texture));
}

const raster::Framebuffer& Stage::finish() {
  renderer_->finish();
  return frame_;
}

State view_from(float distance) {
  State state;
  state.clip_from_eye = pipeline::perspective(radians(45), static_cast<double>(kWidth) / kHeight, 0.1, 100);
  state.eye_from_object = translation(0, 0, -distance);
  state.depth.test = true;
  return state;
}

State flat_view() { return {}; }

State in_cell(State state, int cell, int columns, int rows) {
  const int width = kWidth / columns;
  const int height = kHeight / rows;
  state.viewport.x = cell % columns * width;
  state.viewport.y = kHeight - (cell / columns + 1) * height + 1;
  state.viewport.width = width - 1;
  state.viewport.height = height - 1;
  if (state.clip_from_eye == glm::mat4(1.0f)) return state;
  // What a view shows keeps its proportions and fits in.
  const float wider = static_cast<float>(width * kHeight) / static_cast<float>(height * kWidth);
  state.clip_from_eye = pipeline::product(wider < 1.0f ? scaling(1, wider, 1) : scaling(1.0f / wider, 1, 1),
                                          state.clip_from_eye);
  return state;
}

State placed(State state, const glm::mat4& object) {
  state.eye_from_object = pipeline::product(state.eye_from_object, object);
  return state;
}

glm::mat4 translation(float x, float y, float z) {
  glm::mat4 m(1.0f);
  m[3] = {x, y, z, 1};
  return m;
}

glm::mat4 scaling(float x, float y, float z) {
  glm::mat4 m(1.0f);
  m[0][0] = x;
  m[1][1] = y;
  m[2][2] = z;
  return m;
}

glm::mat4 turned(float degrees, const glm::dvec3& axis) {
  return pipeline::rotation(radians(static_cast<double>(degrees)), axis);
}

raster::Texture texture_of(int side, const raster::TextureOptions& options,
                           const std::function<glm::vec4(int, int)>& rule) {
  std::vector<std::uint8_t> bytes;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const glm::vec4 c = rule(i, j);
      for (int k = 0; k < 4; ++k) bytes.push_back(static_cast<std::uint8_t>(c[k] * 255.0f + 0.5f));
    }
  }
  return raster::Texture::make_2d({side, side, bytes}, options);
}

raster::Texture letter(const raster::TextureOptions& options) {
  return texture_of(16, options, [](int i, int j) -> glm::vec4 {
    const bool ink = (i >= 4 && i < 7 && j >= 2 && j < 14) || (i >= 4 && i < 12 && j >= 11 && j < 14) ||
                     (i >= 4 && i < 10 && j >= 6 && j < 9);
    if (ink) return {1, 1, 1, 1};
    return {i < 8 ? 0.75f : 0.1f, j < 8 ? 0.2f : 0.6f, i < 8 ? 0.15f : 0.6f, 0.5f};
  });
}

raster::Texture checker(int side, const raster::TextureOptions& options) {
  return texture_of(side, options, [side](int i, int j) -> glm::vec4 {
    return (i * 8 / side + j * 8 / side) % 2 == 0 ? glm::vec4(0.95f, 0.9f, 0.8f, 1)
                                                  : glm::vec4(0.1f, 0.2f, 0.45f, 1);
  });
}

raster::Texture marked_cube(int side, const raster::TextureOptions& options) {
  constexpr glm::vec3 kColor[6] = {{0.8f, 0.1f, 0.1f}, {0.1f, 0.7f, 0.7f}, {0.1f, 0.7f, 0.1f},
                                   {0.7f, 0.1f, 0.7f}, {0.1f, 0.2f, 0.8f}, {0.8f, 0.7f, 0.1f}};
  std::vector<std::vector<std::uint8_t>> bytes(raster::kCubeFaces);
  std::vector<raster::Pixels8> faces;
  for (std::size_t face = 0; face < bytes.size(); ++face) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const bool corner = i < side / 4 && j < side / 4;
        const float shade = (i + j) % 2 == 0 ? 1.0f : 0.75f;
        const glm::vec3 c = corner ? glm::vec3(1.0f) : kColor[face] * shade;
        for (int k = 0; k < 3; ++k) bytes[face].push_back(static_cast<std::uint8_t>(c[k] * 255.0f + 0.5f));
        bytes[face].push_back(255);
      }
    }
    faces.push_back({side, side, bytes[face]});
  }
  return raster::Texture::make_cube(std::span<const raster::Pixels8, raster::kCubeFaces>(faces), options);
}

}  // namespace barrido::golden
