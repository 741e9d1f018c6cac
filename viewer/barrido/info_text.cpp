#include "pipeline/scene/names.h"
#include "raster/base/portable_math.h"
#include "viewer/barrido/scene_summary.h"
#include "viewer/barrido/standard_streams.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

/// Lines with a heading of fixed width on the left.
class Sheet {
 public:
  void row(const char* heading, const std::string& text) {
    text_ += "  " + left(heading, 12) + on_one_line(text) + "\n";
  }
  void item(const std::string& text) { text_ += std::string(16, ' ') + on_one_line(text) + "\n"; }
  void title(const std::string& text) { text_ += on_one_line(text) + "\n"; }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string quoted(const std::string& name) { return name.empty() ? "" : " \"" + name + "\""; }

std::string point(const glm::vec3& p) { return shortest(p.x) + "," + shortest(p.y) + "," + shortest(p.z); }

std::string counts_text(const PrimitiveCounts& counts) {
  std::string text = counted(counts.triangles, "triangle", "triangles");
  if (counts.lines > 0) text += ", " + counted(counts.lines, "line", "lines");
  if (counts.points > 0) text += ", " + counted(counts.points, "point", "points");
  return text + ", " + counted(counts.vertices, "vertex", "vertices");
}

std::string degrees_text(float radians_value) { return fixed(radians_value * 180.0 / kPi, 1) + " degrees"; }

std::string camera_text(const scene::Camera& camera) {
  if (camera.kind == scene::Camera::Kind::orthographic) {
    return "orthographic, " + shortest(2 * camera.half_width) + " by " + shortest(2 * camera.half_height);
  }
  return "perspective, " + degrees_text(camera.vertical_fov_rad) + " vertical";
}

std::string light_text(const scene::Light& light) {
  const char* unit = light.kind == scene::Light::Kind::directional ? " lux" : " candela";
  return std::string(name_of(light.kind)) + ", " +
         (light.exact_intensity ? "intensity " + shortest(*light.exact_intensity)
                                : shortest(light.intensity) + unit) +
         ", colour " + point(light.color);
}

void add_images(Sheet& sheet, const scene::Scene& scene) {
  sheet.row("textures", grouped(scene.textures.size()));
  for (const scene::Image& image : scene.images) {
    sheet.item(std::to_string(image.width) + " x " + std::to_string(image.height) + "  " + image.name);
  }
}

void add_cameras_and_lights(Sheet& sheet, const scene::Scene& scene, const SceneSummary& summary) {
  sheet.row("cameras", grouped(summary.camera_nodes.size()));
  for (std::size_t i = 0; i < summary.camera_nodes.size(); ++i) {
    const scene::Node& node = scene.nodes[static_cast<std::size_t>(summary.camera_nodes[i])];
    const scene::Camera& camera = scene.cameras[static_cast<std::size_t>(node.camera)];
    sheet.item(std::to_string(i) + quoted(camera.name.empty() ? node.name : camera.name) + " " +
               camera_text(camera));
  }
  sheet.row("lights", grouped(summary.light_nodes.size()));
  for (const int index : summary.light_nodes) {
    const scene::Node& node = scene.nodes[static_cast<std::size_t>(index)];
    const scene::Light& light = scene.lights[static_cast<std::size_t>(node.light)];
    sheet.item((light.name.empty() ? "" : "\"" + light.name + "\" ") + light_text(light));
  }
}

void add_motion(Sheet& sheet, const scene::Scene& scene) {
  if (!scene.variants.empty()) sheet.row("variants", grouped(scene.variants.size()));
  for (const std::string& variant : scene.variants) sheet.item(variant);
  sheet.row("animations", grouped(scene.animations.size()));
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    const scene::Animation& animation = scene.animations[i];
    sheet.item(std::to_string(i) + quoted(animation.name) + " " + shortest(animation.duration_s) + " s, " +
               counted(animation.channels.size(), "channel", "channels"));
  }
  sheet.row("skins", grouped(scene.skins.size()));
  for (const scene::Skin& skin : scene.skins) sheet.item(counted(skin.joints.size(), "joint", "joints"));
}

void add_features(Sheet& sheet, const scene::Scene& scene) {
  if (scene.features.empty()) return;
  sheet.row("features", "");
  for (const scene::Feature& feature : scene.features) {
    sheet.item(left(std::string(name_of(feature.support)), 14) + feature.name +
               (feature.note.empty() ? "" : ": " + feature.note));
  }
}

std::string bounds_text(const SceneSummary& summary) {
  if (!summary.bounds) return "nothing is drawn";
  const Box& box = *summary.bounds;
  return point(box.least) + " to " + point(box.most) + " (size " + point(box.most - box.least) + ")";
}

}  // namespace

std::string info_text(const scene::Scene& scene, const SceneSummary& summary) {
  Sheet sheet;
  sheet.title(scene.source);
  if (!scene.generator.empty()) sheet.row("made by", scene.generator);
  sheet.row("scenes", grouped(scene.scenes.size()));
  sheet.row("nodes", grouped(scene.nodes.size()));
  sheet.row("meshes", counted(scene.meshes.size(), "mesh", "meshes") + " of " +
                          counted(summary.stored.primitives, "primitive", "primitives") + ": " +
                          counts_text(summary.stored));
  sheet.row("drawn", counts_text(summary.drawn));
  sheet.row("bounds", bounds_text(summary));
  sheet.row("materials", grouped(scene.materials.size()));
  for (const scene::Material& material : scene.materials) {
    if (!material.name.empty()) sheet.item(material.name);
  }
  add_images(sheet, scene);
  add_cameras_and_lights(sheet, scene, summary);
  add_motion(sheet, scene);
  add_features(sheet, scene);
  return sheet.take();
}

}  // namespace barrido::cli
