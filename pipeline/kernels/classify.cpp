// Culling on vectors of triangles.
#include "pipeline/triangle_block.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/kernels/classify.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Areas need 51 bits, so triangles are handled as many at a time as there are doubles in a vector.
using Doubles = hn::ScalableTag<double>;
using Ints = hn::Rebind<std::int32_t, Doubles>;
using Words = hn::Rebind<std::uint32_t, Doubles>;
using IntV = hn::Vec<Ints>;
using WordV = hn::Vec<Words>;

struct Corner {
  WordV x_code, y_code;
  IntV x, y;
};

HWY_INLINE Corner load_corner(const PackedPosition* positions) {
  Corner c;
  hn::LoadInterleaved2(Words(), &positions->x, c.x_code, c.y_code);
  c.x = hn::ShiftRight<kOutcodeBits>(hn::BitCast(Ints(), c.x_code));
  c.y = hn::ShiftRight<kOutcodeBits>(hn::BitCast(Ints(), c.y_code));
  return c;
}

/// −1, 0 or 1: the sign of (x1−x0)(y2−y0) − (x2−x0)(y1−y0), exact: differences have 25 bits.
HWY_INLINE IntV area_sign(const Corner& a, const Corner& b, const Corner& c) {
  const Doubles d;
  const auto dx1 = hn::PromoteTo(d, hn::Sub(b.x, a.x));
  const auto dy1 = hn::PromoteTo(d, hn::Sub(b.y, a.y));
  const auto dx2 = hn::PromoteTo(d, hn::Sub(c.x, a.x));
  const auto dy2 = hn::PromoteTo(d, hn::Sub(c.y, a.y));
  const auto area = hn::Sub(hn::Mul(dx1, dy2), hn::Mul(dx2, dy1));
  return hn::DemoteTo(Ints(), hn::Min(hn::Max(area, hn::Set(d, -1.0)), hn::Set(d, 1.0)));
}

/// The pixels whose centres lie between the smallest and the largest of three coordinates.
struct Centres {
  IntV first, count;  ///< None when count is not positive.
};
HWY_INLINE Centres centres_between(IntV a, IntV b, IntV c) {
  const IntV first = barrido::HWY_NAMESPACE::first_centres_at(hn::Min(hn::Min(a, b), c));
  const IntV end = barrido::HWY_NAMESPACE::first_centres_at(hn::Max(hn::Max(a, b), c));
  return {first, hn::Sub(end, first)};
}

/// The edge function from one corner to the next, negative outside: at a pixel's centre, and what the next
/// pixel adds to it. As raster/kernels/tiny_coverage-inl.h has it; only for triangles of some pixels.
struct Edge {
  IntV value, step_x, step_y;
};
HWY_INLINE Edge edge(IntV ax, IntV ay, IntV bx, IntV by, IntV centre_x, IntV centre_y) {
  const IntV dx = hn::Sub(bx, ax);
  const IntV dy = hn::Sub(by, ay);
  const IntV value = hn::Sub(hn::Mul(dx, hn::Sub(centre_y, ay)), hn::Mul(dy, hn::Sub(centre_x, ax)));
  // Negative when dy is, or when dy is 0 and dx positive: then centres on the edge belong to the triangle.
  const IntV owner = hn::Sub(hn::ShiftLeft<12>(dy), dx);
  const IntV limit = hn::Add(hn::Set(Ints(), 1), hn::ShiftRight<31>(owner));
  return {hn::Sub(value, limit), hn::ShiftLeft<raster::kSubpixelBits>(hn::Neg(dy)),
          hn::ShiftLeft<raster::kSubpixelBits>(dx)};
}

/// Whether triangles whose bounding boxes hold at most two by two centres cover none of them.
HWY_INLINE hn::Mask<Ints> miss_all_centres(const Corner& a, const Corner& b, const Corner& c, IntV sign,
                                           const Centres& columns, const Centres& rows) {
  const auto centre_of = [](IntV pixel) HWY_ATTR {
    return hn::Add(hn::ShiftLeft<raster::kSubpixelBits>(pixel), hn::Set(Ints(), raster::kSubpixelUnits / 2));
  };
  const IntV x = centre_of(columns.first);
  const IntV y = centre_of(rows.first);
  const auto clockwise = hn::Lt(sign, hn::Zero(Ints()));
  const IntV second_x = hn::IfThenElse(clockwise, c.x, b.x);
  const IntV second_y = hn::IfThenElse(clockwise, c.y, b.y);
  const IntV third_x = hn::IfThenElse(clockwise, b.x, c.x);
  const IntV third_y = hn::IfThenElse(clockwise, b.y, c.y);
  const Edge e0 = edge(a.x, a.y, second_x, second_y, x, y);
  const Edge e1 = edge(second_x, second_y, third_x, third_y, x, y);
  const Edge e2 = edge(third_x, third_y, a.x, a.y, x, y);
  // Negative where the centre that is so many columns and rows on is outside.
  const auto outside = [&](auto at) HWY_ATTR { return hn::Or(hn::Or(at(e0), at(e1)), at(e2)); };
  const IntV here = outside([](const Edge& e) HWY_ATTR { return e.value; });
  const IntV right = outside([](const Edge& e) HWY_ATTR { return hn::Add(e.value, e.step_x); });
  const IntV above = outside([](const Edge& e) HWY_ATTR { return hn::Add(e.value, e.step_y); });
  const IntV across =
      outside([](const Edge& e) HWY_ATTR { return hn::Add(e.value, hn::Add(e.step_x, e.step_y)); });
  return hn::Lt(hn::And(hn::And(here, right), hn::And(above, across)), hn::Zero(Ints()));
}

HWY_INLINE WordV any(const WordV& a, const WordV& b, const WordV& c) { return hn::Or(hn::Or(a, b), c); }
HWY_INLINE WordV all(const WordV& a, const WordV& b, const WordV& c) { return hn::And(hn::And(a, b), c); }
HWY_INLINE WordV bits(std::uint32_t value) { return hn::Set(Words(), value); }
HWY_INLINE hn::Mask<Words> is_zero(WordV v) { return hn::Eq(v, hn::Zero(Words())); }

HWY_INLINE std::uint64_t mask_bits(hn::Mask<Words> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Words(), mask, bytes);
  return bytes[0];
}

TriangleClasses ClassifyTriangles(const TriangleBlock& block, const CullRule& rule) {
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(Doubles()));
  static_assert(kLanes <= 8 && kTriangleBlock % kLanes == 0);
  const bool keep_positive = rule.front_is_counter_clockwise ? rule.keep_front : rule.keep_back;
  const bool keep_negative = rule.front_is_counter_clockwise ? rule.keep_back : rule.keep_front;
  const IntV below = hn::Set(Ints(), keep_negative ? -2 : 0);
  const IntV above = hn::Set(Ints(), keep_positive ? 2 : 0);
  TriangleClasses classes;
  std::uint64_t negative = 0;
  for (int i = 0; i < block.count; i += kLanes) {
    const Corner a = load_corner(block.position[0] + i);
    const Corner b = load_corner(block.position[1] + i);
    const Corner c = load_corner(block.position[2] + i);
    const WordV any_x = any(a.x_code, b.x_code, c.x_code);
    const WordV any_y = any(a.y_code, b.y_code, c.y_code);
    const WordV outside = hn::And(all(a.x_code, b.x_code, c.x_code), bits(kOutsideVolume));
    const WordV behind_plane = hn::And(all(a.y_code, b.y_code, c.y_code), bits(kOutcodeMask));
    const WordV broken = hn::And(any_x, bits(kNotANumber));
    const WordV crossing = hn::Or(hn::And(any_x, bits(kNeedsClipping)), hn::And(any_y, bits(kOutcodeMask)));
    const auto possible = is_zero(any(outside, behind_plane, broken));
    const auto whole = is_zero(crossing);

    const IntV sign = area_sign(a, b, c);
    const auto kept =
        hn::And(hn::Ne(sign, hn::Zero(Ints())), hn::And(hn::Gt(sign, below), hn::Lt(sign, above)));
    const Centres columns = centres_between(a.x, b.x, c.x);
    const Centres rows = centres_between(a.y, b.y, c.y);
    const auto most = hn::Max(columns.count, rows.count);
    auto covers = hn::And(kept, hn::Gt(hn::Min(columns.count, rows.count), hn::Zero(Ints())));
    const auto has_few = hn::And(covers, hn::Lt(most, hn::Set(Ints(), 3)));
    if (rule.keep_between_centers) {
      covers = kept;
    } else if (!hn::AllFalse(Ints(), has_few)) {
      covers = hn::AndNot(hn::And(has_few, miss_all_centres(a, b, c, sign, columns, rows)), covers);
    }
    const auto seen = hn::RebindMask(Words(), covers);
    classes.visible |= mask_bits(hn::And(hn::And(possible, whole), seen)) << i;
    classes.clipped |= mask_bits(hn::AndNot(whole, possible)) << i;
    negative |= mask_bits(hn::RebindMask(Words(), hn::Lt(sign, hn::Zero(Ints())))) << i;
  }
  const std::uint64_t in_block = ~std::uint64_t{0} >> (kTriangleBlock - block.count);
  classes.visible &= in_block;
  classes.clipped &= in_block;
  classes.back = classes.visible & (rule.front_is_counter_clockwise ? negative : ~negative);
  return classes;
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::pipeline {

HWY_EXPORT(ClassifyTriangles);

TriangleClasses classify_triangles(const TriangleBlock& block, const CullRule& rule) {
  if (block.count == 0) return {};
  return HWY_DYNAMIC_DISPATCH(ClassifyTriangles)(block, rule);
}

}  // namespace barrido::pipeline
#endif
