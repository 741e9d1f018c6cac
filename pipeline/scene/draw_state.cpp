#include "pipeline/scene/draw_state.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "pipeline/matrix.h"
#include "pipeline/pictures/transfer.h"

namespace barrido::scene {
namespace {

/// Whether lengths stay as they are, so that unit normals need not be normalised again.
bool keeps_lengths(const glm::mat4& matrix) {
  const glm::mat3 m(matrix);
  const auto near = [](float value, float wanted) { return std::abs(value - wanted) < 1e-5f; };
  return near(glm::dot(m[0], m[0]), 1) && near(glm::dot(m[1], m[1]), 1) && near(glm::dot(m[2], m[2]), 1) &&
         near(glm::dot(m[0], m[1]), 0) && near(glm::dot(m[1], m[2]), 0) && near(glm::dot(m[2], m[0]), 0);
}

void set_fog_color(pipeline::State& state, float grey) {
  for (std::size_t c = 0; c < 3; ++c) state.fog.color[c] = grey;
}

void set_alpha(pipeline::State& state, const SurfaceState& surface, Transparency transparency,
               bool write_alpha) {
  if (surface.alpha_mode == AlphaMode::mask) {
    state.alpha_test = {true, raster::Compare::greater_equal, surface.alpha_cutoff};
    state.color_mask[3] = write_alpha;
  }
  if (surface.blending == Blending::none) return;
  using Factor = raster::BlendFactor;
  state.blend.enabled = true;
  state.sorted = transparency == Transparency::exact;
  state.blend.src_alpha = Factor::one;
  state.blend.dst_alpha = Factor::one_minus_src_alpha;
  state.depth.write = false;
  // Fog comes once: it is added by the draw that takes the place of what is behind.
  switch (surface.blending) {
    case Blending::filter:
      state.blend.src_rgb = Factor::zero;
      state.blend.dst_rgb = Factor::src_color;
      state.color_mask[3] = false;
      set_fog_color(state, 1.0f);
      break;
    case Blending::coat:
      state.depth.compare = raster::Compare::equal;
      [[fallthrough]];
    case Blending::add:
      state.blend.src_rgb = Factor::one;
      state.blend.dst_rgb = Factor::one;
      state.color_mask[3] = false;
      set_fog_color(state, 0.0f);
      break;
    default:
      state.blend.src_rgb = Factor::src_alpha;
      state.blend.dst_rgb = Factor::one_minus_src_alpha;
      break;
  }
}

void set_faces(pipeline::State& state, const RenderSettings& settings, const Draw& draw) {
  using Cull = pipeline::CullFace;
  const bool both_sides = draw.surface.double_sided || settings.wireframe;
  state.cull_face = settings.cull.value_or(both_sides ? Cull::none : Cull::back);
  state.front_face = draw.mirrored ? pipeline::FrontFace::clockwise : pipeline::FrontFace::counter_clockwise;
  // Backs that are seen are lit as such, also when only the user's choice of culling shows them.
  state.lighting.two_sided = state.cull_face != Cull::back;
}

void set_reflection(pipeline::State& state, int unit, const Reflection& reflection) {
  const auto index = static_cast<std::size_t>(unit);
  pipeline::TextureCoordinates& coordinates = state.texture_coordinates[index];
  for (std::size_t c = 0; c < 3; ++c) {
    coordinates.generation[c].enabled = true;
    coordinates.generation[c].mode = pipeline::TexGenMode::reflection_map;
  }
  coordinates.matrix = reflection.map_from_eye;
  state.texture_units[index].texture = reflection.map;
  if (reflection.map->level_count() == 1 && uses_mipmaps(state.texture_units[index].min_filter)) {
    state.texture_units[index].min_filter = raster::MinFilter::linear;
  }
}

}  // namespace

bool uses_float_frame(const RenderSettings& settings) {
  return settings.color_management == ColorManagement::srgb || settings.keep_float ||
         settings.exposure_ev != 0.0f || settings.tone_map != raster::ToneMap::clamp;
}

glm::vec3 frame_color(const glm::vec3& seen, const RenderSettings& settings) {
  if (!uses_float_frame(settings)) return seen;
  glm::vec3 color = settings.color_management == ColorManagement::srgb ? linear_from_srgb(seen) : seen;
  for (int channel = 0; channel < 3; ++channel) {
    if (settings.tone_map == raster::ToneMap::reinhard) {
      // White needs infinitely much light; a thousand is white to the eye.
      const float c = color[channel];
      color[channel] = c < 0.999f ? c / (1.0f - c) : 999.0f;
    }
    color[channel] *= portable_exp2(-settings.exposure_ev);
  }
  return color;
}

pipeline::State base_state(const RenderSettings& settings, const View& view, const SceneLights& lights,
                           const std::optional<raster::FogState>& fog) {
  pipeline::State state;
  state.clip_from_eye = view.clip_from_eye;
  state.shade_model = settings.shading;
  state.flat_at = settings.flat_at;
  state.cheap_phong_power = settings.cheap_phong_power;
  state.color_interpolation = settings.color_interpolation;
  state.texture_interpolation = settings.texture_interpolation;
  state.lighting.ambient = glm::vec4(lights.ambient, 1.0f);
  state.lighting.local_viewer = !is_parallel(view);
  state.lighting.separate_specular = true;
  state.lighting.specular_model = settings.lighting;
  for (const pipeline::Light& light : lights.lights) {
    state.lighting.lights.push_back(transformed(light, view.eye_from_world));
    state.lighting.lights.back().ambient = glm::vec4(0, 0, 0, 1);
  }
  if (settings.wireframe) state.polygon_mode = pipeline::PolygonMode::line;
  const auto height = static_cast<float>(settings.height);
  state.point_size = std::max(1.0f, std::floor(height / 180.0f));
  state.line_width = std::max(1.0f, std::floor(height / 540.0f));
  state.clamp_colors = !uses_float_frame(settings);
  state.depth.test = true;
  if (fog) state.fog = *fog;
  return state;
}

pipeline::State state_of(const pipeline::State& base, const RenderSettings& settings, const View& view,
                         const Draw& draw, const Reflection& reflection, bool write_alpha) {
  pipeline::State state = base;
  const SurfaceState& surface = draw.surface;
  state.eye_from_object = pipeline::product(view.eye_from_world, draw.world_from_object);
  state.normalize = !keeps_lengths(state.eye_from_object);
  state.lighting.enabled = surface.lit;
  state.lighting.color_material = surface.color_material;
  state.lighting.front = state.lighting.back = surface.material;
  state.texture_units = surface.units;
  for (std::size_t unit = 0; unit < surface.texture_matrix.size(); ++unit) {
    state.texture_coordinates[unit].matrix = surface.texture_matrix[unit];
  }
  if (surface.placed_unit != kNone) {
    const auto unit = static_cast<std::size_t>(surface.placed_unit);
    raster::Mapping& mapping = state.texture_units[unit].mapping;
    if (raster::needs_normal(mapping)) {
      look_from(state.eye_from_object, surface.placed_from_object, mapping);
    }
  }
  if (surface.reflection_unit != kNone) set_reflection(state, surface.reflection_unit, reflection);
  set_alpha(state, surface, settings.transparency, write_alpha);
  set_faces(state, settings, draw);
  return state;
}

}  // namespace barrido::scene
