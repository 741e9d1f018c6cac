// From a glTF material (metallic-roughness) to the numbers of the fixed-function model. Enters: the material
// and the means of its pictures; leaves: reflection coefficients. Knows no textures, no state and no lights.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/scene/scene.h"

namespace barrido::scene {

/// What has to be known of a material's use: means over all texels of its pictures, 1 where there is none.
struct SurfaceContext {
  glm::vec3 base_color{1, 1, 1};  ///< In the light that the frame is computed in
  float roughness = 1.0f;         ///< G of the metallic-roughness picture
  float metallic = 1.0f;          ///< B of the metallic-roughness picture
  bool vertex_colors = false;     ///< The primitive has its own colours
};

/// Limits of the target: OpenGL's (none) or only those of good sense (srgb, a float frame).
struct ConversionLimits {
  float max_shininess = 2048.0f;
  bool clamp_to_one = false;  ///< Specular coefficients, as OpenGL's colours
};

/// Coefficients of one material. What reflects an environment map is blended in by a texture unit as
/// lit·(1 − reflectance) + map·reflectance, so `diffuse` is divided by (1 − reflectance) beforehand.
struct SurfaceCoefficients {
  glm::vec4 diffuse{1, 1, 1, 1};  ///< k_d, and the alpha of lit colours
  glm::vec3 ambient{1, 1, 1};     ///< k_a
  glm::vec3 specular{0, 0, 0};    ///< k_s
  glm::vec3 emission{0, 0, 0};
  float shininess = 0.0f;  ///< n of Blinn's (N·H)^n; a quarter of it for Phong's (R·V)^n, see below
  /// Exponent of the lobe that gathers the environment, max(0, R·x)^n; not limited as shininess is.
  float reflection_exponent = 0.0f;
  glm::vec3 reflectance{0, 0, 0};
  /// The environment is reflected below the base colour texture, which then colours the reflection (metals).
  bool reflection_before_texture = false;
};

/// The part of light from everywhere that a sheen of colour 1 sends back, the mean of all roughnesses and
/// directions (Estevez and Kulla 2017; three.js takes the same number for their table).
inline constexpr float kSheenAlbedo = 0.157f;

/// Dominant wavelengths of sRGB's primaries: red, green, blue.
inline constexpr std::array<double, 3> kPrimaryWavelengthsNm{611.4, 549.1, 464.2};

/// How reflections of surroundings are to be had.
enum class Reflections : std::uint8_t {
  none,
  metals,  ///< Only where there would be nothing to see without.
  all,     ///< Every lit surface, by its reflectance at normal incidence.
};

/// The conversion of metallic-roughness: k_d = b(1 − 0.04)(1 − m), F0 = lerp(0.04, b, m), n = 2/α² − 2 with
/// α = r² (Karis 2013), k_s = F0 (n + 2)/8, and F0 of the environment is reflected. The factor N·L that
/// belongs to k_s is missing from fixed function; the wider the lobe the more it matters, and the less a lobe
/// differs from diffuse reflection. So the share α² = 2/(n + 2) of F0 goes to k_d, and 1 − α² of it is left
/// for k_s and the environment: a rough metal answers to the lights as chalk does, a smooth one is a mirror.
/// Metals with vertex colours are treated as painted: no texture unit could colour their reflection. Exact
/// MaterialLayers change F0, α and what is left for k_d, as docs/scene.md tells; a clear coat and what is
/// seen through glass are draws of their own. Exact coefficients of the file (extras.barrido) replace what
/// they name; a material whose diffuse or specular is exact reflects no environment.
SurfaceCoefficients convert_material(const Material& material, const SurfaceContext& context,
                                     Reflections reflections, const ConversionLimits& limits);

/// Light that comes through a material with transmission, of what is behind it: base colour, times what its
/// volume leaves of light, T = attenuationColor^(thickness / attenuationDistance) (KHR_materials_volume),
/// times what neither is mirrored nor metal. `scale`: of the mesh's units to the world's.
glm::vec3 transmitted(const Material& material, float scale);

/// A clear coat by itself (KHR_materials_clearcoat): a black dielectric, whose F0 of 0.04 is weighted by the
/// coat.
Material clearcoat_of(const Material& material);

/// Exponent of (R·V)^n that makes a highlight as wide as (N·H)^`blinn_shininess`.
inline float phong_shininess(float blinn_shininess) { return blinn_shininess * 0.25f; }

}  // namespace barrido::scene
