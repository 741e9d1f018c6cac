// Loops are found by walking up from every node, each node but once: a walk that meets itself has a loop.
#include "pipeline/validate/hierarchy.h"

namespace barrido::scene::validation {

Hierarchy::Hierarchy(Link& link) : link_(link) {
  const Json& nodes = link.array("nodes");
  parents_.resize(nodes.size(), kNone);
  in_loop_.resize(nodes.size());
  const Place root, nodes_place(root, "nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_object()) continue;
    const Json& children = array_of(nodes[i], "children");
    for (std::size_t c = 0; c < children.size(); ++c) {
      const auto child = children[c].get<std::size_t>();  // -1 where it was none: larger than any.
      if (!link.references.exists(Collection::nodes, child)) continue;
      if (parents_[child] != kNone) {
        const Place node_place(nodes_place, i), children_place(node_place, "children");
        link.issues.add(kNodeParentOverride, Place(children_place, c), {std::to_string(child)});
      }
      parents_[child] = i;
    }
  }
  find_loops();
}

void Hierarchy::find_loops() {
  std::vector<std::size_t> seen_from(parents_.size(), kNone);
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    std::size_t at = i;
    while (at != kNone && seen_from[at] == kNone) {
      seen_from[at] = i;
      at = parents_[at];
    }
    if (at == kNone || seen_from[at] != i) continue;
    for (std::size_t member = at; !in_loop_[member]; member = parents_[member]) in_loop_[member] = true;
  }
}

std::vector<std::size_t> Hierarchy::line_of(std::size_t node) const {
  std::vector<std::size_t> line;
  std::size_t loop_begin = kNone;
  for (std::size_t at = node; at != kNone && at != loop_begin && link_.budget.take(1); at = parents_[at]) {
    if (loop_begin == kNone && in_loop_[at]) loop_begin = at;
    line.push_back(at);
  }
  return line;
}

}  // namespace barrido::scene::validation
