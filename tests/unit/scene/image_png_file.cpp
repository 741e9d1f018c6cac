#include "image_test_support.h"

namespace barrido::scene::test {
namespace {

void append_u32(Bytes& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

void append_chunk(Bytes& png, const std::string& type, const Bytes& data) {
  append_u32(png, static_cast<std::uint32_t>(data.size()));
  Bytes body(type.begin(), type.end());
  body.insert(body.end(), data.begin(), data.end());
  png.insert(png.end(), body.begin(), body.end());
  append_u32(png, crc32(body));
}

Bytes zlib_stored(const Bytes& raw) {
  Bytes out{0x78, 0x01};
  for (std::size_t begin = 0; begin < raw.size(); begin += 65535) {
    const std::size_t size = std::min<std::size_t>(raw.size() - begin, 65535);
    out.push_back(begin + size == raw.size() ? 1 : 0);
    for (const std::size_t word : {size, ~size}) {
      out.push_back(static_cast<std::uint8_t>(word));
      out.push_back(static_cast<std::uint8_t>(word >> 8));
    }
    out.insert(out.end(), raw.begin() + static_cast<std::ptrdiff_t>(begin),
               raw.begin() + static_cast<std::ptrdiff_t>(begin + size));
  }
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : raw) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  append_u32(out, b << 16 | a);
  return out;
}

struct Pass {
  std::uint32_t x0, y0, dx, dy;
};
const std::vector<Pass> kAdam7{{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                               {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};

}  // namespace

Bytes PngFile::build() const {
  const int channels = color_type == 2 ? 3 : color_type == 4 ? 2 : color_type == 6 ? 4 : 1;
  Bytes raw;
  for (const Pass& pass : interlaced ? kAdam7 : std::vector<Pass>{{0, 0, 1, 1}}) {
    if (pass.x0 >= width) continue;
    for (std::uint32_t y = pass.y0; y < height; y += pass.dy) {
      raw.push_back(filters[y % filters.size()]);
      std::uint32_t bits = 0;
      int bit_count = 0;
      for (std::uint32_t x = pass.x0; x < width; x += pass.dx) {
        for (int c = 0; c < channels; ++c) {
          bits = bits << bit_depth | sample(x, y, c);
          bit_count += bit_depth;
          for (; bit_count >= 8; bit_count -= 8) {
            raw.push_back(static_cast<std::uint8_t>(bits >> (bit_count - 8)));
          }
        }
      }
      if (bit_count > 0) raw.push_back(static_cast<std::uint8_t>(bits << (8 - bit_count)));
    }
  }
  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes header;
  append_u32(header, claimed_side != 0 ? claimed_side : width);
  append_u32(header, claimed_side != 0 ? claimed_side : height);
  for (const int value : {int{bit_depth}, int{color_type}, 0, 0, interlaced ? 1 : 0}) {
    header.push_back(static_cast<std::uint8_t>(value));
  }
  append_chunk(png, "IHDR", header);
  if (!palette.empty()) append_chunk(png, "PLTE", palette);
  if (!transparency.empty()) append_chunk(png, "tRNS", transparency);
  const Bytes data = zlib_stored(raw);
  for (int i = 0; i < data_chunks; ++i) {
    const auto part = [&](int n) {
      return data.begin() + static_cast<std::ptrdiff_t>(data.size()) * n / data_chunks;
    };
    append_chunk(png, "IDAT", Bytes(part(i), part(i + 1)));
  }
  append_chunk(png, "IEND", {});
  return png;
}

}  // namespace barrido::scene::test
