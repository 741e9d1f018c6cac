// Two-part mapping (T4; Bier and Sloan 1986): a point of an object reaches a place on an intermediate surface
// (O-mapping), which has coordinates (S-mapping). And tiles (T9): coordinates changed tile by tile, so that a
// repeated picture shows no pattern. Must not know: objects, pictures.
#pragma once

#include <array>
#include <cstdint>

namespace barrido::raster {

/// The intermediate surface, about the origin with the axis y. `none`: coordinates are used as they are.
enum class MappingSurface : std::uint8_t {
  none,
  planar,    ///< T5: y = ±1; u = ½ + x/2, v = ½ − z/2.
  cylinder,  ///< T6: radius kMappingCylinder; u runs clockwise from −z, v = ½ + y/2.
  sphere,    ///< T7: radius kMappingSphere; u as of the cylinder, v from the south pole to the north.
  box,       ///< T8: the six faces of ±1, each a plane.
};

/// What leads from the object to the intermediate surface.
enum class MappingRay : std::uint8_t {
  surface,     ///< The intermediate surface's normal: the place from which it points at the object's point.
  centre,      ///< From the centre through the point.
  normal,      ///< From the point along the object's normal.
  reflection,  ///< From the point along the reflected ray of the eye.
};

/// Around the box of ±1: an object in the box lies inside.
inline constexpr float kMappingSphere = 1.7320508f;
inline constexpr float kMappingCylinder = 1.4142135f;
inline constexpr float kLargestMappedCoordinate = 1e6f;

/// How a unit's coordinates, which are a point (s, t, r), become those of a picture.
struct Mapping {
  MappingSurface surface = MappingSurface::none;
  MappingRay ray = MappingRay::surface;
  /// s = u·repeats + offset, t = (1 − v)·repeats + offset: v runs up, the rows of pictures down.
  std::array<float, 2> repeats{1, 1};
  std::array<float, 2> offset{0, 0};
  /// For rays along normals and reflections: rows of the matrix that takes points of the mapping to eye
  /// space, and of the one that takes directions back.
  std::array<std::array<float, 4>, 3> eye_from_mapping{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  std::array<std::array<float, 3>, 3> mapping_from_eye{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  bool operator==(const Mapping&) const = default;
};

inline bool needs_normal(const Mapping& mapping) {
  return mapping.surface != MappingSurface::none && mapping.ray >= MappingRay::normal;
}

/// How far coordinates (s, t) move for a step of 1 along the intermediate surface, at most.
inline std::array<float, 2> mapping_density(const Mapping& mapping) {
  constexpr float kTurn = 0.159154943f;  // 1/2π
  const auto size = [](float number) { return number < 0.0f ? -number : number; };
  const float s = size(mapping.repeats[0]), t = size(mapping.repeats[1]);
  switch (mapping.surface) {
    case MappingSurface::cylinder:
      return {s * (kTurn / kMappingCylinder), t * 0.5f};
    case MappingSurface::sphere:
      return {s * (kTurn / kMappingSphere), t * (2.0f * kTurn / kMappingSphere)};
    default:
      return {s * 0.5f, t * 0.5f};
  }
}

/// What a hash of its number does to each tile of a picture.
enum class TileChange : std::uint8_t {
  none,
  rotate,  ///< By a multiple of a quarter turn.
  shift,   ///< By a part of the tile in both directions, the picture going on at its other edge.
  both,
};

/// A number of 32 well-mixed bits for tile (i, j): bits 0 and 1 are its quarter turns, 8 to 15 and 16 to 23
/// its shift in 1/256.
constexpr std::uint32_t tile_hash(std::int32_t i, std::int32_t j) {
  std::uint32_t h = static_cast<std::uint32_t>(i) * 0x9e3779b1u ^ static_cast<std::uint32_t>(j) * 0x85ebca77u;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return h ^ (h >> 15);
}

}  // namespace barrido::raster
