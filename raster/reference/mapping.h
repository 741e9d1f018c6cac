// Two-part mapping and tiles of one fragment (docs/arithmetic.md, "Coordinates by mapping"). Enters a point;
// leaves coordinates of a picture, before they are wrapped.
#pragma once

#include <array>

#include "raster/textures/mapping.h"

namespace barrido::raster::reference {

using Point = std::array<float, 3>;

/// Where the intermediate surface is reached.
struct MappedPlace {
  Point place{};
  int axis = 1;       ///< Of planes and boxes: which face,
  float sign = 1.0f;  ///< and whether it is the one at +1 or at −1.
};

/// O-mapping. `point` in the mapping's space, `normal` in eye space (only read where the ray needs it).
MappedPlace reach_surface(const Mapping& mapping, const Point& point, const Point& normal);

/// The same on the face that `like` is on, for neighbours of its point.
Point place_like(const Mapping& mapping, const MappedPlace& like, const Point& point, const Point& normal);

/// S-mapping: (u, v), each in [0, 1] on the surface, v up.
std::array<float, 2> surface_coordinates(const Mapping& mapping, const MappedPlace& place);

/// (s, t) of a picture whose rows run down, repeated and moved.
std::array<float, 2> mapped_coordinates(const Mapping& mapping, const MappedPlace& place);

struct TilePlace {
  int i = 0, j = 0;  ///< The tile
  int quarter_turns = 0;
  float shift_s = 0.0f, shift_t = 0.0f;
  std::array<float, 2> coordinates{};
};

/// What becomes of coordinates in their tile.
TilePlace change_tile(TileChange change, float s, float t);

}  // namespace barrido::raster::reference
