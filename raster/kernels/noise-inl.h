// Perlin's improved noise and its sums on vectors: the same operations in the same order as
// raster/textures/perlin_noise.h and raster/reference/pattern.cpp.
#if defined(BARRIDO_NOISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_NOISE_INL_H
#undef BARRIDO_NOISE_INL_H
#else
#define BARRIDO_NOISE_INL_H
#endif

#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/simd_math-inl.h"
#include "raster/textures/pattern.h"
#include "raster/textures/perlin_noise.h"

#ifndef BARRIDO_NOISE_PAIRS
#define BARRIDO_NOISE_PAIRS
namespace barrido::raster {
/// hash(i) + 2^16·hash(i + 1): both sides of a lattice cell with one look.
extern const std::array<std::int32_t, 256> kNoisePairs;
}  // namespace barrido::raster
#endif

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Noise on vectors of points.
class Noise {
 public:
  using D = hn::ScalableTag<float>;
  using DI = hn::RebindToSigned<D>;
  using V = hn::Vec<D>;
  using VI = hn::Vec<DI>;

  static HWY_INLINE V at(V x, V y, V z) {
    const D d;
    const auto floor_x = hn::Floor(x), floor_y = hn::Floor(y), floor_z = hn::Floor(z);
    const auto fx = hn::Sub(x, floor_x), fy = hn::Sub(y, floor_y), fz = hn::Sub(z, floor_z);
    const auto u = fade(fx), v = fade(fy), w = fade(fz);
    const auto one = hn::Set(d, 1.0f);
    const auto gx = hn::Sub(fx, one), gy = hn::Sub(fy, one), gz = hn::Sub(fz, one);
    const auto sides = pair_at(whole_to_integer(d, floor_x));
    const auto cell_y = whole_to_integer(d, floor_y), cell_z = whole_to_integer(d, floor_z);
    const auto low = pair_at(hn::Add(first(sides), cell_y));
    const auto high = pair_at(hn::Add(second(sides), cell_y));
    const auto edges = [&](VI a, VI b, V ey, V& near, V& far) HWY_ATTR {
      const auto pa = pair_at(hn::Add(a, cell_z)), pb = pair_at(hn::Add(b, cell_z));
      near = lerp(u, gradient(pa, fx, ey, fz), gradient(pb, gx, ey, fz));
      far =
          lerp(u, gradient(hn::ShiftRight<16>(pa), fx, ey, gz), gradient(hn::ShiftRight<16>(pb), gx, ey, gz));
    };
    auto near0 = hn::Zero(d), far0 = near0, near1 = near0, far1 = near0;
    edges(first(low), first(high), fy, near0, far0);
    edges(second(low), second(high), gy, near1, far1);
    return lerp(w, lerp(v, near0, near1), lerp(v, far0, far1));
  }

 private:
  static HWY_INLINE VI pair_at(VI i) {
    const DI di;
    return hn::GatherIndex(di, kNoisePairs.data(), hn::And(i, hn::Set(di, 255)));
  }
  static HWY_INLINE VI first(VI pair) { return hn::And(pair, hn::Set(DI(), 0xffff)); }
  static HWY_INLINE VI second(VI pair) { return hn::ShiftRight<16>(pair); }
  static HWY_INLINE V lerp(V t, V a, V b) { return hn::Add(a, hn::Mul(t, hn::Sub(b, a))); }

  static HWY_INLINE V fade(V t) {
    const D d;
    const auto cube = hn::Mul(hn::Mul(t, t), t);
    return hn::Mul(cube, hn::Add(hn::Mul(t, hn::Sub(hn::Mul(t, hn::Set(d, 6.0f)), hn::Set(d, 15.0f))),
                                 hn::Set(d, 10.0f)));
  }

  /// Of the hash only the low four bits count.
  static HWY_INLINE V gradient(VI hash, V x, V y, V z) {
    const D d;
    const DI di;
    const auto h = hn::And(hash, hn::Set(di, 15));
    const auto below = [&](std::int32_t n) HWY_ATTR { return hn::RebindMask(d, hn::Lt(h, hn::Set(di, n))); };
    // 12 and 14 are the even ones from 12 on.
    const auto is_12_or_14 = hn::RebindMask(d, hn::Eq(hn::And(h, hn::Set(di, 13)), hn::Set(di, 12)));
    const auto u = hn::IfThenElse(below(8), x, y);
    const auto v = hn::IfThenElse(below(4), y, hn::IfThenElse(is_12_or_14, x, z));
    const auto sign_u = hn::BitCast(d, hn::ShiftLeft<31>(h));
    const auto sign_v = hn::BitCast(d, hn::ShiftLeft<31>(hn::ShiftRight<1>(h)));
    return hn::Add(hn::Xor(u, sign_u), hn::Xor(v, sign_v));
  }
};

/// See octave_weight() of the reference.
template <class D, class V>
HWY_INLINE V octave_weight(D d, V finest, int octave) {
  const auto over = hn::Sub(hn::Sub(finest, hn::Set(d, static_cast<float>(octave))), hn::Set(d, 0.3f));
  const auto t = clamp01(hn::Mul(over, hn::Set(d, 2.5f)));
  return hn::Mul(hn::Mul(t, t), hn::Sub(hn::Set(d, 3.0f), hn::Add(t, t)));
}

/// See sum_of_octaves() of the reference. Adds to `evaluated` for the first `count` lanes.
template <class D, class V>
HWY_INLINE V sum_of_octaves(D d, const Pattern& pattern, const V (&at)[3], V footprint, bool magnitudes,
                            int count, std::uint64_t& evaluated) {
  const auto mean = hn::Set(d, magnitudes ? kMeanAbsoluteNoise : 0.0f);
  const auto finest = hn::Sub(hn::Set(d, -1.0f), Log2(d, footprint));
  const auto limit = hn::Set(d, kLargestNoiseCoordinate);
  float frequency = 1.0f, amplitude = 1.0f;
  auto sum = hn::Zero(d);
  for (int octave = 0; octave < pattern.octaves; ++octave) {
    const auto weight = octave_weight(d, finest, octave);
    const auto is_seen = hn::And(hn::Gt(weight, hn::Zero(d)), lanes_below(d, count));
    auto shown = mean;
    if (!hn::AllFalse(d, is_seen)) {
      evaluated += hn::CountTrue(d, is_seen);
      const auto along = [&](int i) HWY_ATTR {
        return minimum(maximum(hn::Mul(at[i], hn::Set(d, frequency)), hn::Neg(limit)), limit);
      };
      auto noise = Noise::at(along(0), along(1), along(2));
      if (magnitudes) noise = hn::Abs(noise);
      shown = hn::Add(mean, hn::Mul(weight, hn::Sub(noise, mean)));
    }
    sum = hn::Add(sum, hn::Mul(hn::Set(d, amplitude), shown));
    frequency = frequency * 2.0f;
    amplitude = amplitude * pattern.gain;
  }
  return sum;
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
