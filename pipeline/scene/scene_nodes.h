// Which nodes and materials take part in a frame. Enters: a scene and the choice of one of its roots; leaves:
// node indices.
#pragma once

#include <string>
#include <vector>

#include "pipeline/scene/scene.h"

namespace barrido::scene {

/// Index into Scene::scenes that `scene_index` names: itself, the default for kNone, or kNone when the file
/// has no scenes at all.
/// @throws InputError when the file has no such scene.
int resolve_scene_index(const Scene& scene, int scene_index);

/// Index into Scene::variants of the one called `name`; kNone for an empty name.
/// @throws InputError, which lists the names, when there is none.
int resolve_variant(const Scene& scene, const std::string& name);

/// The nodes below the roots of scene `resolved_index`, ascending; every node when that is kNone.
std::vector<int> nodes_of_scene(const Scene& scene, int resolved_index);

/// The nodes among `nodes` that carry a camera, in order.
std::vector<int> camera_nodes(const Scene& scene, const std::vector<int>& nodes);

}  // namespace barrido::scene
