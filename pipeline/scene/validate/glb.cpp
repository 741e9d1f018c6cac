// All numbers are little-endian; offsets in findings are those of the chunk's header.
#include "pipeline/scene/validate/glb.h"

#include <cstdio>

namespace barrido::scene::validation {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;        // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004e4942;  // "BIN\0"
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

std::uint32_t read_u32(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return static_cast<std::uint32_t>(bytes[offset]) | static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
         static_cast<std::uint32_t>(bytes[offset + 2]) << 16 |
         static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

std::string hex(std::uint32_t number) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08x", number);
  return text;
}

class GlbReader {
 public:
  GlbReader(Issues& issues, std::span<const std::uint8_t> file) : issues_(issues), file_(file) {}

  Chunks run() {
    if (!check_header()) return {};
    std::size_t offset = kHeaderBytes;
    for (std::size_t chunk = 0; offset < file_.size(); ++chunk) {
      if (offset == length_) {
        issues_.add_at(offset, kGlbExtraData, {std::to_string(file_.size() - offset)});
        return chunks_;
      }
      if (file_.size() - offset < kChunkHeaderBytes) {
        issues_.add_at(file_.size(), kGlbUnexpectedEndOfChunkHeader);
        return {};
      }
      const std::uint32_t bytes = read_u32(file_, offset), type = read_u32(file_, offset + 4);
      const bool is_new = check_chunk(chunk, offset, bytes, type);
      offset += kChunkHeaderBytes;
      if (bytes > file_.size() - offset) {
        issues_.add_at(file_.size(), kGlbUnexpectedEndOfChunkData);
        return {};
      }
      if (is_new) keep(type, file_.subspan(offset, bytes));
      offset += bytes;
    }
    if (offset != length_) {
      issues_.add_at(offset, kGlbLengthMismatch, {std::to_string(length_), std::to_string(offset)});
    }
    return chunks_;
  }

 private:
  bool check_header() {
    if (file_.size() < kHeaderBytes) {
      issues_.add_at(file_.size(), kGlbUnexpectedEndOfHeader);
      return false;
    }
    if (read_u32(file_, 0) != kMagic) {
      issues_.add_at(0, kGlbInvalidMagic, {hex(read_u32(file_, 0))});
      return false;
    }
    if (read_u32(file_, 4) != 2) {
      issues_.add_at(4, kGlbInvalidVersion, {std::to_string(read_u32(file_, 4))});
      return false;
    }
    length_ = read_u32(file_, 8);
    if (length_ <= kHeaderBytes) issues_.add_at(8, kGlbLengthTooSmall, {std::to_string(length_)});
    return true;
  }

  /// Returns whether the chunk is the first of a type that is known.
  bool check_chunk(std::size_t number, std::size_t offset, std::uint32_t bytes, std::uint32_t type) {
    const std::string name = hex(type);
    if (bytes % 4 != 0) issues_.add_at(offset, kGlbChunkLengthUnaligned, {name});
    if (offset + kChunkHeaderBytes + bytes > length_) {
      issues_.add_at(offset, kGlbChunkTooBig, {name, std::to_string(bytes)});
    }
    if (number == 0 && type != kJsonChunk) issues_.add_at(offset, kGlbUnexpectedFirstChunk, {name});
    if (type == kJsonChunk) {
      if (bytes == 0) issues_.add_at(offset, kGlbEmptyChunk, {name});
      return is_first(has_json_, offset, name);
    }
    if (type == kBinaryChunk) {
      if (number > 1 && !has_binary_) issues_.add_at(offset, kGlbUnexpectedBinChunk);
      if (bytes == 0) issues_.add_at(offset, kGlbEmptyBinChunk);
      return is_first(has_binary_, offset, name);
    }
    issues_.add_at(offset, kGlbUnknownChunkType, {name});
    return false;
  }

  bool is_first(bool& seen, std::size_t offset, const std::string& name) {
    if (seen) issues_.add_at(offset, kGlbDuplicateChunk, {name});
    const bool first = !seen;
    seen = true;
    return first;
  }

  void keep(std::uint32_t type, std::span<const std::uint8_t> bytes) {
    if (type == kJsonChunk) chunks_.json = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    if (type == kBinaryChunk) chunks_.binary = bytes;
  }

  Issues& issues_;
  std::span<const std::uint8_t> file_;
  std::uint64_t length_ = 0;
  Chunks chunks_;
  bool has_json_ = false, has_binary_ = false;
};

}  // namespace

Chunks read_glb(Issues& issues, std::span<const std::uint8_t> file) { return GlbReader(issues, file).run(); }

}  // namespace barrido::scene::validation
