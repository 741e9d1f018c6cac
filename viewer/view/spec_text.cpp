// Lights, fog and materials as the command line spells them.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "raster/base/portable_math.h"
#include "viewer/barrido/text_format.h"
#include "viewer/view/render_words.h"

namespace barrido::view {
namespace {

using cli::shortest;
using Kind = scene::Light::Kind;

std::string triple(float a, float b, float c) { return shortest(a) + "," + shortest(b) + "," + shortest(c); }
std::string triple(const glm::vec3& v) { return triple(v.x, v.y, v.z); }

float radians_of(float degrees) { return static_cast<float>(radians(degrees)); }

/// Degrees in [0, 90] that become these radians.
float degrees_of(float radians_wanted) {
  const float guess = static_cast<float>(static_cast<double>(radians_wanted) * (180.0 / kPi));
  float best = guess;
  float below = guess, above = guess;
  for (int step = 0; step < 4 && radians_of(best) != radians_wanted; ++step) {
    below = std::nextafter(below, 0.0f);
    above = std::nextafter(above, 91.0f);
    if (radians_of(below) == radians_wanted) best = below;
    if (radians_of(above) == radians_wanted) best = above;
  }
  return std::min(std::max(best, 0.0f), 90.0f);
}

/// The shortest number of degrees that becomes these radians when it is read as a double.
std::string degrees_text(float radians_wanted) {
  const std::string text = shortest(degrees_of(radians_wanted));
  double degrees = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), degrees);
  if (static_cast<float>(radians(degrees)) == radians_wanted) return text;
  std::array<char, 32> digits{};
  const double exact = std::min(static_cast<double>(radians_wanted) * (180.0 / kPi), 90.0);
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), exact).ptr};
}

void append_cone(std::string& text, const scene::Light& light) {
  if (!light.spot_exponent) {
    const float outer = degrees_of(light.outer_cone_rad);
    const float inner = std::min(degrees_of(light.inner_cone_rad), outer);
    text += ":cone=" + shortest(inner) + "," + shortest(outer);
    return;
  }
  text += ":cutoff=" + degrees_text(light.outer_cone_rad);
  if (*light.spot_exponent != 0.0f) text += ":exponent=" + shortest(*light.spot_exponent);
}

template <class Value, class Function>
void append(std::string& text, const char* key, const std::optional<Value>& value, const Function& spell) {
  if (value) text += (text.empty() ? "" : ":") + std::string(key) + "=" + spell(*value);
}

}  // namespace

std::string light_text(const scene::UserLight& user) {
  const scene::Light& light = user.light;
  std::string text = light.kind == Kind::directional ? "directional"
                     : light.kind == Kind::point     ? "point"
                                                     : "spot";
  if (light.color != glm::vec3(1.0f)) text += ":color=" + triple(light.color);
  const float intensity = light.exact_intensity.value_or(1.0f);
  if (intensity != 1.0f) text += ":intensity=" + shortest(intensity);
  if (light.kind != Kind::point) text += ":dir=" + triple(user.direction);
  if (light.kind != Kind::directional) {
    text += ":pos=" + triple(user.position);
    const std::array<float, 3> k = light.attenuation.value_or(std::array<float, 3>{1, 0, 0});
    if (k != std::array<float, 3>{1, 0, 0}) text += ":attenuation=" + triple(k[0], k[1], k[2]);
    if (light.range != 0.0f) text += ":range=" + shortest(light.range);
  }
  if (light.kind == Kind::spot) append_cone(text, light);
  if (user.space == scene::UserLight::Space::camera) text += ":space=camera";
  return text;
}

std::string fog_text(const cli::FogChoice& fog) {
  using raster::FogMode;
  const raster::FogState& state = fog.state;
  std::string text;
  if (state.mode == FogMode::linear) {
    text = "linear:" + shortest(state.start) + "," + shortest(state.end);
  } else {
    text = (state.mode == FogMode::exp ? "exp:" : "exp2:") + shortest(state.density);
  }
  if (fog.color_shown) {
    const auto& [r, g, b] = *fog.color_shown;
    text += ":" + triple(r, g, b);
  }
  return text;
}

std::string material_text(const scene::MaterialOverride& material) {
  const auto spell_color = [](const glm::vec3& color) { return triple(color); };
  std::string text;
  append(text, "color", material.base_color, spell_color);
  append(text, "metallic", material.metallic, shortest);
  append(text, "roughness", material.roughness, shortest);
  append(text, "ambient", material.exact.ambient, spell_color);
  append(text, "diffuse", material.exact.diffuse, spell_color);
  append(text, "specular", material.exact.specular, spell_color);
  append(text, "emission", material.exact.emission, spell_color);
  append(text, "shininess", material.exact.shininess, shortest);
  return text;
}

}  // namespace barrido::view
