// Which face of a cube map a direction hits, and the signed components that are its coordinates there (OpenGL
// 1.3, section 3.8.6 and table 3.19).
#pragma once

namespace barrido::raster::reference {

/// A component of a direction with a sign: sign·direction[axis].
struct SignedAxis {
  int axis = 0;
  float sign = 1.0f;

  float of(const float (&direction)[3]) const { return sign * direction[axis]; }
};

struct CubeFace {
  int face = 0;      ///< OpenGL's order: +X −X +Y −Y +Z −Z.
  SignedAxis sc;     ///< Left to right on the face.
  SignedAxis tc;     ///< With t.
  SignedAxis major;  ///< |ma|: never negative.
};

/// The larger magnitude wins, x before y before z in ties; a zero counts as positive.
CubeFace select_cube_face(const float (&direction)[3]);

}  // namespace barrido::raster::reference
