#include "pipeline/scene/material_conversion.h"

#include <algorithm>

#include <glm/common.hpp>

namespace barrido::scene {
namespace {

constexpr float kDielectricReflectance = 0.04f;
/// Pictures of metalness are seldom quite black: less than this is no metal.
constexpr float kLeastMetallic = 0.05f;

float fraction(float value) { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; }

/// The lobe of a mirror is as narrow as a highlight of this exponent.
constexpr float kSmoothest = 2048.0f;

float shininess_of(float alpha_squared, float max_shininess) {
  // Limited as α², since a smooth surface would divide by zero.
  return 2.0f / std::max(alpha_squared, 2.0f / (max_shininess + 2.0f)) - 2.0f;
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
  const glm::vec3 dielectric(kDielectricReflectance);

  SurfaceCoefficients surface;
  const float wide = roughness * roughness * roughness * roughness;  // α²
  surface.shininess = shininess_of(wide, limits.max_shininess);
  surface.reflection_exponent = phong_shininess(shininess_of(wide, kSmoothest));
  const glm::vec3 f0 = glm::mix(dielectric, base * context.base_color, metallic);
  surface.specular = f0 * ((1.0f - wide) * (surface.shininess + 2.0f) / 8.0f);
  // The base colour texture will multiply this, so its mean must not.
  const glm::vec3 wide_lobe = glm::mix(dielectric, base, metallic) * wide;
  const glm::vec3 kd = base * ((1.0f - kDielectricReflectance) * (1.0f - metallic)) + wide_lobe;

  if (reflects(reflections, metallic >= kLeastMetallic, material.exact)) {
    surface.reflection_before_texture = metallic >= 0.5f;
    const glm::vec3 share = surface.reflection_before_texture ? base * metallic : f0;
    surface.reflectance = glm::clamp(share * (1.0f - wide), glm::vec3(0.0f), glm::vec3(1.0f));
  }
  // 1 − reflectance is 0 only for a perfect mirror, whose k_d hardly matters.
  const glm::vec3 through = glm::max(1.0f - surface.reflectance, glm::vec3(1.0f / 16.0f));
  surface.diffuse = glm::vec4(kd / through, material.base_color.a);
  surface.ambient = glm::vec3(surface.diffuse);
  surface.emission = material.emissive;
  apply_exact(material.exact, surface);
  if (limits.clamp_to_one) surface.specular = glm::clamp(surface.specular, glm::vec3(0.0f), glm::vec3(1.0f));
  return surface;
}

}  // namespace barrido::scene
