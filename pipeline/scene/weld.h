// Which vertices stand at the same place, whatever else tells them apart (coordinates at a seam, a normal a
// side of an edge).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace barrido::scene {

/// For each vertex the number of its class: vertices whose `components` floats are all equal are one class.
/// −0 equals 0; numbers that are none are compared by their bits. Numbers are given in ascending order of the
/// floats' bits.
struct Welded {
  std::vector<std::uint32_t> number;  ///< One a vertex
  std::uint32_t count = 0;            ///< Of classes
};
Welded weld(std::span<const float> values, std::size_t components);

}  // namespace barrido::scene
