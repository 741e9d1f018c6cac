// Texture objects, units, coordinate generation.
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

#include "viewer/osmesa/gl_state.h"

namespace barrido::osmesa {
namespace {

constexpr GLint kWrap[] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_CLAMP};
constexpr GLint kMinFilter[] = {GL_NEAREST,
                                GL_LINEAR,
                                GL_NEAREST_MIPMAP_NEAREST,
                                GL_LINEAR_MIPMAP_NEAREST,
                                GL_NEAREST_MIPMAP_LINEAR,
                                GL_LINEAR_MIPMAP_LINEAR,
                                GL_LINEAR_MIPMAP_LINEAR,  // in place of footprints; see cannot.cpp
                                GL_NEAREST};
constexpr GLint kEnvMode[] = {GL_MODULATE, GL_REPLACE, GL_ADD, GL_DECAL, GL_BLEND, GL_COMBINE};
constexpr GLint kFunction[] = {GL_REPLACE,     GL_MODULATE, GL_ADD,      GL_ADD_SIGNED,
                               GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};
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
      gl().TexImage2D(image, level, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      texture.level_rgba8(level, face).data());
    }
  }
  const raster::TextureOptions& options = texture.options();
  // Where filters do not cross its edges, as before OpenGL 3.2, a cube map is clamped to each face's.
  gl().TexParameteri(target, GL_TEXTURE_WRAP_S,
                     texture.is_cube() ? GL_CLAMP_TO_EDGE : constant(kWrap, options.wrap_s));
  gl().TexParameteri(target, GL_TEXTURE_WRAP_T,
                     texture.is_cube() ? GL_CLAMP_TO_EDGE : constant(kWrap, options.wrap_t));
  gl().TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, options.border_color.data());
  gl().TexParameteri(target, GL_TEXTURE_MAX_LEVEL, texture.level_count() - 1);
}

/// Of all cube maps at once, as OpenGL 3.2 has it.
void set_seams(const raster::Texture& cube) {
  cube.options().seamless ? gl().Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS)
                          : gl().Disable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void set_channel(const raster::CombineChannel& channel, bool alpha) {
  gl().TexEnvi(GL_TEXTURE_ENV, alpha ? GL_COMBINE_ALPHA : GL_COMBINE_RGB,
               constant(kFunction, channel.function));
  gl().TexEnvf(GL_TEXTURE_ENV, alpha ? GL_ALPHA_SCALE : GL_RGB_SCALE, channel.scale);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto offset = static_cast<GLenum>(i);
    // Alpha has alpha operands only: of "color", the alpha.
    const auto operand = static_cast<std::size_t>(channel.operand[i]);
    gl().TexEnvi(GL_TEXTURE_ENV, (alpha ? GL_SOURCE0_ALPHA : GL_SOURCE0_RGB) + offset,
                 constant(kSource, channel.source[i]));
    gl().TexEnvi(GL_TEXTURE_ENV, (alpha ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + offset,
                 kOperand[alpha ? operand | 2 : operand]);
  }
}

void set_environment(const raster::TextureUnit& unit) {
  gl().TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, constant(kEnvMode, unit.env_mode));
  gl().TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, unit.env_color.data());
  gl().TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, unit.lod_bias);
  if (unit.env_mode != raster::TextureEnvMode::combine) return;
  set_channel(unit.combine.rgb, false);
  set_channel(unit.combine.alpha, true);
}

void set_coordinates(const pipeline::TextureCoordinates& coordinates) {
  gl().MatrixMode(GL_TEXTURE);
  gl().LoadMatrixf(glm::value_ptr(coordinates.matrix));
  gl().MatrixMode(GL_MODELVIEW);
  gl().PushMatrix();
  gl().LoadIdentity();  // eye planes are in eye space already
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const pipeline::TexGenCoordinate& rule = coordinates.generation[axis];
    const auto offset = static_cast<GLenum>(axis);
    if (!rule.enabled) continue;
    gl().TexGeni(GL_S + offset, GL_TEXTURE_GEN_MODE, constant(kGenMode, rule.mode));
    gl().TexGenfv(GL_S + offset, GL_OBJECT_PLANE, glm::value_ptr(rule.object_plane));
    gl().TexGenfv(GL_S + offset, GL_EYE_PLANE, glm::value_ptr(rule.eye_plane));
    gl().Enable(GL_TEXTURE_GEN_S + offset);
  }
  gl().PopMatrix();
}

}  // namespace

Textures::~Textures() {
  for (const auto& [texture, name] : names_) gl().DeleteTextures(1, &name);
}

void Textures::add(const raster::Texture& texture) {
  const auto [slot, is_new] = names_.try_emplace(&texture, 0);
  if (!is_new) return;
  gl().GenTextures(1, &slot->second);
  gl().BindTexture(target_of(texture), slot->second);
  upload(texture);
}

void Textures::add_of(const pipeline::State& state) {
  for (const raster::TextureUnit& unit : state.texture_units) {
    if (unit.texture != nullptr) add(*unit.texture);
  }
}

GLuint Textures::name_of(const raster::Texture* texture) const {
  const auto found = names_.find(texture);
  if (found == names_.end())
    throw std::runtime_error("a texture unit has a texture that OpenGL was not given");
  return found->second;
}

void set_texture_units(const pipeline::State& state, const Textures& textures) {
  for (std::size_t i = 0; i < state.texture_units.size(); ++i) {
    const raster::TextureUnit& unit = state.texture_units[i];
    if (unit.texture == nullptr && unit.procedure != nullptr) {
      gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
      set_environment(unit);
      set_coordinates(state.texture_coordinates[i]);
    }
    if (unit.texture == nullptr) continue;
    const bool is_map = unit.role != raster::TextureRole::environment;  // of programs alone
    const GLenum target = target_of(*unit.texture);
    gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    gl().BindTexture(target, textures.name_of(unit.texture));
    gl().TexParameteri(target, GL_TEXTURE_MIN_FILTER, constant(kMinFilter, unit.min_filter));
    gl().TexParameteri(target, GL_TEXTURE_MAG_FILTER,
                       unit.mag_filter == raster::MagFilter::linear ? GL_LINEAR : GL_NEAREST);
    gl().TexParameteri(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, unit.max_anisotropy);
    if (!is_map) gl().Enable(target);
    if (unit.texture->is_cube()) set_seams(*unit.texture);
    set_environment(unit);
    set_coordinates(state.texture_coordinates[i]);
  }
  gl().ActiveTexture(GL_TEXTURE0);
}

}  // namespace barrido::osmesa
