// The numbers in an accessor, sparse ones in their places, as doubles: each is exact. Reads nothing outside
// of the buffers, whatever the accessor says.
#pragma once

#include <span>

#include "pipeline/validate/model.h"

namespace barrido::scene::validation {

class Numbers {
 public:
  Numbers(const Model& model, const Accessor& accessor);

  /// Whether all numbers can be had; none may be asked for otherwise. An accessor of nothing but zeros
  /// cannot.
  bool readable() const { return readable_; }
  std::uint64_t count() const { return accessor_.count; }
  std::size_t components() const { return accessor_.components(); }

  /// The number as it is stored. Elements must be asked for in ascending order.
  double at(std::uint64_t element, std::size_t component);
  /// As a shader sees it: normalized integers become -1 to 1 (glTF 2.0, section 3.11).
  double normalized_at(std::uint64_t element, std::size_t component);

  /// The index in front of the i-th sparse element.
  std::uint64_t sparse_index(std::uint64_t i) const;

 private:
  /// Bytes from the element's first to the component's.
  std::size_t offset_of(std::size_t component) const;

  const Accessor& accessor_;
  bool readable_ = false;
  std::uint64_t stride_ = 0;
  std::span<const std::uint8_t> bytes_;  ///< None: zeros.
  std::span<const std::uint8_t> sparse_indices_, sparse_values_;
  std::uint64_t sparse_at_ = 0;
};

}  // namespace barrido::scene::validation
