// The depth test of one span against the tile, and the two things that may come of it: a visible span number
// per pixel (visibility before shading), or the runs of pixels that passed (shading in drawing order).
#if defined(BARRIDO_DEPTH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_DEPTH_INL_H
#undef BARRIDO_DEPTH_INL_H
#else
#define BARRIDO_DEPTH_INL_H
#endif

#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/simd_math-inl.h"
#include "raster/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The usual comparison, `less`, for pixels in vectors and for one.
template <class V>
HWY_INLINE auto is_nearer(V incoming, V stored) {
  return hn::Lt(incoming, stored);
}
inline bool is_nearer(float incoming, float stored) { return incoming < stored; }

/// Any comparison: which of its outcomes pass, as masks. The incoming value stands left.
struct CompareRule {
  using D = hn::ScalableTag<float>;
  hn::Mask<D> less, equal, greater, unordered;

  explicit CompareRule(Compare c) {
    const bool any = c == Compare::always;
    const bool unequal = c == Compare::not_equal;
    less = on(any || unequal || c == Compare::less || c == Compare::less_equal);
    equal = on(any || c == Compare::equal || c == Compare::less_equal || c == Compare::greater_equal);
    greater = on(any || unequal || c == Compare::greater || c == Compare::greater_equal);
    unordered = on(any || unequal);  // one of them is a NaN
  }
  static HWY_INLINE hn::Mask<D> on(bool all) {
    const hn::RebindToSigned<D> di;
    return hn::RebindMask(D(), hn::MaskFromVec(hn::Set(di, all ? -1 : 0)));
  }
  HWY_INLINE hn::Mask<D> operator()(hn::Vec<D> incoming, hn::Vec<D> stored) const {
    const auto lt = is_nearer(incoming, stored);
    const auto eq = hn::Eq(incoming, stored);
    const auto gt = hn::Gt(incoming, stored);
    const auto ordered = hn::Or(hn::Or(lt, eq), gt);
    return hn::Or(hn::Or(hn::And(lt, less), hn::And(eq, equal)),
                  hn::Or(hn::And(gt, greater), hn::AndNot(ordered, unordered)));
  }
};

// The depth test of pixels, in one of two forms: bounded(z) is the depth that is compared and stored,
// passes(z, stored) the pixels that pass, written(passed) those whose depth is stored.

/// DepthTest::less, of depths that need no clamping.
struct UsualDepth {
  template <class V>
  HWY_INLINE V bounded(V z) const {
    return z;
  }
  template <class V>
  HWY_INLINE auto passes(V z, V stored) const {
    return is_nearer(z, stored);
  }
  template <class M>
  HWY_INLINE M written(M passed) const {
    return passed;
  }
};

/// Any test of any depths.
struct AnyDepth {
  CompareRule compare;
  hn::Mask<CompareRule::D> write;

  AnyDepth(const DepthState& state, const KernelKey& key)
      : compare(key.depth == DepthTest::off ? Compare::always : state.compare),
        write(CompareRule::on(state.write && key.depth != DepthTest::off && !key.late_depth)) {}
  template <class V>
  HWY_INLINE V bounded(V z) const {
    return clamp01(z);
  }
  template <class V>
  HWY_INLINE auto passes(V z, V stored) const {
    return compare(z, stored);
  }
  template <class M>
  HWY_INLINE M written(M passed) const {
    return hn::And(passed, write);
  }
};

/// Where to begin with the vectors of columns [begin, end): aligned, unless one vector that is not will do.
inline int first_vector(int begin, int end, int lanes) {
  return end - begin <= lanes ? begin : begin & ~(lanes - 1);
}

/// A span's depth: value at its anchor column and slope; columns relative to the tile.
struct SpanDepth {
  float row;
  float slope;
  int anchor;

  float at(int x) const { return row + slope * static_cast<float>(x - anchor); }
};

/// Columns [begin, end) as a mask of the vector that starts at x.
template <class D>
HWY_INLINE auto columns_mask(D d, int x, int begin, int end) {
  return hn::AndNot(lanes_below(d, begin - x), lanes_below(d, end - x));
}

/// Whether no depth of a span needs clamping to [0, 1], from those at its ends: in floating point, too, a
/// linear function is monotonic.
inline bool within_unit(float at_begin, float at_end) {
  return at_begin > 0.0f && at_begin < 1.0f && at_end > 0.0f && at_end < 1.0f;
}

/// Tests columns [begin, end) of a row and calls passed(x, mask, column) for each vector of pixels, where
/// `column` are the columns as numbers from the anchor on; writes the depth where the test passes. `start` is
/// the column of the first vector, at most `begin`.
template <class Rule, class Passed>
HWY_INLINE void test_depth(const Rule& rule, float* depth_row, const SpanDepth& depth, int start, int begin,
                           int end, Passed&& passed) {
  const hn::ScalableTag<float> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto row = hn::Set(d, depth.row);
  const auto slope = hn::Set(d, depth.slope);
  auto column = lanes_from(d, static_cast<float>(start - depth.anchor));
  const auto all = lanes_below(d, lanes);
  for (int x = start; x < end; x += lanes) {
    auto mask = x >= begin && x + lanes <= end ? all : columns_mask(d, x, begin, end);
    const auto z = rule.bounded(hn::Add(row, hn::Mul(slope, column)));
    mask = hn::And(mask, rule.passes(z, hn::LoadU(d, depth_row + x)));
    hn::BlendedStore(z, rule.written(mask), d, depth_row + x);
    passed(x, mask, column);
    column = hn::Add(column, hn::Set(d, static_cast<float>(lanes)));  // small integers: exact
  }
}

/// By the usual rule where the key and the span's ends allow it, else by `any`.
template <class Passed>
HWY_INLINE void test_depth(const KernelKey& key, const AnyDepth& any, float* depth_row,
                           const SpanDepth& depth, int start, int begin, int end, Passed&& passed) {
  if (key.depth == DepthTest::less && within_unit(depth.at(begin), depth.at(end - 1))) {
    test_depth(UsualDepth(), depth_row, depth, start, begin, end, passed);
  } else {
    test_depth(any, depth_row, depth, start, begin, end, passed);
  }
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
