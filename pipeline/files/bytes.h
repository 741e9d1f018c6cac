// Bytes of model files: a shared, immutable block, read from a regular file below a size limit or decoded
// from a data URI. Problems are values; knows nothing of what the bytes mean.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/files/budget.h"
#include "raster/base/memory.h"

namespace barrido::scene::gltf {

/// Bytes that live as long as any copy of the block; the first stands at an address divisible by 16.
class ByteBlock {
 public:
  ByteBlock() = default;
  /// Memory for `size` bytes, not initialised.
  static ByteBlock allocate(std::size_t size);

  std::span<const std::uint8_t> bytes() const {
    return data_ ? std::span<const std::uint8_t>(*data_) : std::span<const std::uint8_t>();
  }
  /// The first bytes stay. Only while there is no copy.
  void resize(std::size_t size) { data_->resize(size); }
  std::uint8_t* writable() { return data_ ? data_->data() : nullptr; }
  std::size_t size() const { return bytes().size(); }
  std::shared_ptr<const void> owner() const { return data_; }

 private:
  std::shared_ptr<raster::UnclearedArray<std::uint8_t>> data_;
};

/// Either bytes or the reason why there are none.
struct Content {
  ByteBlock block;
  std::string problem;  ///< Empty when all is well.
};

/// The whole of a regular file (no folder, device or pipe) of at most `max_bytes`. It is put down in
/// `budget`, unless that is null, before memory is taken. @throws InputError when the budget does not allow
/// it.
Content read_regular_file(const std::filesystem::path& path, std::uint64_t max_bytes,
                          Budget* budget = nullptr, Budget::Kind kind = Budget::Kind::model);

/// The same for all that comes from standard input.
Content read_standard_input(std::uint64_t max_bytes, Budget* budget = nullptr,
                            Budget::Kind kind = Budget::Kind::model);

/// Either a path or the reason why there is none.
struct ResolvedPath {
  std::filesystem::path path;
  std::string problem;
};

/// The file that a relative URI of a model means: percent-decoded, symbolic links followed, and refused
/// unless it exists in `folder` or below. Nothing is opened.
ResolvedPath resolve_uri(const std::filesystem::path& folder, std::string_view uri);

bool is_data_uri(std::string_view uri);

/// The bytes of a data URI (RFC 2397), in base64 (RFC 4648, section 4) or percent-encoded, whatever its media
/// type.
Content decode_data_uri(std::string_view uri);

}  // namespace barrido::scene::gltf
