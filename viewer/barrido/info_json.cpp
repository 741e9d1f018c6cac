#include <nlohmann/json.hpp>

#include "pipeline/scene/names.h"
#include "viewer/barrido/scene_summary.h"

namespace barrido::cli {
namespace {

using Json = nlohmann::ordered_json;

Json array_of(const glm::vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json counts_json(const PrimitiveCounts& counts) {
  return {{"primitives", counts.primitives},
          {"triangles", counts.triangles},
          {"lines", counts.lines},
          {"points", counts.points},
          {"vertices", counts.vertices}};
}

Json camera_json(const scene::Scene& scene, int node_index) {
  const scene::Node& node = scene.nodes[static_cast<std::size_t>(node_index)];
  const scene::Camera& camera = scene.cameras[static_cast<std::size_t>(node.camera)];
  Json json{{"name", camera.name}, {"node", node_index}};
  if (camera.kind == scene::Camera::Kind::orthographic) {
    json["type"] = "orthographic";
    json["width"] = 2 * camera.half_width;
    json["height"] = 2 * camera.half_height;
  } else {
    json["type"] = "perspective";
    json["vertical_fov_rad"] = camera.vertical_fov_rad;
  }
  return json;
}

Json light_json(const scene::Scene& scene, int node_index) {
  const scene::Node& node = scene.nodes[static_cast<std::size_t>(node_index)];
  const scene::Light& light = scene.lights[static_cast<std::size_t>(node.light)];
  Json json{{"name", light.name},
            {"node", node_index},
            {"type", name_of(light.kind)},
            {"color", array_of(light.color)},
            {"intensity", light.intensity}};
  if (light.exact_intensity) json["exact_intensity"] = *light.exact_intensity;
  return json;
}

Json animations_json(const scene::Scene& scene) {
  Json list = Json::array();
  for (const scene::Animation& animation : scene.animations) {
    list.push_back({{"name", animation.name},
                    {"duration_s", animation.duration_s},
                    {"channels", animation.channels.size()}});
  }
  return list;
}

Json images_json(const scene::Scene& scene) {
  Json list = Json::array();
  for (const scene::Image& image : scene.images) {
    list.push_back({{"name", image.name}, {"width", image.width}, {"height", image.height}});
  }
  return list;
}

Json features_json(const scene::Scene& scene) {
  Json list = Json::array();
  for (const scene::Feature& feature : scene.features) {
    list.push_back({{"name", feature.name}, {"support", name_of(feature.support)}, {"note", feature.note}});
  }
  return list;
}

Json materials_json(const scene::Scene& scene) {
  Json list = Json::array();
  for (const scene::Material& material : scene.materials) list.push_back(material.name);
  return list;
}

}  // namespace

std::string info_json(const scene::Scene& scene, const SceneSummary& summary) {
  Json json{{"file", scene.source},
            {"generator", scene.generator},
            {"scenes", scene.scenes.size()},
            {"default_scene", scene.default_scene},
            {"nodes", scene.nodes.size()},
            {"meshes", scene.meshes.size()},
            {"stored", counts_json(summary.stored)},
            {"drawn", counts_json(summary.drawn)}};
  json["bounds"] =
      summary.bounds ? Json{{"min", array_of(summary.bounds->least)}, {"max", array_of(summary.bounds->most)}}
                     : Json();
  json["materials"] = materials_json(scene);
  json["textures"] = scene.textures.size();
  json["images"] = images_json(scene);
  json["cameras"] = Json::array();
  for (const int node : summary.camera_nodes) json["cameras"].push_back(camera_json(scene, node));
  json["lights"] = Json::array();
  for (const int node : summary.light_nodes) json["lights"].push_back(light_json(scene, node));
  if (!scene.variants.empty()) json["variants"] = scene.variants;
  json["animations"] = animations_json(scene);
  json["skins"] = Json::array();
  for (const scene::Skin& skin : scene.skins) json["skins"].push_back({{"joints", skin.joints.size()}});
  json["features"] = features_json(scene);
  json["warnings"] = scene.warnings;
  // Names in a file need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace barrido::cli
