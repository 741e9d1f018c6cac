// The fixed-function state of draws. Enters: settings, a view, lights, a surface; leaves: pipeline::State.
#pragma once

#include "pipeline/scene/draw_list.h"
#include "pipeline/scene/light_conversion.h"
#include "pipeline/scene/render_scene.h"
#include "pipeline/state.h"

namespace barrido::scene {

/// An environment's cube map and what turns eye space into its directions.
struct Reflection {
  const raster::Texture* map = nullptr;
  glm::mat4 map_from_eye{1.0f};
};

/// Whether all rays of the view are parallel (an orthographic camera).
inline bool is_parallel(const View& view) { return view.clip_from_eye[3][3] != 0.0f; }

/// Whether the frame is computed in floats, beyond 1; else with OpenGL's 8 bits.
bool uses_float_frame(const RenderSettings& settings);

/// A colour that the user gives as it is to be seen on the screen, in the numbers that the frame is computed
/// in: the display transform's inverse.
glm::vec3 frame_color(const glm::vec3& seen, const RenderSettings& settings);

/// What all draws of a view have in common: techniques, matrices, lights (brought to eye space), fog.
pipeline::State base_state(const RenderSettings& settings, const View& view, const SceneLights& lights,
                           const std::optional<raster::FogState>& fog);

/// The complete state of one draw. `write_alpha` is false where the frame is opaque already.
pipeline::State state_of(const pipeline::State& base, const RenderSettings& settings, const View& view,
                         const Draw& draw, const Reflection& reflection, bool write_alpha);

}  // namespace barrido::scene
