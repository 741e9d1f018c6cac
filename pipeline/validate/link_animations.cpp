// Samplers with their accessors, channels with their samplers and targets (glTF 2.0, section 3.11).
#include <map>

#include "pipeline/gltf/report.h"
#include "pipeline/validate/link.h"
#include "pipeline/validate/semantics.h"

namespace barrido::scene::validation {
namespace {

constexpr Format kTimes[] = {{"SCALAR", kFloat}};
constexpr Format kVectors[] = {{"VEC3", kFloat}};
constexpr Format kRotations[] = {{"VEC4", kFloat, false},
                                 {"VEC4", kUnsignedByte, true},
                                 {"VEC4", kByte, true},
                                 {"VEC4", kUnsignedShort, true},
                                 {"VEC4", kShort, true}};
constexpr Format kWeights[] = {{"SCALAR", kFloat, false},
                               {"SCALAR", kUnsignedByte, true},
                               {"SCALAR", kByte, true},
                               {"SCALAR", kUnsignedShort, true},
                               {"SCALAR", kShort, true}};

struct Path {
  std::string_view name;
  std::span<const Format> formats;
};
constexpr Path kPaths[] = {
    {"translation", kVectors}, {"rotation", kRotations}, {"scale", kVectors}, {"weights", kWeights}};

const Path* find_path(std::string_view name) {
  for (const Path& path : kPaths) {
    if (path.name == name) return &path;
  }
  return nullptr;
}

class AnimationLink {
 public:
  AnimationLink(Link& link, const Json& animation, const Place& place)
      : link_(link),
        samplers_(array_of(animation, "samplers")),
        channels_(array_of(animation, "channels")),
        place_(place),
        used_(samplers_.size()) {}

  void run() {
    if (samplers_.empty() || channels_.empty()) return;
    const Place samplers_place(place_, "samplers"), channels_place(place_, "channels");
    for (std::size_t i = 0; i < samplers_.size(); ++i) link_sampler(samplers_[i], Place(samplers_place, i));
    for (std::size_t i = 0; i < channels_.size(); ++i) link_channel(channels_[i], Place(channels_place, i));
    report_duplicates(channels_place);
    for (std::size_t i = 0; i < samplers_.size(); ++i) {
      if (!used_[i]) link_.issues.add(kUnusedObject, Place(samplers_place, i));
    }
  }

 private:
  std::size_t accessor_in(const Json& sampler, const char* name) const {
    const std::size_t index = index_of(sampler, name, link_.model.accessors.size());
    return index != kNone && link_.references.exists(Collection::accessors, index) ? index : kNone;
  }

  static bool is_spline(const Json& sampler) {
    return sampler.value("interpolation", std::string()) == "CUBICSPLINE";
  }

  void use(std::size_t accessor, AccessorUsage usage, const Place& place) {
    const std::size_t view = link_.model.accessors[accessor].view;
    link_.use_accessor(accessor, usage, place);
    link_.use_view(view, ViewUsage::other, place);
    if (view != kNone && link_.model.views[view].stride != 0) {
      link_.issues.add(kAnimationSamplerAccessorWithByteStride, place);
    }
  }

  void link_sampler(const Json& sampler, const Place& place) {
    const std::size_t output = accessor_in(sampler, "output"), input = accessor_in(sampler, "input");
    if (output != kNone) use(output, AccessorUsage::animation_output, Place(place, "output"));
    if (input == kNone) return;
    const Place input_place(place, "input");
    const Accessor& times = link_.model.accessors[input];
    use(input, AccessorUsage::animation_input, input_place);
    if (!is_one_of(times, kTimes)) {
      link_.issues.add(kAnimationSamplerInputAccessorInvalidFormat, input_place,
                       {times.format(), list_of(kTimes)});
    } else {
      link_.data_checks.push_back({DataCheck::Kind::times, input, input_place.pointer()});
    }
    if (times.min.empty() || times.max.empty()) {
      link_.issues.add(kAnimationSamplerInputAccessorWithoutBounds, input_place);
    }
    if (is_spline(sampler) && times.count < 2) {
      link_.issues.add(kAnimationSamplerInputAccessorTooFewElements, input_place,
                       {std::to_string(times.count)});
    }
  }

  /// Morph targets of the mesh of the channel's node; 0 where there are none.
  std::size_t targets_of(const Json& target) const {
    const Json& nodes = link_.array("nodes");
    const std::size_t node = index_of(target, "node", nodes.size());
    if (node == kNone || !nodes[node].is_object()) return 0;
    const Json& meshes = link_.array("meshes");
    const std::size_t mesh = index_of(nodes[node], "mesh", meshes.size());
    if (mesh == kNone || !meshes[mesh].is_object()) return 0;
    const Json& primitives = array_of(meshes[mesh], "primitives");
    return primitives.empty() ? 0 : count_of(primitives[0], "targets");
  }

  void check_target(const Json& target, const std::string& path, const Place& place) {
    const Json& nodes = link_.array("nodes");
    const std::size_t node = index_of(target, "node", nodes.size());
    if (node == kNone || !nodes[node].is_object()) return;
    if (path == "weights") {
      if (targets_of(target) == 0) link_.issues.add(kAnimationChannelTargetNodeWeightsNoMorphs, place);
    } else if (find_path(path) != nullptr) {
      if (nodes[node].contains("matrix")) link_.issues.add(kAnimationChannelTargetNodeMatrix, place);
      const bool skinned = index_of(nodes[node], "skin", link_.array("skins").size()) != kNone;
      if (skinned) link_.issues.add(kAnimationChannelTargetNodeSkin, Place(place, "path"));
    }
  }

  void link_channel(const Json& channel, const Place& place) {
    static const Json kEmpty = Json::object();
    const Json& target = channel.contains("target") ? channel["target"] : kEmpty;
    const std::string path = target.value("path", std::string());
    check_target(target, path, Place(place, "target"));
    if (!channel.contains("sampler")) return;
    const auto sampler = channel["sampler"].get<std::size_t>();
    const Place sampler_place(place, "sampler");
    if (sampler >= samplers_.size()) {
      link_.issues.add(kUnresolvedReference, sampler_place, {gltf::element("samplers", sampler)});
      return;
    }
    used_[sampler] = true;
    const std::size_t output = accessor_in(samplers_[sampler], "output");
    if (output != kNone && channel.contains("target"))
      check_output(samplers_[sampler], output, target, path, sampler_place);
  }

  void check_output(const Json& sampler, std::size_t output, const Json& target, const std::string& path_name,
                    const Place& place) {
    const Accessor& values = link_.model.accessors[output];
    const Path* path = find_path(path_name);
    if (path == nullptr) return;
    if (!is_one_of(values, path->formats)) {
      link_.issues.add(kAnimationSamplerOutputAccessorInvalidFormat, place,
                       {values.format(), path_name, list_of(path->formats)});
    }
    if (path_name == "rotation" && values.is_complete() && values.components() == 4) {
      link_.data_checks.push_back(
          {DataCheck::Kind::rotations, output, place.pointer(), 0, is_spline(sampler)});
    }
    const std::size_t input = accessor_in(sampler, "input");
    if (input == kNone || values.count == 0) return;
    const std::uint64_t per_time =
        (is_spline(sampler) ? 3 : 1) * (path_name == "weights" ? targets_of(target) : 1);
    const std::uint64_t times = link_.model.accessors[input].count;
    if (per_time == 0 || times == 0 || (values.count % per_time == 0 && values.count / per_time == times))
      return;
    link_.issues.add(
        kAnimationSamplerOutputAccessorInvalidCount, place,
        {shown(static_cast<double>(times) * static_cast<double>(per_time)), std::to_string(values.count)});
  }

  void report_duplicates(const Place& channels_place) {
    std::map<std::pair<std::size_t, std::string>, std::size_t> last;
    for (std::size_t i = channels_.size(); i-- > 0;) {
      if (!channels_[i].contains("target") || !channels_[i]["target"].contains("node")) continue;
      const Json& target = channels_[i]["target"];
      const std::pair key(target["node"].get<std::size_t>(), target.value("path", std::string()));
      const auto [other, is_new] = last.try_emplace(key, i);
      if (is_new) continue;
      const Place place(channels_place, i);
      link_.issues.add(kAnimationDuplicateTargets, Place(place, "target"), {std::to_string(other->second)});
      other->second = i;
    }
  }

  Link& link_;
  const Json& samplers_;
  const Json& channels_;
  const Place& place_;
  std::vector<bool> used_;
};

}  // namespace

void link_animations(Link& link) {
  const Json& animations = link.array("animations");
  const Place root, animations_place(root, "animations");
  for (std::size_t i = 0; i < animations.size(); ++i) {
    const Place place(animations_place, i);
    if (animations[i].is_object()) AnimationLink(link, animations[i], place).run();
  }
}

}  // namespace barrido::scene::validation
