#include "pipeline/scene/mapping_lines.h"

#include <array>

#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

using raster::MappingSurface;

constexpr int kMeridians = 24;
constexpr int kParallels = 12;
constexpr int kCells = 8;       ///< Of a plane or face, along each side
constexpr double kPole = 0.12;  ///< Length of the cross at a pole

/// The place of (u, v) on a sphere or cylinder; u runs clockwise from −z.
glm::dvec3 round_place(MappingSurface surface, double u, double v) {
  const double angle = (0.5 - u) * 2.0 * kPi;
  const double x = portable_sin(angle), z = portable_cos(angle);
  if (surface == MappingSurface::cylinder) {
    const double radius = static_cast<double>(raster::kMappingCylinder);
    return {radius * x, 2.0 * v - 1.0, radius * z};
  }
  const double radius = static_cast<double>(raster::kMappingSphere);
  const double down = (1.0 - v) * kPi;
  const double ring = radius * portable_sin(down);
  return {ring * x, radius * portable_cos(down), ring * z};
}

void add(MappingLines& lines, const glm::dvec3& from, const glm::dvec3& to) {
  lines.places.push_back(from);
  lines.places.push_back(to);
}

void add_meridian(MappingLines& lines, MappingSurface surface, double u) {
  for (int k = 0; k < kParallels; ++k) {
    add(lines, round_place(surface, u, static_cast<double>(k) / kParallels),
        round_place(surface, u, static_cast<double>(k + 1) / kParallels));
  }
}

void add_round(MappingLines& lines, MappingSurface surface) {
  for (int m = 1; m < kMeridians; ++m) add_meridian(lines, surface, static_cast<double>(m) / kMeridians);
  for (int p = 0; p <= kParallels; ++p) {
    const double v = static_cast<double>(p) / kParallels;
    for (int m = 0; m < kMeridians; ++m) {
      add(lines, round_place(surface, static_cast<double>(m) / kMeridians, v),
          round_place(surface, static_cast<double>(m + 1) / kMeridians, v));
    }
  }
  lines.first_of_seam = lines.places.size();
  add_meridian(lines, surface, 0.0);
  if (surface != MappingSurface::sphere) return;
  for (const double side : {-1.0, 1.0}) {
    const glm::dvec3 pole(0.0, side * static_cast<double>(raster::kMappingSphere), 0.0);
    for (const glm::dvec3& arm :
         {glm::dvec3(kPole, 0, 0), glm::dvec3(0, kPole, 0), glm::dvec3(0, 0, kPole)}) {
      add(lines, pole - arm, pole + arm);
    }
  }
}

/// The cells of a face; its edges are kept for the seams.
void add_face(MappingLines& lines, int axis, double side, bool edges) {
  for (int k = 0; k <= kCells; ++k) {
    if ((k == 0 || k == kCells) != edges) continue;
    const double across = 2.0 * k / kCells - 1.0;
    for (const int along : {(axis + 1) % 3, (axis + 2) % 3}) {
      glm::dvec3 from(across), to(across);
      from[axis] = to[axis] = side;
      from[along] = -1.0;
      to[along] = 1.0;
      add(lines, from, to);
    }
  }
}

}  // namespace

MappingLines mapping_lines(MappingSurface surface) {
  MappingLines lines;
  if (surface == MappingSurface::sphere || surface == MappingSurface::cylinder) {
    add_round(lines, surface);
    return lines;
  }
  const bool is_box = surface == MappingSurface::box;
  for (const bool edges : {false, true}) {
    if (edges) lines.first_of_seam = lines.places.size();
    for (int axis = is_box ? 0 : 1; axis < (is_box ? 3 : 2); ++axis) {
      if (is_box) add_face(lines, axis, -1.0, edges);
      add_face(lines, axis, 1.0, edges);
    }
  }
  return lines;
}

}  // namespace barrido::scene
