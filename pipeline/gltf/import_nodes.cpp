// Nodes and scenes. The hierarchy of a file may hold anything; here it must prove to be a forest: at most one
// parent a node and no cycle. All walks use a list of their own instead of the program's stack.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "pipeline/gltf/import_parts.h"

namespace barrido::scene::gltf {
namespace {

/// Coordinates of maps need all their digits.
glm::dvec3 dvec3_of(const std::vector<double>& values, glm::dvec3 otherwise) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (values.size() != 3) return otherwise;
  return glm::clamp(glm::dvec3(values[0], values[1], values[2]), -kLargest, kLargest);
}

glm::vec3 vec3_of(const std::vector<double>& values, glm::vec3 otherwise) {
  if (values.size() != 3) return otherwise;
  return {to_float(values[0]), to_float(values[1]), to_float(values[2])};
}

glm::quat rotation_of(Import& import, const std::vector<double>& values) {
  if (values.size() != 4) return {1, 0, 0, 0};
  const double largest = std::max(std::max(std::abs(values[0]), std::abs(values[1])),
                                  std::max(std::abs(values[2]), std::abs(values[3])));
  if (largest == 0.0) {
    import.report.warn("a rotation of length 0 was replaced by none");
    return {1, 0, 0, 0};
  }
  double q[4];  // Divided by its largest component first, so that no square overflows.
  double length_squared = 0.0;
  for (std::size_t c = 0; c < 4; ++c) {
    q[c] = values[c] / largest;
    length_squared += q[c] * q[c];
  }
  const double scale = 1.0 / std::sqrt(length_squared);
  return {static_cast<float>(q[3] * scale), static_cast<float>(q[0] * scale),
          static_cast<float>(q[1] * scale), static_cast<float>(q[2] * scale)};
}

Transform transform_of(Import& import, const tinygltf::Node& source) {
  Transform transform;
  if (source.matrix.size() == 16) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) {
      matrix[i / 4][i % 4] = std::clamp(source.matrix[static_cast<std::size_t>(i)], -kLargest, kLargest);
    }
    transform.matrix = matrix;
  }
  transform.translation = dvec3_of(source.translation, {0, 0, 0});
  transform.rotation = rotation_of(import, source.rotation);
  transform.scale = vec3_of(source.scale, {1, 1, 1});
  return transform;
}

void check_weights(const Import& import, const tinygltf::Node& source, const std::string& place) {
  if (source.weights.empty()) return;
  const std::size_t targets =
      source.mesh < 0 ? 0 : import.scene.meshes[static_cast<std::size_t>(source.mesh)].morph_weights.size();
  if (source.weights.size() != targets) {
    import.report.fail(place + ".weights", "there are " + std::to_string(source.weights.size()) +
                                               " weights, but " + std::to_string(targets) + " morph targets");
  }
}

Node node_of(Import& import, const tinygltf::Node& source, const std::string& place, bool is_drawn) {
  if (is_drawn) check_weights(import, source, place);
  Node node;
  node.name = source.name;
  node.children = source.children;
  node.transform = transform_of(import, source);
  node.mesh = source.mesh < 0 ? kNone : source.mesh;
  node.skin = source.mesh < 0 || source.skin < 0 ? kNone : source.skin;
  node.camera = source.camera < 0 ? kNone : source.camera;
  const auto light = source.extensions.find("KHR_lights_punctual");
  if (light != source.extensions.end()) node.light = light->second.Get("light").GetNumberAsInt();
  for (const double weight : source.weights) node.morph_weights.push_back(to_float(weight));
  return node;
}

void set_parents(Import& import) {
  auto& nodes = import.scene.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      Node& node = nodes[static_cast<std::size_t>(child)];
      if (node.parent != kNone) {
        import.report.fail(element("nodes", static_cast<std::size_t>(child)),
                           "is a child of " + element("nodes", static_cast<std::size_t>(node.parent)) +
                               " and of " + element("nodes", i) + "; a node has at most one parent");
      }
      node.parent = static_cast<int>(i);
    }
  }
}

/// With one parent a node at most, whatever is not reached from a root is part of a cycle or hangs on one.
void check_cycles(const Import& import) {
  const auto& nodes = import.scene.nodes;
  std::vector<char> reached(nodes.size(), 0);
  std::vector<int> waiting;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent == kNone) waiting.push_back(static_cast<int>(i));
  }
  while (!waiting.empty()) {
    const auto index = static_cast<std::size_t>(waiting.back());
    waiting.pop_back();
    reached[index] = 1;
    waiting.insert(waiting.end(), nodes[index].children.begin(), nodes[index].children.end());
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!reached[i]) import.report.fail(element("nodes", i), "is part of a cycle of nodes, or below one");
  }
}

void import_scenes(Import& import) {
  const tinygltf::Model& model = import.document.model();
  auto& scene = import.scene;
  for (std::size_t i = 0; i < model.scenes.size(); ++i) {
    SceneRoot root;
    root.name = model.scenes[i].name;
    root.nodes = model.scenes[i].nodes;
    for (const int index : root.nodes) {
      const auto node = static_cast<std::size_t>(index);
      if (scene.nodes[node].parent != kNone) {
        import.report.warn(element("scenes", i) + ".nodes: " + element("nodes", node) +
                           " is not a root: it has a parent; drawn where that puts it");
      }
    }
    // Twice named is once drawn; below each naming a whole tree would be walked.
    std::vector<int> sorted = root.nodes;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() != root.nodes.size()) {
      import.report.warn(element("scenes", i) + ".nodes names a node twice");
      root.nodes = std::move(sorted);
    }
    scene.scenes.push_back(std::move(root));
  }
  if (scene.scenes.empty()) {
    SceneRoot all;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      if (scene.nodes[i].parent == kNone) all.nodes.push_back(static_cast<int>(i));
    }
    scene.scenes.push_back(std::move(all));
  }
  scene.default_scene = model.defaultScene < 0 ? 0 : model.defaultScene;
}

}  // namespace

DrawnElements find_drawn(const tinygltf::Model& model) {
  DrawnElements drawn;
  drawn.nodes.resize(model.nodes.size(), model.scenes.empty());
  drawn.meshes.resize(model.meshes.size());
  drawn.skins.resize(model.skins.size());
  std::vector<int> waiting;
  for (const tinygltf::Scene& scene : model.scenes) {
    waiting.insert(waiting.end(), scene.nodes.begin(), scene.nodes.end());
  }
  while (!waiting.empty()) {
    const auto index = static_cast<std::size_t>(waiting.back());
    waiting.pop_back();
    if (drawn.nodes[index]) continue;
    drawn.nodes[index] = true;
    const std::vector<int>& children = model.nodes[index].children;
    waiting.insert(waiting.end(), children.begin(), children.end());
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const tinygltf::Node& node = model.nodes[i];
    if (!drawn.nodes[i] || node.mesh < 0) continue;
    drawn.meshes[static_cast<std::size_t>(node.mesh)] = true;
    if (node.skin >= 0) drawn.skins[static_cast<std::size_t>(node.skin)] = true;
  }
  return drawn;
}

void import_nodes(Import& import) {
  const auto& nodes = import.document.model().nodes;
  import.scene.nodes.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    import.scene.nodes.push_back(node_of(import, nodes[i], element("nodes", i), import.drawn.nodes[i]));
  }
  expand_instances(import);
  set_parents(import);
  check_cycles(import);
  import_scenes(import);
}

}  // namespace barrido::scene::gltf
