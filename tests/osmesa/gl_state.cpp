// Transformation, lighting, rasterization and fragment operations.
#include "tests/osmesa/gl_state.h"

#include <glm/gtc/type_ptr.hpp>

namespace barrido::crosscheck {
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

void enable(GLenum capability, bool on) { on ? glEnable(capability) : glDisable(capability); }

void set_light(GLenum name, const pipeline::Light& light) {
  glLightfv(name, GL_AMBIENT, glm::value_ptr(light.ambient));
  glLightfv(name, GL_DIFFUSE, glm::value_ptr(light.diffuse));
  glLightfv(name, GL_SPECULAR, glm::value_ptr(light.specular));
  glLightfv(name, GL_POSITION, glm::value_ptr(light.position));
  glLightfv(name, GL_SPOT_DIRECTION, glm::value_ptr(light.spot_direction));
  glLightf(name, GL_SPOT_EXPONENT, light.spot_exponent);
  glLightf(name, GL_SPOT_CUTOFF, light.spot_cutoff_deg);
  glLightf(name, GL_CONSTANT_ATTENUATION, light.constant_attenuation);
  glLightf(name, GL_LINEAR_ATTENUATION, light.linear_attenuation);
  glLightf(name, GL_QUADRATIC_ATTENUATION, light.quadratic_attenuation);
  glEnable(name);
}

/// Mesa 22.3 takes a short cut where the shininess is 0 that does not give (N·H)^0 = 1 under local lights; a
/// tiny exponent goes the usual way.
void set_material(GLenum face, const pipeline::Material& material, bool per_vertex) {
  glMaterialfv(face, GL_AMBIENT, glm::value_ptr(material.ambient));
  glMaterialfv(face, GL_DIFFUSE, glm::value_ptr(material.diffuse));
  glMaterialfv(face, GL_SPECULAR, glm::value_ptr(material.specular));
  glMaterialfv(face, GL_EMISSION, glm::value_ptr(material.emission));
  glMaterialf(face, GL_SHININESS, per_vertex && material.shininess == 0.0f ? 1e-20f : material.shininess);
}

void set_fog(const raster::FogState& fog) {
  enable(GL_FOG, fog.enabled);
  glFogi(GL_FOG_MODE, static_cast<GLint>(constant(kFogMode, fog.mode)));
  glFogf(GL_FOG_DENSITY, fog.density);
  glFogf(GL_FOG_START, fog.start);
  glFogf(GL_FOG_END, fog.end);
  glFogfv(GL_FOG_COLOR, fog.color.data());
  glHint(GL_FOG_HINT, GL_NICEST);
}

}  // namespace

void set_transform(const pipeline::State& state, int frame_width, int frame_height) {
  const pipeline::Viewport& v = state.viewport;
  glViewport(v.x, v.y, v.width == 0 ? frame_width : v.width, v.height == 0 ? frame_height : v.height);
  glDepthRange(v.depth_near, v.depth_far);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(glm::value_ptr(state.clip_from_eye));
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();  // the structs hold clip planes and lights in eye space
  for (std::size_t i = 0; i < state.clip_planes.size(); ++i) {
    const glm::dvec4 plane(state.clip_planes[i]);
    glClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(i), glm::value_ptr(plane));
    glEnable(GL_CLIP_PLANE0 + static_cast<GLenum>(i));
  }
  enable(GL_NORMALIZE, state.normalize);
  enable(GL_RESCALE_NORMAL, state.rescale_normal);
  enable(GL_DEPTH_CLAMP, state.depth_clamp);
}

void set_current_values() {
  glNormal3f(0, 0, 1);
  glColor4f(1, 1, 1, 1);
  for (GLenum unit = 0; unit < 2; ++unit) glMultiTexCoord4f(GL_TEXTURE0 + unit, 0, 0, 0, 1);
}

void set_lighting(const pipeline::State& state) {
  const pipeline::Lighting& lighting = state.lighting;
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  enable(GL_LIGHTING, lighting.enabled);
  for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
    set_light(GL_LIGHT0 + static_cast<GLenum>(i), lighting.lights[i]);
  }
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(lighting.ambient));
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, lighting.local_viewer);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, lighting.two_sided);
  glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                lighting.separate_specular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  const bool per_vertex = state.shade_model <= pipeline::ShadeModel::gouraud;
  set_material(GL_FRONT, lighting.front, per_vertex);
  set_material(GL_BACK, lighting.back, per_vertex);
  if (lighting.color_material != pipeline::ColorMaterial::none) {
    glColorMaterial(GL_FRONT_AND_BACK, constant(kColorMaterial, lighting.color_material));
    glEnable(GL_COLOR_MATERIAL);
  }
}

void set_rasterization(const pipeline::State& state) {
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(glm::value_ptr(state.eye_from_object));
  glShadeModel(state.shade_model == pipeline::ShadeModel::flat ? GL_FLAT : GL_SMOOTH);
  enable(GL_CULL_FACE, state.cull_face != pipeline::CullFace::none);
  constexpr GLenum kCull[] = {GL_BACK, GL_BACK, GL_FRONT, GL_FRONT_AND_BACK};
  glCullFace(constant(kCull, state.cull_face));
  glFrontFace(state.front_face == pipeline::FrontFace::counter_clockwise ? GL_CCW : GL_CW);
  constexpr GLenum kMode[] = {GL_FILL, GL_LINE, GL_POINT};
  glPolygonMode(GL_FRONT_AND_BACK, constant(kMode, state.polygon_mode));
  glPointSize(state.point_size);
  glLineWidth(state.line_width);
  enable(GL_POLYGON_OFFSET_FILL, state.polygon_offset.enabled);
  // Barrido's r is 2^-24, llvmpipe's (measured) 2^-23; OpenGL leaves it to the implementation.
  glPolygonOffset(state.polygon_offset.factor, 0.5f * state.polygon_offset.units);
  set_fog(state.fog);
}

void set_fragment_operations(const pipeline::State& state) {
  enable(GL_SCISSOR_TEST, state.scissor.enabled);
  glScissor(state.scissor.x, state.scissor.y, state.scissor.width, state.scissor.height);
  enable(GL_ALPHA_TEST, state.alpha_test.enabled);
  glAlphaFunc(constant(kCompare, state.alpha_test.compare), state.alpha_test.reference);
  enable(GL_DEPTH_TEST, state.depth.test);
  glDepthFunc(constant(kCompare, state.depth.compare));
  glDepthMask(state.depth.write);
  const raster::BlendState& b = state.blend;
  enable(GL_BLEND, b.enabled);
  glBlendFuncSeparate(constant(kBlendFactor, b.src_rgb), constant(kBlendFactor, b.dst_rgb),
                      constant(kBlendFactor, b.src_alpha), constant(kBlendFactor, b.dst_alpha));
  glBlendEquation(constant(kBlendEquation, b.equation));
  glBlendColor(b.constant[0], b.constant[1], b.constant[2], b.constant[3]);
  const auto& mask = state.color_mask;
  glColorMask(mask[0], mask[1], mask[2], mask[3]);
}

void draw_mesh(const Mesh& mesh) {
  constexpr int kStride = sizeof(glm::vec4);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(mesh.position_components, GL_FLOAT, kStride, mesh.position.data());
  if (!mesh.normal.empty()) {
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(GL_FLOAT, sizeof(glm::vec3), mesh.normal.data());
  }
  // White everywhere instead of none: Mesa 22.3's colour material does not see the current colour.
  const std::vector<glm::vec4> white(mesh.color.empty() ? mesh.position.size() : 0, glm::vec4(1.0f));
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(4, GL_FLOAT, kStride, mesh.color.empty() ? white.data() : mesh.color.data());
  for (std::size_t unit = 0; unit < mesh.texcoord.size(); ++unit) {
    if (mesh.texcoord[unit].empty()) continue;
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(mesh.texcoord_components[unit], GL_FLOAT, kStride, mesh.texcoord[unit].data());
  }
  const auto mode = static_cast<GLenum>(mesh.mode);  // the same order as OpenGL's constants
  if (mesh.indices.empty()) {
    glDrawArrays(mode, 0, static_cast<GLsizei>(mesh.position.size()));
  } else {
    glDrawElements(mode, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, mesh.indices.data());
  }
}

}  // namespace barrido::crosscheck
