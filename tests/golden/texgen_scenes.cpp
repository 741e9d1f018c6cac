// Generated texture coordinates and cube maps.
#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

using pipeline::TexGenMode;
using raster::MagFilter;
using raster::MinFilter;

void use(State& state, const raster::Texture* texture, MinFilter min, MagFilter mag) {
  raster::TextureUnit& unit = state.texture_units[0];
  unit.texture = texture;
  unit.min_filter = min;
  unit.mag_filter = mag;
  unit.env_mode = raster::TextureEnvMode::replace;
}

void generate(State& state, TexGenMode mode, int coordinates) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(coordinates); ++i) {
    pipeline::TexGenCoordinate& rule = state.texture_coordinates[0].generation[i];
    rule.enabled = true;
    rule.mode = mode;
  }
}

/// A ball that is turned: stripes by object_linear turn with it, by eye_linear they stay where they are.
void linear_generation(Stage& stage) {
  for (int cell = 0; cell < 4; ++cell) {
    State state =
        placed(in_cell(view_from(2.9f), cell, 2, 2), turned(cell % 2 == 0 ? 0.0f : 40.0f, {0, 0, 1}));
    use(state, stage.keep(letter()), MinFilter::linear_mipmap_linear, MagFilter::linear);
    generate(state, cell < 2 ? TexGenMode::object_linear : TexGenMode::eye_linear, 2);
    for (std::size_t i = 0; i < 2; ++i) {
      pipeline::TexGenCoordinate& rule = state.texture_coordinates[0].generation[i];
      rule.object_plane = rule.eye_plane = i == 0 ? glm::vec4(1, 0, 0, 0.5f) : glm::vec4(0, 1, 0, 0.5f);
    }
    stage.draw(state, sphere(24, 16));
  }
}

/// A ball in a room seen as a circle in the map (its middle is what lies behind the eye), in two positions.
void sphere_map(Stage& stage) {
  const raster::Texture* map = stage.keep(texture_of(64, {}, [](int i, int j) -> glm::vec4 {
    const float x = static_cast<float>(i) / 31.5f - 1;
    const float y = static_cast<float>(j) / 31.5f - 1;
    if (x * x + y * y > 1) return {0, 0, 0, 1};
    if ((i % 16) < 2 || (j % 16) < 2) return {1, 1, 1, 1};
    return {0.5f + 0.45f * x, 0.5f + 0.45f * y, 0.4f, 1};
  }));
  for (const int cell : {0, 1}) {
    State state = in_cell(view_from(2.7f), cell, 2, 1);
    if (cell == 1)
      state = placed(state, pipeline::product(translation(0.3f, 0.3f, -0.5f), turned(60, {1, 1, 0})));
    use(state, map, MinFilter::linear, MagFilter::linear);
    generate(state, TexGenMode::sphere_map, 2);
    stage.draw(state, sphere(32, 24));
  }
}

void cube_by(Stage& stage, TexGenMode mode) {
  raster::TextureOptions options;
  options.wrap_s = options.wrap_t = raster::Wrap::clamp_to_edge;
  const raster::Texture* cube = stage.keep(marked_cube(16, options));
  for (const int cell : {0, 1}) {
    State state = in_cell(view_from(2.7f), cell, 2, 1);
    if (cell == 1) state = placed(state, turned(50, {1, 1, 0}));
    use(state, cube, MinFilter::linear_mipmap_linear, MagFilter::linear);
    generate(state, mode, 3);
    stage.draw(state, sphere(32, 24));
  }
}

/// A mirroring ball in a room of coloured walls, yellow (−Z) behind it and blue (+Z) before it. Turned, it
/// shows the same.
void reflection_map(Stage& stage) { cube_by(stage, TexGenMode::reflection_map); }
/// The wall that the normal points to, in eye space.
void normal_map(Stage& stage) { cube_by(stage, TexGenMode::normal_map); }

/// The texture matrix turns reflections back into the world: the walls stay where they are while the eye goes
/// round.
void reflection_in_world(Stage& stage) {
  raster::TextureOptions options;
  options.wrap_s = options.wrap_t = raster::Wrap::clamp_to_edge;
  const raster::Texture* cube = stage.keep(marked_cube(16, options));
  for (int cell = 0; cell < 3; ++cell) {
    const float angle = 45.0f * static_cast<float>(cell);
    State state = placed(in_cell(view_from(2.7f), cell, 3, 1), turned(angle, {0, 1, 0}));
    use(state, cube, MinFilter::linear_mipmap_linear, MagFilter::linear);
    generate(state, TexGenMode::reflection_map, 3);
    state.texture_coordinates[0].matrix = turned(-angle, {0, 1, 0});
    stage.draw(state, sphere(32, 24));
  }
}

/// A box looked up by its positions from six sides: faces and their orientation (white marks s = t = 0),
/// nearest.
void cube_faces(Stage& stage) {
  constexpr glm::dvec3 kAxis[] = {{0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
  constexpr float kAngle[] = {-90, 90, 90, -90, 0, 180};  // +X −X +Y −Y +Z −Z towards the eye
  raster::TextureOptions options;
  options.wrap_s = options.wrap_t = raster::Wrap::clamp_to_edge;
  const raster::Texture* cube = stage.keep(marked_cube(8, options));
  for (int cell = 0; cell < 6; ++cell) {
    State state = in_cell(view_from(4.2f), cell, 3, 2);
    state = placed(placed(state, pipeline::product(turned(15, {1, 0, 0}), turned(-20, {0, 1, 0}))),
                   turned(kAngle[cell], kAxis[cell]));
    use(state, cube, MinFilter::nearest, MagFilter::nearest);
    state.cull_face = pipeline::CullFace::back;
    Shape box = open_box();
    for (int k = 0; k < 4; ++k) {
      const glm::vec4 corner = box.position[static_cast<std::size_t>(16 + k)];
      box.position.emplace_back(-corner.x, corner.y, 1, 1);
    }
    box.normal.clear();
    box.color.clear();
    box.texcoord = box.position;
    box.texcoord_components = 3;
    stage.draw(state, box);
  }
}

/// Four texels a side, magnified: filters that stop at the edges of faces, and that go across.
void cube_seams(Stage& stage) {
  for (const int cell : {0, 1}) {
    raster::TextureOptions options;
    options.wrap_s = options.wrap_t = raster::Wrap::clamp_to_edge;
    options.seamless = cell == 1;
    State state = placed(in_cell(view_from(2.7f), cell, 2, 1), turned(40, {1, -1, 0}));
    use(state, stage.keep(marked_cube(4, options)), MinFilter::linear, MagFilter::linear);
    Shape ball = sphere(32, 24);
    ball.texcoord = ball.position;
    ball.texcoord_components = 3;
    stage.draw(state, ball);
  }
}

}  // namespace

std::vector<Scene> texgen_scenes() {
  return {{"linear_generation", linear_generation},
          {"sphere_map", sphere_map},
          {"reflection_map", reflection_map},
          {"normal_map", normal_map},
          {"reflection_in_world", reflection_in_world},
          {"cube_faces", cube_faces},
          {"cube_seams", cube_seams}};
}

}  // namespace barrido::golden
