// Two-part mapping on vectors: the same operations in the same order as raster/reference/mapping.cpp, which
// has the formulas' reasons.
#if defined(BARRIDO_MAPPING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_MAPPING_INL_H
#undef BARRIDO_MAPPING_INL_H
#else
#define BARRIDO_MAPPING_INL_H
#endif

#include <hwy/highway.h>

#include "raster/fragments/fragment_batch.h"
#include "raster/kernels/simd_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The intermediate surface of a mapping, for vectors of points.
class IntermediateSurface {
 public:
  using D = hn::ScalableTag<float>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  struct Point {
    V x, y, z;
  };
  /// Which face of a plane or box: that of x, of y, or else of z; and ±1.
  struct Face {
    M is_x, is_y;
    V sign;
  };

  explicit IntermediateSurface(const Mapping& mapping)
      : mapping_(mapping),
        is_flat_(mapping.surface == MappingSurface::planar || mapping.surface == MappingSurface::box) {}

  HWY_INLINE Face face_of(const Point& point, const Point& normal) const {
    const D d;
    const auto none = hn::MaskFromVec(hn::Zero(d));
    Face face{none, hn::Not(none), hn::Zero(d)};
    if (!is_flat_) return face;
    const Ray ray = ray_of(point, normal);
    if (mapping_.surface == MappingSurface::box) {
      const auto x = steps_to_face(ray.from.x, ray.along.x, sign_of(ray.along.x));
      const auto y = steps_to_face(ray.from.y, ray.along.y, sign_of(ray.along.y));
      const auto z = steps_to_face(ray.from.z, ray.along.z, sign_of(ray.along.z));
      face.is_x = hn::And(hn::Le(x, y), hn::Le(x, z));
      face.is_y = hn::AndNot(face.is_x, hn::Le(y, z));
    }
    face.sign = sign_of(of_axis(face, ray.along));
    return face;
  }

  HWY_INLINE Point place(const Point& point, const Point& normal, const Face& face) const {
    const Ray ray = ray_of(point, normal);
    return is_flat_ ? place_on_face(point, ray, face) : place_on_round(ray);
  }

  HWY_INLINE void coordinates(const Point& at, const Face& face, V& s, V& t) const {
    const D d;
    const auto half = hn::Set(d, 0.5f);
    const auto centred = [&](V c) HWY_ATTR { return hn::Add(hn::Mul(c, half), half); };
    V u = centred(at.x), v = hn::Sub(half, hn::Mul(at.z, half));
    switch (mapping_.surface) {
      case MappingSurface::cylinder:
        u = hn::Sub(half, Turn(d, at.x, at.z));
        v = centred(at.y);
        break;
      case MappingSurface::sphere: {
        const auto rho = hn::Sqrt(hn::Add(hn::Mul(at.x, at.x), hn::Mul(at.z, at.z)));
        const auto turn = Turn(d, rho, at.y);
        u = hn::Sub(half, Turn(d, at.x, at.z));
        v = hn::Sub(one(), hn::Add(turn, turn));
        break;
      }
      case MappingSurface::box: {
        const auto mirrored = hn::Neg(hn::Mul(face.sign, at.z));
        u = centred(
            hn::IfThenElse(face.is_x, mirrored, hn::IfThenElse(face.is_y, at.x, hn::Mul(face.sign, at.x))));
        v = centred(hn::IfThenElse(face.is_y, mirrored, at.y));
        break;
      }
      default:
        break;
    }
    s = bounded(hn::Add(hn::Mul(u, hn::Set(d, mapping_.repeats[0])), hn::Set(d, mapping_.offset[0])));
    t = bounded(
        hn::Add(hn::Mul(hn::Sub(one(), v), hn::Set(d, mapping_.repeats[1])), hn::Set(d, mapping_.offset[1])));
  }

 private:
  struct Ray {
    Point from, along;
  };

  static HWY_INLINE V one() { return hn::Set(D(), 1.0f); }
  static HWY_INLINE V dot(const Point& a, const Point& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
  }
  static HWY_INLINE V row_times(const float* row, const Point& v) {
    const D d;
    return dot({hn::Set(d, row[0]), hn::Set(d, row[1]), hn::Set(d, row[2])}, v);
  }
  static HWY_INLINE V bounded(V v) {
    const D d;
    return minimum(maximum(v, hn::Set(d, -kLargestMappedCoordinate)), hn::Set(d, kLargestMappedCoordinate));
  }

  HWY_INLINE Point to_mapping(const Point& v) const {
    const auto& m = mapping_.mapping_from_eye;
    return {row_times(m[0].data(), v), row_times(m[1].data(), v), row_times(m[2].data(), v)};
  }

  HWY_INLINE Point reflected(const Point& point, const Point& n) const {
    const D d;
    const auto eye = [&](std::size_t r) HWY_ATTR {
      const std::array<float, 4>& row = mapping_.eye_from_mapping[r];
      return hn::Add(row_times(row.data(), point), hn::Set(d, row[3]));
    };
    const Point u{eye(0), eye(1), eye(2)};
    const auto square = dot(n, n);
    const auto twice = hn::Add(dot(n, u), dot(n, u));
    const auto mirror = [&](V u_i, V n_i)
                            HWY_ATTR { return hn::Sub(hn::Mul(u_i, square), hn::Mul(n_i, twice)); };
    return {mirror(u.x, n.x), mirror(u.y, n.y), mirror(u.z, n.z)};
  }

  HWY_INLINE Ray ray_of(const Point& point, const Point& normal) const {
    const auto zero = hn::Zero(D());
    if (mapping_.ray == MappingRay::normal) return {point, to_mapping(normal)};
    if (mapping_.ray == MappingRay::reflection) return {point, to_mapping(reflected(point, normal))};
    if (mapping_.ray == MappingRay::surface && mapping_.surface == MappingSurface::cylinder) {
      return {{zero, point.y, zero}, {point.x, zero, point.z}};
    }
    return {{zero, zero, zero}, point};
  }

  static HWY_INLINE V sign_of(V value) {
    return hn::IfThenElse(hn::Lt(value, hn::Zero(D())), hn::Set(D(), -1.0f), one());
  }
  static HWY_INLINE V steps_to_face(V from, V along, V sign) {
    const auto least = hn::Set(D(), 1e-20f);
    const auto divisor = hn::IfThenElse(hn::Lt(hn::Abs(along), least), hn::Mul(sign_of(along), least), along);
    return hn::Div(hn::Sub(sign, from), divisor);
  }
  static HWY_INLINE V of_axis(const Face& face, const Point& v) {
    return hn::IfThenElse(face.is_x, v.x, hn::IfThenElse(face.is_y, v.y, v.z));
  }
  static HWY_INLINE Point on_ray(const Ray& ray, V steps) {
    return {hn::Add(ray.from.x, hn::Mul(steps, ray.along.x)),
            hn::Add(ray.from.y, hn::Mul(steps, ray.along.y)),
            hn::Add(ray.from.z, hn::Mul(steps, ray.along.z))};
  }

  HWY_INLINE Point place_on_face(const Point& point, const Ray& ray, const Face& face) const {
    Point place = point;
    if (mapping_.ray != MappingRay::surface) {
      place = on_ray(ray, steps_to_face(of_axis(face, ray.from), of_axis(face, ray.along), face.sign));
    }
    return {hn::IfThenElse(face.is_x, face.sign, place.x),
            hn::IfThenElse(hn::AndNot(face.is_x, face.is_y), face.sign, place.y),
            hn::IfThenElse(hn::Or(face.is_x, face.is_y), place.z, face.sign)};
  }

  HWY_INLINE Point place_on_round(const Ray& ray) const {
    const D d;
    const bool is_cylinder = mapping_.surface == MappingSurface::cylinder;
    const float radius = is_cylinder ? kMappingCylinder : kMappingSphere;
    Point a = ray.from, along = ray.along;
    if (is_cylinder) a.y = along.y = hn::Zero(d);
    const auto length = hn::Sqrt(maximum(dot(along, along), hn::Set(d, 1e-30f)));
    const auto b = hn::Div(dot(a, along), length);
    const auto c = hn::Sub(dot(a, a), hn::Set(d, radius * radius));
    const auto root = hn::Sqrt(maximum(hn::Sub(hn::Mul(b, b), c), hn::Zero(d)));
    return on_ray(ray, hn::Div(hn::Sub(root, b), length));
  }

  const Mapping& mapping_;
  const bool is_flat_;
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
