// Samples: where in every pixel the frame is looked at, and how what is seen there becomes the pixel. What is
// set up here once a frame is done tile by tile: each sample is a drawing of the tile of its own, all of them
// are added up in their order, and one division ends it (docs/samples.md, docs/arithmetic.md "Samples").
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "raster/fragments/primitive.h"
#include "raster/tiles/pixel_filter.h"

namespace barrido::raster {

/// A place in the pixel, in 1/256 pixel from its lower left corner. May lie outside of the pixel.
struct SamplePlace {
  std::int32_t x = kSubpixelUnits / 2;
  std::int32_t y = kSubpixelUnits / 2;

  friend bool operator==(const SamplePlace&, const SamplePlace&) = default;
};

struct Sample {
  SamplePlace place;
  float weight = 1.0f;  ///< Share of the sum; may be negative.
};

/// Around which places pixels are sampled: from `least` to `most` on either axis.
struct SampleReach {
  SamplePlace least, most;

  /// Exactly one sample, at the pixel's centre.
  bool is_center() const { return least == SamplePlace{} && most == SamplePlace{}; }
};

/// What the alpha of samples is.
enum class SampleAlpha : std::uint8_t {
  opaque,    ///< 1 everywhere: it is not looked at.
  straight,  ///< Colours are not multiplied by it.
  /// Blended over a background that lets something through: colours are multiplied by alpha already, and
  /// where something wrote its depth the pixel is opaque, whatever alphas were multiplied.
  blended,
};

/// Which of the two is averaged.
enum class FilterOrder : std::uint8_t {
  light,    ///< Linear light, before exposure and tone reproduction.
  display,  ///< What is shown: edges of what is brighter than the screen stay jagged.
};

/// Sums over all samples of a frame that is drawn in several goes: four floats a pixel, depth, row-major, top
/// row first.
struct FrameSums {
  FrameSums(int width, int height, bool weights)
      : color(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4),
        weight(weights ? color.size() / 4 : 0),
        depth(color.size() / 4) {}

  std::vector<float> color;   ///< Of premultiplied colours times weights; the fourth is alpha's.
  std::vector<float> weight;  ///< Empty where all pixels have the same.
  std::vector<float> depth;   ///< Nearest.
};

/// Samples at places that differ from pixel to pixel (A2; pixel_places.h).
struct JitterSettings {
  std::uint32_t seed = 0;
  PixelFilter filter;
  int first = 0;  ///< Number of the first of SampleSettings::samples among
  int count = 1;  ///< … all of the frame.
};

/// Samples where they are needed (A3; docs/samples.md).
struct AdaptiveSettings {
  float threshold = 0.1f;     ///< Of the difference of a channel as it is shown, 0..1.
  int depth = 2;              ///< How often a pixel is cut into quarters at most, 1..4.
  bool keeps_slivers = true;  ///< What lies between all samples of a pixel is seen all the same.
};

/// What adaptive sampling did; row-major, top row first.
struct SampleReport {
  std::vector<std::uint16_t> counts;  ///< Samples of each pixel.
  std::vector<std::uint8_t> slivers;  ///< 1: holds something that the corners alone would have lost.
};

struct SampleSettings {
  /// In the order in which they are added up; at least one. Where places differ from pixel to pixel, only how
  /// many counts; adaptive sampling has its own.
  std::vector<Sample> samples;
  SampleAlpha alpha = SampleAlpha::straight;
  FilterOrder order = FilterOrder::light;
  /// Straight colour of pixels of which nothing is seen at all.
  std::array<float, 4> background{0, 0, 0, 0};
  float background_depth = 1.0f;
  /// Not null: these samples are some of the frame's, which other flushes draw too. Sums are taken from here,
  /// and put back here unless this is the last go.
  FrameSums* sums = nullptr;
  bool is_first = true, is_last = true;
  float total_weight = 1.0f;  ///< Of all of the frame's samples, added up in their order.
  std::optional<JitterSettings> jitter;
  std::optional<AdaptiveSettings> adaptive;
  SampleReport* report = nullptr;  ///< Filled by adaptive sampling unless null.

  bool has_places() const { return jitter || adaptive; }
  /// Whether the sum of weights is not the same for all pixels.
  bool sums_weights() const { return adaptive || (jitter && jitter->filter.kind != PixelFilterKind::box); }

  SampleReach reach() const {
    if (has_places()) {
      const float radius = adaptive ? 0.5f : jitter->filter.radius;
      const auto units = static_cast<std::int32_t>(radius * kSubpixelUnits) + 1;
      constexpr std::int32_t kCenter = kSubpixelUnits / 2;
      return {{kCenter - units, kCenter - units}, {kCenter + units, kCenter + units}};
    }
    SampleReach r{samples.front().place, samples.front().place};
    for (const Sample& s : samples) {
      r.least = {std::min(r.least.x, s.place.x), std::min(r.least.y, s.place.y)};
      r.most = {std::max(r.most.x, s.place.x), std::max(r.most.y, s.place.y)};
    }
    return r;
  }
};

}  // namespace barrido::raster
