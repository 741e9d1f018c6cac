#include "viewer/barrido/scene_summary.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "pipeline/scene/animate.h"
#include "pipeline/scene/light_conversion.h"
#include "pipeline/scene/scene_nodes.h"
#include "pipeline/scene/triangles.h"

namespace barrido::cli {
namespace {

using pipeline::PrimitiveMode;

void count(const scene::Primitive& primitive, PrimitiveCounts& counts) {
  const std::uint64_t n = primitive.indices.empty() ? primitive.vertex_count : primitive.indices.size();
  counts.primitives += 1;
  counts.vertices += primitive.vertex_count;
  switch (primitive.mode) {
    case PrimitiveMode::points:
      counts.points += n;
      break;
    case PrimitiveMode::lines:
      counts.lines += n / 2;
      break;
    case PrimitiveMode::line_loop:
      counts.lines += n >= 2 ? n : 0;
      break;
    case PrimitiveMode::line_strip:
      counts.lines += n >= 2 ? n - 1 : 0;
      break;
    case PrimitiveMode::triangles:
      counts.triangles += n / 3;
      break;
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::triangle_fan:
    case PrimitiveMode::polygon:
      counts.triangles += n >= 3 ? n - 2 : 0;
      break;
    case PrimitiveMode::quads:
      counts.triangles += n / 4 * 2;
      break;
    case PrimitiveMode::quad_strip:
      counts.triangles += n >= 4 ? n / 2 * 2 - 2 : 0;
      break;
  }
}

/// The box grows around points as they come; points that are not finite are left out.
class BoxBuilder {
 public:
  void add(const glm::vec3& point) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) return;
    if (!box_) box_ = Box{point, point};
    box_->least = glm::min(box_->least, point);
    box_->most = glm::max(box_->most, point);
  }
  const std::optional<Box>& box() const { return box_; }

 private:
  std::optional<Box> box_;
};

void add_points(BoxBuilder& box, std::span<const float> positions, const std::vector<bool>& drawn,
                const glm::mat4& world_from_points, const glm::dvec3& origin) {
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    if (!drawn.empty() && !drawn[i / 3]) continue;
    const glm::vec3 p(world_from_points * glm::vec4(positions[i], positions[i + 1], positions[i + 2], 1.0f));
    box.add(origin == glm::dvec3(0.0) ? p : glm::vec3(glm::dvec3(p) + origin));
  }
}

void add_node(BoxBuilder& box, const scene::Scene& scene, const scene::Pose& pose, int node) {
  const auto index = static_cast<std::size_t>(node);
  if (scene.nodes[index].mesh == scene::kNone) return;
  const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.nodes[index].mesh)];
  for (const scene::Primitive& primitive : mesh.primitives) {
    const glm::mat4& world_from_node = pose.world_from_node[index];
    const std::vector<bool> drawn =
        scene::drawn_vertices(primitive.mode, primitive.indices.values(), primitive.vertex_count);
    if (!scene::is_deformed(scene, node, primitive)) {
      add_points(box, primitive.positions.values(), drawn, world_from_node, pose.origin);
      continue;
    }
    const scene::DeformedVertices deformed = scene::deform(scene, pose, node, primitive);
    add_points(box, deformed.positions, drawn, deformed.in_world_space ? glm::mat4(1.0f) : world_from_node,
               pose.origin);
  }
}

}  // namespace

SceneSummary summarize(const scene::Scene& scene) {
  SceneSummary summary;
  for (const scene::Mesh& mesh : scene.meshes) {
    for (const scene::Primitive& primitive : mesh.primitives) count(primitive, summary.stored);
  }
  const int root = scene::resolve_scene_index(scene, scene::kNone);
  const std::vector<int> nodes = scene::nodes_of_scene(scene, root);
  const scene::Pose pose = scene::pose_at(scene, scene::kNone, 0.0);
  BoxBuilder box;
  for (const int node : nodes) {
    add_node(box, scene, pose, node);
    const int mesh = scene.nodes[static_cast<std::size_t>(node)].mesh;
    if (mesh == scene::kNone) continue;
    for (const auto& primitive : scene.meshes[static_cast<std::size_t>(mesh)].primitives) {
      count(primitive, summary.drawn);
    }
  }
  summary.bounds = box.box();
  summary.camera_nodes = scene::camera_nodes(scene, nodes);
  summary.light_nodes = scene::light_nodes(scene, nodes);
  return summary;
}

}  // namespace barrido::cli
