// Elementary functions on vectors of floats: the same operations in the same order as
// raster/base/portable_math.h, so the same bits. Included once per target by Highway's foreach_target
// mechanism.
#if defined(BARRIDO_SIMD_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_SIMD_MATH_INL_H
#undef BARRIDO_SIMD_MATH_INL_H
#else
#define BARRIDO_SIMD_MATH_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace barrido::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// a < b ? a : b and a > b ? a : b, also for NaN and for zeros of either sign: what x86's instructions do,
/// and what Highway's Min and Max leave open elsewhere.
template <class V>
HWY_INLINE V minimum(V a, V b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128
  return hn::Min(a, b);
#else
  return hn::IfThenElse(hn::Lt(a, b), a, b);
#endif
}
template <class V>
HWY_INLINE V maximum(V a, V b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128
  return hn::Max(a, b);
#else
  return hn::IfThenElse(hn::Gt(a, b), a, b);
#endif
}

/// A NaN gives 0.
template <class V>
HWY_INLINE V clamp01(V v) {
  const hn::DFromV<V> d;
  return minimum(maximum(v, hn::Zero(d)), hn::Set(d, 1.0f));
}

/// See portable_log2.
template <class D, class V>
HWY_INLINE V Log2(D d, V x) {
  const hn::RebindToSigned<D> di;
  x = maximum(x, hn::Set(d, 1.17549435e-38f));
  const auto bits = hn::BitCast(di, x);
  const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3f3504f3)));
  const auto m = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
  const auto one = hn::Set(d, 1.0f);
  const auto s = hn::Div(hn::Sub(m, one), hn::Add(m, one));
  const auto s2 = hn::Mul(s, s);
  auto p = hn::Set(d, 0.32059889f);
  p = hn::Add(hn::Mul(p, s2), hn::Set(d, 0.41219858f));
  p = hn::Add(hn::Mul(p, s2), hn::Set(d, 0.57707802f));
  p = hn::Add(hn::Mul(p, s2), hn::Set(d, 0.96179669f));
  p = hn::Add(hn::Mul(p, s2), hn::Set(d, 2.88539008f));
  return hn::Add(hn::Mul(p, s), hn::ConvertTo(d, exponent));
}

/// See portable_exp2.
template <class D, class V>
HWY_INLINE V Exp2(D d, V x) {
  const hn::RebindToSigned<D> di;
  const auto low = hn::Set(d, -126.0f);
  const auto clamped = minimum(maximum(x, low), hn::Set(d, 127.49f));
  const auto n = hn::Floor(hn::Add(clamped, hn::Set(d, 0.5f)));
  const auto f = hn::Sub(clamped, n);
  auto p = hn::Set(d, 1.52527338e-5f);
  p = hn::Add(hn::Mul(p, f), hn::Set(d, 1.54035304e-4f));
  p = hn::Add(hn::Mul(p, f), hn::Set(d, 1.33335581e-3f));
  p = hn::Add(hn::Mul(p, f), hn::Set(d, 9.61812911e-3f));
  p = hn::Add(hn::Mul(p, f), hn::Set(d, 5.55041087e-2f));
  p = hn::Add(hn::Mul(p, f), hn::Set(d, 2.40226507e-1f));
  p = hn::Add(hn::Mul(p, f), hn::Set(d, 6.93147181e-1f));
  p = hn::Add(hn::Mul(p, f), hn::Set(d, 1.0f));
  const auto scale = hn::BitCast(d, hn::ShiftLeft<23>(hn::Add(hn::ConvertTo(di, n), hn::Set(di, 127))));
  return hn::IfThenZeroElse(hn::Lt(x, low), hn::Mul(p, scale));
}

/// See portable_turn.
template <class D, class V>
HWY_INLINE V Turn(D d, V y, V x) {
  const auto ax = hn::Abs(x);
  const auto ay = hn::Abs(y);
  const auto is_steep = hn::Gt(ay, ax);
  const auto larger = hn::IfThenElse(is_steep, ay, ax);
  const auto r = hn::Div(hn::IfThenElse(is_steep, ax, ay), maximum(larger, hn::Set(d, 1e-30f)));
  const auto r2 = hn::Mul(r, r);
  auto p = hn::Set(d, -0.000270749611f);
  p = hn::Add(hn::Mul(p, r2), hn::Set(d, 0.00166916116f));
  p = hn::Sub(hn::Mul(p, r2), hn::Set(d, 0.0048306492f));
  p = hn::Add(hn::Mul(p, r2), hn::Set(d, 0.00908608492f));
  p = hn::Sub(hn::Mul(p, r2), hn::Set(d, 0.013289f));
  p = hn::Add(hn::Mul(p, r2), hn::Set(d, 0.0173993619f));
  p = hn::Sub(hn::Mul(p, r2), hn::Set(d, 0.0226955205f));
  p = hn::Add(hn::Mul(p, r2), hn::Set(d, 0.0318279253f));
  p = hn::Sub(hn::Mul(p, r2), hn::Set(d, 0.0530515569f));
  p = hn::Add(hn::Mul(p, r2), hn::Set(d, 0.159154943f));
  const auto octant = hn::Mul(p, r);
  const auto quarter = hn::IfThenElse(is_steep, hn::Sub(hn::Set(d, 0.25f), octant), octant);
  const auto half = hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, 0.5f), quarter), quarter);
  return hn::IfThenElse(hn::Lt(y, hn::Zero(d)), hn::Neg(half), half);
}

/// See portable_pow; the exponent is one number for all lanes.
template <class D, class V>
HWY_INLINE V Pow(D d, V x, float n) {
  if (n == 0.0f) return hn::Set(d, 1.0f);
  return hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), Exp2(d, hn::Mul(hn::Set(d, n), Log2(d, x))));
}

}  // namespace barrido::HWY_NAMESPACE

namespace barrido::raster::HWY_NAMESPACE {
using namespace barrido::HWY_NAMESPACE;
}
HWY_AFTER_NAMESPACE();

#endif
