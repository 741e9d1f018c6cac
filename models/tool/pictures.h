// The pictures of models/, drawn by formula: textures and the six faces of a sky. Display-referred RGB bytes
// (sRGB). No library function that may round differently elsewhere is used.
#pragma once

#include "models/tool/png.h"
#include "models/tool/vector.h"

namespace barrido::models {

/// Appends one pixel; the colour is clamped to [0, 1] and rounded.
void append_pixel(Picture& picture, const Vec3& color);

/// 8 × 8 light and dark squares, each framed by a thin line.
Picture draw_checker(int size);

/// Colours that tell (s, t) (red grows with s, green with t), a frame, 8 × 8 squares, and a white arrow
/// pointing to the top left corner, so that turned or mirrored copies are seen at once.
Picture draw_patch(int size);

/// Bricks in running bond with mortar; tiles without seams.
Picture draw_bricks(int size);

/// Heights of the same bricks over their mortar, grey.
Picture draw_brick_heights(int size);

/// Normals in tangent space of a picture of heights that repeats, white standing `height` of the picture's
/// own width over black (glTF 2.0, section 3.9.3: x along s, y against t). Slopes are taken over a texel to
/// either side.
Picture draw_normals(const Picture& heights, double height);

/// Red: how much of the light from all sides reaches the bricks and the bottom of their joints.
Picture draw_brick_occlusion(int size);

/// How much bricks and mortar shine, grey.
Picture draw_brick_shine(int size);

/// Marble after Perlin (1985): a sine of the position bent by turbulence; tiles without seams.
Picture draw_marble(int size);

/// Face `face` (OpenGL's order +X −X +Y −Y +Z −Z and orientation, OpenGL 1.3, table 3.19) of a sky with a
/// sun, clouds, hills and a meadow.
Picture draw_sky(int face, int size);

}  // namespace barrido::models
