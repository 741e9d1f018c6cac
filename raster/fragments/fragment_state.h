// Everything about a draw that the fragment stage must know, as plain structs whose initialisers are OpenGL's
// defaults (OpenGL 1.3 specification, tables 6.14 to 6.20). Constant over one chunk of primitives.
#pragma once

#include <array>
#include <cstdint>

#include "raster/textures/texture.h"

namespace barrido::raster {

inline constexpr int kMaxTextureUnits = 4;
inline constexpr int kMaxLights = 64;
/// Largest number of varyings a vertex carries: cheap Phong's two dot products a light, and 32 others.
inline constexpr int kMaxVaryings = 2 * kMaxLights + 32;

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

enum class CombineFunction : std::uint8_t { replace, modulate, add, add_signed, interpolate, subtract };
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

/// One texture unit; `texture` null means the unit is off.
struct TextureUnit {
  const Texture* texture = nullptr;
  MinFilter min_filter = MinFilter::nearest_mipmap_linear;
  MagFilter mag_filter = MagFilter::linear;
  float lod_bias = 0.0f;
  TextureEnvMode env_mode = TextureEnvMode::modulate;
  CombineState combine;
  std::array<float, 4> env_color{0, 0, 0, 0};
};

inline constexpr int kAbsent = -1;

/// What a unit's texture coordinates are made of.
enum class TexcoordKind : std::uint8_t {
  plain,       ///< 2 varyings (s, t): a two-dimensional texture.
  projective,  ///< 3 varyings (s, t, q): a two-dimensional texture sampled at (s/q, t/q).
  cube,        ///< 3 varyings (s, t, r): a direction into a cube map.
};

/// What a vertex record carries after depth and 1/w, as offsets in floats. The first `affine_count` varyings
/// are linear on the screen; the others are stored divided by w and are perspective-correct:
/// f = Σ(b f/w) / Σ(b/w) (OpenGL 1.3, eq. 3.6).
struct VaryingLayout {
  int color = kAbsent;         ///< 4: primary colour; absent when the primitive's flat colour is used.
  int specular = kAbsent;      ///< 3: secondary colour, added after texturing; absent when flat or unused.
  int normal = kAbsent;        ///< 3: eye-space normal (Phong).
  int eye_position = kAbsent;  ///< 3: eye-space position (Phong with local lights or viewer).
  int dots = kAbsent;          ///< 2 a light: N·L and R·V (or its power) (cheap Phong, S7).
  int fog = kAbsent;           ///< 1: eye-space z, or any value whose magnitude is the fog distance.
  std::array<int, kMaxTextureUnits> texcoord{kAbsent, kAbsent, kAbsent, kAbsent};
  std::array<TexcoordKind, kMaxTextureUnits> texcoord_kind{};
  int count = 0;         ///< Varyings in all, at most kMaxVaryings.
  int affine_count = 0;  ///< How many of them, from the first, are linear on the screen.
};

struct FragmentBatch;

/// Per-fragment illumination (Phong, cheap Phong), supplied by whoever knows lights: reads the batch's
/// varyings, writes its primary and secondary colours. Must treat every fragment alike, whatever its place in
/// the batch.
struct FragmentIllumination {
  using Function = void (*)(const void* parameters, FragmentBatch& batch);
  Function function = nullptr;  ///< Null: colours come from the varyings or the flat values.
  const void* parameters = nullptr;
};

struct FragmentState {
  VaryingLayout varyings;
  FragmentIllumination illumination;
  std::array<TextureUnit, kMaxTextureUnits> texture_units;
  bool separate_specular = false;  ///< Add the secondary colour after texturing.
  bool clamp_colors = true;  ///< Clamp colours to [0, 1] before texturing and after each unit, as OpenGL 1.x.
  FogState fog;
  AlphaTest alpha_test;
  DepthState depth;
  PolygonOffset polygon_offset;
  BlendState blend;
  std::array<bool, 4> color_mask{true, true, true, true};
  Scissor scissor;
};

inline bool all_channels(const std::array<bool, 4>& mask) { return mask[0] && mask[1] && mask[2] && mask[3]; }

/// Whether a fragment that passes its tests replaces what is behind it.
inline bool is_opaque(const FragmentState& state) {
  return !state.blend.enabled && !state.alpha_test.enabled && all_channels(state.color_mask);
}

/// Whether a texture unit takes part: it has a texture, and coordinates of the texture's kind.
inline bool is_active(const FragmentState& state, int unit) {
  const auto u = static_cast<std::size_t>(unit);
  const Texture* texture = state.texture_units[u].texture;
  return texture != nullptr && state.varyings.texcoord[u] != kAbsent &&
         texture->is_cube() == (state.varyings.texcoord_kind[u] == TexcoordKind::cube);
}

}  // namespace barrido::raster
