// Nodes with their meshes and skins, skins with their joints, scenes with their roots (glTF 2.0, sections 3.5
// and 3.7.3).
#include <algorithm>
#include <array>

#include "pipeline/validate/hierarchy.h"
#include "pipeline/validate/link.h"
#include "pipeline/validate/semantics.h"

namespace barrido::scene::validation {
namespace {

constexpr Format kMatrixFormats[] = {{"MAT4", kFloat}};

bool holds(const std::vector<std::size_t>& sorted, std::size_t value) {
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

bool is_all(const Json& node, const char* name, std::initializer_list<double> values) {
  const auto found = node.find(name);
  return found == node.end() ||
         std::equal(found->begin(), found->end(), values.begin(), values.end(),
                    [](const Json& component, double value) { return component.get<double>() == value; });
}

bool has_transform(const Json& node) {
  return !(is_all(node, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}) &&
           is_all(node, "translation", {0, 0, 0}) && is_all(node, "rotation", {0, 0, 0, 1}) &&
           is_all(node, "scale", {1, 1, 1}));
}

class NodeLink {
 public:
  explicit NodeLink(Link& link)
      : link_(link), nodes_(link.array("nodes")), hierarchy_(link), is_joint_(nodes_.size()) {}

  void run() {
    const Place root, nodes_place(root, "nodes"), skins_place(root, "skins");
    find_skinned_meshes();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].is_object()) link_mesh(nodes_[i], Place(nodes_place, i));
    }
    const Json& skins = link_.array("skins");
    common_.resize(skins.size());
    for (std::size_t i = 0; i < skins.size(); ++i) {
      if (skins[i].is_object()) link_skin(skins[i], i, Place(skins_place, i));
    }
    link_scenes();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].is_object()) check_node(i, Place(nodes_place, i));
    }
    report_unused_weights();
  }

 private:
  void find_skinned_meshes() {
    for (const Json& mesh : link_.array("meshes")) {
      Mesh state;
      const Json& primitives = mesh.is_object() ? array_of(mesh, "primitives") : array_of(Json::object(), "");
      for (const Json& primitive : primitives) {
        const auto attributes = primitive.find("attributes");
        state.has_joints = state.has_joints ||
                           (attributes != primitive.end() && count_attribute_sets(*attributes).joints > 0);
      }
      state.is_drawable = !primitives.empty();
      if (state.is_drawable) state.targets = count_of(primitives[0], "targets");
      state.has_weights = mesh.is_object() && mesh.contains("weights");
      meshes_.push_back(state);
    }
  }

  void link_mesh(const Json& node, const Place& place) {
    const std::size_t index = index_of(node, "mesh", meshes_.size());
    if (index == kNone || !meshes_[index].is_drawable) return;
    Mesh& mesh = meshes_[index];
    mesh.is_used = true;
    const std::size_t weights = count_of(node, "weights");
    if (weights == 0) {
      mesh.weights_used = true;
    } else if (weights != mesh.targets) {
      link_.issues.add(kNodeWeightsInvalid, Place(place, "weights"),
                       {std::to_string(weights), std::to_string(mesh.targets)});
    }
    const bool has_skin = index_of(node, "skin", link_.array("skins").size()) != kNone;
    if (has_skin && !mesh.has_joints) link_.issues.add(kNodeSkinWithNonSkinnedMesh, place);
    if (!has_skin && mesh.has_joints) link_.issues.add(kNodeSkinnedMeshWithoutSkin, place);
  }

  void link_skin(const Json& skin, std::size_t index, const Place& place) {
    const Json& joints = array_of(skin, "joints");
    std::vector<std::size_t>& common = common_[index];
    bool is_first = true;
    for (const Json& item : joints) {
      const auto joint = item.get<std::size_t>();
      if (!link_.references.exists(Collection::nodes, joint)) continue;
      is_joint_[joint] = true;
      std::vector<std::size_t> line = hierarchy_.line_of(joint);
      std::sort(line.begin(), line.end());
      // As the reference validator does: an empty set begins anew.
      if (is_first || common.empty()) {
        common = std::move(line);
      } else {
        std::erase_if(common, [&](std::size_t node) { return !holds(line, node); });
      }
      is_first = false;
    }
    if (link_.budget.exhausted()) return;
    if (!joints.empty() && common.empty()) link_.issues.add(kSkinNoCommonRoot, Place(place, "joints"));
    const std::size_t skeleton = index_of(skin, "skeleton", nodes_.size());
    if (skeleton != kNone && nodes_[skeleton].is_object() && !holds(common, skeleton)) {
      link_.issues.add(kSkinSkeletonInvalid, Place(place, "skeleton"));
    }
    link_matrices(skin, joints.size(), Place(place, "inverseBindMatrices"));
  }

  void link_matrices(const Json& skin, std::size_t joints, const Place& place) {
    const std::size_t index = index_of(skin, "inverseBindMatrices", link_.model.accessors.size());
    if (index == kNone) return;
    const Accessor& accessor = link_.model.accessors[index];
    link_.use_accessor(index, AccessorUsage::inverse_bind_matrices, place);
    link_.use_view(accessor.view, ViewUsage::inverse_bind_matrices, place);
    if (accessor.view != kNone && link_.model.views[accessor.view].stride != 0) {
      link_.issues.add(kSkinIbmAccessorWithByteStride, place);
    }
    if (!is_one_of(accessor, kMatrixFormats)) {
      link_.issues.add(kSkinIbmInvalidFormat, place, {accessor.format(), list_of(kMatrixFormats)});
    } else {
      link_.data_checks.push_back({DataCheck::Kind::inverse_bind, index, place.pointer()});
    }
    if (accessor.count < joints) {
      link_.issues.add(kInvalidIbmAccessorCount, place,
                       {std::to_string(joints), std::to_string(accessor.count)});
    }
  }

  void link_scenes() {
    const Json& scenes = link_.array("scenes");
    const Place root, scenes_place(root, "scenes");
    scenes_of_root_.resize(nodes_.size());
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      if (!scenes[s].is_object()) continue;
      const Json& roots = array_of(scenes[s], "nodes");
      for (std::size_t i = 0; i < roots.size(); ++i) {
        const auto node = roots[i].get<std::size_t>();
        if (!link_.references.exists(Collection::nodes, node)) continue;
        scenes_of_root_[node].push_back(s);
        if (hierarchy_.parent(node) == kNone) continue;
        const Place scene_place(scenes_place, s), nodes_place(scene_place, "nodes");
        link_.issues.add(kSceneNonRootNode, Place(nodes_place, i), {std::to_string(node)});
      }
    }
  }

  /// The scenes that have the node among the descendants of their roots, or as a root.
  std::vector<std::size_t> scenes_of(std::size_t node) const {
    std::vector<std::size_t> scenes;
    for (const std::size_t ancestor : hierarchy_.line_of(node)) {
      if (!link_.budget.take(scenes_of_root_[ancestor].size())) break;
      scenes.insert(scenes.end(), scenes_of_root_[ancestor].begin(), scenes_of_root_[ancestor].end());
    }
    std::sort(scenes.begin(), scenes.end());
    return scenes;
  }

  void check_node(std::size_t index, const Place& place) {
    const Json& node = nodes_[index];
    const auto refers = [&](const char* name, Collection target) {
      return node.contains(name) && link_.references.exists(target, node[name].get<std::size_t>());
    };
    const bool has_content = node.contains("children") || refers("mesh", Collection::meshes) ||
                             refers("camera", Collection::cameras) ||
                             !node.value("extras", Json()).is_null() ||
                             (node.contains("extensions") && !node["extensions"].empty());
    if (!is_joint_[index] && !has_content) link_.issues.add(kNodeEmpty, place);
    if (hierarchy_.is_in_loop(index)) link_.issues.add(kNodeLoop, place);
    const std::size_t skin = index_of(node, "skin", common_.size());
    if (skin != kNone) check_skinned_node(index, skin, place);
  }

  void check_skinned_node(std::size_t index, std::size_t skin, const Place& place) {
    if (has_transform(nodes_[index])) link_.issues.add(kNodeSkinnedMeshLocalTransforms, place);
    const std::vector<std::size_t> line = hierarchy_.line_of(index);
    if (line.size() > 1) {
      const bool moved = std::any_of(line.begin() + 1, line.end(),
                                     [&](std::size_t ancestor) { return has_transform(nodes_[ancestor]); });
      if (moved) link_.issues.add(kNodeSkinnedMeshParentTransforms, place);
      link_.issues.add(kNodeSkinnedMeshNonRoot, place);
    }
    const auto& common = common_[skin];
    const auto top = std::find_if(common.begin(), common.end(),
                                  [&](std::size_t node) { return hierarchy_.parent(node) == kNone; });
    if (top == common.end()) return;
    const std::vector<std::size_t> own = scenes_of(index), of_joints = scenes_of(*top);
    if (!link_.budget.exhausted() &&
        !std::includes(of_joints.begin(), of_joints.end(), own.begin(), own.end())) {
      link_.issues.add(kNodeSkinNoScene, place);
    }
  }

  void report_unused_weights() {
    const Place root, meshes_place(root, "meshes");
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      const Mesh& mesh = meshes_[i];
      if (!mesh.has_weights || !mesh.is_used || mesh.weights_used) continue;
      const Place mesh_place(meshes_place, i);
      link_.issues.add(kUnusedMeshWeights, Place(mesh_place, "weights"));
    }
  }

  struct Mesh {
    bool is_drawable = false, has_joints = false, has_weights = false;
    bool is_used = false, weights_used = false;
    std::size_t targets = 0;
  };

  Link& link_;
  const Json& nodes_;
  Hierarchy hierarchy_;
  std::vector<Mesh> meshes_;
  std::vector<bool> is_joint_;
  std::vector<std::vector<std::size_t>> common_;          ///< Ancestors of all joints, by skin, sorted.
  std::vector<std::vector<std::size_t>> scenes_of_root_;  ///< By node.
};

}  // namespace

void link_nodes(Link& link) { NodeLink(link).run(); }

}  // namespace barrido::scene::validation
