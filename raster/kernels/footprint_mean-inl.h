// Catmull's filter: the mean of all texels under the pixel's footprint, a parallelogram, each with the area
// that lies under it. Strip by strip of rows of texels, a vector of fragments at a time.
#if defined(BARRIDO_FOOTPRINT_MEAN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_FOOTPRINT_MEAN_INL_H
#undef BARRIDO_FOOTPRINT_MEAN_INL_H
#else
#define BARRIDO_FOOTPRINT_MEAN_INL_H
#endif

#include <hwy/highway.h>

#include "raster/kernels/level_of_detail-inl.h"
#include "raster/kernels/texture_filter-inl.h"
#include "raster/textures/footprint_limits.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE VF sane_slope(VF slope) {
  return hn::IfThenElseZero(hn::Lt(hn::Abs(slope), hn::Set(F(), kLargestSlope)), slope);
}

HWY_INLINE Slopes sane(const Slopes& s) {
  return {sane_slope(s.ux), sane_slope(s.uy), sane_slope(s.vx), sane_slope(s.vy)};
}

/// The sides of the box around the footprint.
struct Extent {
  VF width, height;
};
HWY_INLINE Extent extent_of(const Slopes& s) {
  return {hn::Add(hn::Abs(s.ux), hn::Abs(s.uy)), hn::Add(hn::Abs(s.vx), hn::Abs(s.vy))};
}

HWY_INLINE Slopes in_texels(const Slopes& s, VF width, VF height) {
  return {hn::Mul(s.ux, width), hn::Mul(s.uy, width), hn::Mul(s.vx, height), hn::Mul(s.vy, height)};
}

/// The smallest level under which both sides have at most 2^kMostSummedLog2 texels.
HWY_INLINE VI summed_levels(const Slopes& slopes, const Texture& texture) {
  const F d;
  const I di;
  const Extent extent = extent_of(in_texels(sane(slopes), hn::Set(d, static_cast<float>(texture.width())),
                                            hn::Set(d, static_cast<float>(texture.height()))));
  const auto bits = hn::BitCast(di, maximum(extent.width, extent.height));
  const auto level =
      hn::Sub(hn::ShiftRight<23>(hn::Add(bits, hn::Set(di, 0x7fffff))), hn::Set(di, 127 + kMostSummedLog2));
  return hn::Min(hn::Max(level, hn::Zero(di)), hn::Set(di, texture.level_count() - 1));
}

/// Footprints of a batch's fragments.
struct FootprintShapes {
  alignas(64) std::int32_t level[kBatchStride];          ///< Whose texels are summed
  alignas(64) std::int32_t slope_bits[4][kBatchStride];  ///< ux, uy, vx, vy

  HWY_INLINE Slopes slopes(int i) const {
    const F d;
    const auto at = [&](int k) HWY_ATTR { return hn::BitCast(d, hn::Load(I(), slope_bits[k] + i)); };
    return {at(0), at(1), at(2), at(3)};
  }
};

/// Parallelograms about (0, 0), in texels.
class Parallelograms {
 public:
  HWY_INLINE explicit Parallelograms(Slopes side) {
    const F d;
    const auto half = hn::Set(d, 0.5f);
    const auto least = hn::Set(d, kLeastFootprintWidth * 0.5f);
    const auto longest = hn::Set(d, kLongestFootprintSide);
    const Extent before = extent_of(side);
    const auto extent = maximum(before.width, before.height);
    const auto shrink = hn::IfThenElse(hn::Gt(extent, longest), hn::Div(longest, extent), hn::Set(d, 1.0f));
    side = in_texels(side, shrink, shrink);
    const Extent box = extent_of(side);
    half_width_ = maximum(hn::Mul(box.width, half), least);
    half_height = maximum(hn::Mul(box.height, half), least);
    corner_height = hn::Mul(hn::Abs(hn::Sub(hn::Abs(side.vx), hn::Abs(side.vy))), half);
    const auto area = hn::Abs(hn::Sub(hn::Mul(side.ux, side.vy), hn::Mul(side.vx, side.uy)));
    bands_[0] = band(side.uy, side.vy, area);
    bands_[1] = band(side.ux, side.vx, area);
  }

  struct Interval {
    VF left, right;
  };
  HWY_INLINE Interval at(VF y) const {
    const F d;
    auto left = hn::Neg(half_width_);
    auto right = half_width_;
    for (const Band& b : bands_) {
      const auto middle = hn::Mul(y, b.slope);
      left = maximum(left, hn::Sub(middle, b.half));
      right = minimum(right, hn::Add(middle, b.half));
    }
    const auto thin = hn::Lt(hn::Sub(right, left), hn::Set(d, kLeastFootprintWidth));
    const auto x =
        minimum(maximum(hn::Mul(hn::Add(left, right), hn::Set(d, 0.5f)), hn::Neg(half_width_)), half_width_);
    const auto half = hn::Set(d, kLeastFootprintWidth * 0.5f);
    return {hn::IfThenElse(thin, hn::Sub(x, half), left), hn::IfThenElse(thin, hn::Add(x, half), right)};
  }

  VF half_height;
  VF corner_height;  ///< Of the two corners between the lowest and the highest, one below 0.

 private:
  /// Between two parallel sides: |x − y·slope| ≤ half.
  struct Band {
    VF slope, half;
  };
  static HWY_INLINE Band band(VF x, VF y, VF area) {
    const F d;
    const auto rises = hn::Ge(hn::Abs(y), hn::Set(d, kLeastFootprintRise));
    return {hn::IfThenElseZero(rises, hn::Div(x, y)),
            hn::IfThenElse(rises, hn::Div(hn::Mul(area, hn::Set(d, 0.5f)), hn::Abs(y)),
                           hn::Set(d, 2.0f * kLongestFootprintSide))};
  }

  Band bands_[2];
  VF half_width_;
};

/// Where the middle of the footprint lies, in texels; wrapped, but mirrors are left to the texels.
HWY_INLINE VF middle_of_footprint(VF u, VF size, Wrap mode) {
  const F d;
  switch (mode) {
    case Wrap::repeat:
      return hn::Mul(hn::Sub(u, hn::Floor(u)), size);
    case Wrap::mirrored_repeat:
      return hn::Mul(hn::Sub(u, hn::Mul(hn::Set(d, 2.0f), hn::Floor(hn::Mul(u, hn::Set(d, 0.5f))))), size);
    case Wrap::clamp:
      return hn::Mul(clamp01(u), size);
    case Wrap::clamp_to_edge:
    case Wrap::clamp_to_border:
      break;
  }
  const auto beyond = hn::Set(d, kBeyondEdgeTexels);
  return minimum(maximum(hn::Mul(u, size), hn::Neg(beyond)), hn::Add(size, beyond));
}

/// The texel that stands for column (or row) i; −1 and `size` are the apron.
HWY_INLINE VI wrapped_texel(VI i, VI size, Wrap mode) {
  const F d;
  const I di;
  // Exact: both are below 2^16, so the quotient is not rounded up to a whole number.
  const auto modulo = [&](VI a, VI n) HWY_ATTR {
    const auto times = floor_to_integer(hn::Div(hn::ConvertTo(d, a), hn::ConvertTo(d, n)));
    return hn::Sub(a, hn::Mul(times, n));
  };
  const auto one = hn::Set(di, 1);
  switch (mode) {
    case Wrap::repeat:
      return modulo(i, size);
    case Wrap::mirrored_repeat: {
      const auto both = hn::Add(size, size);
      const auto m = modulo(i, both);
      return hn::IfThenElse(hn::Lt(m, size), m, hn::Sub(hn::Sub(both, one), m));
    }
    case Wrap::clamp_to_edge:
      return hn::Min(hn::Max(i, hn::Zero(di)), hn::Sub(size, one));
    case Wrap::clamp:
    case Wrap::clamp_to_border:
      break;
  }
  return hn::Min(hn::Max(i, hn::Neg(one)), size);
}

/// Texels [first, end) that [low, high] meets, at least one.
struct TexelRanges {
  VI first, end;
};
HWY_INLINE TexelRanges texels_between(VF low, VF high) {
  const auto first = floor_to_integer(low);
  return {first, hn::Max(whole_to_integer(F(), hn::Ceil(high)), hn::Add(first, hn::Set(I(), 1)))};
}

/// The mean of max(c, 0) while c goes from p to q at an even pace.
HWY_INLINE VF mean_of_positive(VF p, VF q) {
  const F d;
  const auto zero = hn::Zero(d);
  const auto both = hn::And(hn::Gt(p, zero), hn::Gt(q, zero));
  const auto most = maximum(maximum(p, q), zero);
  const auto apart = hn::Mul(hn::Set(d, 2.0f), hn::Abs(hn::Sub(p, q)));
  return hn::IfThenElse(both, hn::Mul(hn::Add(p, q), hn::Set(d, 0.5f)),
                        hn::Div(hn::Mul(most, most), maximum(apart, hn::Set(d, 1e-30f))));
}

/// What strips of a row of texels, with a straight side at their left and their right, cover of each texel.
class Strips {
 public:
  HWY_INLINE Strips(const Parallelograms::Interval& low, const Parallelograms::Interval& high, VF x,
                    VF strip_height) {
    left_[0] = hn::Add(x, low.left);
    left_[1] = hn::Add(x, high.left);
    right_[0] = hn::Add(x, low.right);
    right_[1] = hn::Add(x, high.right);
    height = strip_height;
    columns = texels_between(minimum(left_[0], left_[1]), maximum(right_[0], right_[1]));
  }

  TexelRanges columns;
  VF height;

  /// The area of the strip left of x, were it a row high.
  HWY_INLINE VF left_of(VF x) const {
    return hn::Sub(mean_of_positive(hn::Sub(x, left_[0]), hn::Sub(x, left_[1])),
                   mean_of_positive(hn::Sub(x, right_[0]), hn::Sub(x, right_[1])));
  }

 private:
  VF left_[2], right_[2];
};

class FootprintMean {
 public:
  explicit FootprintMean(const Texture& texture)
      : texture_(texture),
        // The apron of a cube map's face holds what lies beyond an edge.
        wrap_s_(texture.is_cube() ? Wrap::clamp_to_border : texture.options().wrap_s),
        wrap_t_(texture.is_cube() ? Wrap::clamp_to_border : texture.options().wrap_t) {}

  /// Of the lanes `wanted`. @return the texels that each lane read.
  HWY_INLINE VI of(const Coordinates& place, const FootprintShapes& shapes, int i, hn::Mask<I> wanted,
                   VF* color) const {
    const F d;
    const I di;
    const TexelLevels& tables = texture_.texel_levels();
    const auto level = hn::Load(di, shapes.level + i);
    const auto look_up = [&](const std::int32_t* table)
                             HWY_ATTR { return hn::GatherIndex(di, table, level); };
    const auto width = look_up(tables.width);
    const auto height = look_up(tables.height);
    const auto pitch = look_up(tables.pitch);
    const auto origin = hn::Add(look_up(tables.origin), hn::Mul(place.face, look_up(tables.face_stride)));
    const auto float_width = hn::ConvertTo(d, width);
    const auto float_height = hn::ConvertTo(d, height);
    const Parallelograms footprint(in_texels(sane(shapes.slopes(i)), float_width, float_height));
    const auto x = middle_of_footprint(place.u, float_width, wrap_s_);
    const auto y = middle_of_footprint(place.v, float_height, wrap_t_);
    const auto bottom = hn::Sub(y, footprint.half_height);
    const auto top = hn::Add(y, footprint.half_height);

    WeightedMeans means;
    const auto one = hn::Set(di, 1);
    const auto corner_low = hn::Sub(y, footprint.corner_height);
    const auto corner_high = hn::Add(y, footprint.corner_height);
    // Strips between whole rows and the footprints' corners: within each, both sides are straight.
    VF high;
    for (VF low = bottom;; low = high) {
      const auto in_strip = hn::And(wanted, hn::RebindMask(di, hn::Lt(low, top)));
      if (hn::AllFalse(di, in_strip)) break;
      const auto whole = hn::Floor(low);
      high = minimum(hn::Add(whole, hn::Set(d, 1.0f)), top);
      high = hn::IfThenElse(hn::Gt(corner_low, low), minimum(high, corner_low), high);
      high = hn::IfThenElse(hn::Gt(corner_high, low), minimum(high, corner_high), high);
      const Strips strip(footprint.at(hn::Sub(low, y)), footprint.at(hn::Sub(high, y)), x,
                         hn::Sub(high, low));
      const auto row =
          hn::Add(origin, hn::Mul(wrapped_texel(whole_to_integer(d, whole), height, wrap_t_), pitch));
      auto before = strip.left_of(hn::ConvertTo(d, strip.columns.first));
      for (VI k = strip.columns.first;; k = hn::Add(k, one)) {
        const auto in_texel = hn::And(in_strip, hn::Lt(k, strip.columns.end));
        if (hn::AllFalse(di, in_texel)) break;
        const auto after = strip.left_of(hn::ConvertTo(d, hn::Add(k, one)));
        const auto weight = maximum(hn::Mul(hn::Sub(after, before), strip.height), hn::Zero(d));
        means.add(texture_, hn::Add(row, wrapped_texel(k, width, wrap_s_)), in_texel, weight);
        before = after;
      }
    }
    means.finish(texture_, color);
    return means.texels;
  }

 private:
  /// Σ wᵢ(tᵢ − t₀) of each lane, so that texels of one colour have exactly that for their mean.
  struct WeightedMeans {
    VF base[4], sum[4], weights;
    VI texels;
    bool is_first = true;

    HWY_INLINE WeightedMeans() {
      for (VF& s : sum) s = hn::Zero(F());
      weights = hn::Zero(F());
      texels = hn::Zero(I());
    }

    HWY_INLINE void add(const Texture& texture, VI address, hn::Mask<I> lanes, VF weight) {
      const F d;
      VF channel[4];
      if (texture.format() == TexelFormat::rgba8) {
        load8(texture.data(), address, channel);
      } else {
        load16(texture.data(), address, channel);
      }
      // All lanes that are wanted take part in the first texel.
      if (is_first) std::copy_n(channel, 4, base);
      is_first = false;
      const auto w = hn::IfThenElseZero(hn::RebindMask(d, lanes), weight);
      for (int c = 0; c < 4; ++c) sum[c] = hn::Add(sum[c], hn::Mul(hn::Sub(channel[c], base[c]), w));
      weights = hn::Add(weights, w);
      texels = hn::Add(texels, hn::IfThenElseZero(lanes, hn::Set(I(), 1)));
    }

    HWY_INLINE void finish(const Texture& texture, VF* color) const {
      const F d;
      const auto scale = hn::Set(d, texture.format() == TexelFormat::rgba8 ? 1.0f / 255.0f : 1.0f / 65535.0f);
      for (int c = 0; c < 4; ++c) {
        color[c] = clamp01(hn::Mul(hn::Add(base[c], hn::Div(sum[c], weights)), scale));
      }
    }

   private:
    static HWY_INLINE void load8(const std::uint8_t* data, VI address, VF* channel) {
      const F d;
      const I di;
      const auto texel = hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(data), address);
      const auto low = hn::Set(di, 0xff);
      channel[0] = hn::ConvertTo(d, hn::And(texel, low));
      channel[1] = hn::ConvertTo(d, hn::And(hn::ShiftRight<8>(texel), low));
      channel[2] = hn::ConvertTo(d, hn::And(hn::ShiftRight<16>(texel), low));
      channel[3] = hn::ConvertTo(d, hn::And(hn::ShiftRight<24>(texel), low));
    }
    static HWY_INLINE void load16(const std::uint8_t* data, VI address, VF* channel) {
      const F d;
      const I di;
      const auto* words = reinterpret_cast<const std::int32_t*>(data);
      const auto at = hn::Add(address, address);
      const auto low = hn::Set(di, 0xffff);
      for (int half = 0; half < 2; ++half) {
        const auto pair = hn::GatherIndex(di, words, hn::Add(at, hn::Set(di, half)));
        channel[2 * half] = hn::ConvertTo(d, hn::And(pair, low));
        channel[2 * half + 1] = hn::ConvertTo(d, hn::And(hn::ShiftRight<16>(pair), low));
      }
    }
  };

  const Texture& texture_;
  const Wrap wrap_s_, wrap_t_;
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
