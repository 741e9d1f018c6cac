// The Utah teapot from its bicubic Bézier patches. Enters: how finely to cut each patch; leaves: a mesh with
// y up, the spout along +X, the base on y = 0. Must not know files.
//
// Figures: Martin Newell, "The Utilization of Procedure Models in Digital Image Synthesis", University of
// Utah, 1975; with the bottom's four patches as published by Frank Crow, "The Origins of the Teapot", IEEE
// Computer Graphics and Applications 7(1), 1987.
#pragma once

#include <array>
#include <cstdint>

#include "models/tool/mesh.h"

namespace barrido::models {

inline constexpr int kTeapotPatchCount = 32;
inline constexpr int kTeapotControlPointCount = 290;

using ControlPoint = std::array<double, 3>;
using PatchIndices = std::array<std::uint16_t, 16>;  ///< Four rows of four control points.

/// Distinct control points as published: z up.
extern const std::array<ControlPoint, kTeapotControlPointCount> kTeapotControlPoints;
extern const std::array<PatchIndices, kTeapotPatchCount> kTeapotPatches;

/// Every patch becomes cells × cells quadrilaterals with normals from the patch's derivatives and texture
/// coordinates of its own, (0, 0) to (1, 1), unmirrored seen from outside (course T10).
Mesh make_teapot(int cells);

}  // namespace barrido::models
