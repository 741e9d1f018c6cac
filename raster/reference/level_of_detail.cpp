#include "raster/reference/level_of_detail.h"

#include "raster/base/portable_math.h"
#include "raster/reference/arithmetic.h"
#include "raster/reference/cube_face.h"

namespace barrido::raster::reference {
namespace {

/// A quantity at one place, with its slopes per pixel.
struct Sloped {
  float value;
  float dx;
  float dy;
};

/// Slopes of the texture coordinates (u, v), per pixel.
struct CoordinateSlopes {
  float ux, uy, vx, vy;
};

Sloped sloped_at(const SpanQuantity& quantity, float distance) {
  return {quantity.at(distance), quantity.ddx, quantity.ddy};
}

/// Slopes of s/d and t/d, `w` being 1/d: the quotient rule.
CoordinateSlopes quotient_slopes(const Sloped& s, const Sloped& t, const Sloped& d, float w) {
  const float u = s.value * w;
  const float v = t.value * w;
  return {(s.dx - u * d.dx) * w, (s.dy - u * d.dy) * w, (t.dx - v * d.dx) * w, (t.dy - v * d.dy) * w};
}

Sloped signed_component(SignedAxis component, const Sloped (&direction)[3]) {
  const Sloped& part = direction[component.axis];
  return {component.sign * part.value, component.sign * part.dx, component.sign * part.dy};
}

CoordinateSlopes cube_slopes(const Sloped (&direction)[3]) {
  const float values[3] = {direction[0].value, direction[1].value, direction[2].value};
  const CubeFace face = select_cube_face(values);
  const Sloped sc = signed_component(face.sc, direction);
  const Sloped tc = signed_component(face.tc, direction);
  const Sloped major = signed_component(face.major, direction);
  const CoordinateSlopes slopes = quotient_slopes(sc, tc, major, 1.0f / major.value);
  // A face spans 2 in sc/|ma| and 1 in u.
  return {slopes.ux * 0.5f, slopes.uy * 0.5f, slopes.vx * 0.5f, slopes.vy * 0.5f};
}

CoordinateSlopes coordinate_slopes(const FragmentState& state, int unit, const SpanQuantities& along,
                                   float distance) {
  const int texcoord = state.varyings.at(Meaning::texcoord, unit);
  const SpanQuantity* first = &along.quantities[static_cast<std::size_t>(kRecordVaryings + texcoord)];
  const Sloped s = sloped_at(first[0], distance);
  const Sloped t = sloped_at(first[1], distance);
  switch (texcoord_kind(state, unit)) {
    case TexcoordKind::direct: {
      const Sloped direction[3] = {s, t, sloped_at(first[2], distance)};
      return cube_slopes(direction);
    }
    case TexcoordKind::projective: {
      const Sloped q = sloped_at(first[2], distance);
      return quotient_slopes(s, t, q, 1.0f / q.value);
    }
    case TexcoordKind::plain:
      break;
  }
  if (texcoord < state.varyings.affine_count) return {s.dx, s.dy, t.dx, t.dy};
  const Sloped q = sloped_at(along.quantities[kRecordQ], distance);
  return quotient_slopes(s, t, q, 1.0f / maximum(q.value, 1e-30f));
}

}  // namespace

float level_of_detail(const FragmentState& state, int unit, const SpanQuantities& along, int x) {
  const auto anchor = static_cast<float>(along.anchor);
  const auto last = static_cast<float>(along.last);
  const float group_center = static_cast<float>(x & ~3) + 1.5f;
  const float distance = minimum(maximum(group_center, anchor), last) - anchor;

  const CoordinateSlopes slopes = coordinate_slopes(state, unit, along, distance);
  const Texture& texture = *state.texture_units[static_cast<std::size_t>(unit)].texture;
  const auto width = static_cast<float>(texture.width());
  const auto height = static_cast<float>(texture.height());
  const float ux = slopes.ux * width;
  const float uy = slopes.uy * width;
  const float vx = slopes.vx * height;
  const float vy = slopes.vy * height;
  const float a = ux * ux + vx * vx;
  const float b = uy * uy + vy * vy;
  return 0.5f * portable_log2(minimum(maximum(a, b), 1e30f));
}

}  // namespace barrido::raster::reference
