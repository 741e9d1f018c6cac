#include "tests/oracle/closed_form.h"

#include <algorithm>
#include <cmath>

#include "tests/oracle/illumination.h"

namespace barrido::oracle {
namespace {

pipeline::Light light_of(const OracleLight& light) {
  pipeline::Light out;
  out.diffuse = out.specular = glm::vec4(light.color, 1.0f);
  out.position = light.position;
  out.constant_attenuation = static_cast<float>(light.kc);
  out.linear_attenuation = static_cast<float>(light.kl);
  out.quadratic_attenuation = static_cast<float>(light.kq);
  return out;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

pipeline::Lighting lighting_of(const OracleModel& model) {
  pipeline::Lighting lighting;
  lighting.enabled = true;
  lighting.ambient = glm::vec4(model.ambient, 1.0f);
  lighting.local_viewer = model.local_viewer;
  lighting.specular_model = model.phong ? pipeline::SpecularModel::phong : pipeline::SpecularModel::blinn;
  for (const OracleLight& light : model.lights) lighting.lights.push_back(light_of(light));
  lighting.front.ambient = glm::vec4(model.material.ka, 1.0f);
  lighting.front.diffuse = glm::vec4(model.material.kd, 1.0f);
  lighting.front.specular = glm::vec4(model.material.ks, 1.0f);
  lighting.front.shininess = static_cast<float>(model.material.n);
  return lighting;
}

double attenuation(const OracleLight& light, const glm::dvec3& p) {
  const pipeline::Light of = light_of(light);
  double distance = 0.0;
  const glm::dvec3 l = direction(of, p, distance);
  return factor(of, l, distance);
}

Dots dots_at(const OracleModel& model, const OracleLight& light, const glm::dvec3& p, const glm::dvec3& n) {
  double distance = 0.0;
  const glm::dvec3 l = direction(light_of(light), p, distance);
  return {glm::dot(n, l), highlight(lighting_of(model), n, l, p)};
}

double highlight_of(const Dots& dots, double exponent) {
  return dots.diffuse > 0.0 ? std::pow(std::max(dots.highlight, 0.0), exponent) : 0.0;
}

glm::dvec3 illuminated(const OracleModel& model, const glm::dvec3& p, const glm::dvec3& n) {
  return illuminate(lighting_of(model), {n, p}).primary;
}

OracleMesh::OracleMesh(std::vector<glm::dvec3> positions, std::vector<std::uint32_t> indices,
                       const glm::dmat4& clip_from_eye, int width, int height)
    : positions_(std::move(positions)), indices_(std::move(indices)) {
  for (const glm::dvec3& p : positions_) {
    const glm::dvec4 clip = clip_from_eye * glm::dvec4(p, 1.0);
    window_.emplace_back((clip.x / clip.w + 1.0) * 0.5 * width, (clip.y / clip.w + 1.0) * 0.5 * height);
    w_.push_back(clip.w);
  }
}

OracleMesh::Hit OracleMesh::at(double x, double y, double margin) const {
  const glm::dvec2 p(x, y);
  for (int t = 0; t < triangle_count(); ++t) {
    const std::uint32_t index[3] = {vertex(t, 0), vertex(t, 1), vertex(t, 2)};
    const glm::dvec2 corner[3] = {window_[index[0]], window_[index[1]], window_[index[2]]};
    const double area = cross(corner[1] - corner[0], corner[2] - corner[0]);
    if (area == 0.0) continue;
    Hit hit{t, {}, {}};
    bool inside = true;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec2 a = corner[(k + 1) % 3], b = corner[(k + 2) % 3];
      hit.screen[k] = cross(b - a, p - a) / area;
      // Distance of p from the edge opposite to corner k, positive inside.
      inside = inside && hit.screen[k] * std::abs(area) / glm::length(b - a) >= margin;
    }
    if (!inside) continue;
    for (int k = 0; k < 3; ++k) hit.weights[k] = hit.screen[k] / w_[index[k]];
    hit.weights /= hit.weights.x + hit.weights.y + hit.weights.z;
    return hit;
  }
  return {};
}

}  // namespace barrido::oracle
