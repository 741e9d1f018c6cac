#include "pipeline/pictures/format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "pipeline/pictures/codecs.h"

namespace barrido::scene {
namespace {

using enum ImageFormat;

constexpr std::array<FormatTraits, 9> kTraits{{
    // format name openimageio alpha floats associated read
    {png, "PNG", nullptr, true, false, false, true},
    {jpeg, "JPEG", nullptr, false, false, false, true},
    {exr, "EXR", "openexr", true, true, true, true},
    {hdr, "HDR", "hdr", false, true, false, true},
    {tiff, "TIFF", "tiff", true, true, false, true},
    {webp, "WebP", "webp", true, false, false, false},  // its reader multiplies alpha in, unasked
    {bmp, "BMP", "bmp", false, false, false, true},
    {tga, "TGA", "targa", true, false, false, true},
    {pnm, "PNM", "pnm", false, false, false, false},
}};

struct Extension {
  std::string_view text;
  ImageFormat format;
};

constexpr std::array<Extension, 13> kExtensions{{
    {".png", png},
    {".jpg", jpeg},
    {".jpeg", jpeg},
    {".jpe", jpeg},
    {".exr", exr},
    {".hdr", hdr},
    {".rgbe", hdr},
    {".tif", tiff},
    {".tiff", tiff},
    {".webp", webp},
    {".bmp", bmp},
    {".tga", tga},
    {".ppm", pnm},
}};

struct Magic {
  std::string_view bytes;
  std::size_t offset;
  ImageFormat format;
};

using std::string_view_literals::operator""sv;  // NOLINT(misc-unused-using-decls): used below

constexpr std::array<Magic, 9> kMagics{{
    {"\x76\x2f\x31\x01"sv, 0, exr},
    {"#?RADIANCE"sv, 0, hdr},
    {"#?RGBE"sv, 0, hdr},
    {"II*\0"sv, 0, tiff},
    {"MM\0*"sv, 0, tiff},
    {"II+\0"sv, 0, tiff},
    {"MM\0+"sv, 0, tiff},
    {"WEBP"sv, 8, webp},
    {"BM"sv, 0, bmp},
}};

bool has_magic(std::span<const std::uint8_t> bytes, const Magic& magic) {
  if (bytes.size() < magic.offset + magic.bytes.size()) return false;
  return std::equal(magic.bytes.begin(), magic.bytes.end(), bytes.data() + magic.offset,
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  if (text.empty()) text = path.filename().string();  // ".png" alone is a file name without extension
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return text;
}

}  // namespace

const FormatTraits& traits_of(ImageFormat format) {
  return *std::find_if(kTraits.begin(), kTraits.end(),
                       [format](const FormatTraits& traits) { return traits.format == format; });
}

const FormatTraits* format_by_extension(const std::filesystem::path& path) {
  const std::string text = lower_case_extension(path);
  const auto* found = std::find_if(kExtensions.begin(), kExtensions.end(),
                                   [&text](const Extension& extension) { return extension.text == text; });
  return found == kExtensions.end() ? nullptr : &traits_of(found->format);
}

const FormatTraits* format_by_content(std::span<const std::uint8_t> bytes,
                                      const std::filesystem::path& path) {
  if (is_png(bytes)) return &traits_of(png);
  if (is_jpeg(bytes)) return &traits_of(jpeg);
  for (const Magic& magic : kMagics) {
    if (has_magic(bytes, magic)) return &traits_of(magic.format);
  }
  const FormatTraits* named = format_by_extension(path);
  return named != nullptr && named->format == tga ? named : nullptr;
}

}  // namespace barrido::scene
