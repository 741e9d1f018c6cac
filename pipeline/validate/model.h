// Buffers, views and accessors of a checked document as plain values, for the rules that link them.
// Everything here may still reach past the end of what it lies in.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/validate/format.h"
#include "pipeline/validate/json_text.h"

namespace barrido::scene::validation {

inline constexpr std::size_t kNone = SIZE_MAX;

struct Buffer {
  std::optional<std::uint64_t> byte_length;
  std::span<const std::uint8_t> bytes;  ///< At least byte_length of them, or none.
  std::shared_ptr<const void> owner;
};

struct BufferView {
  std::size_t buffer = kNone;  ///< kNone as well where there is no such buffer.
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t stride = 0;  ///< 0: none given.
  int target = 0;
};

struct Sparse {
  std::uint64_t count = 0;
  std::size_t index_view = kNone, value_view = kNone;
  std::uint64_t index_offset = 0, value_offset = 0;
  int index_type = 0;
};

struct Accessor {
  /// Whether type, component type and count are known.
  bool is_complete() const { return type != nullptr && component_type != 0 && count != 0; }
  std::size_t components() const { return type->components; }
  /// Without what may follow the last column of a matrix.
  std::uint64_t element_bytes() const;
  /// From one element to the next, where the view gives no stride.
  std::uint64_t packed_stride() const;
  /// {VEC3, FLOAT}
  std::string format() const;

  std::size_t view = kNone;  ///< kNone as well where there is no such view.
  std::uint64_t offset = 0;
  int component_type = 0;
  std::uint64_t count = 0;
  const TypeTraits* type = nullptr;
  bool normalized = false;
  std::vector<double> min, max;  ///< As single precision for floats; empty where they are not given.
  std::optional<Sparse> sparse;
};

struct Model {
  explicit Model(const Json& document);

  /// Bytes from one element of the accessor to the next.
  std::uint64_t stride_of(const Accessor& accessor) const;
  /// `length` bytes from `offset` on in the view; nothing unless they are there.
  std::span<const std::uint8_t> bytes_of(std::size_t view, std::uint64_t offset, std::uint64_t length) const;

  std::vector<Buffer> buffers;
  std::vector<BufferView> views;
  std::vector<Accessor> accessors;
};

/// The objects of a top-level array; a static empty array where there is none.
const Json& array_of(const Json& document, std::string_view name);
/// The index in that property if there is something at it; kNone otherwise.
std::size_t index_of(const Json& object, std::string_view name, std::size_t size);

}  // namespace barrido::scene::validation
