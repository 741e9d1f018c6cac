#include "pipeline/scene/material_conversion.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

constexpr float kDielectricReflectance = 0.04f;
/// Pictures of metalness are seldom quite black: less than this is no metal.
constexpr float kLeastMetallic = 0.05f;

/// Without metalness (specular-glossiness), what mirrors as much counts as metal.
constexpr float kLeastMirror = 0.2f;

float largest(const glm::vec3& color) { return std::max({color.r, color.g, color.b}); }

/// Reflectance of the dielectric at normal incidence: ((n − 1)/(n + 1))² (KHR_materials_ior), times the
/// specular colour and factor (KHR_materials_specular, section "Implementation"), or as specular-glossiness
/// gives it.
glm::vec3 dielectric_reflectance(const MaterialLayers* layers) {
  if (layers == nullptr) return glm::vec3(kDielectricReflectance);
  if (layers->specular_glossiness) return glm::min(layers->specular_glossiness->specular, glm::vec3(1.0f));
  const float ratio = (layers->ior - 1.0f) / (layers->ior + 1.0f);
  const float f0 = layers->ior == 1.5f ? kDielectricReflectance : ratio * ratio;
  return glm::min(layers->specular_color * f0, glm::vec3(1.0f)) * layers->specular;
}

/// Reflectance of a thin film over a surface of reflectance `f0`, at normal incidence, at the dominant
/// wavelengths of sRGB's primaries (Airy's sum; Born and Wolf, Principles of Optics, section 1.6.4).
glm::vec3 film_reflectance(const glm::vec3& f0, float ior, float thickness_nm) {
  glm::vec3 result;
  for (int c = 0; c < 3; ++c) {
    const double root = std::sqrt(std::clamp(double{f0[c]}, 0.0, 0.9999));
    const double below = (1.0 + root) / (1.0 - root);  // The surface's own index of refraction
    const double r1 = (1.0 - ior) / (1.0 + ior), r2 = (ior - below) / (ior + below);
    const double turns =
        2.0 * double{ior} * thickness_nm / kPrimaryWavelengthsNm[static_cast<std::size_t>(c)];
    const double phase = portable_cos(2.0 * kPi * (turns - std::floor(turns)));
    const double mixed = 2.0 * r1 * r2 * phase, product = r1 * r1 * r2 * r2;
    result[c] = static_cast<float>((r1 * r1 + r2 * r2 + mixed) / (1.0 + product + mixed));
  }
  return result;
}

glm::vec3 with_film(const glm::vec3& f0, const MaterialLayers* layers) {
  if (layers == nullptr || layers->iridescence == 0.0f) return f0;
  return glm::mix(f0, film_reflectance(f0, layers->iridescence_ior, layers->iridescence_thickness_nm),
                  layers->iridescence);
}

/// α² of the lobe. An anisotropic one is as wide as αt = lerp(α, 1, strength²) along the one axis and α along
/// the other (KHR_materials_anisotropy); a round lobe of the same solid angle has the product.
float squared_width(float roughness, const MaterialLayers* layers) {
  if (layers == nullptr || layers->anisotropy == 0.0f) return roughness * roughness * roughness * roughness;
  const float alpha = roughness * roughness;
  return alpha * glm::mix(alpha, 1.0f, layers->anisotropy * layers->anisotropy);
}

/// Sheen is a lobe at grazing angles, which k_d must stand for.
glm::vec3 with_sheen(const glm::vec3& kd, const MaterialLayers* layers) {
  if (layers == nullptr) return kd;
  return kd * (1.0f - kSheenAlbedo * std::min(largest(layers->sheen_color), 1.0f)) +
         layers->sheen_color * kSheenAlbedo;
}

float fraction(float value) { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; }

/// The lobe of a mirror is as narrow as a highlight of this exponent.
constexpr float kSmoothest = 2048.0f;

float shininess_of(float alpha_squared, float max_shininess) {
  // Limited as α², since a smooth surface would divide by zero.
  return 2.0f / std::max(alpha_squared, 2.0f / (max_shininess + 2.0f)) - 2.0f;
}

/// What a clear coat lets through.
void cover(SurfaceCoefficients& surface, float share) {
  surface.diffuse = glm::vec4(glm::vec3(surface.diffuse) * share, surface.diffuse.a);
  surface.ambient *= share;
  surface.specular *= share;
  surface.emission *= share;
}

void apply_exact(const ExactMaterial& exact, SurfaceCoefficients& surface) {
  if (exact.diffuse) {
    surface.diffuse = glm::vec4(*exact.diffuse, surface.diffuse.a);
    surface.ambient = *exact.diffuse;
    surface.specular = glm::vec3(0.0f);
  }
  if (exact.ambient) surface.ambient = *exact.ambient;
  if (exact.specular) surface.specular = *exact.specular;
  if (exact.emission) surface.emission = *exact.emission;
  if (exact.shininess) surface.shininess = std::max(*exact.shininess, 0.0f);
}

bool reflects(Reflections reflections, bool metal, const ExactMaterial& exact) {
  if (exact.diffuse || exact.specular) return false;
  return reflections == Reflections::all || (reflections == Reflections::metals && metal);
}

}  // namespace

SurfaceCoefficients convert_material(const Material& material, const SurfaceContext& context,
                                     Reflections reflections, const ConversionLimits& limits) {
  const glm::vec3 base(material.base_color);
  const float metallic = context.vertex_colors ? 0.0f : fraction(material.metallic * context.metallic);
  const float roughness = fraction(material.roughness * context.roughness);
  const MaterialLayers* layers = material.layers.get();
  const glm::vec3 dielectric = dielectric_reflectance(layers);

  SurfaceCoefficients surface;
  const float wide = squared_width(roughness, layers);  // α²
  surface.shininess = shininess_of(wide, limits.max_shininess);
  surface.reflection_exponent = phong_shininess(shininess_of(wide, kSmoothest));
  const glm::vec3 f0 = with_film(glm::mix(dielectric, base * context.base_color, metallic), layers);
  surface.specular = f0 * ((1.0f - wide) * (surface.shininess + 2.0f) / 8.0f);
  // The base colour texture will multiply this, so its mean must not.
  const glm::vec3 wide_lobe = with_film(glm::mix(dielectric, base, metallic), layers) * wide;
  const float left = layers != nullptr ? 1.0f - largest(dielectric) : 1.0f - kDielectricReflectance;
  const float opacity = layers != nullptr ? 1.0f - layers->transmission : 1.0f;
  const glm::vec3 kd = with_sheen(base * (left * (1.0f - metallic) * opacity) + wide_lobe, layers);

  const bool mirrors = layers != nullptr && largest(dielectric) >= kLeastMirror;
  if (reflects(reflections, metallic >= kLeastMetallic || mirrors, material.exact)) {
    surface.reflection_before_texture = metallic >= 0.5f;
    const glm::vec3 share = surface.reflection_before_texture ? base * metallic : f0;
    surface.reflectance = glm::clamp(share * (1.0f - wide), glm::vec3(0.0f), glm::vec3(1.0f));
  }
  // 1 − reflectance is 0 only for a perfect mirror, whose k_d hardly matters.
  const glm::vec3 through = glm::max(1.0f - surface.reflectance, glm::vec3(1.0f / 16.0f));
  surface.diffuse = glm::vec4(kd / through, material.base_color.a);
  surface.ambient = glm::vec3(surface.diffuse);
  surface.emission = material.emissive;
  if (layers != nullptr && layers->clearcoat > 0.0f) {
    cover(surface, 1.0f - kDielectricReflectance * layers->clearcoat);
  }
  apply_exact(material.exact, surface);
  if (limits.clamp_to_one) surface.specular = glm::clamp(surface.specular, glm::vec3(0.0f), glm::vec3(1.0f));
  return surface;
}

glm::vec3 transmitted(const Material& material, float scale) {
  const MaterialLayers& layers = *material.layers;
  glm::vec3 light = glm::vec3(material.base_color) * (1.0f - largest(dielectric_reflectance(&layers))) *
                    (1.0f - fraction(material.metallic));
  if (!(layers.attenuation_distance > 0.0f)) return light;
  const float depth = layers.thickness * scale / layers.attenuation_distance;
  for (int c = 0; c < 3; ++c) {
    const float color = std::max(layers.attenuation_color[c], 1e-6f);
    light[c] *= portable_pow(color, depth);
  }
  return light;
}

Material clearcoat_of(const Material& material) {
  auto layers = std::make_shared<MaterialLayers>();
  layers->specular = material.layers->clearcoat;
  Material coat;
  coat.base_color = glm::vec4(0, 0, 0, 1);
  coat.metallic = 0.0f;
  coat.roughness = material.layers->clearcoat_roughness;
  coat.double_sided = material.double_sided;
  coat.layers = std::move(layers);
  return coat;
}

}  // namespace barrido::scene
