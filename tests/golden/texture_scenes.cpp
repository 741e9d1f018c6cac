// Textures: wraps, filters, levels, coordinates.
#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

using raster::MagFilter;
using raster::MinFilter;
using raster::Wrap;

void use(State& state, const raster::Texture* texture, MinFilter min, MagFilter mag) {
  raster::TextureUnit& unit = state.texture_units[0];
  unit.texture = texture;
  unit.min_filter = min;
  unit.mag_filter = mag;
  unit.env_mode = raster::TextureEnvMode::replace;
}

/// Coordinates from −1 to 2.
Shape beyond_edges() {
  Shape shape = rectangle(-1, -1, 1, 1);
  for (glm::vec4& c : shape.texcoord) c = {3 * c.x - 1, 3 * c.y - 1, 0, 1};
  return shape;
}

/// Repeat, mirrored repeat, clamp to edge; clamp to border (orange) and OpenGL 1.0's clamp.
void wraps(Stage& stage, MinFilter min, MagFilter mag) {
  for (int cell = 0; cell < 5; ++cell) {
    raster::TextureOptions options;
    options.wrap_s = options.wrap_t = static_cast<Wrap>(cell);
    options.border_color = {1, 0.6f, 0.1f, 1};
    State state = in_cell(flat_view(), cell, 3, 2);
    use(state, stage.keep(letter(options)), min, mag);
    stage.draw(state, beyond_edges());
  }
  raster::TextureOptions mixed;
  mixed.wrap_s = Wrap::mirrored_repeat;
  mixed.wrap_t = Wrap::clamp_to_edge;
  State state = in_cell(flat_view(), 5, 3, 2);
  use(state, stage.keep(letter(mixed)), min, mag);
  stage.draw(state, beyond_edges());
}
void wraps_nearest(Stage& stage) { wraps(stage, MinFilter::nearest, MagFilter::nearest); }
void wraps_linear(Stage& stage) { wraps(stage, MinFilter::linear, MagFilter::linear); }

/// Magnified six times: nearest and linear.
void magnification(Stage& stage) {
  for (const int cell : {0, 1}) {
    State state = in_cell(flat_view(), cell, 2, 1);
    use(state, stage.keep(letter()), MinFilter::linear, static_cast<MagFilter>(cell));
    stage.draw(state, rectangle(-0.9f, -0.9f, 0.9f, 0.9f));
  }
}

/// A floor under the six minification filters: nearest, linear; then nearest and linear within the nearest
/// level; nearest and linear between two levels.
void minification(Stage& stage) {
  const raster::Texture* texture = stage.keep(checker(64));
  for (int cell = 0; cell < 6; ++cell) {
    State state = in_cell(view_from(0), cell, 2, 3);
    use(state, texture, static_cast<MinFilter>(cell), MagFilter::nearest);
    stage.draw(state, ground(24, 12));
  }
}

/// Each level in a colour of its own: red 64, orange 32, yellow 16, green 8, blue 4, violet 2, white 1.
/// Nearest level above, between levels below.
raster::Texture colored_levels() {
  constexpr glm::vec3 kColors[] = {{0.9f, 0.1f, 0.1f}, {0.9f, 0.5f, 0.1f}, {0.9f, 0.9f, 0.1f},
                                   {0.1f, 0.8f, 0.2f}, {0.1f, 0.3f, 0.9f}, {0.6f, 0.1f, 0.8f},
                                   {1, 1, 1}};
  std::vector<std::vector<std::uint8_t>> bytes;
  std::vector<raster::Pixels8> levels;
  for (int level = 0, side = 64; side > 0; ++level, side /= 2) {
    std::vector<std::uint8_t>& into = bytes.emplace_back();
    for (int i = 0; i < side * side; ++i) {
      for (int k = 0; k < 3; ++k)
        into.push_back(static_cast<std::uint8_t>(kColors[level][k] * 255.0f + 0.5f));
      into.push_back(255);
    }
  }
  for (std::size_t level = 0; level < bytes.size(); ++level) {
    levels.push_back({64 >> level, 64 >> level, bytes[level]});
  }
  return raster::Texture::make_2d_levels(levels, {});
}

void levels(Stage& stage) {
  const raster::Texture* texture = stage.keep(colored_levels());
  for (const int cell : {0, 1}) {
    State state = in_cell(view_from(0), cell, 1, 2);
    use(state, texture, cell == 0 ? MinFilter::nearest_mipmap_nearest : MinFilter::linear_mipmap_linear,
        MagFilter::nearest);
    stage.draw(state, ground(40, 8));
  }
}

/// The level is one lower, as it is, one and two higher: aliased to blurred.
void lod_bias(Stage& stage) {
  const raster::Texture* texture = stage.keep(checker(64));
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(view_from(0), cell, 2, 2);
    use(state, texture, MinFilter::linear_mipmap_linear, MagFilter::linear);
    state.texture_units[0].lod_bias = static_cast<float>(cell - 1);
    stage.draw(state, ground(24, 12));
  }
}

/// Linear on the screen (the course's affine error), and perspective-correct.
void affine_and_perspective(Stage& stage) {
  for (const int cell : {0, 1}) {
    State state = placed(in_cell(view_from(2.4f), cell, 2, 1), turned(-60, {1, 0, 0}));
    use(state, stage.keep(checker(64)), MinFilter::linear_mipmap_linear, MagFilter::linear);
    state.texture_interpolation = static_cast<pipeline::TextureInterpolation>(1 - cell);
    stage.draw(state, plane(1));
  }
}

/// A matrix that turns by 30°, one that shrinks and moves, and one that sheds perspective over the square.
void texture_matrix(Stage& stage) {
  for (int cell = 0; cell < 3; ++cell) {
    State state = in_cell(flat_view(), cell, 3, 1);
    use(state, stage.keep(letter()), MinFilter::linear_mipmap_linear, MagFilter::linear);
    glm::mat4& matrix = state.texture_coordinates[0].matrix;
    if (cell == 0) matrix = turned(30, {0, 0, 1});
    if (cell == 1) matrix = pipeline::product(translation(0.25f, 0, 0), scaling(2, 3, 1));
    if (cell == 2) matrix[1][3] = 1.5f;  // q = 1 + 1.5 t
    stage.draw(state, rectangle(-0.9f, -0.9f, 0.9f, 0.9f));
  }
}

/// Coordinates (s, t, 0, q): a trapezium keeps its picture straight when q follows its width.
void projective(Stage& stage) {
  for (const int cell : {0, 1}) {
    State state = in_cell(flat_view(), cell, 2, 1);
    use(state, stage.keep(checker(64)), MinFilter::linear_mipmap_linear, MagFilter::linear);
    Shape shape = rectangle(-0.9f, -0.9f, 0.9f, 0.9f);
    for (const std::size_t top : {std::size_t{2}, std::size_t{3}}) {
      shape.position[top].x *= 0.35f;
      if (cell == 1) shape.texcoord[top] *= 0.35f;
    }
    shape.texcoord_components = 4;
    stage.draw(state, shape);
  }
}

/// Sides that are no powers of two, one texel wide, and a single texel.
void odd_sizes(Stage& stage) {
  constexpr int kSides[][2] = {{13, 7}, {1, 5}, {9, 1}, {1, 1}};
  for (int cell = 0; cell < 4; ++cell) {
    const int width = kSides[cell][0];
    const int height = kSides[cell][1];
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < width * height; ++i) {
      for (const int c : {60 + i * 37 % 190, 40 + i * 71 % 210, 90 + i * 13 % 160, 255})
        bytes.push_back(static_cast<std::uint8_t>(c));
    }
    State state = in_cell(flat_view(), cell, 2, 2);
    use(state, stage.keep(raster::Texture::make_2d({width, height, bytes}, {})), MinFilter::linear,
        MagFilter::linear);
    stage.draw(state, rectangle(-0.9f, -0.9f, 0.9f, 0.9f, 0, 2));
  }
}

/// The same texels used as they are, and decoded from sRGB before they are filtered: darker numbers, as light
/// has.
void srgb_decoding(Stage& stage) {
  for (const int cell : {0, 1}) {
    raster::TextureOptions options;
    options.encoding = static_cast<raster::Encoding>(cell);
    State state = in_cell(flat_view(), cell, 2, 1);
    use(state, stage.keep(letter(options)), MinFilter::linear_mipmap_linear, MagFilter::linear);
    stage.draw(state, rectangle(-0.9f, -0.9f, 0.9f, 0.9f));
  }
}

}  // namespace

std::vector<Scene> texture_scenes() {
  return {{"wraps_nearest", wraps_nearest},
          {"wraps_linear", wraps_linear},
          {"magnification", magnification},
          {"minification", minification},
          {"levels", levels},
          {"lod_bias", lod_bias},
          {"affine_and_perspective", affine_and_perspective},
          {"texture_matrix", texture_matrix},
          {"projective", projective},
          {"odd_sizes", odd_sizes},
          {"srgb_decoding", srgb_decoding}};
}

}  // namespace barrido::golden
