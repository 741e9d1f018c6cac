#include "tests/oracle/closed_form.h"

#include <algorithm>
#include <cmath>

namespace barrido::oracle {
namespace {

glm::dvec3 to_light(const OracleLight& light, const glm::dvec3& p) {
  const glm::dvec3 position(light.position);
  return glm::normalize(light.position.w == 0.0 ? position : position - p);
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

double attenuation(const OracleLight& light, const glm::dvec3& p) {
  if (light.position.w == 0.0) return 1.0;
  const double d = glm::length(glm::dvec3(light.position) - p);
  return 1.0 / (light.kc + light.kl * d + light.kq * d * d);
}

Dots dots_at(const OracleModel& model, const OracleLight& light, const glm::dvec3& p, const glm::dvec3& n) {
  const glm::dvec3 l = to_light(light, p);
  const glm::dvec3 v = model.local_viewer ? glm::normalize(-p) : glm::dvec3(0, 0, 1);
  Dots dots;
  dots.diffuse = glm::dot(n, l);
  const glm::dvec3 r = 2.0 * glm::dot(n, l) * n - l;
  dots.highlight = model.phong ? glm::dot(r, v) : glm::dot(n, glm::normalize(l + v));
  return dots;
}

double highlight_of(const Dots& dots, double exponent) {
  return dots.diffuse > 0.0 ? std::pow(std::max(dots.highlight, 0.0), exponent) : 0.0;
}

glm::dvec3 illuminated(const OracleModel& model, const glm::dvec3& p, const glm::dvec3& n) {
  const OracleMaterial& m = model.material;
  glm::dvec3 sum = model.ambient * m.ka;
  for (const OracleLight& light : model.lights) {
    const Dots dots = dots_at(model, light, p, n);
    sum += attenuation(light, p) * light.color *
           (m.kd * std::max(dots.diffuse, 0.0) + m.ks * highlight_of(dots, m.n));
  }
  return sum;
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
