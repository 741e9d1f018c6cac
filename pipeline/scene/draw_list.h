// What there is to draw in a frame, whatever the eye. Enters: a scene in a pose; leaves: one draw a
// primitive and surface, with its geometry. Knows no lights and no view.
#pragma once

#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>

#include "pipeline/scene/displacer.h"
#include "pipeline/scene/prepared_geometry.h"
#include "pipeline/scene/surface.h"

namespace barrido::scene {

struct Draw {
  int node = kNone;
  int mesh = kNone;
  int primitive = 0;     ///< Of the mesh
  int material = kNone;  ///< kNone: glTF's default material
  glm::mat4 world_from_object{1.0f};
  bool mirrored = false;  ///< The matrix turns left into right, and so front into back.
  SurfaceState surface;
  pipeline::Geometry geometry;
  glm::vec3 center{0, 0, 0};             ///< Middle of the bounding box, object space
  const Displaced* displaced = nullptr;  ///< Null where it is not.
};

struct DrawList {
  std::vector<Draw> draws;  ///< In node order
  /// Vertices that were deformed for this frame; the draws point into them.
  std::vector<std::unique_ptr<PreparedGeometry>> deformed;
  /// Texture coordinates that were made for this frame; the draws point into them.
  std::vector<std::unique_ptr<std::vector<float>>> coordinates;
  std::uint64_t displaced_vertices = 0, displaced_triangles = 0;  ///< Of all draws
};

/// What of the settings the draws depend on, and what lives longer than they.
struct DrawListInputs {
  std::optional<float> crease_angle_deg;
  const SurfaceOptions& options;
  Displacer& displacer;
  GeometryCache& geometry;
  TextureCache& textures;
};

/// The draws of `nodes` in `pose`. Arrays that do not depend on the pose stay in `geometry`. @throws
/// LimitError where a displacement takes more memory than it may.
DrawList collect_draws(const Scene& scene, const std::vector<int>& nodes, const Pose& pose,
                       const DrawListInputs& inputs);

}  // namespace barrido::scene
