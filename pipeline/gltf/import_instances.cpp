// EXT_mesh_gpu_instancing: each instance of a node's mesh becomes a child of the node, which then has no mesh
// itself.
#include <cmath>
#include <utility>

#include "pipeline/gltf/import_parts.h"
#include "pipeline/gltf/values.h"

namespace barrido::scene::gltf {
namespace {

constexpr const char* kName = "EXT_mesh_gpu_instancing";
constexpr std::uint64_t kOfAnInstance = 4096;  // Its node, and its draw later

/// The instances' numbers; empty where they are not given.
struct Instances {
  std::size_t count = 0;
  FloatArray translations, rotations, scales;

  Transform transform(std::size_t i) const {
    Transform transform;
    if (!translations.empty()) {
      const float* t = translations.data() + 3 * i;
      transform.translation = glm::dvec3(t[0], t[1], t[2]);
    }
    if (!rotations.empty()) {
      const float* r = rotations.data() + 4 * i;
      const float square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3];
      const float scale = square > 0.0f ? 1.0f / std::sqrt(square) : 0.0f;
      if (scale > 0.0f) transform.rotation = {r[3] * scale, r[0] * scale, r[1] * scale, r[2] * scale};
    }
    if (!scales.empty()) {
      const float* s = scales.data() + 3 * i;
      transform.scale = {s[0], s[1], s[2]};
    }
    return transform;
  }
};

Instances read_instances(Import& import, const tinygltf::Value& extension, const std::string& node_place) {
  Instances instances;
  const auto read = [&](const char* name, int components, unsigned formats) -> FloatArray {
    const tinygltf::Value& value = member(member(extension, "attributes"), name);
    if (!value.IsNumber()) return {};
    const std::string place = node_place + ".extensions." + kName + ".attributes." + name;
    const int accessor = whole_number(value);
    const std::size_t accessors = import.document.model().accessors.size();
    if (accessor < 0 || static_cast<std::size_t>(accessor) >= accessors) {
      import.report.fail(place,
                         "must be the number of an accessor, and there are " + std::to_string(accessors));
    }
    import.reader.require(accessor, place, {components}, formats, instances.count);
    instances.count = import.reader.count(accessor);
    return import.reader.floats(accessor);
  };
  instances.translations = read("TRANSLATION", 3, kFloat);
  instances.rotations = read("ROTATION", 4, kFloat | kNormalizedByte | kNormalizedShort);
  instances.scales = read("SCALE", 3, kFloat);
  return instances;
}

}  // namespace

void expand_instances(Import& import) {
  const auto& sources = import.document.model().nodes;
  auto& nodes = import.scene.nodes;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto extension = sources[i].extensions.find(kName);
    if (extension == sources[i].extensions.end() || nodes[i].mesh == kNone) continue;
    const std::string place = element("nodes", i);
    const Instances instances = read_instances(import, extension->second, place);
    if (instances.count == 0) continue;
    import.document.budget().take(kOfAnInstance * instances.count, import.report.file(), place);
    Node instance;
    instance.mesh = std::exchange(nodes[i].mesh, kNone);
    instance.skin = std::exchange(nodes[i].skin, kNone);
    instance.morph_weights = nodes[i].morph_weights;
    for (std::size_t n = 0; n < instances.count; ++n) {
      instance.name = nodes[i].name.empty() ? std::string() : element(nodes[i].name, n);
      instance.transform = instances.transform(n);
      nodes[i].children.push_back(static_cast<int>(nodes.size()));
      nodes.push_back(instance);
    }
  }
}

}  // namespace barrido::scene::gltf
