#include "models/tool/scene_parts.h"

#include <algorithm>

#include "raster/base/portable_math.h"

namespace barrido::models {
namespace {

void add_light_node(GlbWriter& writer, Json node, Json light) {
  const int index = writer.add_light(std::move(light));
  node["extensions"]["KHR_lights_punctual"]["light"] = index;
  writer.add_node(std::move(node));
}

}  // namespace

Json json_of(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json make_material(const std::string& name, const Vec3& base_color, double metallic, double roughness) {
  Json material{{"name", name}};
  material["pbrMetallicRoughness"] = {
      {"baseColorFactor", Json::array({base_color.x, base_color.y, base_color.z, 1.0})},
      {"metallicFactor", metallic},
      {"roughnessFactor", roughness}};
  return material;
}

Json make_textured_material(const std::string& name, int texture, double metallic, double roughness) {
  Json material{{"name", name}};
  material["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", texture}}},
                                      {"metallicFactor", metallic},
                                      {"roughnessFactor", roughness}};
  return material;
}

Json make_exact_material(const std::string& name, const ExactMaterial& exact) {
  // Other programs, which do not know the extras, see something close.
  const double roughness = std::clamp(std::sqrt(std::sqrt(2.0 / (exact.shininess + 2.0))), 0.05, 1.0);
  Json material = make_material(name, exact.diffuse, 0.0, roughness);
  material["extras"]["barrido"] = {{"ambient", json_of(exact.ambient)},
                                   {"diffuse", json_of(exact.diffuse)},
                                   {"specular", json_of(exact.specular)},
                                   {"shininess", exact.shininess}};
  return material;
}

void add_camera(GlbWriter& writer, const CameraSpec& spec) {
  // Rounded: nobody needs more digits of an angle.
  const double angle = std::floor(2.0 * portable_atan2(spec.half_height, 1.0) * 1e6 + 0.5) / 1e6;
  const int camera = writer.add_camera(
      {{"type", "perspective"},
       {"perspective", {{"yfov", angle}, {"znear", spec.near_plane}, {"zfar", spec.far_plane}}}});
  Json node = looking_node("camera", spec.position, spec.target);
  node["camera"] = camera;
  writer.add_node(std::move(node));
}

void add_sun(GlbWriter& writer, const std::string& name, const Vec3& from, const Vec3& color, double lux) {
  add_light_node(writer, looking_node(name, from, {0, 0, 0}),
                 {{"name", name}, {"type", "directional"}, {"color", json_of(color)}, {"intensity", lux}});
}

void add_exact_point_light(GlbWriter& writer, const std::string& name, const Vec3& position,
                           const Vec3& color, double intensity, const Vec3& attenuation) {
  Json light{{"name", name}, {"type", "point"}, {"color", json_of(color)}};
  light["intensity"] = std::floor(intensity * kPi * 1e3 + 0.5) / 1e3;  // Candela, for other programs.
  light["extras"]["barrido"] = {{"intensity", intensity}, {"attenuation", json_of(attenuation)}};
  add_light_node(writer, {{"name", name}, {"translation", json_of(position)}}, std::move(light));
}

}  // namespace barrido::models
