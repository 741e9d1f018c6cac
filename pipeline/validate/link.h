// What the rules between objects share: the document, its data, what each view and accessor serves for, and
// the checks of numbers that are to be made when the buffers are there.
#pragma once

#include <string>
#include <vector>

#include "pipeline/validate/model.h"
#include "pipeline/validate/schema_walk.h"

namespace barrido::scene::validation {

enum class ViewUsage : std::uint8_t { none, vertices, indices, inverse_bind_matrices, image, other };
enum class AccessorUsage : std::uint8_t {
  none,
  vertex_attribute,
  primitive_indices,
  inverse_bind_matrices,
  animation_input,
  animation_output
};

/// A check of the numbers in an accessor.
struct DataCheck {
  enum class Kind : std::uint8_t {
    unit_vectors,
    unit_vectors_and_sign,
    clamped,
    indices,  ///< `limit`: vertices, 0 where unknown; `flag`: whether they make triangles
    inverse_bind,
    times,
    rotations,  ///< `flag`: whether there are tangents of splines
  };
  Kind kind = Kind::clamped;
  std::size_t accessor = 0;
  std::string pointer;  ///< Of what uses the accessor.
  std::uint64_t limit = 0;
  bool flag = false;
};

/// Steps that one validation may take in all, so that no file keeps it busy for long.
class Budget {
 public:
  explicit Budget(std::uint64_t steps) : left_(steps) {}
  /// Returns false, from then on, when that many are not left.
  bool take(std::uint64_t steps) {
    exhausted_ = exhausted_ || steps > left_;
    if (!exhausted_) left_ -= steps;
    return !exhausted_;
  }
  bool exhausted() const { return exhausted_; }

 private:
  std::uint64_t left_;
  bool exhausted_ = false;
};

struct Link {
  Link(SchemaWalk& walk, const JsonText& checked, Budget& steps);

  void use_view(std::size_t view, ViewUsage usage, const Place& place);
  void use_accessor(std::size_t accessor, AccessorUsage usage, const Place& place);
  const Json& array(std::string_view name) const { return array_of(document, name); }

  Issues& issues;
  References& references;
  const std::vector<MaterialNeeds>& materials;
  const SchemaWalk& schema;
  const Json& document;
  const NamesInOrder& attribute_names;
  Model model;
  Budget& budget;
  std::vector<DataCheck> data_checks;
  std::vector<ViewUsage> view_usages;
  std::vector<AccessorUsage> accessor_usages;
};

/// Formats that an accessor may have: types and component types. Integers are normalized or not, or either.
struct Format {
  std::string_view type;
  int component_type = 0;
  bool normalized = false;
};
bool is_one_of(const Accessor& accessor, std::span<const Format> formats);
std::string list_of(std::span<const Format> formats);

void link_accessors(Link& link);
void link_images(Link& link);
void link_meshes(Link& link);
void link_nodes(Link& link);
void link_animations(Link& link);

}  // namespace barrido::scene::validation
