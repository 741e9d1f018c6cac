// Textures by procedure on vectors: the values of a pattern at the points of a batch.
// raster/reference/pattern.cpp says the same of one point, and why.
#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/pattern.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using VF = hn::Vec<F>;

HWY_INLINE VF clamped_to(VF v, float limit) {
  const F d;
  return minimum(maximum(v, hn::Set(d, -limit)), hn::Set(d, limit));
}

HWY_INLINE VF filtered_parity(VF x, VF w) {
  const F d;
  const auto half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f);
  x = clamped_to(x, kLargestNoiseCoordinate);
  w = minimum(maximum(w, hn::Set(d, 1e-20f)), hn::Set(d, 4096.0f));
  const auto place = hn::Sub(x, hn::Mul(hn::Set(d, 2.0f), hn::Floor(hn::Mul(x, half))));
  const auto edge = hn::Floor(hn::Add(place, half));
  const auto from_edge = hn::Sub(place, edge);
  const auto share = clamped_to(hn::Div(hn::Add(from_edge, from_edge), w), 1.0f);
  const auto narrow = hn::IfThenElse(hn::Eq(edge, one), hn::Neg(share), share);
  const auto is_wide = hn::Gt(w, one);
  if (hn::AllFalse(d, is_wide)) return narrow;
  const auto fold = [&](VF y) HWY_ATTR {
    const auto part = hn::Mul(y, half);
    return hn::Abs(hn::Sub(hn::Sub(part, hn::Floor(part)), half));
  };
  const auto h = hn::Mul(w, half);
  const auto difference = hn::Sub(fold(hn::Sub(place, h)), fold(hn::Add(place, h)));
  return hn::IfThenElse(is_wide, hn::Div(hn::Add(difference, difference), w), narrow);
}

HWY_INLINE VF wave_integral(VF x, float rise) {
  const F d;
  const auto half = hn::Set(d, 0.5f);
  const auto whole = hn::Floor(x);
  const auto f = hn::Sub(x, whole);
  const auto rest = hn::Sub(hn::Set(d, 1.0f), f);
  const auto risen = hn::Mul(hn::Mul(f, f), hn::Set(d, 0.5f / rise));
  const auto fallen = hn::Sub(half, hn::Mul(hn::Mul(rest, rest), hn::Set(d, 0.5f / (1.0f - rise))));
  return hn::Add(hn::Mul(whole, half), hn::IfThenElse(hn::Lt(f, hn::Set(d, rise)), risen, fallen));
}

HWY_INLINE VF filtered_wave(VF x, VF w, float rise) {
  const F d;
  x = clamped_to(x, kLargestNoiseCoordinate);
  w = minimum(maximum(w, hn::Set(d, 1.0f / 64.0f)), hn::Set(d, 1024.0f));
  const auto place = hn::Sub(x, hn::Floor(x));
  const auto h = hn::Mul(w, hn::Set(d, 0.5f));
  return hn::Div(hn::Sub(wave_integral(hn::Add(place, h), rise), wave_integral(hn::Sub(place, h), rise)), w);
}

/// One vector of points.
struct PatternPoint {
  VF at[3], extent[3], footprint;
  int count;  ///< Lanes that are points.
};

HWY_INLINE VF noise_value(const Pattern& pattern, const PatternPoint& p, std::uint64_t& noise) {
  const F d;
  const auto half = hn::Set(d, 0.5f);
  const auto sum = sum_of_octaves(d, pattern, p.at, p.footprint, false, p.count, noise);
  if (!pattern.has_threshold) return hn::Add(hn::Mul(half, sum), half);
  const auto width = hn::Mul(maximum(p.footprint, hn::Set(d, 1e-6f)), hn::Set(d, 2.0f));
  return hn::Add(hn::Div(hn::Sub(sum, hn::Set(d, pattern.threshold)), width), half);
}

HWY_INLINE VF moved_wave(const Pattern& pattern, const PatternPoint& p, VF place, VF width,
                         std::uint64_t& noise) {
  const F d;
  if (pattern.turbulence != 0.0f) {
    const auto moved = hn::Set(d, pattern.turbulence);
    const auto sum = sum_of_octaves(d, pattern, p.at, p.footprint, true, p.count, noise);
    place = hn::Add(place, hn::Mul(moved, sum));
    width = hn::Add(width, hn::Mul(hn::Abs(moved), p.footprint));
  }
  return filtered_wave(place, width, pattern.kind == PatternKind::wood ? kWoodRise : kMarbleRise);
}

HWY_INLINE VF pattern_value(const Pattern& pattern, const PatternPoint& p, std::uint64_t& noise) {
  const F d;
  const auto half = hn::Set(d, 0.5f);
  switch (pattern.kind) {
    case PatternKind::stripes:
      return hn::Sub(half, hn::Mul(half, filtered_parity(p.at[1], p.extent[1])));
    case PatternKind::checker: {
      const auto xy = hn::Mul(filtered_parity(p.at[0], p.extent[0]), filtered_parity(p.at[1], p.extent[1]));
      return hn::Sub(half, hn::Mul(half, hn::Mul(xy, filtered_parity(p.at[2], p.extent[2]))));
    }
    case PatternKind::noise:
      return noise_value(pattern, p, noise);
    case PatternKind::wood: {
      const auto square = hn::Add(hn::Mul(p.at[0], p.at[0]), hn::Mul(p.at[2], p.at[2]));
      return moved_wave(pattern, p, hn::Sqrt(square), maximum(p.extent[0], p.extent[2]), noise);
    }
    case PatternKind::marble:
      break;
  }
  return moved_wave(pattern, p, p.at[1], p.extent[1], noise);
}

std::uint64_t PatternValues(const Pattern& pattern, const ProcedurePoints& points, float* value) {
  const F d;
  std::uint64_t noise = 0;
  for (int i = 0; i < points.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto load = [&](const float* from, float otherwise) HWY_ATTR {
      return from != nullptr ? hn::LoadU(d, from + i) : hn::Set(d, otherwise);
    };
    PatternPoint p;
    for (std::size_t k = 0; k < 3; ++k) {
      p.at[k] = load(points.at[k], 0.5f);
      p.extent[k] = load(points.extent[k], 0.0f);
    }
    p.footprint = maximum(maximum(p.extent[0], p.extent[1]), p.extent[2]);
    p.count = points.count - i;
    hn::StoreU(clamp01(pattern_value(pattern, p, noise)), d, value + i);
  }
  return noise;
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(PatternValues);

const std::array<std::int32_t, 256> kNoisePairs = [] {
  std::array<std::int32_t, 256> pairs{};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i] = kNoisePermutation[i] + (kNoisePermutation[(i + 1) & 255] << 16);
  }
  return pairs;
}();

std::uint64_t pattern_values(const Pattern& pattern, const ProcedurePoints& points, float* value) {
  return HWY_DYNAMIC_DISPATCH(PatternValues)(pattern, points, value);
}

}  // namespace barrido::raster
#endif
