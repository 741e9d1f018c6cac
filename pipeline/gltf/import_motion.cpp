// Skins and animations: joints, inverse bind matrices, and key frames as plain floats.
#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "pipeline/gltf/import_pointers.h"

namespace barrido::scene::gltf {
namespace {

constexpr unsigned kAnyFormat = kFloat | kByte | kUnsignedByte | kShort | kUnsignedShort | kNormalizedByte |
                                kNormalizedUnsignedByte | kNormalizedShort | kNormalizedUnsignedShort;

Skin skin_of(Import& import, const tinygltf::Skin& source, const std::string& place) {
  Skin skin;
  skin.joints = source.joints;
  if (skin.joints.empty()) import.report.fail(place + ".joints", "a skin needs at least one joint");
  skin.inverse_bind_matrices.assign(skin.joints.size(), glm::mat4(1.0f));
  if (source.inverseBindMatrices < 0) return skin;
  const std::string matrices_place = place + ".inverseBindMatrices";
  import.reader.require(source.inverseBindMatrices, matrices_place, {16}, kFloat);
  const FloatArray values = import.reader.floats(source.inverseBindMatrices);
  if (values.size() < 16 * skin.joints.size()) {
    import.report.fail(matrices_place, "there are " + std::to_string(values.size() / 16) + " matrices for " +
                                           std::to_string(skin.joints.size()) + " joints");
  }
  for (std::size_t i = 0; i < 16 * skin.joints.size(); ++i) {
    skin.inverse_bind_matrices[i / 16][static_cast<int>(i % 16 / 4)][static_cast<int>(i % 4)] =
        values.data()[i];
  }
  return skin;
}

/// The largest joint that each mesh names; -1 where it names none.
std::vector<int> largest_joints(const Scene& scene) {
  std::vector<int> largest(scene.meshes.size(), -1);
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    for (const Primitive& primitive : scene.meshes[mesh].primitives) {
      for (const auto& joints : primitive.joints) {
        for (const std::uint16_t joint : joints) largest[mesh] = std::max(largest[mesh], int{joint});
      }
    }
  }
  return largest;
}

void check_joints(Import& import) {
  Scene& scene = import.scene;
  const std::vector<int> largest = largest_joints(scene);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    Node& node = scene.nodes[i];
    if (i < import.drawn.nodes.size() && !import.drawn.nodes[i]) node.skin = kNone;
    if (node.skin == kNone) continue;
    const std::size_t joints = scene.skins[static_cast<std::size_t>(node.skin)].joints.size();
    const auto mesh = static_cast<std::size_t>(node.mesh);
    if (largest[mesh] >= static_cast<int>(joints)) {
      import.report.fail(element("nodes", i), element("meshes", mesh) + " names joint " +
                                                  std::to_string(largest[mesh]) + ", but " +
                                                  element("skins", static_cast<std::size_t>(node.skin)) +
                                                  " has only " + std::to_string(joints));
    }
  }
}

class AnimationImporter {
 public:
  AnimationImporter(Import& import, std::size_t index)
      : import_(import),
        source_(import.document.model().animations[index]),
        tree_(import.document.tree().at("animations")[index]),
        place_(element("animations", index)) {}

  Animation run() {
    Animation animation;
    animation.name = source_.name;
    for (std::size_t i = 0; i < source_.channels.size(); ++i) {
      read_or_warn(import_, false, "this channel is left out",
                   [&] { read_channel(source_.channels[i], animation); });
    }
    // tinygltf leaves out what has no node.
    for (const nlohmann::json& channel : tree_.at("channels")) {
      read_or_warn(import_, false, "this channel is left out", [&] { read_pointer(channel, animation); });
    }
    return animation;
  }

 private:
  using Path = AnimationChannel::Path;
  using Interpolation = AnimationChannel::Interpolation;

  void check_sampler(int sampler) const {
    if (sampler >= 0 && static_cast<std::size_t>(sampler) < source_.samplers.size()) return;
    import_.report.fail(place_ + ".channels", "refers to samplers[" + std::to_string(sampler) +
                                                  "], but there are " +
                                                  std::to_string(source_.samplers.size()));
  }

  void read_channel(const tinygltf::AnimationChannel& channel, Animation& animation) {
    check_sampler(channel.sampler);
    if (channel.target_node < 0) return;  // Nothing that glTF's core animates.
    AnimationChannel result;
    if (!read_target(channel, result)) return;
    add(channel.sampler, std::move(result), animation);
  }

  void add(int sampler, AnimationChannel channel, Animation& animation) {
    read_keys(sampler, node_components(channel), channel);
    add_duration(channel, animation);
    animation.channels.push_back(std::move(channel));
  }

  /// A channel whose target is named by KHR_animation_pointer.
  void read_pointer(const nlohmann::json& channel, Animation& animation) {
    const nlohmann::json& target = channel.at("target");
    const nlohmann::json::json_pointer place("/extensions/KHR_animation_pointer/pointer");
    if (target.contains("node") || target.value("path", std::string()) != "pointer") return;
    if (!target.contains(place) || !target[place].is_string()) return;
    const int sampler = channel.at("sampler").get<int>();
    check_sampler(sampler);
    const std::string pointer = target[place].get<std::string>();
    if (const auto node = node_pointer(pointer)) {
      AnimationChannel result;
      if (read_node_pointer(*node, result)) add(sampler, std::move(result), animation);
      return;
    }
    std::optional<PropertyPointer> found = property_pointer(import_, pointer);
    if (!found) {
      import_.report.warn("animation of \"" + one_line(pointer, 80) + "\" is not supported");
      return;
    }
    read_keys(sampler, {found->components, 1}, found->channel.keys);
    add_duration(found->channel.keys, animation);
    animation.properties.push_back(std::move(found->channel));
  }

  static void add_duration(const AnimationChannel& keys, Animation& animation) {
    animation.duration_s = std::max(animation.duration_s, keys.times_s.back());
  }

  bool read_node_pointer(const NodePointer& pointer, AnimationChannel& result) const {
    const std::size_t nodes = import_.scene.nodes.size();
    if (static_cast<std::size_t>(pointer.node) >= nodes) {
      import_.report.fail(place_, "KHR_animation_pointer names nodes[" + std::to_string(pointer.node) +
                                      "], but there are " + std::to_string(nodes));
    }
    result.node = pointer.node;
    result.path = pointer.path;
    return can_move(result);
  }

  /// False, with a warning, when the channel moves nothing that can be moved.
  bool read_target(const tinygltf::AnimationChannel& channel, AnimationChannel& result) const {
    static const std::array<std::pair<const char*, Path>, 4> kPaths = {{{"translation", Path::translation},
                                                                        {"rotation", Path::rotation},
                                                                        {"scale", Path::scale},
                                                                        {"weights", Path::weights}}};
    const auto path = std::find_if(kPaths.begin(), kPaths.end(),
                                   [&](const auto& known) { return known.first == channel.target_path; });
    if (path == kPaths.end()) {
      import_.report.warn("animation of \"" + one_line(channel.target_path, 40) + "\" is not supported");
      return false;
    }
    result.node = channel.target_node;
    result.path = path->second;
    return can_move(result);
  }

  bool can_move(const AnimationChannel& result) const {
    const Node& node = import_.scene.nodes[static_cast<std::size_t>(result.node)];
    if (result.path == Path::weights && morph_targets(node) == 0) {
      import_.report.warn("animation of morph weights of a node without morph targets is ignored");
      return false;
    }
    if (result.path != Path::weights && node.transform.matrix) {
      import_.report.warn("animation of a node whose transform is a matrix is ignored");
      return false;
    }
    return true;
  }

  std::size_t morph_targets(const Node& node) const {
    if (node.mesh == kNone) return 0;
    return import_.scene.meshes[static_cast<std::size_t>(node.mesh)].morph_weights.size();
  }

  /// What a key's value consists of.
  struct KeyShape {
    int components = 1;
    std::size_t elements = 1;
  };

  KeyShape node_components(const AnimationChannel& result) const {
    if (result.path == Path::rotation) return {4, 1};
    if (result.path != Path::weights) return {3, 1};
    return {1, morph_targets(import_.scene.nodes[static_cast<std::size_t>(result.node)])};
  }

  void read_keys(int sampler_index, const KeyShape& shape, AnimationChannel& result) {
    const auto index = static_cast<std::size_t>(sampler_index);
    const tinygltf::AnimationSampler& sampler = source_.samplers[index];
    const std::string place = place_ + '.' + element("samplers", index);
    if (sampler.interpolation == "STEP") result.interpolation = Interpolation::step;
    if (sampler.interpolation == "CUBICSPLINE") result.interpolation = Interpolation::cubic_spline;
    import_.reader.require(sampler.input, place + ".input", {1}, kFloat);
    result.times_s = import_.reader.copy_floats(sampler.input);
    if (!std::is_sorted(result.times_s.begin(), result.times_s.end())) {
      import_.report.fail(place + ".input", "the times of an animation must ascend");
    }

    const std::size_t elements_a_key =
        shape.elements * (result.interpolation == Interpolation::cubic_spline ? 3 : 1);
    import_.reader.require(sampler.output, place + ".output", {shape.components}, kAnyFormat,
                           result.times_s.size() * elements_a_key);
    result.values = import_.reader.copy_floats(sampler.output);
  }

  Import& import_;
  const tinygltf::Animation& source_;
  const nlohmann::json& tree_;  ///< The same as it stands in the file
  std::string place_;
};

}  // namespace

void import_skins(Import& import) {
  const auto& skins = import.document.model().skins;
  for (std::size_t i = 0; i < skins.size(); ++i) {
    Skin& skin = import.scene.skins.emplace_back();
    read_or_warn(import, import.drawn.skins[i], "nothing drawn uses this skin",
                 [&] { skin = skin_of(import, skins[i], element("skins", i)); });
  }
  check_joints(import);
}

void import_animations(Import& import) {
  const auto& animations = import.document.model().animations;
  for (std::size_t i = 0; i < animations.size(); ++i) {
    import.scene.animations.push_back(AnimationImporter(import, i).run());
  }
}

}  // namespace barrido::scene::gltf
