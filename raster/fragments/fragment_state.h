// Everything about a draw that the fragment stage must know, as plain structs whose initialisers are OpenGL's
// defaults (OpenGL 1.3 specification, tables 6.14 to 6.20). Constant over one chunk of primitives.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/fragments/fragment_stage.h"
#include "raster/textures/mapping.h"
#include "raster/textures/pattern.h"
#include "raster/textures/texture.h"

namespace barrido::raster {

/// GL_NEVER … GL_ALWAYS. The incoming value stands left: `less` passes when incoming < stored.
enum class Compare : std::uint8_t {
  never,
  less,
  equal,
  less_equal,
  greater,
  not_equal,
  greater_equal,
  always
};

struct DepthState {
  bool test = false;
  bool write = true;  ///< Writes only happen while the test is enabled, as in OpenGL.
  Compare compare = Compare::less;
};

struct AlphaTest {
  bool enabled = false;
  Compare compare = Compare::always;
  float reference = 0.0f;  ///< [0, 1]
};

enum class BlendFactor : std::uint8_t {
  zero,
  one,
  src_color,
  one_minus_src_color,
  dst_color,
  one_minus_dst_color,
  src_alpha,
  one_minus_src_alpha,
  dst_alpha,
  one_minus_dst_alpha,
  constant_color,
  one_minus_constant_color,
  constant_alpha,
  one_minus_constant_alpha,
  src_alpha_saturate,
};

enum class BlendEquation : std::uint8_t { add, subtract, reverse_subtract, min, max };

struct BlendState {
  bool enabled = false;
  BlendFactor src_rgb = BlendFactor::one;
  BlendFactor dst_rgb = BlendFactor::zero;
  BlendFactor src_alpha = BlendFactor::one;
  BlendFactor dst_alpha = BlendFactor::zero;
  BlendEquation equation = BlendEquation::add;
  std::array<float, 4> constant{0, 0, 0, 0};
};

/// Pixels outside [x, x + width) × [y, y + height) are not touched. Window coordinates, y up.
struct Scissor {
  bool enabled = false;
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Depth of triangles moves by m·factor + r·units; m the largest depth slope, r = 2⁻²⁴ (OpenGL 1.3,
/// section 3.5.5).
struct PolygonOffset {
  bool enabled = false;
  float factor = 0.0f;
  float units = 0.0f;
};

enum class FogMode : std::uint8_t { linear, exp, exp2 };

/// f·C + (1 − f)·C_fog on the colour channels; alpha stays (OpenGL 1.3, section 3.10). The distance is
/// |z_eye|.
struct FogState {
  bool enabled = false;
  FogMode mode = FogMode::exp;
  float density = 1.0f;
  float start = 0.0f;
  float end = 1.0f;
  std::array<float, 4> color{0, 0, 0, 0};
};

/// GL_TEXTURE_ENV_MODE (OpenGL 1.3, tables 3.22 and 3.23). `combine` uses the CombineState.
enum class TextureEnvMode : std::uint8_t { modulate, replace, add, decal, blend, combine };

/// The last two only of the colour channels: 4 Σ (a − ½)(b − ½) over R, G and B, for all three, or with alpha
/// for all four channels, whose own combination is then not asked for.
enum class CombineFunction : std::uint8_t {
  replace,
  modulate,
  add,
  add_signed,
  interpolate,
  subtract,
  dot3_rgb,
  dot3_rgba
};
enum class CombineSource : std::uint8_t { texture, constant, primary, previous };
enum class CombineOperand : std::uint8_t { color, one_minus_color, alpha, one_minus_alpha };

struct CombineChannel {
  CombineFunction function = CombineFunction::modulate;
  std::array<CombineSource, 3> source{CombineSource::texture, CombineSource::previous,
                                      CombineSource::constant};
  std::array<CombineOperand, 3> operand{CombineOperand::color, CombineOperand::color, CombineOperand::alpha};
  float scale = 1.0f;  ///< 1, 2 or 4
};

struct CombineState {
  CombineChannel rgb;
  CombineChannel alpha{CombineFunction::modulate,
                       {CombineSource::texture, CombineSource::previous, CombineSource::constant},
                       {CombineOperand::alpha, CombineOperand::alpha, CombineOperand::alpha},
                       1.0f};
};

/// What becomes of a unit's texels.
enum class TextureRole : std::uint8_t {
  environment,  ///< The texture environment works them into the colour.
  normal,       ///< Normals in tangent space, (2t − 1), before light.
  bump,         ///< Heights, the mean of R, G and B, whose slopes tilt the normal before light.
  occlusion,    ///< R: the share of ambient light that arrives.
  shine,        ///< Factors of the secondary colour, where that is added by itself.
};

/// How slopes tilt a normal (course T14; Blinn 1978).
enum class BumpForm : std::uint8_t {
  invariant,  ///< D' = a D |N|/|D|, a = √(F_u² + F_v²): the same at every size of the object.
  blinn,      ///< N' = N + D: heights and lengths of the object are of one unit.
};

inline constexpr int kMaxAnisotropy = 16;

/// One texture unit; off when it has neither a texture nor a procedure.
struct TextureUnit {
  TextureRole role = TextureRole::environment;
  const Texture* texture = nullptr;
  const TextureProcedure* procedure = nullptr;  ///< In place of a texture.
  Pattern pattern;                              ///< What the procedure makes.
  Mapping mapping;                              ///< Makes (s, t) of a point.
  TileChange tiles = TileChange::none;          ///< Of two-dimensional coordinates.
  MinFilter min_filter = MinFilter::nearest_mipmap_linear;
  MagFilter mag_filter = MagFilter::linear;
  float lod_bias = 0.0f;
  /// GL_TEXTURE_MAX_ANISOTROPY_EXT, in 1 … kMaxAnisotropy: the most samples along the longer side of the
  /// footprint. The filters of the footprint itself need none and leave it alone.
  int max_anisotropy = 1;
  TextureEnvMode env_mode = TextureEnvMode::modulate;
  CombineState combine;
  std::array<float, 4> env_color{0, 0, 0, 0};
  float strength = 1.0f;  ///< Of a map: scale of x and y of normals, height of white, share of the occlusion.
  BumpForm bump_form = BumpForm::invariant;
};

/// Whether the unit's filters follow the shape of the pixel's footprint, not only its size.
inline bool has_wide_filter(const TextureUnit& unit) {
  return unit.max_anisotropy > 1 || unit.min_filter == MinFilter::footprint ||
         unit.min_filter == MinFilter::corners;
}

/// What a unit's texture coordinates are made of.
enum class TexcoordKind : std::uint8_t {
  plain,       ///< 2 varyings (s, t): a two-dimensional texture.
  projective,  ///< 3 varyings (s, t, q): a two-dimensional texture sampled at (s/q, t/q).
  direct,      ///< 3 varyings (s, t, r): a direction into a cube map, or a place in a solid or mapping.
};
constexpr int floats_of(TexcoordKind kind) { return kind == TexcoordKind::plain ? 2 : 3; }

struct FragmentState {
  VaryingList varyings;
  std::vector<FragmentStage> stages{{.kind = &kTakeColors}};  ///< In order; see make_stages().
  std::array<TextureUnit, kMaxTextureUnits> texture_units;
  bool separate_specular = false;  ///< Add the secondary colour after texturing.
  bool clamp_colors = true;  ///< Clamp colours to [0, 1] before texturing and after each unit, as OpenGL 1.x.
  FogState fog;
  AlphaTest alpha_test;
  DepthState depth;
  PolygonOffset polygon_offset;
  BlendState blend;
  bool sorted =
      false;  ///< Blended by depth, pixel by pixel, in place of the order of drawing: pixel_layers.h
  std::array<bool, 4> color_mask{true, true, true, true};
  Scissor scissor;
};

inline bool all_channels(const std::array<bool, 4>& mask) { return mask[0] && mask[1] && mask[2] && mask[3]; }

/// Whether a fragment that passes its tests replaces what is behind it.
inline bool is_opaque(const FragmentState& state) {
  return !state.blend.enabled && !state.sorted && !state.alpha_test.enabled && all_channels(state.color_mask);
}

/// Whether a stage reads the unit.
inline bool is_active(const FragmentState& state, int unit) {
  for (const FragmentStage& stage : state.stages) {
    for (const Varying& read : stage.reads) {
      if (read.meaning == Meaning::texcoord && read.unit == unit && read.floats > 0) return true;
    }
  }
  return false;
}

/// Whether that unit reads a picture.
inline bool has_picture(const FragmentState& state, int unit) {
  return is_active(state, unit) && state.texture_units[static_cast<std::size_t>(unit)].procedure == nullptr;
}

/// Whether a stage makes the primary colour before it is taken: neither vertices nor primitives give it.
inline bool is_lit(const FragmentState& state) {
  for (const FragmentStage& stage : state.stages) {
    if (stage.kind == &kTakeColors) break;
    if ((stage.kind->writes & set_of(Meaning::color)) != 0) return true;
  }
  return false;
}

/// Whether a unit's coordinates are a point in space, of a procedure or to be mapped.
inline bool has_point(const FragmentState& state, int unit) {
  const TextureUnit& texture = state.texture_units[static_cast<std::size_t>(unit)];
  const bool is_mapped = texture.mapping.surface != MappingSurface::none;
  return is_mapped || (texture.procedure != nullptr && state.varyings.floats(Meaning::texcoord, unit) == 3);
}

/// What a unit's coordinates are when its texture is looked up: a mapping has made two of its point.
inline TexcoordKind texcoord_kind(const FragmentState& state, int unit) {
  const TextureUnit& texture = state.texture_units[static_cast<std::size_t>(unit)];
  const bool is_mapped = texture.mapping.surface != MappingSurface::none;
  if (is_mapped || state.varyings.floats(Meaning::texcoord, unit) == 2) return TexcoordKind::plain;
  const bool is_picture = texture.procedure == nullptr && !texture.texture->is_cube();
  return is_picture ? TexcoordKind::projective : TexcoordKind::direct;
}

/// Whether a unit's coordinates are changed tile by tile: those of a picture that colours.
inline bool changes_tiles(const FragmentState& state, int unit) {
  const TextureUnit& texture = state.texture_units[static_cast<std::size_t>(unit)];
  return texture.tiles != TileChange::none && texture.procedure == nullptr &&
         texture.role == TextureRole::environment && texcoord_kind(state, unit) == TexcoordKind::plain;
}

}  // namespace barrido::raster
