// Small scenes made in memory, for tests of what is drawn and how.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "pipeline/scene/scene.h"

namespace barrido::scene::testing {

/// A scene with nodes that each show a mesh of their own; one glTF scene holds them all.
class SceneBuilder {
 public:
  /// @return the node's index.
  int add_node(Node node) {
    const int index = static_cast<int>(scene.nodes.size());
    scene.nodes.push_back(std::move(node));
    if (scene.scenes.empty()) scene.scenes.emplace_back();
    scene.scenes[0].nodes.push_back(index);
    return index;
  }

  int add_mesh_node(Primitive primitive, const glm::vec3& translation = {0, 0, 0}) {
    Mesh mesh;
    mesh.primitives.push_back(std::move(primitive));
    scene.meshes.push_back(std::move(mesh));
    Node node;
    node.mesh = static_cast<int>(scene.meshes.size()) - 1;
    node.transform.translation = translation;
    return add_node(node);
  }

  int add_material(const Material& material) {
    scene.materials.push_back(material);
    return static_cast<int>(scene.materials.size()) - 1;
  }

  Scene scene;
};

inline Primitive triangles(std::vector<float> positions, std::vector<std::uint32_t> indices = {}) {
  Primitive primitive;
  primitive.vertex_count = static_cast<std::uint32_t>(positions.size() / 3);
  primitive.positions = FloatArray(std::move(positions));
  primitive.indices = IndexArray(std::move(indices));
  return primitive;
}

/// A square of half side 1 in the plane z = 0 that faces +Z, with normals.
inline Primitive square(int material = kNone) {
  Primitive primitive = triangles({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, {0, 1, 2, 0, 2, 3});
  primitive.normals = FloatArray(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  primitive.material = material;
  return primitive;
}

}  // namespace barrido::scene::testing
