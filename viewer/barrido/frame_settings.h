// From the options of a command to what the renderer takes. Enters: options; leaves: settings with colours
// resolved, and the environment's cube map. Knows no output.
#pragma once

#include <memory>

#include "pipeline/scene/render_scene.h"
#include "viewer/barrido/render_options.h"

namespace barrido::cli {

/// What the renderer looks at; pictures for other uses need not be decoded.
extern const unsigned kDrawnImages;

/// Colours are passed as they are to be seen: the renderer undoes its own display transform. The environment
/// is left out, and what differs from frame to frame.
scene::RenderSettings resolved_settings(const RenderOptions& options);

/// The cube map of --environment PATH; null where none was asked for. @throws scene::InputError.
std::shared_ptr<const raster::Texture> load_environment(const RenderOptions& options,
                                                        scene::Budget* budget = nullptr);

}  // namespace barrido::cli
