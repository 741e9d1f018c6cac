// All numbers are little-endian; offsets in findings are those of the chunk's header.
#include "pipeline/validate/glb.h"

#include <cstdio>

#include "pipeline/gltf/glb_format.h"

namespace barrido::scene::validation {
namespace {

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
    std::size_t offset = glb::kHeaderBytes;
    for (std::size_t chunk = 0; offset < file_.size(); ++chunk) {
      chunks_.has_json = has_json_;
      if (offset == length_) {
        issues_.add_at(offset, kGlbExtraData, {std::to_string(file_.size() - offset)});
        return chunks_;
      }
      if (file_.size() - offset < glb::kChunkHeaderBytes) {
        issues_.add_at(file_.size(), kGlbUnexpectedEndOfChunkHeader);
        return {};
      }
      const std::uint32_t bytes = glb::read_u32(file_, offset), type = glb::read_u32(file_, offset + 4);
      const bool is_new = check_chunk(chunk, offset, bytes, type);
      offset += glb::kChunkHeaderBytes;
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
    if (file_.size() < glb::kHeaderBytes) {
      issues_.add_at(file_.size(), kGlbUnexpectedEndOfHeader);
      return false;
    }
    if (glb::read_u32(file_, 0) != glb::kMagic) {
      issues_.add_at(0, kGlbInvalidMagic, {hex(glb::read_u32(file_, 0))});
      return false;
    }
    if (glb::read_u32(file_, 4) != 2) {
      issues_.add_at(4, kGlbInvalidVersion, {std::to_string(glb::read_u32(file_, 4))});
      return false;
    }
    length_ = glb::read_u32(file_, 8);
    if (length_ <= glb::kHeaderBytes) issues_.add_at(8, kGlbLengthTooSmall, {std::to_string(length_)});
    return true;
  }

  /// Returns whether the chunk is the first of a type that is known.
  bool check_chunk(std::size_t number, std::size_t offset, std::uint32_t bytes, std::uint32_t type) {
    const std::string name = hex(type);
    if (bytes % 4 != 0) issues_.add_at(offset, kGlbChunkLengthUnaligned, {name});
    if (offset + glb::kChunkHeaderBytes + bytes > length_) {
      issues_.add_at(offset, kGlbChunkTooBig, {name, std::to_string(bytes)});
    }
    if (number == 0 && type != glb::kJsonChunk) issues_.add_at(offset, kGlbUnexpectedFirstChunk, {name});
    if (type == glb::kJsonChunk) {
      if (bytes == 0) issues_.add_at(offset, kGlbEmptyChunk, {name});
      return is_first(has_json_, offset, name);
    }
    if (type == glb::kBinaryChunk) {
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
    if (type == glb::kJsonChunk) {
      chunks_.json = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
      chunks_.has_json = !bytes.empty();
    }
    if (type == glb::kBinaryChunk) chunks_.binary = bytes;
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
