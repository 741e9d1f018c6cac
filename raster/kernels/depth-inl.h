// The depth test of one span against the tile, and the two things that may come of it: a visible span number
// per pixel (visibility before shading), or the runs of pixels that passed (shading in drawing order).
#if defined(BARRIDO_DEPTH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_DEPTH_INL_H
#undef BARRIDO_DEPTH_INL_H
#else
#define BARRIDO_DEPTH_INL_H
#endif

#include <hwy/highway.h>

#include <type_traits>

#include "raster/kernels/simd_math-inl.h"

#include "raster/kernels/lanes-inl.h"
#include "raster/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Comparison of floats as a mask; `incoming` stands left.
template <Compare kCompare, class V>
HWY_INLINE auto compare(V incoming, V stored) {
  if constexpr (kCompare == Compare::less) {
    return hn::Lt(incoming, stored);
  } else if constexpr (kCompare == Compare::equal) {
    return hn::Eq(incoming, stored);
  } else if constexpr (kCompare == Compare::less_equal) {
    return hn::Le(incoming, stored);
  } else if constexpr (kCompare == Compare::greater) {
    return hn::Gt(incoming, stored);
  } else if constexpr (kCompare == Compare::not_equal) {
    return hn::Not(hn::Eq(incoming, stored));  // true for NaN, which Ne leaves open
  } else if constexpr (kCompare == Compare::greater_equal) {
    return hn::Ge(incoming, stored);
  } else if constexpr (kCompare == Compare::always) {
    return hn::Eq(hn::Zero(hn::DFromV<V>()), hn::Zero(hn::DFromV<V>()));
  } else {
    return hn::Lt(hn::Zero(hn::DFromV<V>()), hn::Zero(hn::DFromV<V>()));
  }
}

/// Calls `call.template operator()<kCompare>()` for the comparison at hand.
template <class Call>
HWY_INLINE void with_compare(Compare function, Call&& call) {
  switch (function) {
    case Compare::never:
      return call.template operator()<Compare::never>();
    case Compare::less:
      return call.template operator()<Compare::less>();
    case Compare::equal:
      return call.template operator()<Compare::equal>();
    case Compare::less_equal:
      return call.template operator()<Compare::less_equal>();
    case Compare::greater:
      return call.template operator()<Compare::greater>();
    case Compare::not_equal:
      return call.template operator()<Compare::not_equal>();
    case Compare::greater_equal:
      return call.template operator()<Compare::greater_equal>();
    case Compare::always:
      return call.template operator()<Compare::always>();
  }
}

/// Where to begin with the vectors of columns [begin, end): aligned, unless one vector that is not will do.
inline int first_vector(int begin, int end, int lanes) {
  return end - begin <= lanes ? begin : begin & ~(lanes - 1);
}

/// A span's depth: value at its anchor column and slope; columns relative to the tile.
struct SpanDepth {
  float row;
  float slope;
  int anchor;
};

/// Columns [begin, end) as a mask of the vector that starts at x.
template <class D>
HWY_INLINE auto columns_mask(D d, int x, int begin, int end) {
  using barrido::HWY_NAMESPACE::lanes_below;
  return hn::AndNot(lanes_below(d, begin - x), lanes_below(d, end - x));
}

/// Whether no depth of columns [begin, end) needs clamping to [0, 1]. In floating point, too, a linear
/// function is monotonic, so the ends decide.
inline bool within_unit(const SpanDepth& depth, int begin, int end) {
  const auto at = [&depth](int x) { return depth.row + depth.slope * static_cast<float>(x - depth.anchor); };
  const float a = at(begin);
  const float b = at(end - 1);
  return a > 0.0f && a < 1.0f && b > 0.0f && b < 1.0f;
}

/// A depth test of any kind: which outcomes of comparing the incoming depth with the stored one pass, as
/// masks.
struct DepthRule {
  using D = hn::ScalableTag<float>;
  hn::Mask<D> less, equal, greater, unordered, write;

  DepthRule(const DepthState& state, bool writes) {
    const hn::RebindToSigned<D> di;
    const auto mask = [&](bool on)
                          HWY_ATTR { return hn::RebindMask(D(), hn::MaskFromVec(hn::Set(di, on ? -1 : 0))); };
    const Compare c = state.test ? state.compare : Compare::always;
    const bool any = c == Compare::always;
    const bool unequal = c == Compare::not_equal;
    less = mask(any || unequal || c == Compare::less || c == Compare::less_equal);
    equal = mask(any || c == Compare::equal || c == Compare::less_equal || c == Compare::greater_equal);
    greater = mask(any || unequal || c == Compare::greater || c == Compare::greater_equal);
    unordered = mask(any || unequal);  // a NaN that the frame was cleared to
    write = mask(writes && state.test);
  }
  template <class V>
  HWY_INLINE hn::Mask<D> operator()(V incoming, V stored) const {
    const auto lt = hn::Lt(incoming, stored);
    const auto eq = hn::Eq(incoming, stored);
    const auto gt = hn::Gt(incoming, stored);
    const auto ordered = hn::Or(hn::Or(lt, eq), gt);
    return hn::Or(hn::Or(hn::And(lt, less), hn::And(eq, equal)),
                  hn::Or(hn::And(gt, greater), hn::AndNot(ordered, unordered)));
  }
};

/// The usual one: `less`, with writing, of depths that need no clamping.
struct UsualDepthRule {};

/// Tests columns [begin, end) of a row and calls passed(x, mask, column) for each vector of pixels, where
/// `column` are the columns as numbers from the anchor on; writes the depth where the test passes.
template <class Rule, class Passed>
HWY_INLINE void test_depth(const Rule& rule, float* depth_row, const SpanDepth& depth, int start, int begin,
                           int end, Passed&& passed) {
  const hn::ScalableTag<float> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto row = hn::Set(d, depth.row);
  const auto slope = hn::Set(d, depth.slope);
  int x = start;
  auto column = barrido::HWY_NAMESPACE::lanes_from(d, static_cast<float>(x - depth.anchor));
  const auto all = barrido::HWY_NAMESPACE::lanes_below(d, lanes);
  for (; x < end; x += lanes) {
    auto mask = x >= begin && x + lanes <= end ? all : columns_mask(d, x, begin, end);
    auto z = hn::Add(row, hn::Mul(slope, column));
    const auto stored = hn::LoadU(d, depth_row + x);
    if constexpr (std::is_same_v<Rule, UsualDepthRule>) {
      mask = hn::And(mask, hn::Lt(z, stored));
      hn::BlendedStore(z, mask, d, depth_row + x);
    } else {
      z = barrido::HWY_NAMESPACE::minimum(barrido::HWY_NAMESPACE::maximum(z, hn::Zero(d)), hn::Set(d, 1.0f));
      mask = hn::And(mask, rule(z, stored));
      hn::BlendedStore(z, hn::And(mask, rule.write), d, depth_row + x);
    }
    passed(x, mask, column);
    column = hn::Add(column, hn::Set(d, static_cast<float>(lanes)));  // small integers: exact
  }
}

/// `start` is the column of the first vector, at most `begin`.
template <class Passed>
HWY_INLINE void test_depth(const DepthState& state, bool write, float* depth_row, const SpanDepth& depth,
                           int start, int begin, int end, Passed&& passed) {
  if (state.test && state.compare == Compare::less && write && within_unit(depth, begin, end)) {
    test_depth(UsualDepthRule(), depth_row, depth, start, begin, end, passed);
  } else {
    test_depth(DepthRule(state, write), depth_row, depth, start, begin, end, passed);
  }
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
