#include "pipeline/reference/illumination.h"

#include <algorithm>
#include <cmath>

#include "pipeline/bounded.h"
#include "pipeline/cheap_phong.h"
#include "raster/base/portable_math.h"

namespace barrido::pipeline::reference {
namespace {

// Sums of products in the order that is written here; the C++ library and glm may choose another.
float dot(const glm::vec3& a, const glm::vec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
float positive(float value) { return value > 0.0f ? value : 0.0f; }

constexpr float kMinSquare = 1e-30f;  // squares of lengths below this count as it
float inverse_length(float square) { return 1.0f / std::sqrt(std::max(square, kMinSquare)); }
glm::vec3 normalized(const glm::vec3& v) { return v * inverse_length(dot(v, v)); }

std::size_t side_of(const Illumination& illumination, bool back) {
  return back && illumination.two_sided ? 1 : 0;
}

struct Surface {
  glm::vec3 normal, position, to_viewer{0, 0, 1};
};

Surface surface_of(const Illumination& illumination, const SurfacePoint& point) {
  Surface s{point.normal, point.position};
  if (point.normalize) s.normal = normalized(s.normal);
  if (point.back && illumination.two_sided) s.normal = -s.normal;
  if (illumination.local_viewer) s.to_viewer = normalized(-s.position);
  return s;
}

/// Blinn (L9): N·H with H = (L + V)/|L + V|.
float blinn_highlight(const Surface& s, const glm::vec3& l, bool local_viewer) {
  const glm::vec3 h = local_viewer ? l + s.to_viewer : glm::vec3(l.x, l.y, l.z + 1.0f);
  return dot(s.normal, h) * inverse_length(dot(h, h));
}

/// Phong (L3): R·V = 2 (N·L)(N·V) − L·V.
float phong_highlight(const Surface& s, const glm::vec3& l, float n_dot_l, bool local_viewer) {
  const float n_dot_v = local_viewer ? dot(s.normal, s.to_viewer) : s.normal.z;
  const float l_dot_v = local_viewer ? dot(l, s.to_viewer) : l.z;
  return (n_dot_l + n_dot_l) * n_dot_v - l_dot_v;
}

/// Spot factor for c = −L · direction.
float spot_factor(const IlluminatingLight& light, float c) {
  if (!(c >= light.cos_cutoff)) return 0.0f;
  if (light.falloff == SpotFalloff::exponent) return portable_pow(positive(c), light.spot_exponent);
  if (light.falloff == SpotFalloff::none) return 1.0f;
  const float t = std::min(positive(c * light.soft_scale + light.soft_offset), 1.0f);
  return t * t;
}

/// Attenuation, range and cone at distance `d` in direction `l`.
float weakening(const IlluminatingLight& light, float d, const glm::vec3& l) {
  const float denominator =
      (light.constant_attenuation + light.linear_attenuation * d) + light.quadratic_attenuation * (d * d);
  float factor = 1.0f / std::max(denominator, 1.0f / kBound);
  if (light.inverse_range != 0.0f) {
    const float r = d * light.inverse_range;
    const float r2 = r * r;
    factor = factor * positive(1.0f - r2 * r2);
  }
  if (light.has_cone) factor = factor * spot_factor(light, -dot(l, light.spot_direction));
  return factor;
}

/// How a light falls on a surface.
struct Incidence {
  float n_dot_l = 0.0f;
  float highlight = 0.0f;  ///< N·H or R·V; only where something shines.
  float factor = 1.0f;     ///< Weakening.
};

Incidence incidence(const Illumination& illumination, const IlluminatingLight& light, const Surface& s,
                    bool shines) {
  Incidence at;
  const bool local = illumination.local_viewer;
  glm::vec3 l = light.to_light;
  if (!light.directional) {
    const glm::vec3 towards = light.position - s.position;
    const float distance = std::sqrt(std::max(dot(towards, towards), kMinSquare));
    l = towards * (1.0f / distance);
    if (light.weakens) at.factor = weakening(light, distance, l);
  }
  at.n_dot_l = dot(s.normal, l);
  if (!shines) return at;
  if (illumination.specular_model == SpecularModel::phong) {
    at.highlight = phong_highlight(s, l, at.n_dot_l, local);
  } else if (light.directional && !local) {
    at.highlight = dot(s.normal, light.half_vector);
  } else {
    at.highlight = blinn_highlight(s, l, local);
  }
  return at;
}

/// h^n where the light falls on the front of the surface.
float shine(float n_dot_l, float highlight, float shininess) {
  return n_dot_l > 0.0f ? std::min(portable_pow(highlight, shininess), kBound) : 0.0f;
}

/// The sum over the lights, primary and secondary kept apart.
class Sum {
 public:
  Sum(const Illumination& illumination, const SurfacePoint& point)
      : illumination_(illumination), side_(side_of(illumination, point.back)), color_(point.color) {
    for (int c = 0; c < 3; ++c) primary[c] = coefficient(illumination.base, c);
    if (point.occlusion.empty()) return;
    const float share = point.occlusion[0];
    for (int c = 0; c < 3; ++c) {
      primary[c] = primary[c] * share + coefficient(illumination.emission, c) * (1.0f - share);
    }
  }

  void add(glm::vec3& into, const LightProducts& products, float weight) const {
    for (int c = 0; c < 3; ++c) into[c] = into[c] + weight * coefficient(products, c);
  }

  LitColor result() const {
    LitColor out;
    for (std::size_t c = 0; c < 3; ++c) {
      const int k = static_cast<int>(c);
      out.primary[c] = illumination_.separate_specular ? primary[k] : primary[k] + secondary[k];
      out.secondary[c] = illumination_.separate_specular ? secondary[k] : 0.0f;
    }
    out.primary[3] = illumination_.tracks_alpha ? color_.a : illumination_.alpha[side_];
    return out;
  }

  glm::vec3 primary{0.0f}, secondary{0.0f};

 private:
  float coefficient(const LightProducts& products, int c) const {
    const float fixed = products.fixed[side_][c];
    return illumination_.tracks_color ? fixed + products.tracked[side_][c] * color_[c] : fixed;
  }

  const Illumination& illumination_;
  std::size_t side_;
  glm::vec4 color_;
};

/// A light's ambient part, `weight` of it, where some is occluded.
float occluded(const SurfacePoint& point, float weight) {
  return point.occlusion.empty() ? weight : weight * point.occlusion[0];
}

float visible(const SurfacePoint& point, std::size_t light) {
  return point.visibility.empty() ? 1.0f : point.visibility[light];
}

}  // namespace

LitColor illuminate(const Illumination& illumination, const SurfacePoint& point) {
  const std::size_t side = side_of(illumination, point.back);
  const Surface surface = surface_of(illumination, point);
  Sum sum(illumination, point);
  for (std::size_t i = 0; i < illumination.lights.size(); ++i) {
    const IlluminatingLight& light = illumination.lights[i];
    const Incidence at = incidence(illumination, light, surface, light.shines[side]);
    float diffuse = positive(at.n_dot_l);
    if (light.weakens) {
      diffuse = diffuse * at.factor;
      sum.add(sum.primary, light.ambient, occluded(point, at.factor));
    }
    sum.add(sum.primary, light.diffuse, diffuse * visible(point, i));
    if (!light.shines[side]) continue;
    float specular = shine(at.n_dot_l, at.highlight, illumination.shininess[side]);
    if (light.weakens) specular = specular * at.factor;
    sum.add(sum.secondary, light.specular, specular * visible(point, i));
  }
  return sum.result();
}

void cheap_phong_dots(const Illumination& illumination, const SurfacePoint& point, std::span<float> dots) {
  const std::size_t side = side_of(illumination, point.back);
  const float n = illumination.shininess[side];
  const bool power_here = power_at_vertices(illumination, static_cast<int>(side));
  const Surface surface = surface_of(illumination, point);
  Sum sum(illumination, point);
  sum.primary = glm::vec3(0.0f);
  const std::size_t lights = illumination.lights.size();
  for (std::size_t i = 0; i < lights; ++i) {
    const IlluminatingLight& light = illumination.lights[i];
    const Incidence at = incidence(illumination, light, surface, light.shines[side]);
    float highlight = light.shines[side] ? at.highlight : 0.0f;
    if (light.shines[side] && power_here) highlight = shine(at.n_dot_l, at.highlight, n);
    if (light.shines[side] && light.weakens) {
      highlight = highlight * (power_here ? at.factor : portable_pow(at.factor, 1.0f / n));
    }
    dots[2 * i] = light.weakens ? at.n_dot_l * at.factor : at.n_dot_l;
    dots[2 * i + 1] = highlight;
    if (light.weakens) sum.add(sum.primary, light.ambient, at.factor);
  }
  for (std::size_t c = 2 * lights; c < dots.size(); ++c) {
    dots[c] = sum.primary[static_cast<int>(c - 2 * lights)];
  }
}

LitColor cheap_phong_color(const Illumination& illumination, std::span<const float> dots,
                           const SurfacePoint& point) {
  const std::size_t side = side_of(illumination, point.back);
  const bool power_here = !power_at_vertices(illumination, static_cast<int>(side));
  Sum sum(illumination, point);
  const std::size_t lights = illumination.lights.size();
  for (std::size_t c = 2 * lights; c < dots.size(); ++c) {
    float& primary = sum.primary[static_cast<int>(c - 2 * lights)];
    primary = primary + occluded(point, dots[c]);
  }
  for (std::size_t i = 0; i < lights; ++i) {
    const float n_dot_l = dots[2 * i];
    const float highlight = dots[2 * i + 1];
    sum.add(sum.primary, illumination.lights[i].diffuse, positive(n_dot_l) * visible(point, i));
    if (!illumination.lights[i].shines[side]) continue;
    const float power = power_here ? shine(n_dot_l, highlight, illumination.shininess[side]) : highlight;
    sum.add(sum.secondary, illumination.lights[i].specular, power * visible(point, i));
  }
  return sum.result();
}

}  // namespace barrido::pipeline::reference
