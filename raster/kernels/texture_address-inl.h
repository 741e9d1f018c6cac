// Which texels: from coordinates and levels to texel addresses and 8-bit weights, a vector of fragments at a
// time (docs/arithmetic.md, "Texels").
#if defined(BARRIDO_TEXTURE_ADDRESS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_TEXTURE_ADDRESS_INL_H
#undef BARRIDO_TEXTURE_ADDRESS_INL_H
#else
#define BARRIDO_TEXTURE_ADDRESS_INL_H
#endif

#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/levels-inl.h"
#include "raster/kernels/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The tables of one level for a vector of fragments: what its addresses depend on.
struct LevelShape {
  VF scale_x, scale_y;  ///< Width and height × 256: texels in 24.8 fixed point.
  VI pitch;             ///< To the texel above.
  VI origin;            ///< Of face 0.
  VI face_stride;
};

/// Shape of each fragment's `level`; when `uniform`, of the first fragment's.
HWY_INLINE LevelShape level_shape(VI level, bool uniform, const TexelLevels& tables) {
  const F d;
  const I di;
  const std::int32_t first = hn::GetLane(level);
  const auto look_up = [&](const std::int32_t* table) HWY_ATTR {
    return uniform ? hn::Set(di, table[first]) : hn::GatherIndex(di, table, level);
  };
  const auto scale = hn::Set(d, 256.0f);
  return {hn::Mul(hn::ConvertTo(d, look_up(tables.width)), scale),
          hn::Mul(hn::ConvertTo(d, look_up(tables.height)), scale), look_up(tables.pitch),
          look_up(tables.origin), look_up(tables.face_stride)};
}

/// The shapes of the two levels that a vector of fragments is sampled from. Neighbours mostly share their
/// levels, so the shapes are looked up when they change.
class LevelShapes {
 public:
  explicit LevelShapes(const TexelLevels& tables) : tables_(tables) {}

  /// Of fragments whose packed levels are these.
  HWY_INLINE void look_up(VI packed) {
    const I di;
    const auto levels = hn::And(packed, hn::Set(di, kLevelsMask));
    if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(levels, hn::Set(di, current_))))) return;
    const std::int32_t first = hn::GetLane(levels);
    uniform = hn::AllTrue(di, hn::Eq(levels, hn::Set(di, first)));
    current_ = uniform ? first : kNone;
    const auto low_bits = hn::Set(di, 0x7f);
    lower = level_shape(hn::And(hn::ShiftRight<kLowerLevelShift>(levels), low_bits), uniform, tables_);
    upper = level_shape(hn::And(hn::ShiftRight<kUpperLevelShift>(levels), low_bits), uniform, tables_);
    linear = hn::TestBit(levels, hn::Set(di, kFourTexels));
    any_linear = !hn::AllFalse(di, linear);
    any_nearest = !hn::AllTrue(di, linear);
  }

  LevelShape lower, upper;
  hn::Mask<I> linear;  ///< Four texels a level.
  bool any_linear = false, any_nearest = false;
  bool uniform = false;

 private:
  static constexpr std::int32_t kNone = -1;
  const TexelLevels& tables_;
  std::int32_t current_ = kNone;
};

/// Coordinates of a vector of fragments: on a face of a cube map or on the one image.
struct Coordinates {
  VF u, v;
  VI face;
};

/// Coordinates not below 2^22 in magnitude, and NaN, count as 0.
HWY_INLINE hn::Mask<F> usable(VF c) {
  const F d;
  return hn::Lt(hn::Abs(c), hn::Set(d, 4194304.0f));
}

HWY_INLINE VF wrap(VF u, Wrap mode) {
  const F d;
  switch (mode) {
    case Wrap::repeat:
      return hn::Sub(u, hn::Floor(u));
    case Wrap::mirrored_repeat: {
      const auto two = hn::Set(d, 2.0f);
      const auto m = hn::Sub(u, hn::Mul(two, hn::Floor(hn::Mul(u, hn::Set(d, 0.5f)))));
      return hn::IfThenElse(hn::Gt(m, hn::Set(d, 1.0f)), hn::Sub(two, m), m);
    }
    case Wrap::clamp_to_border:
      return u;
    case Wrap::clamp_to_edge:
    case Wrap::clamp:
      break;
  }
  return clamp01(u);
}

HWY_INLINE Coordinates coordinates_2d(VF s, VF t, const TextureOptions& options) {
  // 0 wraps to 0.
  return {hn::IfThenElseZero(usable(s), wrap(s, options.wrap_s)),
          hn::IfThenElseZero(usable(t), wrap(t, options.wrap_t)), hn::Zero(I())};
}

/// Face and (u, v) in [0, 1] by the major axis (OpenGL 1.3, table 3.19).
HWY_INLINE Coordinates coordinates_cube(VF x, VF y, VF z) {
  const F d;
  const I di;
  const auto ax = hn::Abs(x);
  const auto ay = hn::Abs(y);
  const auto az = hn::Abs(z);
  const auto is_x = hn::And(hn::Ge(ax, ay), hn::Ge(ax, az));
  const auto is_y = hn::And(hn::Not(is_x), hn::Ge(ay, az));
  const auto ma = hn::IfThenElse(is_x, x, hn::IfThenElse(is_y, y, z));
  const auto negative = hn::Lt(ma, hn::Zero(d));
  const auto negated = [&](VF v) HWY_ATTR { return hn::IfThenElse(negative, hn::Neg(v), v); };
  // +X (−z, −y), −X (z, −y), +Y (x, z), −Y (x, −z), +Z (x, −y), −Z (−x, −y)
  const auto sc = hn::IfThenElse(is_x, hn::Neg(negated(z)), hn::IfThenElse(is_y, x, negated(x)));
  const auto tc = hn::IfThenElse(is_y, negated(z), hn::Neg(y));
  const auto w = hn::Div(hn::Set(d, 1.0f), hn::Abs(ma));
  const auto one = hn::Set(d, 1.0f);
  const auto half = hn::Set(d, 0.5f);
  const auto valid = hn::Gt(hn::Abs(ma), hn::Zero(d));
  const auto to_unit = [&](VF c) HWY_ATTR {
    const auto u = hn::Mul(hn::Add(hn::Mul(c, w), one), half);
    return clamp01(hn::IfThenElse(valid, u, half));
  };
  const auto axis = hn::IfThenElse(hn::RebindMask(di, is_x), hn::Zero(di),
                                   hn::IfThenElse(hn::RebindMask(di, is_y), hn::Set(di, 2), hn::Set(di, 4)));
  const auto side = hn::IfThenElseZero(hn::RebindMask(di, negative), hn::Set(di, 1));
  return {to_unit(sc), to_unit(tc), hn::Add(axis, side)};
}

/// Texel addresses and 8-bit weights of a batch, for one level of each fragment.
struct Footprint {
  alignas(64) std::int32_t address[kBatchStride];  ///< Of the (nearest or lower left) texel, in texels.
  alignas(64) std::int32_t pitch[kBatchStride];    ///< To the texel above.
  alignas(64) std::int32_t weights[kBatchStride];  ///< Along x in bits 0–7, along y in bits 24–31.
  bool has_one_pitch = true;                       ///< The same for all, the usual case.
};

/// Nearest texel along one axis, in 24.8 fixed point. Only coordinates with a border leave [0, 1].
HWY_INLINE VI nearest_texel(VF u, VF scale, bool border) {
  const F d;
  const I di;
  const auto size = hn::Mul(scale, hn::Set(d, 1.0f / 256.0f));
  const auto last = hn::Sub(whole_to_integer(d, size), hn::Set(di, border ? 0 : 1));
  auto scaled = hn::Mul(u, size);
  if (border) scaled = minimum(maximum(scaled, hn::Set(d, -1.0f)), size);
  return hn::ShiftLeft<8>(hn::Min(floor_to_integer(scaled), last));
}

/// Lower texel along one axis, in 24.8 fixed point.
HWY_INLINE VI linear_texel(VF u, VF scale, bool border) {
  const F d;
  // Half a texel, less half a step of 1/256: the floor below rounds to the nearest step.
  auto fixed = hn::Sub(hn::Mul(u, scale), hn::Set(d, 127.5f));
  if (border) fixed = minimum(maximum(fixed, hn::Set(d, -256.0f)), scale);
  return floor_to_integer(fixed);
}

/// Which of the two axes have coordinates outside [0, 1].
struct Borders {
  bool s, t;
};

/// Addresses and weights of a vector of fragments in one level. Where `linear` is false the weights are 0, so
/// that the four-texel filter gives exactly the nearest texel.
HWY_INLINE void address(const Coordinates& c, const LevelShape& level, const LevelShapes& shapes,
                        const Borders& borders, bool cube, Footprint& out, int i) {
  const I di;
  auto x = hn::Zero(di);
  auto y = hn::Zero(di);
  if (shapes.any_linear) {
    x = linear_texel(c.u, level.scale_x, borders.s);
    y = linear_texel(c.v, level.scale_y, borders.t);
  }
  if (shapes.any_nearest) {
    x = hn::IfThenElse(shapes.linear, x, nearest_texel(c.u, level.scale_x, borders.s));
    y = hn::IfThenElse(shapes.linear, y, nearest_texel(c.v, level.scale_y, borders.t));
  }
  const auto origin = cube ? hn::Add(level.origin, hn::Mul(c.face, level.face_stride)) : level.origin;
  const auto column = hn::ShiftRight<8>(x);
  const auto row = hn::ShiftRight<8>(y);
  hn::Store(hn::Add(origin, hn::Add(column, hn::Mul(row, level.pitch))), di, out.address + i);
  hn::Store(level.pitch, di, out.pitch + i);
  out.has_one_pitch = out.has_one_pitch && shapes.uniform && hn::GetLane(level.pitch) == out.pitch[0];
  hn::Store(hn::Or(hn::And(x, hn::Set(di, 255)), hn::ShiftLeft<24>(y)), di, out.weights + i);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
