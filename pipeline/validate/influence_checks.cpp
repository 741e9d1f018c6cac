// Joints and weights are read side by side: all sets of a vertex together say how it moves (glTF 2.0, section
// 3.7.3.3).
#include <cmath>
#include <set>

#include "pipeline/validate/data_checks.h"
#include "pipeline/validate/numbers.h"
#include "pipeline/validate/semantics.h"

namespace barrido::scene::validation {
namespace {

/// The skin with the fewest joints of those that nodes put on a mesh.
struct LimitingSkin {
  std::size_t joints = 0;  ///< 0: there is no skin.
  std::size_t skin = kNone;
};

std::vector<LimitingSkin> limiting_skins(const Link& link) {
  const Json &meshes = link.array("meshes"), &skins = link.array("skins");
  std::vector<LimitingSkin> limits(meshes.size());
  for (const Json& node : link.array("nodes")) {
    if (!node.is_object()) continue;
    const std::size_t mesh = index_of(node, "mesh", meshes.size()),
                      skin = index_of(node, "skin", skins.size());
    if (mesh == kNone || skin == kNone || !skins[skin].is_object()) continue;
    const std::size_t joints = count_of(skins[skin], "joints");
    if (joints != 0 && (limits[mesh].joints == 0 || joints < limits[mesh].joints))
      limits[mesh] = {joints, skin};
  }
  return limits;
}

struct InfluenceSet {
  Numbers joints, weights;
  std::string joints_pointer, weights_pointer;
};

class InfluenceCheck {
 public:
  InfluenceCheck(Issues& issues, const LimitingSkin& limit, std::vector<InfluenceSet>& sets)
      : issues_(issues), limit_(limit), sets_(sets) {}

  void run(std::uint64_t vertices) {
    for (std::uint64_t vertex = 0; vertex < vertices; ++vertex) {
      sum_ = 0;
      threshold_ = 0;
      seen_.clear();
      for (std::size_t c = 0; c < 4; ++c) {
        for (InfluenceSet& set : sets_) check_influence(set, vertex, c);
      }
      if (!(std::abs(sum_ - 1) > threshold_)) continue;
      const std::string first = std::to_string(4 * vertex), last = std::to_string(4 * vertex + 3);
      for (const InfluenceSet& set : sets_) {
        issues_.add(kAccessorWeightsNonNormalized, set.weights_pointer, {first, last, shown(sum_)});
      }
    }
  }

 private:
  void check_influence(InfluenceSet& set, std::uint64_t vertex, std::size_t component) {
    const auto report = [&](const Code& code, const std::string& pointer, double value) {
      issues_.add(code, pointer,
                  {std::to_string(4 * vertex + component), std::to_string(component), shown(value),
                   std::to_string(limit_.joints - 1), std::to_string(limit_.skin)});
    };
    const double joint = set.joints.at(vertex, component);
    if (joint >= static_cast<double>(limit_.joints)) {
      return report(kAccessorJointsIndexOob, set.joints_pointer, joint);
    }
    const double weight = set.weights.normalized_at(vertex, component);
    if (weight == 0) {
      if (joint != 0) report(kAccessorJointsUsedZeroWeight, set.joints_pointer, joint);
      return;
    }
    const bool is_new = seen_.insert(joint).second;
    if (!is_new) report(kAccessorJointsIndexDuplicate, set.joints_pointer, joint);
    if (weight < 0) {
      report(kAccessorWeightsNegative, set.weights_pointer, weight);
    } else if (is_new) {
      sum_ = static_cast<double>(static_cast<float>(sum_ + weight));
      threshold_ += 2e-7;
    }
  }

  Issues& issues_;
  const LimitingSkin& limit_;
  std::vector<InfluenceSet>& sets_;
  double sum_ = 0, threshold_ = 0;
  std::set<double> seen_;
};

void check_primitive(Link& link, Budget& budget, const Json& primitive, const LimitingSkin& limit,
                     const Place& place) {
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end()) return;
  const std::size_t set_count = count_attribute_sets(*attributes).joints;
  std::vector<InfluenceSet> sets;
  std::uint64_t vertices = 0;
  for (std::size_t i = 0; i < set_count; ++i) {
    const std::string joints_name = "JOINTS_" + std::to_string(i),
                      weights_name = "WEIGHTS_" + std::to_string(i);
    const auto accessor_in = [&](const std::string& name) -> const Accessor* {
      const std::size_t index = index_of(*attributes, name, link.model.accessors.size());
      return index == kNone ? nullptr : &link.model.accessors[index];
    };
    const Accessor *joints = accessor_in(joints_name), *weights = accessor_in(weights_name);
    if (joints == nullptr || weights == nullptr) return;
    if (i == 0) vertices = joints->count;
    sets.push_back({Numbers(link.model, *joints), Numbers(link.model, *weights),
                    Place(place, joints_name).pointer(), Place(place, weights_name).pointer()});
    const InfluenceSet& set = sets.back();
    const bool usable = set.joints.readable() && set.weights.readable() && joints->count == vertices &&
                        weights->count == vertices && joints->components() == 4 &&
                        weights->components() == 4 && joints->component_type != kFloat;
    if (!usable || !budget.take(vertices * 64)) return;  // A set of joints costs more than plain numbers.
  }
  if (!sets.empty()) InfluenceCheck(link.issues, limit, sets).run(vertices);
}

}  // namespace

void check_influences(Link& link, Budget& budget) {
  const std::vector<LimitingSkin> limits = limiting_skins(link);
  const Json& meshes = link.array("meshes");
  const Place root, meshes_place(root, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (limits[m].joints == 0 || !meshes[m].is_object()) continue;
    const Json& primitives = array_of(meshes[m], "primitives");
    const Place mesh_place(meshes_place, m), primitives_place(mesh_place, "primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const Place primitive_place(primitives_place, p);
      check_primitive(link, budget, primitives[p], limits[m], Place(primitive_place, "attributes"));
    }
  }
}

}  // namespace barrido::scene::validation
