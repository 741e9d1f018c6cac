// PNG from pixels to bytes. The compressor is libdeflate: at its first level twice as fast as zlib's, which
// libpng and libspng call, for a smaller file; it wants the whole picture at once, so the few bytes around
// the compressed data are written here (PNG specification, third edition, sections 5, 9 and 11).
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <string_view>

#include "pipeline/pictures/image_io.h"
#include "pipeline/pictures/pack.h"

namespace barrido::scene {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Bytes that are not cleared first: most of a compressor's worst case is never touched.
using Buffer = PixelBytes;

struct CompressorDeleter {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};
using Compressor = std::unique_ptr<libdeflate_compressor, CompressorDeleter>;

/// Filter types (section 9.2). Rendered pictures repeat themselves exactly, which `none` leaves for the
/// compressor to find; large gradients (fog, sky) shrink ten times further as differences.
enum class Filter : std::uint8_t { none = 0, up = 2 };

/// The pixels as PNG wants them: rows of RGB or RGBA bytes.
struct Rows {
  int width = 0;
  int height = 0;
  int channels = 3;
  bool opaque = true;
  std::span<const std::uint8_t> rgba;

  std::size_t bytes() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels); }

  void copy_row(int y, std::uint8_t* out) const {
    const std::size_t pitch = static_cast<std::size_t>(width) * 4;
    const auto row = rgba.subspan(static_cast<std::size_t>(y) * pitch, pitch);
    if (channels == 4) {
      std::copy(row.begin(), row.end(), out);
    } else if (opaque) {
      drop_alpha(row, out);
    } else {
      compose_over_black(row, out);
    }
  }
};

/// Rows [begin, end), each after its filter's number.
Buffer filter_rows(const Rows& rows, int begin, int end, Filter filter) {
  const std::size_t bytes = rows.bytes();
  Buffer filtered((bytes + 1) * static_cast<std::size_t>(end - begin));
  Bytes row(bytes), previous(bytes, 0);
  if (filter == Filter::up && begin > 0) rows.copy_row(begin - 1, previous.data());
  std::uint8_t* out = filtered.data();
  for (int y = begin; y < end; ++y, out += bytes) {
    *out++ = static_cast<std::uint8_t>(filter);
    if (filter == Filter::none) {
      rows.copy_row(y, out);
      continue;
    }
    rows.copy_row(y, row.data());
    for (std::size_t i = 0; i < bytes; ++i) out[i] = static_cast<std::uint8_t>(row[i] - previous[i]);
    row.swap(previous);
  }
  return filtered;
}

/// A zlib stream (RFC 1950).
Buffer compress(libdeflate_compressor* compressor, const Buffer& raw) {
  Buffer out(libdeflate_zlib_compress_bound(compressor, raw.size()));
  const std::size_t size =
      libdeflate_zlib_compress(compressor, raw.data(), raw.size(), out.data(), out.size());
  out.resize(size);
  return out;
}

/// The filter that suits three bands of eight rows: a trial of some 3 % of a large picture, worth it
/// because no simple rule tells the two kinds of pictures apart.
Filter choose_filter(const Rows& rows, libdeflate_compressor* compressor) {
  constexpr int kBands = 3, kBandRows = 8;
  if (rows.height < kBands * kBandRows * 2) return Filter::none;
  std::array<std::size_t, 2> sizes{};
  for (int band = 0; band < kBands; ++band) {
    const int begin = (rows.height - kBandRows) * (band + 1) / (kBands + 1);
    for (const Filter filter : {Filter::none, Filter::up}) {
      sizes[filter == Filter::up ? 1 : 0] +=
          compress(compressor, filter_rows(rows, begin, begin + kBandRows, filter)).size();
    }
  }
  // Narrow bands hide most repetitions, so that `up` must win clearly: measured on rendered pictures, bands a
  // third smaller still meant files a fifth larger.
  return sizes[1] * 2 < sizes[0] ? Filter::up : Filter::none;
}

void append_u32(Bytes& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// Length, type, data, checksum of type and data (section 5.3); `fill` appends the data.
template <class Fill>
void append_chunk(Bytes& png, std::string_view type, Fill fill) {
  const std::size_t start = png.size();
  append_u32(png, 0);
  png.insert(png.end(), type.begin(), type.end());
  fill();
  const std::size_t length = png.size() - start - 8;
  for (std::size_t i = 0; i < 4; ++i) {
    png[start + i] = static_cast<std::uint8_t>(static_cast<std::uint32_t>(length) >> (24 - 8 * i));
  }
  append_u32(png, libdeflate_crc32(0, png.data() + start + 4, length + 4));
}

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

void append_header(Bytes& png, const Rows& rows) {
  append_chunk(png, "IHDR", [&] {
    append_u32(png, static_cast<std::uint32_t>(rows.width));
    append_u32(png, static_cast<std::uint32_t>(rows.height));
    const std::uint32_t color_type = rows.channels == 4 ? 6 : 2;
    append_u32(png, 8u << 24 | color_type << 16);  // 8 bits; deflate and the filters of section 9
    png.push_back(0);                              // not interlaced
  });
}

}  // namespace

std::vector<std::uint8_t> encode_png(const ImageView& image, const WriteOptions& options) {
  PixelBytes storage;
  const auto rgba = bytes_of(image, storage);
  const bool opaque = is_opaque(rgba);
  const Rows rows{image.width, image.height, opaque || !options.write_alpha ? 3 : 4, opaque, rgba};

  const Compressor compressor(libdeflate_alloc_compressor(std::clamp(options.png_compression, 0, 9)));
  if (!compressor) throw std::bad_alloc();
  const Filter filter = choose_filter(rows, compressor.get());
  const Buffer compressed = compress(compressor.get(), filter_rows(rows, 0, rows.height, filter));

  Bytes png(kSignature.begin(), kSignature.end());
  append_header(png, rows);
  append_chunk(png, "IDAT", [&] { png.insert(png.end(), compressed.begin(), compressed.end()); });
  append_chunk(png, "IEND", [] {});
  return png;
}

}  // namespace barrido::scene
