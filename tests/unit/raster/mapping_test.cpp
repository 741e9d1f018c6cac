// Two-part mapping: the published values of planar, cylindrical, spherical and box mapping, what the four
// O-mappings reach, and tiles.
#include "raster/reference/mapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace barrido::raster {
namespace {

using reference::Point;

constexpr float kRoot = 0.70710678f;

struct Mapped {
  Point point;
  float u, v;
};

Mapping mapping_on(MappingSurface surface, MappingRay ray = MappingRay::surface) {
  Mapping mapping;
  mapping.surface = surface;
  mapping.ray = ray;
  return mapping;
}

/// u and v up, as those who published the values have them.
std::array<float, 2> uv_of(const Mapping& mapping, const Point& point) {
  return reference::surface_coordinates(mapping, reference::reach_surface(mapping, point, {0, 0, 1}));
}

TEST(Mapping, SphereHasThePublishedValues) {
  constexpr Mapped kValues[] = {{{0, 0, -1}, 0, 0.5f},
                                {{1, 0, 0}, 0.25f, 0.5f},
                                {{0, 0, 1}, 0.5f, 0.5f},
                                {{-1, 0, 0}, 0.75f, 0.5f},
                                {{0, 1, 0}, 0.5f, 1},
                                {{0, -1, 0}, 0.5f, 0},
                                {{kRoot, kRoot, 0}, 0.25f, 0.75f}};
  for (const MappingRay ray : {MappingRay::surface, MappingRay::centre}) {
    for (const Mapped& m : kValues) {
      const auto [u, v] = uv_of(mapping_on(MappingSurface::sphere, ray), m.point);
      EXPECT_NEAR(u, m.u, 1e-7f) << m.point[0] << " " << m.point[1];
      EXPECT_NEAR(v, m.v, 1e-7f) << m.point[0] << " " << m.point[1];
    }
  }
}

/// Published with height 1 for v from 0 to 1; here the cylinder is 2 high about the origin.
TEST(Mapping, CylinderHasThePublishedValues) {
  constexpr Mapped kValues[] = {{{0, 0.5f, -1}, 0, 0.5f},
                                {{kRoot, 0.5f, -kRoot}, 0.125f, 0.5f},
                                {{1, 0.5f, 0}, 0.25f, 0.5f},
                                {{0, -0.25f, 1}, 0.5f, 0.75f},
                                {{-1, 1.25f, 0}, 0.75f, 0.25f}};
  for (const Mapped& m : kValues) {
    const auto [u, v] = uv_of(mapping_on(MappingSurface::cylinder), m.point);
    const float height = 2.0f * v - 1.0f;
    EXPECT_NEAR(u, m.u, 1e-7f);
    EXPECT_NEAR(height - std::floor(height), m.v, 1e-6f);
  }
}

/// Published with v = z; here v runs up as one sees the plane from above.
TEST(Mapping, PlaneHasThePublishedValues) {
  constexpr Mapped kValues[] = {{{0.25f, 0, -0.25f}, 0.25f, 0.75f}, {{0.25f, 0, -1.75f}, 0.25f, 0.25f}};
  for (const Mapped& m : kValues) {
    const auto [u, v] = uv_of(mapping_on(MappingSurface::planar), m.point);
    const auto part = [](float c) { return c - std::floor(c); };
    EXPECT_NEAR(part(2.0f * u - 1.0f), m.u, 1e-6f);
    EXPECT_NEAR(part(1.0f - 2.0f * v), m.v, 1e-6f);
  }
}

TEST(Mapping, BoxHasThePublishedValues) {
  constexpr Mapped kValues[] = {{{-0.5f, 0.5f, 1}, 0.25f, 0.75f},  {{0.5f, 0.5f, -1}, 0.25f, 0.75f},
                                {{-1, 0.5f, -0.5f}, 0.25f, 0.75f}, {{1, 0.5f, 0.5f}, 0.25f, 0.75f},
                                {{-0.5f, 1, -0.5f}, 0.25f, 0.75f}, {{-0.5f, -1, 0.5f}, 0.25f, 0.75f}};
  for (const MappingRay ray : {MappingRay::surface, MappingRay::centre}) {
    for (const Mapped& m : kValues) {
      const auto [u, v] = uv_of(mapping_on(MappingSurface::box, ray), m.point);
      EXPECT_NEAR(u, m.u, 1e-7f);
      EXPECT_NEAR(v, m.v, 1e-7f);
    }
  }
}

TEST(Mapping, RepeatsAndOffsetsAreOfTheCoordinates) {
  Mapping mapping = mapping_on(MappingSurface::planar);
  mapping.repeats = {3, -2};
  mapping.offset = {0.25f, 0.5f};
  const auto [s, t] = reference::mapped_coordinates(
      mapping, reference::reach_surface(mapping, {0.5f, 0.3f, -0.5f}, {0, 1, 0}));
  EXPECT_FLOAT_EQ(s, 0.75f * 3.0f + 0.25f);
  EXPECT_FLOAT_EQ(t, (1.0f - 0.75f) * -2.0f + 0.5f);
}

/// From a point inside, along its normal, the place lies on the surface and on the ray.
TEST(Mapping, NormalsReachTheSurface) {
  const Point p{0.2f, -0.3f, 0.1f}, n{0.6f, 0.64f, -0.48f};
  const auto at = [&](MappingSurface surface) {
    return reference::reach_surface(mapping_on(surface, MappingRay::normal), p, n).place;
  };
  const auto on_ray = [&](const Point& place) {
    const float steps = (place[0] - p[0]) / n[0];
    EXPECT_GT(steps, 0.0f);
    for (std::size_t i = 1; i < 3; ++i) EXPECT_NEAR(place[i], p[i] + steps * n[i], 1e-5f);
  };
  const Point sphere = at(MappingSurface::sphere), cylinder = at(MappingSurface::cylinder);
  on_ray(sphere);
  on_ray(cylinder);
  on_ray(at(MappingSurface::box));
  on_ray(at(MappingSurface::planar));
  EXPECT_NEAR(std::hypot(std::hypot(sphere[0], sphere[1]), sphere[2]), kMappingSphere, 1e-5f);
  EXPECT_NEAR(std::hypot(cylinder[0], cylinder[2]), kMappingCylinder, 1e-5f);
  EXPECT_EQ(at(MappingSurface::planar)[1], 1.0f);
}

/// The eye at the origin looks along −z at a mirror that is turned by 45°: the ray goes to +x.
TEST(Mapping, ReflectionsReachTheSurface) {
  Mapping mapping = mapping_on(MappingSurface::box, MappingRay::reflection);
  mapping.eye_from_mapping[2][3] = -5.0f;  // the object is 5 before the eye
  const Point turned{kRoot, 0, kRoot};
  const auto at = reference::reach_surface(mapping, {0, 0, 0}, turned);
  EXPECT_EQ(at.axis, 0);
  EXPECT_EQ(at.sign, 1.0f);
  EXPECT_NEAR(at.place[1], 0.0f, 1e-6f);
  EXPECT_NEAR(at.place[2], 0.0f, 1e-6f);
}

TEST(Tiles, NeighboursDifferAndStayWithinTheirBounds) {
  std::set<std::pair<int, float>> changes;
  for (int i = -20; i < 20; ++i) {
    for (int j = -20; j < 20; ++j) {
      const float s = static_cast<float>(i) + 0.25f, t = static_cast<float>(j) + 0.125f;
      const auto tile = reference::change_tile(TileChange::both, s, t);
      EXPECT_EQ(tile.i, i);
      EXPECT_EQ(tile.j, j);
      changes.emplace(tile.quarter_turns, tile.shift_s);
      const auto turned = reference::change_tile(TileChange::rotate, s, t).coordinates;
      constexpr float kTurns[4][2] = {{0.25f, 0.125f}, {0.875f, 0.25f}, {0.75f, 0.875f}, {0.125f, 0.75f}};
      EXPECT_EQ(turned[0], kTurns[tile.quarter_turns][0]);
      EXPECT_EQ(turned[1], kTurns[tile.quarter_turns][1]);
      const auto moved = reference::change_tile(TileChange::shift, s, t);
      EXPECT_EQ(moved.coordinates[0], 0.25f + moved.shift_s);
      EXPECT_EQ(moved.coordinates[1], 0.125f + moved.shift_t);
      EXPECT_LT(moved.shift_t, 1.0f);
    }
  }
  EXPECT_GT(changes.size(), 600u);
}

}  // namespace
}  // namespace barrido::raster
