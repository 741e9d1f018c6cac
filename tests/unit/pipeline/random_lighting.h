// Random lights and materials of every kind.
#pragma once

#include <glm/geometric.hpp>

#include "pipeline/state.h"
#include "random.h"

namespace barrido::pipeline {

inline glm::vec3 random_direction(Random& random) {
  for (;;) {
    const glm::vec3 v = random.vec3(-1, 1);
    const float length = std::sqrt(glm::dot(v, v));
    if (length > 0.1f && length < 1.0f) return v / length;
  }
}

inline Light random_light(Random& random) {
  Light light;
  light.ambient = random.vec4(0, 0.3);
  light.diffuse = random.vec4(random.chance(0.1) ? -1 : 0, 1);  // negative ones take light away (V5)
  light.specular = random.vec4(0, 1);
  light.position =
      random.chance(0.4) ? glm::vec4(random_direction(random), 0.0f) : glm::vec4(random.vec3(-5, 5), 1.0f);
  if (random.chance(0.1)) light.position *= 2.0f;
  light.spot_direction = 3.0f * random_direction(random);
  if (random.chance(0.3)) {
    light.spot_cutoff_deg = random.in(30, 90);
    light.spot_exponent = random.chance(0.5) ? random.in(0, 20) : 0.0f;
  } else if (random.chance(0.2)) {
    light.spot_inner_cos = random.in(0.5, 0.9);
    light.spot_outer_cos = light.spot_inner_cos - random.in(0.01, 1);
  }
  if (random.chance(0.5)) {
    light.constant_attenuation = random.in(0.1, 2);
    light.linear_attenuation = random.in(0, 0.5);
    light.quadratic_attenuation = random.chance(0.5) ? random.in(0, 0.2) : 0.0f;
  }
  if (random.chance(0.2)) light.range = random.in(4, 12);
  return light;
}

inline Material random_material(Random& random) {
  Material m;
  m.ambient = random.vec4(0, 1);
  m.diffuse = random.vec4(0, 1);
  m.specular = random.chance(0.2) ? glm::vec4(0, 0, 0, 1) : random.vec4(0, 1);
  m.emission = random.vec4(0, 0.2);
  m.shininess = random.chance(0.1) ? 0.0f : random.in(0.5, 200);
  return m;
}

inline Lighting random_lighting(Random& random) {
  Lighting lighting;
  lighting.enabled = true;
  const int lights = random.below(5);
  for (int i = 0; i < lights; ++i) lighting.lights.push_back(random_light(random));
  lighting.ambient = random.vec4(0, 0.3);
  lighting.local_viewer = random.chance(0.5);
  lighting.two_sided = random.chance(0.5);
  lighting.separate_specular = random.chance(0.5);
  lighting.specular_model = random.chance(0.5) ? SpecularModel::blinn : SpecularModel::phong;
  lighting.color_material = static_cast<ColorMaterial>(random.below(6));
  lighting.front = random_material(random);
  lighting.back = random_material(random);
  return lighting;
}

}  // namespace barrido::pipeline
