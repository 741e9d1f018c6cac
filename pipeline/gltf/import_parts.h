// The steps of an import, one source file each. Every step reads the checked document and fills its own part
// of the scene; import_gltf.cpp shows their order.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/gltf/accessor.h"
#include "pipeline/gltf/document.h"
#include "pipeline/gltf/import_gltf.h"
#include "pipeline/gltf/report.h"

namespace barrido::scene::gltf {

/// What the nodes of any scene use, and so whatever can be asked for; without scenes all nodes count.
struct DrawnElements {
  std::vector<bool> nodes, meshes, skins;
};
DrawnElements find_drawn(const tinygltf::Model& model);

struct Import {
  Report& report;
  const Document& document;
  AccessorReader& reader;
  const ImportOptions& options;
  Scene& scene;
  const DrawnElements& drawn;
};

/// Runs `read`; what is wrong with an element that is not drawn is a warning. @return whether it was read.
template <typename Read>
bool read_or_warn(Import& import, bool is_drawn, const char* consequence, Read read) {
  if (is_drawn) {
    read();
    return true;
  }
  try {
    read();
    return true;
  } catch (const LimitError&) {
    throw;
  } catch (const InputError& error) {
    import.report.warn(std::string(error.what()).substr(import.report.file().size() + 2) + "; " +
                       consequence);
    return false;
  }
}

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
/// extras.barrido of materials; their pictures are yet to be read.
void import_material_extras(Import& import);
/// extras.barrido of lights and scenes.
void import_extras(Import& import);
/// Scene::features, from what the other steps have found.
void list_features(Import& import);

/// A use of a texture as a material names it; kNone for a negative `index`. `extensions`: of the texture's
/// use.
TextureUse texture_use(Import& import, int index, int texcoord_set, const tinygltf::ExtensionMap& extensions);
/// What extensions add to the material; null where there is nothing. `place` is for messages.
std::shared_ptr<const MaterialLayers> layers_of(Import& import, const tinygltf::Material& source,
                                                const std::string& place);
/// The material of KHR_materials_pbrSpecularGlossiness in place of metallic-roughness, as far as both have
/// the same properties.
void use_specular_glossiness(Import& import, const tinygltf::Material& source, const std::string& place,
                             Material& material);

/// Scene::variants.
void import_variants(Import& import);
/// The material of the primitive in each variant that gives it another. `place` is for messages.
std::map<int, int> variant_materials_of(const Import& import, const tinygltf::Primitive& source,
                                        const std::string& place);
/// Nodes for the instances of EXT_mesh_gpu_instancing; their parents are not yet set.
void expand_instances(Import& import);

/// JSON numbers may be larger than any float.
float to_float(double value);

}  // namespace barrido::scene::gltf
