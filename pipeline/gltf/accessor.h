// Typed arrays out of accessors. Floats that lie tightly packed in their buffer are viewed there; everything
// else (normalised integers, strides, sparse elements) is converted once and shared. No index, offset or
// count of the file is believed before it is checked.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/gltf/document.h"
#include "pipeline/gltf/report.h"
#include "pipeline/scene/scene.h"

namespace barrido::scene::gltf {

/// One for each buffer view: that it does not lie within its buffer.
std::vector<std::optional<Problem>> check_views(const Document& document);

/// One for each accessor: that its elements, sparse ones included, do not lie within their buffer views, have
/// no component type of glTF, or are more than `max_count`.
std::vector<std::optional<Problem>> check_accessors(const Document& document, std::uint64_t max_count);

/// Component types as a set, so that a caller can say which ones it takes.
enum ComponentFormat : unsigned {
  kFloat = 1u << 0,
  kByte = 1u << 1,
  kUnsignedByte = 1u << 2,
  kShort = 1u << 3,
  kUnsignedShort = 1u << 4,
  kUnsignedInt = 1u << 5,
  kNormalizedByte = 1u << 6,
  kNormalizedUnsignedByte = 1u << 7,
  kNormalizedShort = 1u << 8,
  kNormalizedUnsignedShort = 1u << 9,
};

struct CheckedIndices {
  IndexArray values;
  std::uint32_t largest = 0;
};

class AccessorReader {
 public:
  AccessorReader(Report& report, const Document& document);

  std::size_t count(int accessor) const { return source(accessor).count; }
  /// Numbers in an element: 1 for SCALAR, 16 for MAT4.
  int components(int accessor) const;

  /// @throws InputError unless the accessor has one of `component_counts` components of one of `formats` (a
  /// union of ComponentFormat) and, where `expected_count` is not 0, that many elements. To be called before
  /// any of the functions below.
  void require(int accessor, const std::string& place, std::initializer_list<int> component_counts,
               unsigned formats, std::size_t expected_count = 0) const;

  /// All elements as floats, `out_components` each (as many as the accessor has, or one more, which is then
  /// 1). Numbers that are not finite are replaced by 0 and counted.
  FloatArray floats(int accessor, int out_components);
  FloatArray floats(int accessor) { return floats(accessor, components(accessor)); }

  /// The same numbers in a vector of their own.
  std::vector<float> copy_floats(int accessor);

  /// Vertex indices and the largest of them. The reference stays valid as long as the reader.
  const CheckedIndices& indices(int accessor, const std::string& place);
  /// Unsigned integers of four components of at most 16 bits.
  std::vector<std::array<std::uint16_t, 4>> unsigned_vec4(int accessor, const std::string& place);

  /// Warns, once, of numbers that were replaced.
  void finish();

 private:
  const tinygltf::Accessor& source(int accessor) const {
    return document_.model().accessors[static_cast<std::size_t>(accessor)];
  }
  void require_bytes(int accessor, const std::string& place) const;
  /// Counts numbers that are about to be copied. Many accessors may share bytes, or have none at all, so a
  /// small file could ask for any amount of memory. @throws InputError above the limit.
  void take_scalars(int accessor, std::size_t scalars);
  FloatArray read_floats(int accessor, int out_components);
  IndexArray read_indices(int accessor);
  std::shared_ptr<const void> owner_of(int accessor) const;
  FloatArray make_finite(FloatArray array);
  template <typename Visit>
  void visit_sparse(int accessor, Visit visit) const;

  Report& report_;
  const Document& document_;
  std::uint64_t not_finite_ = 0;
  std::map<std::pair<int, int>, FloatArray> cache_;  ///< By accessor and components.
  std::map<int, CheckedIndices> index_cache_;
};

}  // namespace barrido::scene::gltf
