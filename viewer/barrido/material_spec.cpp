#include "viewer/barrido/material_spec.h"

#include <algorithm>
#include <array>

#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

using scene::MaterialOverride;

constexpr double kLargestCoefficient = 1e6;
constexpr double kLargestShininess = 1e5;

glm::vec3 parse_color(std::string_view text, double most) {
  const auto color = parse_tuple<3>(text, "R,G,B", 0.0, most);
  return {color[0], color[1], color[2]};
}

glm::vec3 parse_coefficient(std::string_view text) { return parse_color(text, kLargestCoefficient); }

float parse_float(std::string_view text, double most) {
  return static_cast<float>(parse_number(text, 0.0, most));
}

struct Key {
  std::string_view name;
  void (*apply)(MaterialOverride& material, std::string_view text);
};

constexpr std::array<Key, 8> kKeys{{
    {"color", [](MaterialOverride& m, std::string_view t) { m.base_color = parse_color(t, 1.0); }},
    {"metallic", [](MaterialOverride& m, std::string_view t) { m.metallic = parse_float(t, 1.0); }},
    {"roughness", [](MaterialOverride& m, std::string_view t) { m.roughness = parse_float(t, 1.0); }},
    {"ambient", [](MaterialOverride& m, std::string_view t) { m.exact.ambient = parse_coefficient(t); }},
    {"diffuse", [](MaterialOverride& m, std::string_view t) { m.exact.diffuse = parse_coefficient(t); }},
    {"specular", [](MaterialOverride& m, std::string_view t) { m.exact.specular = parse_coefficient(t); }},
    {"emission", [](MaterialOverride& m, std::string_view t) { m.exact.emission = parse_coefficient(t); }},
    {"shininess",
     [](MaterialOverride& m, std::string_view t) { m.exact.shininess = parse_float(t, kLargestShininess); }},
}};

const Key& find_key(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Key& key : kKeys) {
    if (key.name == name) return key;
    names.push_back(key.name);
  }
  throw ValueError("'" + std::string(name) + "': expected " + one_of(names) + did_you_mean(name, names));
}

}  // namespace

MaterialOverride parse_material(std::string_view spec) {
  MaterialOverride material;
  std::vector<std::string_view> given;
  for (const std::string_view pair : split(spec, ':')) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos) {
      throw ValueError("expected KEY=VALUE:..., but '" + std::string(pair) + "' has no '='");
    }
    const std::string_view name = pair.substr(0, equals);
    const Key& key = find_key(name);
    if (std::find(given.begin(), given.end(), name) != given.end()) {
      throw ValueError(std::string(name) + " is given twice");
    }
    given.push_back(name);
    try {
      key.apply(material, pair.substr(equals + 1));
    } catch (const ValueError& error) {
      throw ValueError(std::string(name) + ": " + error.what());
    }
  }
  return material;
}

}  // namespace barrido::cli
