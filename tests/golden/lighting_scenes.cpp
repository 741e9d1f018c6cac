// Local illumination and shading as the course teaches them, with the values of its formulas.
#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

using pipeline::Light;
using pipeline::ShadeModel;

/// A red plastic ball, one white point light from the upper left in front.
State lit_view(float distance) {
  State state = view_from(distance);
  state.lighting.enabled = true;
  state.lighting.local_viewer = true;
  state.lighting.front.ambient = {0.7f, 0.15f, 0.1f, 1};
  state.lighting.front.diffuse = {0.7f, 0.15f, 0.1f, 1};
  state.lighting.front.specular = {0.6f, 0.6f, 0.6f, 1};
  state.lighting.front.shininess = 30;
  Light light;
  light.position = {-2, 2, 1, 1};
  state.lighting.lights = {light};
  return state;
}

/// Flat, Gouraud, cheap Phong and Phong of the same coarse ball.
void four_shadings(Stage& stage) {
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(lit_view(3), cell, 2, 2);
    state.shade_model = static_cast<ShadeModel>(cell);
    stage.draw(state, sphere(14, 9));
  }
}

/// One square, the light near its middle: lit at four corners, Gouraud and cheap Phong miss what Phong shows.
void highlight_in_polygon(Stage& stage) {
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(lit_view(2.6f), cell, 2, 2);
    state.shade_model = static_cast<ShadeModel>(cell);
    state.lighting.lights[0].position = {0.2f, 0.2f, -1.8f, 1};
    stage.draw(state, plane(1));
  }
}

/// Cheap Phong: the power per pixel, and at the vertices.
void cheap_phong_powers(Stage& stage) {
  for (const int cell : {0, 1}) {
    State state = in_cell(lit_view(2.6f), cell, 2, 1);
    state.shade_model = ShadeModel::cheap_phong;
    state.cheap_phong_power = static_cast<pipeline::CheapPhongPower>(cell);
    stage.draw(state, sphere(14, 9));
  }
}

/// (R·V)^n above, (N·H)^n below, n = 5, 20, 80: Blinn's lobe is about twice as wide.
void phong_and_blinn(Stage& stage) {
  constexpr float kShininess[] = {5, 20, 80};
  for (int cell = 0; cell < 6; ++cell) {
    State state = in_cell(lit_view(2.9f), cell, 3, 2);
    state.shade_model = ShadeModel::phong;
    state.lighting.front.shininess = kShininess[cell % 3];
    state.lighting.specular_model =
        cell < 3 ? pipeline::SpecularModel::phong : pipeline::SpecularModel::blinn;
    stage.draw(state, sphere(24, 16));
  }
}

/// Ambient; diffuse; specular; and their sum.
void terms(Stage& stage) {
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(lit_view(3), cell, 2, 2);
    state.shade_model = ShadeModel::phong;
    state.lighting.ambient = {0.3f, 0.3f, 0.3f, 1};
    pipeline::Material& material = state.lighting.front;
    if (cell % 4 != 0 && cell != 3) material.ambient = {0, 0, 0, 1};
    if (cell != 1 && cell != 3) material.diffuse = {0, 0, 0, 1};
    if (cell != 2 && cell != 3) material.specular = {0, 0, 0, 1};
    stage.draw(state, sphere(24, 16));
  }
}

/// A wall with a light 0.4 before its middle: 1, 1/(d + 0.4), 1/d² and a range of 1.2.
void attenuation(Stage& stage) {
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(lit_view(2.6f), cell, 2, 2);
    state.shade_model = ShadeModel::phong;
    state.lighting.front.diffuse = {0.8f, 0.8f, 0.7f, 1};
    state.lighting.front.specular = {0, 0, 0, 1};
    state.lighting.ambient = {0, 0, 0, 1};
    Light& light = state.lighting.lights[0];
    light.position = {0, 0, -2.2f, 1};
    light.diffuse = {0.5f, 0.5f, 0.5f, 1};
    light.constant_attenuation = cell == 0 || cell == 3 ? 1.0f : cell == 1 ? 0.4f : 0.0f;
    light.linear_attenuation = cell == 1 ? 1.0f : 0.0f;
    light.quadratic_attenuation = cell == 2 ? 1.0f : 0.0f;
    light.range = cell == 3 ? 1.2f : 0.0f;
    stage.draw(state, plane(1));
  }
}

/// Spots on a wall: hard rim, exponent 8, exponent 60 and the soft cone of glTF.
void spots(Stage& stage) {
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(lit_view(2.6f), cell, 2, 2);
    state.shade_model = ShadeModel::phong;
    state.lighting.front.diffuse = {0.9f, 0.85f, 0.7f, 1};
    Light& light = state.lighting.lights[0];
    light.position = {0.8f, 0.6f, -1.4f, 1};
    light.spot_direction = {-0.6f, -0.5f, -1.2f};
    light.spot_cutoff_deg = cell == 3 ? 180.0f : 24.0f;
    light.spot_exponent = cell == 1 ? 8.0f : cell == 2 ? 60.0f : 0.0f;
    if (cell == 3) {
      light.spot_inner_cos = 0.97f;
      light.spot_outer_cos = 0.85f;
    }
    stage.draw(state, plane(1));
  }
}

/// Red, green and blue lights add up to white where they meet; a negative one takes blue away on the right.
void colored_lights(Stage& stage) {
  for (const int cell : {0, 1}) {
    State state = in_cell(lit_view(2.7f), cell, 2, 1);
    state.shade_model = ShadeModel::phong;
    state.lighting.front.diffuse = {0.9f, 0.9f, 0.9f, 1};
    state.lighting.front.specular = {0, 0, 0, 1};
    state.lighting.lights.clear();
    constexpr glm::vec4 kPosition[] = {{-1, 0.4f, 1, 0}, {1, 0.4f, 1, 0}, {0, -1, 1, 0}};
    for (int i = 0; i < 3; ++i) {
      Light light;
      light.diffuse = {0, 0, 0, 1};
      light.diffuse[i] = 0.9f;
      light.position = kPosition[i];
      state.lighting.lights.push_back(light);
    }
    if (cell == 1) {
      Light negative;
      negative.diffuse = {0, 0, -1, 1};
      negative.position = {0.3f, 0.1f, 1, 0};
      state.lighting.lights.push_back(negative);
    }
    stage.draw(state, sphere(24, 16));
  }
}

/// A half ball that shows its inside: lit by the front's material alone, and two-sided with a blue back.
void two_sided(Stage& stage) {
  for (const int cell : {0, 1}) {
    State state = in_cell(lit_view(3), cell, 2, 1);
    state.shade_model = cell == 0 ? ShadeModel::gouraud : ShadeModel::phong;
    state.lighting.two_sided = cell == 1;
    state.lighting.back.diffuse = {0.1f, 0.3f, 0.8f, 1};
    state.lighting.back.specular = {0.5f, 0.5f, 0.5f, 1};
    state.lighting.back.shininess = 10;
    state.clip_planes = {{0.5f, -0.6f, -0.6f, -1.7f}};
    stage.draw(state, sphere(24, 16));
  }
}

/// Vertex colours stand for no property, the diffuse one, and emission.
void color_material(Stage& stage) {
  constexpr pipeline::ColorMaterial kKinds[] = {
      pipeline::ColorMaterial::none, pipeline::ColorMaterial::ambient_and_diffuse,
      pipeline::ColorMaterial::specular, pipeline::ColorMaterial::emission};
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(lit_view(3), cell, 2, 2);
    state.lighting.color_material = kKinds[cell];
    Shape ball = sphere(24, 16);
    for (const glm::vec4& p : ball.position)
      ball.color.emplace_back(0.2f, 0.5f + 0.4f * p.x, 0.5f - 0.4f * p.y, 1);
    stage.draw(state, ball);
  }
}

/// A checkered ball: the highlight is darkened by the texture, and as separate colour stays white.
void separate_specular(Stage& stage) {
  const raster::Texture* texture = stage.keep(checker(32));
  for (const int cell : {0, 1}) {
    State state = in_cell(lit_view(2.7f), cell, 2, 1);
    state.shade_model = ShadeModel::phong;
    state.lighting.front.diffuse = {0.8f, 0.8f, 0.8f, 1};
    state.lighting.front.specular = {1, 1, 1, 1};
    state.lighting.front.shininess = 12;
    state.lighting.separate_specular = cell == 1;
    state.texture_units[0].texture = texture;
    stage.draw(state, sphere(24, 16));
  }
}

/// A ball made three times as large and squashed: normals as they come out, rescaled, and normalised.
void normals_of_scaled(Stage& stage) {
  for (int cell = 0; cell < 3; ++cell) {
    State state = placed(in_cell(lit_view(9), cell, 3, 1), scaling(3, 2, 3));
    state.lighting.front.specular = {0, 0, 0, 1};
    state.rescale_normal = cell == 1;
    state.normalize = cell == 2;
    stage.draw(state, sphere(24, 16));
  }
}

/// Lit at the polygon's middle (the course), and at its last vertex (OpenGL).
void flat_at(Stage& stage) {
  for (const int cell : {0, 1}) {
    State state = in_cell(lit_view(2.7f), cell, 2, 1);
    state.shade_model = ShadeModel::flat;
    state.flat_at = cell == 0 ? pipeline::FlatAt::centroid : pipeline::FlatAt::provoking_vertex;
    stage.draw(state, sphere(10, 7));
  }
}

/// A floor in two triangles with a bright corner: colours linear on the screen, and in perspective.
void screen_colors(Stage& stage) {
  for (const int cell : {0, 1}) {
    State state = placed(in_cell(view_from(2.6f), cell, 2, 1), turned(-70, {1, 0, 0}));
    state.color_interpolation =
        cell == 0 ? pipeline::ColorInterpolation::screen : pipeline::ColorInterpolation::perspective;
    Shape square = plane(1);
    square.color = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 0, 1}};
    stage.draw(state, square);
  }
}

raster::FramebufferOptions float_frame(raster::ToneMap map, float exposure) {
  raster::FramebufferOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.format = raster::ColorFormat::rgba32f;
  options.display = {exposure, map, false};
  return options;
}
raster::FramebufferOptions clamped() { return float_frame(raster::ToneMap::clamp, 1); }
raster::FramebufferOptions reinhard() { return float_frame(raster::ToneMap::reinhard, 1); }
raster::FramebufferOptions exposed() { return float_frame(raster::ToneMap::clamp, 0.25f); }

/// An orange light four times too strong.
void over_maximum(Stage& stage) {
  State state = lit_view(2.7f);
  state.clamp_colors = false;
  state.shade_model = ShadeModel::phong;
  state.lighting.front.diffuse = {0.9f, 0.9f, 0.9f, 1};
  state.lighting.lights[0].diffuse = {4, 2, 0.8f, 1};
  state.lighting.lights[0].specular = {4, 2, 0.8f, 1};
  stage.draw(state, sphere(24, 16));
}

}  // namespace

std::vector<Scene> lighting_scenes() {
  return {{"four_shadings", four_shadings},
          {"highlight_in_polygon", highlight_in_polygon},
          {"cheap_phong_powers", cheap_phong_powers},
          {"phong_and_blinn", phong_and_blinn},
          {"terms", terms},
          {"attenuation", attenuation},
          {"spots", spots},
          {"colored_lights", colored_lights},
          {"two_sided", two_sided},
          {"color_material", color_material},
          {"separate_specular", separate_specular},
          {"normals_of_scaled", normals_of_scaled},
          {"flat_at", flat_at},
          {"screen_colors", screen_colors},
          {"over_maximum_clamped", over_maximum, clamped},
          {"over_maximum_reinhard", over_maximum, reinhard},
          {"over_maximum_exposed", over_maximum, exposed}};
}

}  // namespace barrido::golden
