// Lines over a finished picture: edges of triangles, normals, where the lights are. Enters: the draws and
// lights of a frame; leaves: more draws, without light, texture and fog. Knows no files and no keys.
#pragma once

#include <list>
#include <vector>

#include "pipeline/renderer.h"
#include "pipeline/scene/frame.h"

namespace barrido::scene {

/// Must live until the renderer is finished: it owns the lines.
class Overlay {
 public:
  /// Both must outlive the overlay.
  Overlay(const RenderSettings& settings, const View& view) : settings_(settings), view_(view) {}

  /// Draws what is asked for on top of what was drawn; hidden lines stay hidden.
  void draw(pipeline::Renderer& renderer, const pipeline::State& base, const SceneFrame& frame,
            const Overlays& wanted);

 private:
  struct Lines {
    std::vector<float> positions;  ///< 3 floats a vertex
    std::vector<float> colors;     ///< 3 floats a vertex, or empty
  };

  pipeline::State line_state(const pipeline::State& base) const;
  void draw_edges(pipeline::Renderer& renderer, const pipeline::State& base, const Draw& draw);
  void draw_normals(pipeline::Renderer& renderer, const pipeline::State& base, const Draw& draw,
                    float length);
  void draw_mapping(pipeline::Renderer& renderer, const pipeline::State& base, const Draw& draw);
  void draw_lights(pipeline::Renderer& renderer, const pipeline::State& base, const SceneFrame& frame);
  void submit(pipeline::Renderer& renderer, const pipeline::State& state, Lines lines,
              const glm::vec4& color);
  glm::vec4 color_of(const glm::vec3& seen) const;

  const RenderSettings& settings_;
  const View& view_;
  std::list<Lines> lines_;
};

}  // namespace barrido::scene
