// Finds draws whose specular term is 0^0 at a vertex.
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {
namespace {

/// For either direction of the normal: lit, and the halfway vector not in front.
bool is_zero_power(const pipeline::State& state, const pipeline::Light& light, const glm::dvec3& n,
                   const glm::dvec3& position) {
  constexpr double kNear = 1e-3;
  const glm::dvec4 p(light.position);
  const glm::dvec3 l = glm::normalize(p.w == 0.0 ? glm::dvec3(p) : glm::dvec3(p) / p.w - position);
  const glm::dvec3 v = state.lighting.local_viewer ? glm::normalize(-position) : glm::dvec3(0, 0, 1);
  const double n_dot_l = glm::dot(n, l);
  const double n_dot_h = glm::dot(n, l + v);
  return (n_dot_l > -kNear && n_dot_h < kNear) || (n_dot_l < kNear && n_dot_h > -kNear);
}

}  // namespace

void avoid_zero_power(DrawCall& draw) {
  pipeline::Lighting& lighting = draw.state.lighting;
  if (!lighting.enabled || (lighting.front.shininess > 0.0f && lighting.back.shininess > 0.0f)) return;
  const glm::dmat4 model_view(draw.state.eye_from_object);
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(model_view)));
  for (std::size_t v = 0; v < draw.mesh.position.size(); ++v) {
    const glm::dvec3 position(model_view * glm::dvec4(glm::dvec3(draw.mesh.position[v]), 1.0));
    const glm::dvec3 n = glm::normalize(normals * glm::dvec3(draw.mesh.normal[v]));
    for (const pipeline::Light& light : lighting.lights) {
      if (!is_zero_power(draw.state, light, n, position)) continue;
      if (lighting.front.shininess == 0.0f) lighting.front.shininess = 1.0f;
      if (lighting.back.shininess == 0.0f) lighting.back.shininess = 1.0f;
      return;
    }
  }
}

}  // namespace barrido::crosscheck
