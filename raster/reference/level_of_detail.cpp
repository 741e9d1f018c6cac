#include "raster/reference/level_of_detail.h"

#include <cmath>

#include "raster/base/portable_math.h"
#include "raster/reference/arithmetic.h"
#include "raster/reference/cube_face.h"
#include "raster/reference/mapping.h"

namespace barrido::raster::reference {
namespace {

/// A quantity at one place, with its slopes per pixel.
struct Sloped {
  float value;
  float dx;
  float dy;
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

CoordinateSlopes slopes_at(const FragmentState& state, int unit, const SpanQuantities& along,
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

/// Where a group of four pixels is evaluated, from the span's anchor.
float group_distance(const SpanQuantities& along, int x) {
  const auto anchor = static_cast<float>(along.anchor);
  const auto last = static_cast<float>(along.last);
  const float group_center = static_cast<float>(x & ~3) + 1.5f;
  return minimum(maximum(group_center, anchor), last) - anchor;
}

/// ½ log2 of the larger of two squares.
float half_log2_of_larger(float a, float b) { return 0.5f * portable_log2(minimum(maximum(a, b), 1e30f)); }

/// One coordinate of the unit's point, and how it changes from pixel to pixel.
Sloped point_coordinate(const FragmentState& state, int unit, const SpanQuantities& along, float distance,
                        std::size_t i) {
  const int texcoord = state.varyings.at(Meaning::texcoord, unit);
  const Sloped c =
      sloped_at(along.quantities[static_cast<std::size_t>(kRecordVaryings + texcoord) + i], distance);
  if (texcoord < state.varyings.affine_count) return c;
  const Sloped q = sloped_at(along.quantities[kRecordQ], distance);
  const float w = 1.0f / maximum(q.value, 1e-30f);
  const float value = c.value * w;
  return {value, (c.dx - value * q.dx) * w, (c.dy - value * q.dy) * w};
}

/// Squares of the steps that a pixel to the right and a pixel up make on the intermediate surface.
std::array<float, 2> steps_on_surface(const FragmentState& state, int unit, const SpanQuantities& along,
                                      float distance) {
  const Mapping& mapping = state.texture_units[static_cast<std::size_t>(unit)].mapping;
  Sloped p[3], n[3];
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = n[i] = point_coordinate(state, unit, along, distance, i);
    if (!needs_normal(mapping)) continue;
    const auto normal = static_cast<std::size_t>(kRecordVaryings + state.varyings.at(Meaning::normal));
    n[i] = sloped_at(along.quantities[normal + i], distance);
  }
  const MappedPlace here =
      reach_surface(mapping, {p[0].value, p[1].value, p[2].value}, {n[0].value, n[1].value, n[2].value});
  const auto square_to = [&](float Sloped::*step) {
    const auto moved = [&](const Sloped& c) { return c.value + c.*step; };
    const Point there = place_like(mapping, here, {moved(p[0]), moved(p[1]), moved(p[2])},
                                   {moved(n[0]), moved(n[1]), moved(n[2])});
    const float x = there[0] - here.place[0], y = there[1] - here.place[1], z = there[2] - here.place[2];
    return (x * x + y * y) + z * z;
  };
  return {square_to(&Sloped::dx), square_to(&Sloped::dy)};
}

/// λ of coordinates that a mapping makes: the step on the intermediate surface, in texels.
float mapped_level_of_detail(const FragmentState& state, int unit, const SpanQuantities& along,
                             float distance) {
  const TextureUnit& texture = state.texture_units[static_cast<std::size_t>(unit)];
  const std::array<float, 2> density = mapping_density(texture.mapping);
  const float texels = maximum(density[0] * static_cast<float>(texture.texture->width()),
                               density[1] * static_cast<float>(texture.texture->height()));
  const auto [square_x, square_y] = steps_on_surface(state, unit, along, distance);
  const float scale = texels * texels;
  return half_log2_of_larger(square_x * scale, square_y * scale);
}

}  // namespace

void pixel_extent(const FragmentState& state, int unit, const SpanQuantities& along, int x,
                  float (&extent)[3]) {
  const float distance = group_distance(along, x);
  const Mapping& mapping = state.texture_units[static_cast<std::size_t>(unit)].mapping;
  const std::size_t coordinates = texcoord_kind(state, unit) == TexcoordKind::plain ? 2 : 3;
  for (std::size_t i = 0; i < 3; ++i) extent[i] = 0.0f;
  if (mapping.surface != MappingSurface::none) {
    const auto [square_x, square_y] = steps_on_surface(state, unit, along, distance);
    for (std::size_t i = 0; i < 2; ++i) {
      extent[i] = std::sqrt(maximum(square_x, square_y)) * mapping_density(mapping)[i];
    }
    return;
  }
  for (std::size_t i = 0; i < coordinates; ++i) {
    const Sloped c = point_coordinate(state, unit, along, distance, i);
    extent[i] = maximum(std::fabs(c.dx), std::fabs(c.dy));
  }
}

CoordinateSlopes coordinate_slopes(const FragmentState& state, int unit, const SpanQuantities& along, int x) {
  if (state.texture_units[static_cast<std::size_t>(unit)].mapping.surface == MappingSurface::none) {
    return slopes_at(state, unit, along, group_distance(along, x));
  }
  float extent[3];
  pixel_extent(state, unit, along, x, extent);
  return {extent[0], 0.0f, 0.0f, extent[1]};
}

float level_of_detail(const FragmentState& state, int unit, const SpanQuantities& along, int x) {
  const TextureUnit& texture = state.texture_units[static_cast<std::size_t>(unit)];
  if (texture.mapping.surface != MappingSurface::none) {
    return mapped_level_of_detail(state, unit, along, group_distance(along, x));
  }
  return level_of_detail(coordinate_slopes(state, unit, along, x), *texture.texture);
}

float level_of_detail(const CoordinateSlopes& slopes, const Texture& texture) {
  const auto width = static_cast<float>(texture.width());
  const auto height = static_cast<float>(texture.height());
  const float ux = slopes.ux * width;
  const float uy = slopes.uy * width;
  const float vx = slopes.vx * height;
  const float vy = slopes.vy * height;
  const float a = ux * ux + vx * vx;
  const float b = uy * uy + vy * vy;
  return half_log2_of_larger(a, b);
}

}  // namespace barrido::raster::reference
