#include "raster/reference/mapping.h"

#include <cmath>

#include "raster/base/portable_math.h"
#include "raster/reference/arithmetic.h"

namespace barrido::raster::reference {
namespace {

struct Ray {
  Point from{}, along{};
};

float dot(const Point& a, const Point& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

Point to_mapping(const Mapping& mapping, const Point& direction) {
  const auto& m = mapping.mapping_from_eye;
  return {dot(m[0], direction), dot(m[1], direction), dot(m[2], direction)};
}

/// The eye's ray to the point, mirrored: u (n·n) − 2 n (n·u), whose length does not matter.
Point reflected(const Mapping& mapping, const Point& point, const Point& n) {
  Point u{};
  for (std::size_t r = 0; r < 3; ++r) {
    const std::array<float, 4>& row = mapping.eye_from_mapping[r];
    u[r] = ((row[0] * point[0] + row[1] * point[1]) + row[2] * point[2]) + row[3];
  }
  const float square = dot(n, n);
  const float twice = dot(n, u) + dot(n, u);
  return {u[0] * square - n[0] * twice, u[1] * square - n[1] * twice, u[2] * square - n[2] * twice};
}

bool is_flat(const Mapping& mapping) {
  return mapping.surface == MappingSurface::planar || mapping.surface == MappingSurface::box;
}

Ray ray_of(const Mapping& mapping, const Point& point, const Point& normal) {
  switch (mapping.ray) {
    case MappingRay::normal:
      return {point, to_mapping(mapping, normal)};
    case MappingRay::reflection:
      return {point, to_mapping(mapping, reflected(mapping, point, normal))};
    case MappingRay::surface:
      if (mapping.surface == MappingSurface::cylinder) return {{0, point[1], 0}, {point[0], 0, point[2]}};
      [[fallthrough]];
    case MappingRay::centre:
      break;
  }
  return {{0, 0, 0}, point};
}

/// −1 or 1; of zeros and of what is no number 1.
float sign_of(float value) { return value < 0.0f ? -1.0f : 1.0f; }

/// Steps along the ray to the face at `sign` on the axis.
float steps_to_face(const Ray& ray, std::size_t axis, float sign) {
  const float along = ray.along[axis];
  const float divisor = std::fabs(along) < 1e-20f ? sign_of(along) * 1e-20f : along;
  return (sign - ray.from[axis]) / divisor;
}

MappedPlace face_of(const Mapping& mapping, const Ray& ray) {
  MappedPlace at;
  if (mapping.surface == MappingSurface::box) {
    const auto steps = [&](std::size_t axis) { return steps_to_face(ray, axis, sign_of(ray.along[axis])); };
    const float x = steps(0), y = steps(1), z = steps(2);
    const bool is_x = x <= y && x <= z;
    at.axis = is_x ? 0 : y <= z ? 1 : 2;
  }
  at.sign = sign_of(ray.along[static_cast<std::size_t>(at.axis)]);
  return at;
}

Point place_on_face(const Mapping& mapping, const MappedPlace& face, const Ray& ray, const Point& point) {
  const auto axis = static_cast<std::size_t>(face.axis);
  Point place = point;
  if (mapping.ray != MappingRay::surface) {
    const float steps = steps_to_face(ray, axis, face.sign);
    for (std::size_t i = 0; i < 3; ++i) place[i] = ray.from[i] + steps * ray.along[i];
  }
  place[axis] = face.sign;
  return place;
}

/// Where the ray leaves the sphere, or the cylinder, for which its height does not count.
Point place_on_round(const Mapping& mapping, const Ray& ray) {
  const bool is_cylinder = mapping.surface == MappingSurface::cylinder;
  const float radius = is_cylinder ? kMappingCylinder : kMappingSphere;
  Point a = ray.from, d = ray.along;
  if (is_cylinder) a[1] = d[1] = 0.0f;
  const float length = std::sqrt(maximum(dot(d, d), 1e-30f));
  const float b = dot(a, d) / length;
  const float c = dot(a, a) - radius * radius;
  const float steps = (std::sqrt(maximum(b * b - c, 0.0f)) - b) / length;
  Point place{};
  for (std::size_t i = 0; i < 3; ++i) place[i] = ray.from[i] + steps * ray.along[i];
  return place;
}

float bounded(float coordinate) {
  return minimum(maximum(coordinate, -kLargestMappedCoordinate), kLargestMappedCoordinate);
}

}  // namespace

MappedPlace reach_surface(const Mapping& mapping, const Point& point, const Point& normal) {
  const Ray ray = ray_of(mapping, point, normal);
  MappedPlace at = is_flat(mapping) ? face_of(mapping, ray) : MappedPlace{};
  at.place = place_like(mapping, at, point, normal);
  return at;
}

Point place_like(const Mapping& mapping, const MappedPlace& like, const Point& point, const Point& normal) {
  const Ray ray = ray_of(mapping, point, normal);
  return is_flat(mapping) ? place_on_face(mapping, like, ray, point) : place_on_round(mapping, ray);
}

std::array<float, 2> surface_coordinates(const Mapping& mapping, const MappedPlace& at) {
  const auto [x, y, z] = at.place;
  switch (mapping.surface) {
    case MappingSurface::cylinder:
      return {0.5f - portable_turn(x, z), y * 0.5f + 0.5f};
    case MappingSurface::sphere: {
      const float turn = portable_turn(std::sqrt(x * x + z * z), y);
      return {0.5f - portable_turn(x, z), 1.0f - (turn + turn)};
    }
    case MappingSurface::box: {
      const float u = at.axis == 0 ? -(at.sign * z) : at.axis == 1 ? x : at.sign * x;
      const float v = at.axis == 1 ? -(at.sign * z) : y;
      return {u * 0.5f + 0.5f, v * 0.5f + 0.5f};
    }
    default:
      return {x * 0.5f + 0.5f, 0.5f - z * 0.5f};
  }
}

std::array<float, 2> mapped_coordinates(const Mapping& mapping, const MappedPlace& place) {
  const auto [u, v] = surface_coordinates(mapping, place);
  return {bounded(u * mapping.repeats[0] + mapping.offset[0]),
          bounded((1.0f - v) * mapping.repeats[1] + mapping.offset[1])};
}

TilePlace change_tile(TileChange change, float s, float t) {
  constexpr float kLimit = 2097152.0f;
  s = minimum(maximum(s, -kLimit), kLimit);
  t = minimum(maximum(t, -kLimit), kLimit);
  const float i = std::floor(s), j = std::floor(t);
  TilePlace tile{static_cast<int>(i), static_cast<int>(j), 0, 0.0f, 0.0f, {s - i, t - j}};
  const std::uint32_t hash = tile_hash(tile.i, tile.j);
  auto& [x, y] = tile.coordinates;
  if (change != TileChange::shift) {
    tile.quarter_turns = static_cast<int>(hash & 3);
    // Half a turn mirrors both coordinates, a quarter exchanges them and mirrors one.
    if ((hash & 2) != 0) {
      x = 1.0f - x;
      y = 1.0f - y;
    }
    if ((hash & 1) != 0) tile.coordinates = {1.0f - y, x};
  }
  if (change != TileChange::rotate) {
    tile.shift_s = static_cast<float>((hash >> 8) & 255) * (1.0f / 256.0f);
    tile.shift_t = static_cast<float>((hash >> 16) & 255) * (1.0f / 256.0f);
    x = x + tile.shift_s;
    y = y + tile.shift_t;
  }
  return tile;
}

}  // namespace barrido::raster::reference
