#include "pipeline/cheap_phong.h"

namespace barrido::pipeline {

int cheap_phong_varyings(const Illumination& illumination) {
  bool ambient = false;
  for (const IlluminatingLight& light : illumination.lights) {
    for (std::size_t side = 0; side < 2; ++side) {
      ambient |=
          light.ambient.fixed[side] != glm::vec3(0.0f) || light.ambient.tracked[side] != glm::vec3(0.0f);
    }
  }
  return 2 * static_cast<int>(illumination.lights.size()) + (ambient ? 3 : 0);
}

bool power_at_vertices(const Illumination& illumination, int side) {
  return illumination.cheap_phong_power == CheapPhongPower::vertex ||
         illumination.shininess[static_cast<std::size_t>(side)] == 0.0f;
}

int cheap_phong_vertex_powers(const Illumination& illumination, int side) {
  const auto s = static_cast<std::size_t>(side);
  const bool power_here = power_at_vertices(illumination, side);
  int powers = 0;
  for (const IlluminatingLight& light : illumination.lights) {
    powers += light.weakens && light.falloff == SpotFalloff::exponent;
    powers += light.shines[s] && (power_here ? illumination.shininess[s] != 0.0f : light.weakens);
  }
  return powers;
}

int cheap_phong_fragment_powers(const Illumination& illumination, int side) {
  if (power_at_vertices(illumination, side)) return 0;
  int powers = 0;
  for (const IlluminatingLight& light : illumination.lights) {
    powers += light.shines[static_cast<std::size_t>(side)];
  }
  return powers;
}

}  // namespace barrido::pipeline
