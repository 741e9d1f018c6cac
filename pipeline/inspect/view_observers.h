// Internal to the views: what each reads from an observed frame. Enters: the frame; leaves: numbers in the
// values. Knows no colours.
#pragma once

#include "pipeline/inspect/structure_view.h"
#include "pipeline/scene/frame_observer.h"

namespace barrido::inspect {

/// Of overdraw, layers, illuminations and texels.
void count_work(const scene::ObservedFrame& frame, ViewValues& values);

/// Of mip_level, texel_density, coordinates, triangles and depth.
void look_at_front(const scene::ObservedFrame& frame, ViewValues& values);

/// Of normals. The frame must have been assembled for Phong shading, or flat at the centroid; then
/// `at_provoking` says whose normal a polygon has.
void look_at_normals(const scene::ObservedFrame& frame, bool at_provoking, ViewValues& values);

/// Of mach_bands: the five-point second derivative of the luma of the displayed frame, in 1/255. Borders
/// repeat their pixels. @param frame with float colours.
void differentiate(const raster::Framebuffer& frame, ViewValues& values);

}  // namespace barrido::inspect
