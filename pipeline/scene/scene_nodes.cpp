#include "pipeline/scene/scene_nodes.h"

#include <algorithm>
#include <numeric>

#include "pipeline/files/error.h"

namespace barrido::scene {

int resolve_scene_index(const Scene& scene, int scene_index) {
  const int count = static_cast<int>(scene.scenes.size());
  if (scene_index == kNone) {
    if (count == 0) return kNone;
    return std::clamp(scene.default_scene, 0, count - 1);
  }
  if (scene_index < 0 || scene_index >= count) {
    throw InputError(scene.source, "scene " + std::to_string(scene_index),
                     "the file has " + std::to_string(count) + (count == 1 ? " scene" : " scenes"));
  }
  return scene_index;
}

int resolve_variant(const Scene& scene, const std::string& name) {
  if (name.empty()) return kNone;
  const auto found = std::find(scene.variants.begin(), scene.variants.end(), name);
  if (found != scene.variants.end()) return static_cast<int>(found - scene.variants.begin());
  std::string known;
  for (const std::string& variant : scene.variants) known += (known.empty() ? "" : ", ") + variant;
  throw InputError(
      scene.source, "variant " + name,
      known.empty() ? "the file has no variants" : "there is no such variant; the file has " + known);
}

std::vector<int> nodes_of_scene(const Scene& scene, int resolved_index) {
  std::vector<int> nodes;
  if (resolved_index == kNone) {
    nodes.resize(scene.nodes.size());
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
  }
  nodes = scene.scenes[static_cast<std::size_t>(resolved_index)].nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::vector<int>& children = scene.nodes[static_cast<std::size_t>(nodes[i])].children;
    nodes.insert(nodes.end(), children.begin(), children.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<int> camera_nodes(const Scene& scene, const std::vector<int>& nodes) {
  std::vector<int> cameras;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(cameras),
               [&](int node) { return scene.nodes[static_cast<std::size_t>(node)].camera != kNone; });
  return cameras;
}

}  // namespace barrido::scene
