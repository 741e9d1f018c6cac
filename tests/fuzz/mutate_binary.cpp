#include <algorithm>
#include <array>
#include <string>

#include "mutators.h"

namespace barrido::fuzz {
namespace {

constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;

std::uint32_t load_little(const std::uint8_t* bytes) {
  return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
         std::uint32_t{bytes[3]} << 24;
}

void append_little(std::string& out, std::size_t value) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(value >> shift & 0xff);
}

void append_chunk(std::string& out, const char* type, std::string content, char padding) {
  content.resize((content.size() + 3) / 4 * 4, padding);
  append_little(out, content.size());
  out.append(type, 4);
  out += content;
}

/// CRC-32 of PNG (ISO 3309), bit by bit.
std::uint32_t crc_of(const std::uint8_t* bytes, std::size_t size) {
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

std::uint32_t load_big(const std::uint8_t* bytes) {
  return bytes[3] | std::uint32_t{bytes[2]} << 8 | std::uint32_t{bytes[1]} << 16 |
         std::uint32_t{bytes[0]} << 24;
}

}  // namespace

std::size_t mutate_glb(std::uint8_t* data, std::size_t size, std::size_t capacity, unsigned seed) {
  const std::size_t first = kGlbHeader + kChunkHeader;
  if (seed % 8 == 0 || size < first) return LLVMFuzzerMutate(data, size, capacity);
  const std::size_t json_size = std::min<std::size_t>(load_little(data + kGlbHeader), size - first);
  std::string text(reinterpret_cast<const char*>(data) + first, json_size);
  std::string binary;
  const std::size_t second = std::min(size, first + json_size + kChunkHeader);
  binary.assign(reinterpret_cast<const char*>(data) + second, size - second);
  if (seed % 4 == 1) {
    const std::size_t old = binary.size();
    binary.resize(old + 64);
    binary.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(binary.data()), old, binary.size()));
  } else {
    text = mutate_json_text(text, seed);
  }
  std::string chunks;
  append_chunk(chunks, "JSON", text, ' ');
  if (!binary.empty()) append_chunk(chunks, "BIN\0", binary, '\0');
  std::string file = "glTF";
  append_little(file, 2);
  append_little(file, kGlbHeader + chunks.size());
  file += chunks;
  if (file.size() > capacity) return LLVMFuzzerMutate(data, size, capacity);
  std::copy(file.begin(), file.end(), data);
  return file.size();
}

std::size_t mutate_image(std::uint8_t* data, std::size_t size, std::size_t capacity, unsigned seed) {
  constexpr std::size_t kSignature = 8, kFrame = 12;
  size = LLVMFuzzerMutate(data, size, capacity);
  if (seed % 8 == 0 || size < kSignature || data[0] != 0x89) return size;
  for (std::size_t at = kSignature; at + kFrame <= size;) {
    const std::size_t length = load_big(data + at);
    if (length > size - at - kFrame) break;
    const std::uint32_t crc = crc_of(data + at + 4, length + 4);
    for (std::size_t i = 0; i < 4; ++i) {
      data[at + 8 + length + i] = static_cast<std::uint8_t>(crc >> (24 - 8 * i));
    }
    at += kFrame + length;
  }
  return size;
}

}  // namespace barrido::fuzz
