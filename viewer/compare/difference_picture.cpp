#include "viewer/compare/difference_picture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/pictures/transfer.h"

namespace barrido::compare {
namespace {

std::array<float, 4> pixel(const scene::StoredPicture& picture, int x, int y) {
  if (x >= picture.width || y >= picture.height) return {};
  const std::size_t index =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
  std::array<float, 4> values{};
  std::copy_n(picture.rgba.data() + index * 4, 4, values.begin());
  return values;
}

}  // namespace

DifferencePicture difference_picture(const scene::StoredPicture& expected, const scene::StoredPicture& actual,
                                     const DifferenceOptions& options) {
  DifferencePicture picture;
  picture.width = std::max(expected.width, actual.width);
  picture.height = std::max(expected.height, actual.height);
  const auto width = static_cast<std::size_t>(picture.width);
  picture.rgba_float.resize(width * static_cast<std::size_t>(picture.height) * 4);
  picture.rgba8.resize(picture.rgba_float.size());
  tbb::parallel_for(0, picture.height, [&](int y) {
    std::size_t out = static_cast<std::size_t>(y) * width * 4;
    for (int x = 0; x < picture.width; ++x, out += 4) {
      const auto a = pixel(expected, x, y), b = pixel(actual, x, y);
      const auto difference = [&](std::size_t c) {
        const float d = a[c] - b[c];
        return (options.absolute ? std::fabs(d) : d) * options.scale;
      };
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = difference(c) + difference(3);
        picture.rgba_float[out + c] = value;
        picture.rgba8[out + c] = scene::byte_from_fraction(value);
      }
      picture.rgba_float[out + 3] = 1.0f;
      picture.rgba8[out + 3] = 255;
    }
  });
  return picture;
}

}  // namespace barrido::compare
