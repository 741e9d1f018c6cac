// What a pixel is an average over: how many samples, where they lie, when and through which place of a lens
// they are looked at. Plain values, the defaults being one sample at the pixel's centre.
#pragma once

#include <cstdint>
#include <optional>

#include "raster/tiles/pixel_filter.h"
#include "raster/tiles/samples.h"

namespace barrido::scene {

enum class Sampling : std::uint8_t {
  uniform,   ///< The same places in every pixel: a grid (A1).
  jittered,  ///< One random place in each cell of the grid, others in every pixel (A2).
  adaptive,  ///< Corners of each pixel, and more where they differ (A3).
};

/// Moments between which the shutter is open, in frames after the frame's own.
struct Shutter {
  float open = 0.0f, close = 1.0f;

  friend bool operator==(const Shutter&, const Shutter&) = default;
};

/// A pixel of the frame, counted from the upper left one.
struct PixelPlace {
  int x = 0, y = 0;

  friend bool operator==(const PixelPlace&, const PixelPlace&) = default;
};

struct SampleChoice {
  int count = 1;  ///< Samples a pixel.
  Sampling sampling = Sampling::uniform;
  raster::PixelFilter filter;
  int seed = 0;
  float adaptive_threshold = 0.1f;  ///< See raster::AdaptiveSettings.
  int adaptive_depth = 2;
  bool corners_only = false;  ///< Adaptive: what lies between the corners may be lost, as in the textbook.
  raster::FilterOrder order = raster::FilterOrder::light;
  std::optional<Shutter> shutter;    ///< Empty: everything stands still.
  std::optional<float> lens_radius;  ///< The model's units. Empty and no f-stop: a pinhole.
  std::optional<float> f_stop;       ///< Of a lens before a picture 24 mm high, in a model in metres.
  std::optional<float>
      focus_distance;  ///< The model's units along the line of sight; empty: the focal point's.
  std::optional<PixelPlace> focus_pixel;  ///< What is seen there is in focus.

  bool moves() const { return shutter.has_value(); }
  bool has_lens() const { return lens_radius.has_value() || f_stop.has_value(); }
  /// Whether frames are what they are without any choice.
  bool is_plain() const { return count == 1 && sampling == Sampling::uniform && !moves() && !has_lens(); }

  friend bool operator==(const SampleChoice&, const SampleChoice&) = default;
};

}  // namespace barrido::scene
