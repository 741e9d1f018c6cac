#include "tests/osmesa/exact_light.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "raster/base/portable_math.h"

namespace barrido::crosscheck {
namespace {

struct Incoming {
  glm::dvec3 direction;
  double spot_cosine;
};

Incoming incoming(const pipeline::Light& light, const glm::dvec3& position) {
  const glm::dvec4 p(light.position);
  const glm::dvec3 l = glm::normalize(p.w == 0.0 ? glm::dvec3(p) : glm::dvec3(p) / p.w - position);
  return {l, glm::dot(-l, glm::normalize(glm::dvec3(light.spot_direction)))};
}

/// Attenuation and spot (OpenGL 1.3, section 2.13.1).
double weakening(const pipeline::Light& light, const glm::dvec3& position, const Incoming& in) {
  double f = 1.0;
  if (light.position.w != 0.0f) {
    const double d =
        glm::length(glm::dvec3(light.position) / static_cast<double>(light.position.w) - position);
    f = 1.0 /
        (light.constant_attenuation + light.linear_attenuation * d + light.quadratic_attenuation * d * d);
  }
  if (light.spot_cutoff_deg == 180.0f) return f;
  if (in.spot_cosine < std::cos(light.spot_cutoff_deg * kPi / 180.0)) return 0.0;
  return f * std::pow(in.spot_cosine, light.spot_exponent);
}

}  // namespace

ExactLights::ExactLights(const DrawCall& draw) : state_(draw.state) {
  const bool per_pixel = state_.shade_model == pipeline::ShadeModel::phong ||
                         state_.shade_model == pipeline::ShadeModel::cheap_phong;
  if (!state_.lighting.enabled || !per_pixel) return;
  const glm::dmat4 model_view(state_.eye_from_object);
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(model_view)));
  for (std::size_t v = 0; v < draw.mesh.position.size(); ++v) {
    position_.emplace_back(model_view * glm::dvec4(glm::dvec3(draw.mesh.position[v]), 1.0));
    normal_.push_back(normals * glm::dvec3(draw.mesh.normal[v]));
  }
}

bool ExactLights::near_step(const ExactTriangle& triangle, double x, double y) const {
  constexpr double kNear = 2e-5;
  const glm::dvec3 over_w = triangle.weights_over_w(x, y);
  const glm::dvec3 b = over_w / (over_w[0] + over_w[1] + over_w[2]);
  for (const pipeline::Light& light : state_.lighting.lights) {
    glm::dvec3 n(0.0), p(0.0);
    double cheap = 0.0;
    for (int i = 0; i < 3; ++i) {
      const std::size_t v = triangle.vertex[static_cast<std::size_t>(i)];
      n += b[i] * normal_[v];
      p += b[i] * position_[v];
      const Incoming in = incoming(light, position_[v]);
      cheap += b[i] * weakening(light, position_[v], in) * glm::dot(glm::normalize(normal_[v]), in.direction);
    }
    if (state_.shade_model == pipeline::ShadeModel::cheap_phong) {
      if (std::abs(cheap) < kNear) return true;
      continue;
    }
    const Incoming in = incoming(light, p);
    if (std::abs(glm::dot(glm::normalize(n), in.direction)) < kNear) return true;
    if (light.spot_cutoff_deg != 180.0f &&
        std::abs(in.spot_cosine - std::cos(light.spot_cutoff_deg * kPi / 180.0)) < kNear)
      return true;
  }
  return false;
}

}  // namespace barrido::crosscheck
