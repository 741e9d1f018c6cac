// How OpenGL's primitive modes are made of elements: which vertices a point, line, triangle or polygon takes,
// in which order, and which one of them is provoking (OpenGL 1.3, sections 2.6.1 and 2.13.7, table 2.12).
// "Element" is a place in the index array, or in the vertex arrays where there are no indices.
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/geometry.h"

namespace barrido::pipeline {

/// Whether the mode makes polygons, which have a front and a back.
constexpr bool is_polygonal(PrimitiveMode mode) { return mode >= PrimitiveMode::triangles; }

/// Polygons that `elements` elements make; incomplete ones are ignored.
constexpr std::uint32_t polygon_count(PrimitiveMode mode, std::uint32_t elements) {
  switch (mode) {
    case PrimitiveMode::triangles:
      return elements / 3;
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::triangle_fan:
      return elements < 3 ? 0 : elements - 2;
    case PrimitiveMode::quads:
      return elements / 4;
    case PrimitiveMode::quad_strip:
      return elements < 4 ? 0 : elements / 2 - 1;
    case PrimitiveMode::polygon:
      return elements < 3 ? 0 : 1;
    default:
      return 0;
  }
}

/// Corners of each polygon.
constexpr std::uint32_t polygon_size(PrimitiveMode mode, std::uint32_t elements) {
  switch (mode) {
    case PrimitiveMode::quads:
    case PrimitiveMode::quad_strip:
      return 4;
    case PrimitiveMode::polygon:
      return elements;
    default:
      return 3;
  }
}

/// Element of a polygon's corner, in the order that decides its facing.
constexpr std::uint32_t polygon_corner(PrimitiveMode mode, std::uint32_t polygon, std::uint32_t corner) {
  switch (mode) {
    case PrimitiveMode::triangles:
      return 3 * polygon + corner;
    case PrimitiveMode::triangle_strip:  // every other triangle is turned round
      return polygon + (corner == 2 ? 2 : (corner ^ (polygon & 1)));
    case PrimitiveMode::triangle_fan:
      return corner == 0 ? 0 : polygon + corner;
    case PrimitiveMode::quads:
      return 4 * polygon + corner;
    case PrimitiveMode::quad_strip:  // 2p, 2p + 1, 2p + 3, 2p + 2
      return 2 * polygon + (corner < 2 ? corner : 5 - corner);
    default:
      return corner;
  }
}

/// The element whose colour a flat polygon takes.
constexpr std::uint32_t provoking_element(PrimitiveMode mode, std::uint32_t polygon) {
  switch (mode) {
    case PrimitiveMode::triangles:
      return 3 * polygon + 2;
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::triangle_fan:
      return polygon + 2;
    case PrimitiveMode::quads:
      return 4 * polygon + 3;
    case PrimitiveMode::quad_strip:
      return 2 * polygon + 3;
    default:
      return 0;
  }
}

/// Triangles that all polygons together are cut into.
constexpr std::uint32_t triangle_count(PrimitiveMode mode, std::uint32_t elements) {
  return polygon_count(mode, elements) * (polygon_size(mode, elements) - 2);
}

/// The polygon that a triangle is part of.
constexpr std::uint32_t polygon_of_triangle(PrimitiveMode mode, std::uint32_t triangle) {
  switch (mode) {
    case PrimitiveMode::quads:
    case PrimitiveMode::quad_strip:
      return triangle / 2;
    case PrimitiveMode::polygon:
      return 0;
    default:
      return triangle;
  }
}

/// Elements of a triangle, facing as its polygon. Quads are cut from the provoking corner to the one
/// opposite, as Mesa does: (0, 1, 3) and (1, 2, 3), in strips (3, 0, 2) and (0, 1, 2).
constexpr std::array<std::uint32_t, 3> triangle_elements(PrimitiveMode mode, std::uint32_t triangle) {
  const std::uint32_t polygon = polygon_of_triangle(mode, triangle);
  std::array<std::uint32_t, 3> corner{0, 1, 2};
  if (mode == PrimitiveMode::quads) {
    corner =
        triangle % 2 == 0 ? std::array<std::uint32_t, 3>{0, 1, 3} : std::array<std::uint32_t, 3>{1, 2, 3};
  } else if (mode == PrimitiveMode::quad_strip) {
    corner =
        triangle % 2 == 0 ? std::array<std::uint32_t, 3>{3, 0, 2} : std::array<std::uint32_t, 3>{0, 1, 2};
  } else if (mode == PrimitiveMode::polygon) {
    corner = {0, triangle + 1, triangle + 2};
  }
  return {polygon_corner(mode, polygon, corner[0]), polygon_corner(mode, polygon, corner[1]),
          polygon_corner(mode, polygon, corner[2])};
}

/// Lines of the line modes. A line's provoking element is its second one.
constexpr std::uint32_t line_count(PrimitiveMode mode, std::uint32_t elements) {
  if (mode == PrimitiveMode::lines) return elements / 2;
  if (elements < 2) return 0;
  return mode == PrimitiveMode::line_loop ? elements : elements - 1;
}

constexpr std::array<std::uint32_t, 2> line_elements(PrimitiveMode mode, std::uint32_t line,
                                                     std::uint32_t elements) {
  if (mode == PrimitiveMode::lines) return {2 * line, 2 * line + 1};
  return {line, line + 1 == elements ? 0 : line + 1};
}

}  // namespace barrido::pipeline
