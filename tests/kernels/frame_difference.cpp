#include "frame_difference.h"

#include <bit>
#include <cmath>
#include <cstdio>

namespace barrido::raster::testing {
namespace {

bool is_same(std::uint32_t a, std::uint32_t b) { return a == b; }
bool is_same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

std::string text_of(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", value);
  return text;
}
std::string text_of(float value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.9g (%08x)", static_cast<double>(value),
                std::bit_cast<std::uint32_t>(value));
  return text;
}

/// `channels` values a pixel, top row first.
template <class Value>
std::string compare_arrays(const char* name, const PixelArray<Value>& expected,
                           const PixelArray<Value>& actual, const Framebuffer& frame, std::size_t channels) {
  if (expected.size() != actual.size()) return std::string(name) + ": sizes differ\n";
  std::size_t different = 0;
  std::size_t first = 0;
  for (std::size_t k = expected.size(); k-- > 0;) {
    if (is_same(expected[k], actual[k])) continue;
    first = k;
    ++different;
  }
  if (different == 0) return {};
  const std::size_t pixel = first / channels;
  const auto width = static_cast<std::size_t>(frame.width());
  const std::size_t y = static_cast<std::size_t>(frame.height()) - 1 - pixel / width;
  return std::string(name) + ": " + std::to_string(different) + " values differ, first at pixel (" +
         std::to_string(pixel % width) + ", " + std::to_string(y) + ") channel " +
         std::to_string(first % channels) + ": expected " + text_of(expected[first]) + ", got " +
         text_of(actual[first]) + "\n";
}

}  // namespace

std::string describe_difference(const Framebuffer& expected, const Framebuffer& actual) {
  return compare_arrays("depth", expected.depth(), actual.depth(), expected, 1) +
         compare_arrays("color_float", expected.color_float(), actual.color_float(), expected, 4) +
         compare_arrays("color8", expected.color8(), actual.color8(), expected, 1);
}

}  // namespace barrido::raster::testing
