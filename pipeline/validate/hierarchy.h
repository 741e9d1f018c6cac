// Who is whose parent, for the rules on scenes and skins. Every question is answered in a bounded number of
// steps, whatever loops the file holds.
#pragma once

#include <vector>

#include "pipeline/validate/link.h"

namespace barrido::scene::validation {

class Hierarchy {
 public:
  /// Reports children that have a parent already; the last one counts.
  explicit Hierarchy(Link& link);

  std::size_t parent(std::size_t node) const { return parents_[node]; }
  std::size_t size() const { return parents_.size(); }
  /// Whether the node is its own ancestor.
  bool is_in_loop(std::size_t node) const { return in_loop_[node]; }
  /// The node itself and its ancestors upwards, each once; cut off where the budget ends.
  std::vector<std::size_t> line_of(std::size_t node) const;

 private:
  void find_loops();

  Link& link_;
  std::vector<std::size_t> parents_;  ///< kNone for roots.
  std::vector<bool> in_loop_;
};

}  // namespace barrido::scene::validation
