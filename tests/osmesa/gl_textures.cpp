// Texture objects, units, coordinate generation.
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

#include "tests/osmesa/gl_state.h"

namespace barrido::crosscheck {
namespace {

constexpr GLint kWrap[] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_CLAMP};
constexpr GLint kMinFilter[] = {GL_NEAREST,
                                GL_LINEAR,
                                GL_NEAREST_MIPMAP_NEAREST,
                                GL_LINEAR_MIPMAP_NEAREST,
                                GL_NEAREST_MIPMAP_LINEAR,
                                GL_LINEAR_MIPMAP_LINEAR};
constexpr GLint kEnvMode[] = {GL_MODULATE, GL_REPLACE, GL_ADD, GL_DECAL, GL_BLEND, GL_COMBINE};
constexpr GLint kFunction[] = {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT};
constexpr GLint kSource[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
constexpr GLint kOperand[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
constexpr GLint kGenMode[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP,
                              GL_NORMAL_MAP};

template <std::size_t kCount, class Enumeration>
GLint constant(const GLint (&table)[kCount], Enumeration value) {
  return table[static_cast<std::size_t>(value)];
}

GLenum target_of(const raster::Texture& texture) {
  return texture.is_cube() ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
}

void upload(const raster::Texture& texture) {
  const GLenum target = target_of(texture);
  for (int face = 0; face < texture.face_count(); ++face) {
    const GLenum image =
        texture.is_cube() ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GL_TEXTURE_2D;
    for (int level = 0; level < texture.level_count(); ++level) {
      const raster::MipLevel& size = texture.level(level, face);
      glTexImage2D(image, level, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                   texture.level_rgba8(level, face).data());
    }
  }
  const raster::TextureOptions& options = texture.options();
  // A cube map without seams, as before OpenGL 3.2, is clamped to the edge of each face.
  glTexParameteri(target, GL_TEXTURE_WRAP_S,
                  texture.is_cube() ? GL_CLAMP_TO_EDGE : constant(kWrap, options.wrap_s));
  glTexParameteri(target, GL_TEXTURE_WRAP_T,
                  texture.is_cube() ? GL_CLAMP_TO_EDGE : constant(kWrap, options.wrap_t));
  glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, options.border_color.data());
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, texture.level_count() - 1);
}

void set_channel(const raster::CombineChannel& channel, bool alpha) {
  glTexEnvi(GL_TEXTURE_ENV, alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB, constant(kFunction, channel.function));
  glTexEnvf(GL_TEXTURE_ENV, alpha ? GL_ALPHA_SCALE : GL_RGB_SCALE, channel.scale);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto offset = static_cast<GLenum>(i);
    // Alpha has alpha operands only: of "color", the alpha.
    const auto operand = static_cast<std::size_t>(channel.operand[i]);
    glTexEnvi(GL_TEXTURE_ENV, (alpha ? GL_SOURCE0_ALPHA : GL_SOURCE0_RGB) + offset,
              constant(kSource, channel.source[i]));
    glTexEnvi(GL_TEXTURE_ENV, (alpha ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + offset,
              kOperand[alpha ? operand | 2 : operand]);
  }
}

void set_environment(const raster::TextureUnit& unit) {
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, constant(kEnvMode, unit.env_mode));
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, unit.env_color.data());
  glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, unit.lod_bias);
  if (unit.env_mode != raster::TextureEnvMode::combine) return;
  set_channel(unit.combine.rgb, false);
  set_channel(unit.combine.alpha, true);
}

void set_coordinates(const pipeline::TextureCoordinates& coordinates) {
  glMatrixMode(GL_TEXTURE);
  glLoadMatrixf(glm::value_ptr(coordinates.matrix));
  glMatrixMode(GL_MODELVIEW);
  glPushMatrix();
  glLoadIdentity();  // eye planes are in eye space already
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const pipeline::TexGenCoordinate& rule = coordinates.generation[axis];
    const auto offset = static_cast<GLenum>(axis);
    if (!rule.enabled) continue;
    glTexGeni(GL_S + offset, GL_TEXTURE_GEN_MODE, constant(kGenMode, rule.mode));
    glTexGenfv(GL_S + offset, GL_OBJECT_PLANE, glm::value_ptr(rule.object_plane));
    glTexGenfv(GL_S + offset, GL_EYE_PLANE, glm::value_ptr(rule.eye_plane));
    glEnable(GL_TEXTURE_GEN_S + offset);
  }
  glPopMatrix();
}

}  // namespace

GlTextures::GlTextures(const ScenePair& pair) : pair_(pair), names_(pair.textures.size()) {
  glGenTextures(static_cast<GLsizei>(names_.size()), names_.data());
  for (std::size_t i = 0; i < names_.size(); ++i) {
    glBindTexture(target_of(*pair.textures[i]), names_[i]);
    upload(*pair.textures[i]);
  }
}

GlTextures::~GlTextures() { glDeleteTextures(static_cast<GLsizei>(names_.size()), names_.data()); }

GLuint GlTextures::name_of(const raster::Texture* texture) const {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (pair_.textures[i].get() == texture) return names_[i];
  }
  throw std::runtime_error("a texture unit has a texture that is not the scene's");
}

void set_texture_units(const pipeline::State& state, const GlTextures& textures) {
  for (std::size_t i = 0; i < state.texture_units.size(); ++i) {
    const raster::TextureUnit& unit = state.texture_units[i];
    if (unit.texture == nullptr) continue;
    const GLenum target = target_of(*unit.texture);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    glBindTexture(target, textures.name_of(unit.texture));
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, constant(kMinFilter, unit.min_filter));
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER,
                    unit.mag_filter == raster::MagFilter::linear ? GL_LINEAR : GL_NEAREST);
    glEnable(target);
    set_environment(unit);
    set_coordinates(state.texture_coordinates[i]);
  }
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace barrido::crosscheck
