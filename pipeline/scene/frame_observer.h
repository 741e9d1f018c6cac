// A look at a frame after everything that decides its pixels is settled and before they are drawn. For the
// pixel inspector and the views of cost and structure. Nothing here changes what is drawn.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/assembled_frame.h"
#include "pipeline/geometry.h"
#include "pipeline/scene/light_conversion.h"
#include "pipeline/scene/prepared_geometry.h"
#include "pipeline/scene/render_scene.h"
#include "pipeline/scene/straight_alpha.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::scene {

/// What in the scene a draw is made of.
struct DrawOrigin {
  bool backdrop = false;  ///< The environment behind everything; the rest is not set then.
  int node = kNone;
  int mesh = kNone;
  int primitive = 0;     ///< Of the mesh
  int material = kNone;  ///< kNone: glTF's default material
  /// As the primitive has it; the triangles of blended draws are sorted.
  const pipeline::Geometry* geometry = nullptr;
  const Displaced* displaced = nullptr;  ///< Null where it is not.
};

struct ObservedFrame {
  const pipeline::AssembledFrame& assembled;
  const std::vector<DrawOrigin>& origins;  ///< One for each of the frame's draws.
  const View& view;
  const SceneLights& lights;
  const raster::FramebufferOptions& options;
  std::optional<Backing> backing;  ///< Where the finished colours are made straight.
};

class FrameObserver {
 public:
  FrameObserver() = default;
  virtual ~FrameObserver() = default;
  FrameObserver(const FrameObserver&) = delete;
  FrameObserver& operator=(const FrameObserver&) = delete;

  /// Called once a frame. What it is shown is gone afterwards.
  /// @return whether the frame shall be drawn.
  virtual bool observe(const ObservedFrame& frame) = 0;
};

}  // namespace barrido::scene
