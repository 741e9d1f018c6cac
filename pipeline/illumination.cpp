#include "pipeline/illumination.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "pipeline/bounded.h"
#include "raster/base/portable_math.h"

namespace barrido::pipeline {
namespace {

glm::vec3 unit(const glm::vec3& v) {
  const glm::dvec3 d(bounded(glm::dvec3(v)));
  const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  return length > 0.0 ? glm::vec3(d / length) : glm::vec3(0.0f);
}

double dot(const glm::vec3& a, const glm::vec3& b) {
  return static_cast<double>(a.x) * b.x + static_cast<double>(a.y) * b.y + static_cast<double>(a.z) * b.z;
}

/// A property of the material: its own value, or what takes its place when it tracks the vertex colour.
struct Property {
  std::array<glm::vec3, 2> value;
  bool tracked = false;
};

/// The material of both sides with GL_COLOR_MATERIAL resolved.
struct ResolvedMaterial {
  Property ambient, diffuse, specular, emission;
  std::array<float, 2> alpha;
};

ResolvedMaterial resolve(const Lighting& lighting, const glm::vec4* constant_color) {
  ResolvedMaterial m;
  const std::array<const Material*, 2> sides{&lighting.front,
                                             lighting.two_sided ? &lighting.back : &lighting.front};
  for (std::size_t side = 0; side < 2; ++side) {
    m.ambient.value[side] = glm::vec3(sides[side]->ambient);
    m.diffuse.value[side] = glm::vec3(sides[side]->diffuse);
    m.specular.value[side] = glm::vec3(sides[side]->specular);
    m.emission.value[side] = glm::vec3(sides[side]->emission);
    m.alpha[side] = bounded(sides[side]->diffuse.a);
  }
  const auto track = [&](Property& property) {
    property.tracked = constant_color == nullptr;
    if (constant_color != nullptr) property.value.fill(glm::vec3(*constant_color));
  };
  const ColorMaterial which = lighting.color_material;
  const bool both = which == ColorMaterial::ambient_and_diffuse;
  if (which == ColorMaterial::ambient || both) track(m.ambient);
  if (which == ColorMaterial::diffuse || both) {
    track(m.diffuse);
    if (constant_color != nullptr) m.alpha.fill(bounded(constant_color->a));
  }
  if (which == ColorMaterial::specular) track(m.specular);
  if (which == ColorMaterial::emission) track(m.emission);
  return m;
}

/// Adds light × property × factor to the products.
void add_product(LightProducts& products, const glm::vec3& light, const Property& property, double factor) {
  const glm::dvec3 color = glm::dvec3(bounded(glm::dvec3(light))) * factor;
  for (std::size_t side = 0; side < 2; ++side) {
    glm::vec3& into = property.tracked ? products.tracked[side] : products.fixed[side];
    const glm::dvec3 value =
        property.tracked ? glm::dvec3(1.0) : glm::dvec3(bounded(glm::dvec3(property.value[side])));
    into = bounded(glm::dvec3(into) + color * value);
  }
}

void set_cone(IlluminatingLight& out, const Light& light) {
  const bool soft = light.spot_outer_cos < light.spot_inner_cos;
  out.has_cone = light.spot_cutoff_deg != 180.0f || soft;
  out.spot_direction = unit(light.spot_direction);
  if (light.spot_cutoff_deg != 180.0f) {
    out.cos_cutoff = static_cast<float>(portable_cos(radians(light.spot_cutoff_deg)));
  }
  if (soft) {
    const double scale =
        1.0 / std::max(0.001, static_cast<double>(light.spot_inner_cos) - light.spot_outer_cos);
    out.falloff = SpotFalloff::soft;
    out.soft_scale = bounded(scale);
    out.soft_offset = bounded(-light.spot_outer_cos * scale);
  } else if (out.has_cone && light.spot_exponent != 0.0f) {
    out.falloff = SpotFalloff::exponent;
    out.spot_exponent = bounded(light.spot_exponent);
  }
}

/// The spot factor of a directional light, which is the same everywhere.
double constant_spot_factor(const IlluminatingLight& light) {
  if (!light.has_cone) return 1.0;
  const double cosine = -dot(light.to_light, light.spot_direction);
  if (cosine < light.cos_cutoff) return 0.0;
  if (light.falloff == SpotFalloff::exponent) {
    return portable_pow(static_cast<float>(cosine), light.spot_exponent);
  }
  if (light.falloff == SpotFalloff::none) return 1.0;
  const double s = std::clamp(cosine * light.soft_scale + light.soft_offset, 0.0, 1.0);
  return s * s;
}

void set_place(IlluminatingLight& out, const Light& light) {
  const glm::dvec3 p(bounded(glm::dvec4(light.position)));
  out.directional = light.position.w == 0.0f;
  if (!out.directional) {
    out.position = bounded(p / static_cast<double>(light.position.w));
    return;
  }
  out.to_light = unit(glm::vec3(p));
  out.half_vector = unit(out.to_light + glm::vec3(0, 0, 1));
}

/// Attenuation and range. @return the factor where it is the same everywhere, else 1.
double set_weakening(IlluminatingLight& out, const Light& light) {
  if (out.directional) {
    const double factor = constant_spot_factor(out);
    out.has_cone = false;
    return factor;
  }
  out.constant_attenuation = bounded(light.constant_attenuation);
  out.linear_attenuation = bounded(light.linear_attenuation);
  out.quadratic_attenuation = bounded(light.quadratic_attenuation);
  out.inverse_range = light.range > 0.0f ? bounded(1.0 / light.range) : 0.0f;
  out.weakens = out.has_cone || out.inverse_range > 0.0f || out.linear_attenuation != 0.0f ||
                out.quadratic_attenuation != 0.0f;
  return out.weakens ? 1.0 : 1.0 / std::max(static_cast<double>(out.constant_attenuation), 1e-12);
}

IlluminatingLight compile_light(const Light& light, const ResolvedMaterial& material, LightProducts& base) {
  const float cutoff = light.spot_cutoff_deg;
  if (!((cutoff >= 0.0f && cutoff <= 90.0f) || cutoff == 180.0f)) {
    throw std::invalid_argument("a light's cut-off must be in [0, 90] degrees, or 180");
  }
  if (!(light.spot_exponent >= 0.0f))
    throw std::invalid_argument("a light's spot exponent must not be negative");
  IlluminatingLight out;
  set_place(out, light);
  set_cone(out, light);
  const double factor = set_weakening(out, light);
  add_product(out.weakens ? out.ambient : base, glm::vec3(light.ambient), material.ambient, factor);
  add_product(out.diffuse, glm::vec3(light.diffuse), material.diffuse, factor);
  add_product(out.specular, glm::vec3(light.specular), material.specular, factor);
  for (std::size_t side = 0; side < 2; ++side) {
    out.shines[side] =
        out.specular.fixed[side] != glm::vec3(0.0f) || out.specular.tracked[side] != glm::vec3(0.0f);
  }
  return out;
}

}  // namespace

int Illumination::powers_per_point(int side) const {
  const auto s = static_cast<std::size_t>(side);
  int powers = 0;
  for (const IlluminatingLight& light : lights) {
    powers += light.shines[s] && shininess[s] != 0.0f;
    powers += light.weakens && light.falloff == SpotFalloff::exponent;
  }
  return powers;
}

Illumination compile_illumination(const Lighting& lighting, const glm::vec4* constant_color) {
  if (lighting.lights.size() > static_cast<std::size_t>(raster::kMaxLights)) {
    throw std::invalid_argument("at most " + std::to_string(raster::kMaxLights) + " lights can be on");
  }
  const ResolvedMaterial material = resolve(lighting, constant_color);
  Illumination out;
  out.specular_model = lighting.specular_model;
  out.two_sided = lighting.two_sided;
  out.separate_specular = lighting.separate_specular;
  out.alpha = material.alpha;
  out.tracks_alpha = material.diffuse.tracked;
  out.tracks_color = material.ambient.tracked || material.diffuse.tracked || material.specular.tracked ||
                     material.emission.tracked;
  out.shininess = {lighting.front.shininess,
                   lighting.two_sided ? lighting.back.shininess : lighting.front.shininess};
  for (float& n : out.shininess) {
    if (!(n >= 0.0f)) throw std::invalid_argument("a material's shininess must not be negative");
    n = bounded(n);
  }
  add_product(out.base, glm::vec3(1.0f), material.emission, 1.0);
  out.emission = out.base;
  add_product(out.base, glm::vec3(lighting.ambient), material.ambient, 1.0);
  out.lights.reserve(lighting.lights.size());
  bool shines = false, near = false;
  for (const Light& light : lighting.lights) {
    out.lights.push_back(compile_light(light, material, out.base));
    shines |= out.lights.back().shines[0] || out.lights.back().shines[1];
    near |= !out.lights.back().directional;
  }
  out.local_viewer = lighting.local_viewer && shines;
  out.needs_position = out.local_viewer || near;
  return out;
}

}  // namespace barrido::pipeline
