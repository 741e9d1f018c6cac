// What a file asks for and how well it is drawn: extensions by name, and the features of glTF's core that a
// fixed-function pipeline cannot draw as they are meant.
#include <algorithm>
#include <string_view>

#include "pipeline/gltf/import_parts.h"

namespace barrido::scene::gltf {
namespace {

using Support = Feature::Support;

struct KnownExtension {
  std::string_view name;
  Support support;
  const char* note;
};

constexpr KnownExtension kSupportedExtensions[] = {
    {"EXT_mesh_gpu_instancing", Support::exact, "each instance is a node"},
    {"EXT_meshopt_compression", Support::exact, ""},
    {"EXT_texture_webp", Support::exact, ""},
    {"KHR_animation_pointer", Support::approximated,
     "nodes, base colours, emission, texture transforms, lights and cameras move; other properties stand"},
    {"KHR_draco_mesh_compression", Support::exact, ""},
    {"KHR_lights_punctual", Support::approximated, "light units become intensities of fixed-function lights"},
    {"KHR_materials_anisotropy", Support::approximated, "as a round highlight of the same size"},
    {"KHR_materials_clearcoat", Support::approximated,
     "as a second highlight and reflection, drawn over the first"},
    {"KHR_materials_emissive_strength", Support::exact, ""},
    {"KHR_materials_ior", Support::approximated, "as the strength of highlights; nothing is refracted"},
    {"KHR_materials_iridescence", Support::approximated, "as the colour of highlights at normal incidence"},
    {"KHR_materials_pbrSpecularGlossiness", Support::approximated,
     "as k_d, k_s and n; pictures of k_s by their mean"},
    {"KHR_materials_sheen", Support::approximated, "as a colour added to k_d"},
    {"KHR_materials_specular", Support::approximated, "as k_s; of metals, pictures by their mean"},
    {"KHR_materials_transmission", Support::approximated, "as blending by its colour, without blur"},
    {"KHR_materials_unlit", Support::exact, "lighting is switched off"},
    {"KHR_materials_variants", Support::exact, "--variant NAME chooses"},
    {"KHR_materials_volume", Support::approximated,
     "as the colour of what is seen through; nothing is refracted"},
    {"KHR_mesh_quantization", Support::exact, ""},
    {"KHR_meshopt_compression", Support::exact, "but for its own filter and the vertex codec's version 1"},
    {"KHR_texture_basisu", Support::approximated, "the picture that a file holds beside it is used"},
    {"KHR_texture_transform", Support::exact, "as the texture matrix"},
};

/// Extensions that add to what is drawn, or to what is known about it: a picture without them is still one of
/// the model. Others, when they are required, may change what the numbers in the file mean.
constexpr std::string_view kIgnorable[] = {
    "ADOBE_materials_",
    "AGI_articulations",
    "AGI_stk_metadata",
    "CESIUM_primitive_outline",
    "EXT_feature_metadata",
    "EXT_instance_features",
    "EXT_lights_",
    "EXT_materials_",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "EXT_property_feature",
    "EXT_structural_metadata",
    "EXT_texture_",
    "FB_geometry_metadata",
    "FB_materials_",
    "GODOT_",
    "KHR_audio",
    "KHR_character",
    "KHR_environment_map",
    "KHR_interactivity",
    "KHR_lights_",
    "KHR_materials_",
    "KHR_node_",
    "KHR_physics_",
    "KHR_collision_",
    "KHR_techniques_webgl",
    "KHR_texture_",
    "KHR_xmp",
    "MPEG_",
    "MSFT_audio_",
    "MSFT_lod",
    "MSFT_packing_",
    "MSFT_texture_dds",
    "NV_materials_",
    "OMI_",
    "VRM",
};

bool is_ignorable(std::string_view name) {
  return std::any_of(std::begin(kIgnorable), std::end(kIgnorable),
                     [&](std::string_view prefix) { return name.starts_with(prefix); });
}

const KnownExtension* find_extension(const std::string& name) {
  const auto found = std::find_if(std::begin(kSupportedExtensions), std::end(kSupportedExtensions),
                                  [&](const KnownExtension& known) { return known.name == name; });
  return found == std::end(kSupportedExtensions) ? nullptr : found;
}

bool any_material(const Scene& scene, bool (*has)(const Material&)) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), has);
}

bool any_primitive(const Scene& scene, bool (*has)(const Primitive&)) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(), has);
  });
}

bool any_sparse(const tinygltf::Model& model) {
  return std::any_of(model.accessors.begin(), model.accessors.end(),
                     [](const tinygltf::Accessor& accessor) { return accessor.sparse.isSparse; });
}

void list_extensions(Import& import) {
  for (const std::string& name : import.document.model().extensionsUsed) {
    if (const KnownExtension* known = find_extension(name)) {
      import.scene.features.push_back({name, known->support, known->note});
    } else {
      import.scene.features.push_back(
          {one_line(name, 80), Support::ignored, "the model is drawn without it"});
    }
  }
}

void list_materials(Import& import) {
  const Scene& scene = import.scene;
  const auto add = [&](bool found, const char* name, Support support, const char* note = "") {
    if (found) import.scene.features.push_back({name, support, note});
  };
  add(any_material(scene, [](const Material& m) { return !m.unlit; }), "material: metallic-roughness",
      Support::approximated, "converted to ambient, diffuse, specular and shininess");
  add(any_material(scene, [](const Material& m) { return m.base_color_texture.texture != kNone; }),
      "material: base colour texture", Support::exact);
  add(any_material(scene, [](const Material& m) { return m.metallic_roughness_texture.texture != kNone; }),
      "material: metallic-roughness texture", Support::approximated, "its mean is used");
  add(any_material(scene, [](const Material& m) { return m.emissive_texture.texture != kNone; }),
      "material: emissive texture", Support::exact);
  add(any_material(scene, [](const Material& m) { return m.occlusion_texture.texture != kNone; }),
      "material: occlusion texture", Support::exact, "a factor of ambient light, in Phong shading");
  add(any_material(scene, [](const Material& m) { return m.normal_texture.texture != kNone; }),
      "material: normal texture", Support::exact, "in Phong shading");
  add(any_material(scene, [](const Material& m) { return m.alpha_mode == AlphaMode::mask; }),
      "material: alpha mask", Support::exact, "as the alpha test");
  add(any_material(scene, [](const Material& m) { return m.alpha_mode == AlphaMode::blend; }),
      "material: alpha blending", Support::approximated, "surfaces are sorted, not their pixels");
  add(any_material(scene, [](const Material& m) { return m.double_sided; }), "material: double-sided",
      Support::exact, "as two-sided lighting");
}

void list_geometry(Import& import) {
  const Scene& scene = import.scene;
  const auto add = [&](bool found, const char* name) {
    if (found) import.scene.features.push_back({name, Support::exact, ""});
  };
  add(any_primitive(scene, [](const Primitive& p) { return p.mode < pipeline::PrimitiveMode::triangles; }),
      "mesh: points and lines");
  add(any_primitive(scene, [](const Primitive& p) { return !p.colors.empty(); }), "mesh: vertex colours");
  add(any_primitive(scene, [](const Primitive& p) { return !p.texcoords[1].empty(); }),
      "mesh: second texture coordinates");
  add(any_primitive(scene, [](const Primitive& p) { return !p.morph_targets.empty(); }),
      "mesh: morph targets");
  add(!scene.skins.empty(), "skins");
  add(!scene.animations.empty(), "animations");
  add(!scene.cameras.empty(), "cameras");
  add(any_sparse(import.document.model()), "sparse accessors");
}

}  // namespace

void check_extensions(Import& import) {
  const tinygltf::Model& model = import.document.model();
  for (const std::string& name : model.extensionsRequired) {
    if (find_extension(name) == nullptr && !is_ignorable(name)) {
      import.report.fail("extensionsRequired", one_line(name, 80) + " is not supported");
    }
  }
  std::string unknown;
  std::vector<std::string> names = model.extensionsUsed;
  for (const std::string& name : model.extensionsRequired) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  for (const std::string& name : names) {
    if (find_extension(name) != nullptr) continue;
    unknown += (unknown.empty() ? "" : ", ") + one_line(name, 80);
  }
  if (!unknown.empty()) import.report.warn("not supported and ignored: " + one_line(unknown, 400));
}

namespace {

/// Extensions have a warning of their own.
void warn_of_ignored(Import& import) {
  std::string ignored;
  for (const Feature& feature : import.scene.features) {
    constexpr std::string_view kMaterial = "material: ";
    if (feature.support != Support::ignored || !feature.name.starts_with(kMaterial)) continue;
    ignored += (ignored.empty() ? "" : ", ") + feature.name.substr(kMaterial.size());
  }
  if (!ignored.empty()) import.report.warn("of materials, ignored: " + ignored);
}

}  // namespace

void list_features(Import& import) {
  list_extensions(import);
  list_materials(import);
  list_geometry(import);
  warn_of_ignored(import);
}

}  // namespace barrido::scene::gltf
