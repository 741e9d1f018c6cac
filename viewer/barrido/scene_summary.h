// What a loaded file holds, counted and measured, for `barrido info`. Enters: a scene; leaves: numbers and
// names. Draws nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "pipeline/scene/scene.h"

namespace barrido::cli {

/// Primitives by what they are made of; strips and fans count the triangles they hold.
struct PrimitiveCounts {
  std::uint64_t primitives = 0;  ///< glTF primitives
  std::uint64_t triangles = 0;
  std::uint64_t lines = 0;
  std::uint64_t points = 0;
  std::uint64_t vertices = 0;
};

struct Box {
  glm::vec3 least{0.0f};
  glm::vec3 most{0.0f};
};

struct SceneSummary {
  PrimitiveCounts stored;         ///< Each mesh once.
  PrimitiveCounts drawn;          ///< As often as nodes of the default scene use it.
  std::vector<int> camera_nodes;  ///< Nodes of the default scene with cameras: what --camera-index counts.
  std::vector<int> light_nodes;   ///< Nodes of the default scene with lights.
  std::optional<Box> bounds;      ///< World space, as the scene stands; empty when nothing finite is drawn.
};

SceneSummary summarize(const scene::Scene& scene);

/// The summary as text for people, ending in a line feed.
std::string info_text(const scene::Scene& scene, const SceneSummary& summary);
/// The same as a JSON object on several lines, ending in a line feed.
std::string info_json(const scene::Scene& scene, const SceneSummary& summary);

}  // namespace barrido::cli
