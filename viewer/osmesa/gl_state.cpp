// Transformation, lighting, rasterization and fragment operations.
#include "viewer/osmesa/gl_state.h"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

namespace barrido::osmesa {
namespace {

constexpr GLenum kCompare[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                               GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
constexpr GLenum kBlendFactor[] = {GL_ZERO,
                                   GL_ONE,
                                   GL_SRC_COLOR,
                                   GL_ONE_MINUS_SRC_COLOR,
                                   GL_DST_COLOR,
                                   GL_ONE_MINUS_DST_COLOR,
                                   GL_SRC_ALPHA,
                                   GL_ONE_MINUS_SRC_ALPHA,
                                   GL_DST_ALPHA,
                                   GL_ONE_MINUS_DST_ALPHA,
                                   GL_CONSTANT_COLOR,
                                   GL_ONE_MINUS_CONSTANT_COLOR,
                                   GL_CONSTANT_ALPHA,
                                   GL_ONE_MINUS_CONSTANT_ALPHA,
                                   GL_SRC_ALPHA_SATURATE};
constexpr GLenum kBlendEquation[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
constexpr GLenum kFogMode[] = {GL_LINEAR, GL_EXP, GL_EXP2};
constexpr GLenum kColorMaterial[] = {GL_NONE,     GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE,
                                     GL_SPECULAR, GL_EMISSION};

template <std::size_t kCount, class Enumeration>
GLenum constant(const GLenum (&table)[kCount], Enumeration value) {
  return table[static_cast<std::size_t>(value)];
}

void enable(GLenum capability, bool on) { on ? gl().Enable(capability) : gl().Disable(capability); }

void set_light(GLenum name, const pipeline::Light& light) {
  gl().Lightfv(name, GL_AMBIENT, glm::value_ptr(light.ambient));
  gl().Lightfv(name, GL_DIFFUSE, glm::value_ptr(light.diffuse));
  gl().Lightfv(name, GL_SPECULAR, glm::value_ptr(light.specular));
  gl().Lightfv(name, GL_POSITION, glm::value_ptr(light.position));
  gl().Lightfv(name, GL_SPOT_DIRECTION, glm::value_ptr(light.spot_direction));
  gl().Lightf(name, GL_SPOT_EXPONENT, std::min(light.spot_exponent, kGlLargestExponent));
  gl().Lightf(name, GL_SPOT_CUTOFF, light.spot_cutoff_deg);
  gl().Lightf(name, GL_CONSTANT_ATTENUATION, light.constant_attenuation);
  gl().Lightf(name, GL_LINEAR_ATTENUATION, light.linear_attenuation);
  gl().Lightf(name, GL_QUADRATIC_ATTENUATION, light.quadratic_attenuation);
  gl().Enable(name);
}

/// Mesa 22.3 takes a short cut where the shininess is 0 that does not give (N·H)^0 = 1 under local lights; a
/// tiny exponent goes the usual way.
void set_material(GLenum face, const pipeline::Material& material, bool per_vertex) {
  gl().Materialfv(face, GL_AMBIENT, glm::value_ptr(material.ambient));
  gl().Materialfv(face, GL_DIFFUSE, glm::value_ptr(material.diffuse));
  gl().Materialfv(face, GL_SPECULAR, glm::value_ptr(material.specular));
  gl().Materialfv(face, GL_EMISSION, glm::value_ptr(material.emission));
  const float shininess = std::min(material.shininess, kGlLargestExponent);
  gl().Materialf(face, GL_SHININESS, per_vertex && shininess == 0.0f ? 1e-20f : shininess);
}

void set_fog(const raster::FogState& fog) {
  enable(GL_FOG, fog.enabled);
  gl().Fogi(GL_FOG_MODE, static_cast<GLint>(constant(kFogMode, fog.mode)));
  gl().Fogf(GL_FOG_DENSITY, fog.density);
  gl().Fogf(GL_FOG_START, fog.start);
  gl().Fogf(GL_FOG_END, fog.end);
  gl().Fogfv(GL_FOG_COLOR, fog.color.data());
  gl().Hint(GL_FOG_HINT, GL_NICEST);
}

}  // namespace

void set_transform(const pipeline::State& state, int frame_width, int frame_height) {
  const pipeline::Viewport& v = state.viewport;
  gl().Viewport(v.x, v.y, v.width == 0 ? frame_width : v.width, v.height == 0 ? frame_height : v.height);
  gl().DepthRange(v.depth_near, v.depth_far);
  gl().MatrixMode(GL_PROJECTION);
  gl().LoadMatrixf(glm::value_ptr(state.clip_from_eye));
  gl().MatrixMode(GL_MODELVIEW);
  gl().LoadIdentity();  // the structs hold clip planes and lights in eye space
  for (std::size_t i = 0; i < state.clip_planes.size(); ++i) {
    const glm::dvec4 plane(state.clip_planes[i]);
    gl().ClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(i), glm::value_ptr(plane));
    gl().Enable(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
  }
  enable(GL_NORMALIZE, state.normalize);
  enable(GL_RESCALE_NORMAL, state.rescale_normal);
  enable(GL_DEPTH_CLAMP, state.depth_clamp);
}

void set_lighting(const pipeline::State& state) {
  const pipeline::Lighting& lighting = state.lighting;
  gl().MatrixMode(GL_MODELVIEW);
  gl().LoadIdentity();
  enable(GL_LIGHTING, lighting.enabled);
  for (std::size_t i = 0; i < std::min(lighting.lights.size(), kGlLights); ++i) {
    set_light(GL_LIGHT0 + static_cast<GLenum>(i), lighting.lights[i]);
  }
  gl().LightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(lighting.ambient));
  gl().LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, lighting.local_viewer);
  gl().LightModeli(GL_LIGHT_MODEL_TWO_SIDE, lighting.two_sided);
  gl().LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                   lighting.separate_specular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  const bool per_vertex = !pipeline::shading_mode(state.shade_model).lit.at_fragments;
  set_material(GL_FRONT, lighting.front, per_vertex);
  set_material(GL_BACK, lighting.back, per_vertex);
  if (lighting.color_material != pipeline::ColorMaterial::none) {
    gl().ColorMaterial(GL_FRONT_AND_BACK, constant(kColorMaterial, lighting.color_material));
    gl().Enable(GL_COLOR_MATERIAL);
  }
}

void set_rasterization(const pipeline::State& state) {
  gl().MatrixMode(GL_MODELVIEW);
  gl().LoadMatrixf(glm::value_ptr(state.eye_from_object));
  gl().ShadeModel(pipeline::shading_mode(state.shade_model).lit.flat ? GL_FLAT : GL_SMOOTH);
  enable(GL_CULL_FACE, state.cull_face != pipeline::CullFace::none);
  constexpr GLenum kCull[] = {GL_BACK, GL_BACK, GL_FRONT, GL_FRONT_AND_BACK};
  gl().CullFace(constant(kCull, state.cull_face));
  gl().FrontFace(state.front_face == pipeline::FrontFace::counter_clockwise ? GL_CCW : GL_CW);
  constexpr GLenum kMode[] = {GL_FILL, GL_LINE, GL_POINT};
  gl().PolygonMode(GL_FRONT_AND_BACK, constant(kMode, state.polygon_mode));
  gl().PointSize(state.point_size);
  gl().LineWidth(state.line_width);
  enable(GL_POLYGON_OFFSET_FILL, state.polygon_offset.enabled);
  // Barrido's r is 2^-24, llvmpipe's (measured) 2^-23; OpenGL leaves it to the implementation.
  gl().PolygonOffset(state.polygon_offset.factor, 0.5f * state.polygon_offset.units);
  set_fog(state.fog);
}

void set_fragment_operations(const pipeline::State& state) {
  enable(GL_SCISSOR_TEST, state.scissor.enabled);
  gl().Scissor(state.scissor.x, state.scissor.y, state.scissor.width, state.scissor.height);
  enable(GL_ALPHA_TEST, state.alpha_test.enabled);
  gl().AlphaFunc(constant(kCompare, state.alpha_test.compare), state.alpha_test.reference);
  enable(GL_DEPTH_TEST, state.depth.test);
  gl().DepthFunc(constant(kCompare, state.depth.compare));
  gl().DepthMask(state.depth.write);
  const raster::BlendState& b = state.blend;
  enable(GL_BLEND, b.enabled);
  gl().BlendFuncSeparate(constant(kBlendFactor, b.src_rgb), constant(kBlendFactor, b.dst_rgb),
                         constant(kBlendFactor, b.src_alpha), constant(kBlendFactor, b.dst_alpha));
  gl().BlendEquation(constant(kBlendEquation, b.equation));
  gl().BlendColor(b.constant[0], b.constant[1], b.constant[2], b.constant[3]);
  const auto& mask = state.color_mask;
  gl().ColorMask(mask[0], mask[1], mask[2], mask[3]);
}

}  // namespace barrido::osmesa
