// How much two pictures differ, in the figures of OpenImageIO's idiff, and whether that is too much. Enters:
// pixels on the same footing. Leaves: numbers. Must not know: files, reports.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "pipeline/pictures/stored_picture.h"

namespace barrido::compare {

/// As a threshold: nothing is over it.
inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// What is allowed, with idiff's names and defaults. A difference is that of one channel's value, whose range
/// is 0..1 but for floats.
struct Thresholds {
  double fail = 1e-6;                ///< A pixel with a greater difference fails.
  double fail_percent = 0.0;         ///< So many of the pixels may fail, in percent.
  std::uint64_t allow_failures = 0;  ///< So many pixels may fail.
  double hard_fail = kUnlimited;     ///< No difference may be greater.
  double warn = 1e-6;
  double warn_percent = 0.0;
  double hard_warn = kUnlimited;
  double fail_flip = kUnlimited;  ///< FLIP's mean may not be greater.
};

/// Where two pictures differ most.
struct WorstPixel {
  int x = 0, y = 0;  ///< From the left and the top, from 0.
  int channel = 0;   ///< 0..3: R, G, B, A.
  std::array<float, 4> expected{}, actual{};
};

struct Figures {
  int channels = 0;   ///< That were compared: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA.
  double mean = 0.0;  ///< Of the absolute differences of all values; NaN where some have none.
  double rms = 0.0;   ///< Root of their mean square; NaN likewise.
  double peak = 1.0;  ///< The greatest value of both pictures, at least 1.
  double max = 0.0;   ///< Infinite where a NaN or an infinity meets something else.
  WorstPixel worst;   ///< The first of several, row by row; its place means nothing while max is 0.
  std::uint64_t pixels = 0;
  std::uint64_t over_fail = 0, over_warn = 0;  ///< Pixels with a difference over the threshold,
  std::uint64_t over_zero = 0;                 ///< and with any.
  std::uint64_t incomparable = 0;  ///< Values, not pixels, where a NaN or an infinity meets something else.

  /// Peak signal-to-noise ratio in decibels, 20·log10(peak/rms); infinite for equal pictures, NaN where the
  /// others are.
  double psnr() const;
};

enum class Verdict { same, warning, different };

/// Compares the channels that at least one of the pictures has. Pictures of different sizes lie with their
/// upper left corners on each other, and what one of them lacks counts as 0 in every channel.
Figures measure(const scene::StoredPicture& expected, const scene::StoredPicture& actual,
                const Thresholds& thresholds);

/// Of pictures of the same size. The figure of FLIP is judged elsewhere.
Verdict judge(const Figures& figures, const Thresholds& thresholds);

/// "RGB" and the like, for 1..4 channels.
const char* channels_name(int channels);

}  // namespace barrido::compare
