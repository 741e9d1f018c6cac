// The illumination equation evaluated plainly, in double precision and with the C library, straight from the
// state: the one oracle that kernels and pictures are compared with. Knows the state's structs and shares no
// code with pipeline/.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/state.h"

namespace barrido::oracle {

using pipeline::ColorMaterial;
using pipeline::Light;
using pipeline::Lighting;
using pipeline::Material;
using pipeline::SpecularModel;

struct Color {
  glm::dvec3 primary{0};
  glm::dvec3 secondary{0};
  double alpha = 1;
};

inline glm::dvec3 rgb(const glm::vec4& v) { return {v.x, v.y, v.z}; }

/// Weakening by distance, range and cone; `l` points to the light.
inline double factor(const Light& light, const glm::dvec3& l, double d) {
  double f = 1.0;
  if (light.position.w != 0.0f) {
    f = 1.0 /
        (light.constant_attenuation + light.linear_attenuation * d + light.quadratic_attenuation * d * d);
    if (light.range > 0.0f) f *= std::max(std::min(1.0 - std::pow(d / light.range, 4.0), 1.0), 0.0);
  }
  const double c = -glm::dot(l, glm::normalize(glm::dvec3(light.spot_direction)));
  if (light.spot_cutoff_deg != 180.0f && c < std::cos(light.spot_cutoff_deg * M_PI / 180.0)) return 0.0;
  if (light.spot_outer_cos < light.spot_inner_cos) {
    const double width = std::max(0.001, static_cast<double>(light.spot_inner_cos) - light.spot_outer_cos);
    const double t = std::clamp((c - light.spot_outer_cos) / width, 0.0, 1.0);
    return f * t * t;
  }
  if (light.spot_cutoff_deg != 180.0f) f *= std::pow(std::max(c, 0.0), light.spot_exponent);
  return f;
}

struct Point {
  glm::dvec3 normal{0, 0, 1};
  glm::dvec3 position{0, 0, -1};
  glm::dvec4 color{1};
  bool back = false;
};

inline Material material_at(const Lighting& lighting, const Point& point) {
  Material m = point.back && lighting.two_sided ? lighting.back : lighting.front;
  const glm::vec4 c(point.color);
  switch (lighting.color_material) {
    case ColorMaterial::none:
      break;
    case ColorMaterial::ambient:
      m.ambient = c;
      break;
    case ColorMaterial::diffuse:
      m.diffuse = c;
      break;
    case ColorMaterial::ambient_and_diffuse:
      m.ambient = m.diffuse = c;
      break;
    case ColorMaterial::specular:
      m.specular = c;
      break;
    case ColorMaterial::emission:
      m.emission = c;
      break;
  }
  return m;
}

/// Towards the light; and the distance.
inline glm::dvec3 direction(const Light& light, const glm::dvec3& position, double& distance) {
  const glm::dvec3 p = rgb(light.position);
  distance = 0.0;
  if (light.position.w == 0.0f) return glm::normalize(p);
  const glm::dvec3 towards = p / static_cast<double>(light.position.w) - position;
  distance = glm::length(towards);
  return towards / distance;
}

inline double highlight(const Lighting& lighting, const glm::dvec3& n, const glm::dvec3& l,
                        const glm::dvec3& position) {
  const glm::dvec3 v = lighting.local_viewer ? glm::normalize(-position) : glm::dvec3(0, 0, 1);
  if (lighting.specular_model == SpecularModel::blinn) return glm::dot(n, glm::normalize(l + v));
  return glm::dot(2.0 * glm::dot(n, l) * n - l, v);
}

/// OpenGL 1.3, equation 2.4, with the course's extensions; not clamped.
inline Color illuminate(const Lighting& lighting, const Point& point) {
  const Material m = material_at(lighting, point);
  const glm::dvec3 n = point.back && lighting.two_sided ? -point.normal : point.normal;
  Color color;
  color.primary = rgb(m.emission) + rgb(lighting.ambient) * rgb(m.ambient);
  color.alpha = m.diffuse.a;
  for (const Light& light : lighting.lights) {
    double d = 0.0;
    const glm::dvec3 l = direction(light, point.position, d);
    const double f = factor(light, l, d);
    const double n_dot_l = glm::dot(n, l);
    color.primary += f * (rgb(light.ambient) * rgb(m.ambient) +
                          std::max(n_dot_l, 0.0) * rgb(light.diffuse) * rgb(m.diffuse));
    if (n_dot_l <= 0.0) continue;
    const double h = std::max(highlight(lighting, n, l, point.position), 0.0);
    const float shininess = (point.back && lighting.two_sided ? lighting.back : lighting.front).shininess;
    color.secondary += f * std::pow(h, shininess) * rgb(light.specular) * rgb(m.specular);
  }
  if (!lighting.separate_specular) {
    color.primary += color.secondary;
    color.secondary = glm::dvec3(0);
  }
  return color;
}

}  // namespace barrido::oracle
