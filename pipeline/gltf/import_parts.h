// The steps of an import, one source file each. Every step reads the checked document and fills its own part
// of the scene; import_gltf.cpp shows their order.
#pragma once

#include <cstddef>
#include <string>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/gltf/accessor.h"
#include "pipeline/gltf/document.h"
#include "pipeline/gltf/import_gltf.h"
#include "pipeline/gltf/report.h"

namespace barrido::scene::gltf {

struct Import {
  Report& report;
  const Document& document;
  AccessorReader& reader;
  const ImportOptions& options;
  Scene& scene;
};

/// extensionsRequired that are not supported end the import; unknown extensionsUsed are one warning.
void check_extensions(Import& import);
/// Samplers, textures, materials with their extensions.
void import_materials(Import& import);
/// Decodes, in parallel, the images that materials use.
void import_images(Import& import);
void import_cameras(Import& import);
/// KHR_lights_punctual.
void import_lights(Import& import);
void import_meshes(Import& import);
/// Nodes and scenes; afterwards the nodes are known to form strict trees.
void import_nodes(Import& import);
/// Skins, and that every joint a mesh names is one of its skin.
void import_skins(Import& import);
void import_animations(Import& import);
/// extras.barrido of materials, lights and scenes.
void import_extras(Import& import);
/// Scene::features, from what the other steps have found.
void list_features(Import& import);

/// JSON numbers may be larger than any float.
float to_float(double value);

}  // namespace barrido::scene::gltf
