// Resolve: from the float samples of a tile to the bytes that one looks at, as steps of their own after all
// drawing. Here is what the steps are set to; raster/kernels/resolve.cpp computes them for a row of pixels,
// raster/reference/resolve.h for one.
//
//   samples → pixels    one sample a pixel, at its centre: they are the pixels. Of several (samples.h) the
//                       sums of their light, each times its weight, are divided once.
//   pixels → bytes      exposure, tone reproduction, encoding, rounding; alpha is only rounded.
//
// 8-bit frames have nothing to resolve: their samples are bytes already.
#pragma once

namespace barrido::raster {

enum class ToneMap {
  clamp,     ///< min(c, 1) per channel.
  reinhard,  ///< c / (1 + c) per channel (Reinhard et al. 2002, eq. 3).
};

/// How a float colour becomes the 8-bit colour one looks at: exposure, tone reproduction, then transfer.
struct DisplayTransform {
  float exposure_scale = 1.0f;  ///< Linear factor, 2^EV.
  ToneMap tone_map = ToneMap::clamp;
  bool srgb_encode = false;  ///< Apply the sRGB transfer function (IEC 61966-2-1) after tone mapping.
};

/// Neighbouring float pixels of one row, an array a channel. Arrays begin at a cache line, and whole vectors
/// of them may be read.
struct PixelRow {
  const float* channel[4];
  int count;
};

}  // namespace barrido::raster
