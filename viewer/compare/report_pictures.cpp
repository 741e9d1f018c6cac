#include "viewer/compare/report_pictures.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

#include "pipeline/pictures/image_io.h"
#include "pipeline/pictures/transfer.h"
#include "viewer/compare/difference_picture.h"
#include "viewer/compare/false_color.h"

namespace barrido::compare {
namespace {

using scene::StoredPicture;

/// Small files matter more than the tenth of a second: reports are kept and sent about.
Png encode(int width, int height, const std::vector<std::uint8_t>& rgba) {
  scene::WriteOptions options;
  options.png_compression = 6;
  return scene::encode_png({width, height, rgba, {}}, options);
}

/// The colour of a pixel as a screen shows it: straight, encoded, in 0..1.
float shown(const StoredPicture& picture, float value, float alpha, float gain) {
  if (picture.is_associated && alpha > 0.0f) value /= alpha;
  return picture.is_linear ? scene::srgb_from_linear(value * gain) : value;
}

Png as_shown(const StoredPicture& picture, double exposure) {
  if (picture.rgba.empty()) return {};
  const auto gain = static_cast<float>(std::exp2(exposure));
  std::vector<std::uint8_t> bytes(picture.rgba.size());
  const std::size_t row = static_cast<std::size_t>(picture.width) * 4;
  tbb::parallel_for(0, picture.height, [&](int y) {
    const std::size_t begin = static_cast<std::size_t>(y) * row;
    for (std::size_t i = begin; i < begin + row; i += 4) {
      const float alpha = picture.rgba[i + 3];
      for (std::size_t c = 0; c < 3; ++c) {
        bytes[i + c] = scene::byte_from_fraction(shown(picture, picture.rgba[i + c], alpha, gain));
      }
      bytes[i + 3] = scene::byte_from_fraction(alpha);
    }
  });
  return encode(picture.width, picture.height, bytes);
}

/// What differs shall be seen: its root mean square becomes at most a half. Powers of two are easy to reckon
/// with.
int amplification_for(const Figures& figures) {
  const auto part = static_cast<double>(std::max<std::uint64_t>(figures.over_zero, 1)) /
                    static_cast<double>(figures.pixels);
  const double rms = figures.rms / std::sqrt(part);
  int factor = 1;
  while (factor < 256 && rms * factor * 2 <= 0.5) factor *= 2;
  return factor;
}

Png difference_of(const ComparedPair& pair, int amplification) {
  const DifferencePicture picture =
      difference_picture(pair.expected, pair.actual, {true, static_cast<float>(amplification)});
  return encode(picture.width, picture.height, picture.rgba8);
}

Png false_colors(const FlipMap& map) {
  if (map.errors.empty()) return {};
  std::vector<std::uint8_t> rgba(map.errors.size() * 4);
  for (std::size_t i = 0; i < map.errors.size(); ++i) {
    const auto color = false_color(map.errors[i]);
    std::copy(color.begin(), color.end(), rgba.begin() + static_cast<std::ptrdiff_t>(i * 4));
    rgba[i * 4 + 3] = 255;
  }
  return encode(map.width, map.height, rgba);
}

double exposure_of(const ComparedPair& pair) {
  const auto& flip = pair.result.flip;
  return flip && flip->exposures ? 0.5 * (flip->exposures->start + flip->exposures->stop) : 0.0;
}

}  // namespace

ReportPictures report_pictures(const ComparedPair& pair) {
  ReportPictures pictures;
  const Result& result = pair.result;
  const bool equal = result.figures && result.figures->max == 0.0 && result.outcome != Outcome::different;
  if (equal || result.outcome == Outcome::error) return pictures;
  pictures.exposure = exposure_of(pair);
  const bool both = result.figures.has_value();
  if (both) pictures.amplification = amplification_for(*result.figures);
  tbb::parallel_invoke([&] { pictures.expected = as_shown(pair.expected, pictures.exposure); },
                       [&] { pictures.actual = as_shown(pair.actual, pictures.exposure); },
                       [&] {
                         if (both) pictures.difference = difference_of(pair, pictures.amplification);
                       },
                       [&] { pictures.flip = false_colors(pair.flip); });
  return pictures;
}

}  // namespace barrido::compare
