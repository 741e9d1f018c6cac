// Environments in a frame: drawn behind everything, and made by the z-buffer itself from an object's centre
// (T17). Enters: cube maps, draws; leaves: a backdrop in the frame, or a new cube map.
#pragma once

#include <array>
#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "pipeline/renderer.h"
#include "pipeline/scene/framing.h"
#include "pipeline/scene/render_scene.h"

namespace barrido::scene {

/// What the background of a view is made of.
struct Backdrop {
  const raster::Texture* map = nullptr;  ///< Null: nothing is drawn, the clear colour stays.
  glm::mat4 map_from_eye{1.0f};
};

/// Draws a cube around the eye at the far plane, where nothing has been drawn yet; the depth stays. A view
/// with parallel rays shows the map as a view of 45° would.
void draw_backdrop(pipeline::Renderer& renderer, const Backdrop& backdrop, const View& view, double aspect,
                   bool clamp_colors);

/// The view of a cube map's face from `center`: 90° each way, the rows from t = 0 upwards as the frame's
/// window coordinates run.
View cube_face_view(int face, const glm::dvec3& center, const Sphere& bounds);

/// Six frames of one size become a cube map with mip levels.
raster::Texture cube_of_frames(std::span<const raster::Framebuffer> frames, raster::Encoding encoding);

/// Sums the work of two renderers.
void add(pipeline::Statistics& sum, const pipeline::Statistics& more);

}  // namespace barrido::scene
