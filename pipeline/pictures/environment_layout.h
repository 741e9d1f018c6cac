// From one picture of the surroundings to the six faces of a cube map. Enters: pixels. Leaves: faces in
// OpenGL's orientation. Must not know: files.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/pictures/environment.h"
#include "pipeline/pictures/module.h"

namespace barrido::scene {

/// How the colours of a picture become the bytes of a face.
struct EnvironmentEncoding {
  float exposure_ev = 0.0f;  ///< Floats only: multiplied by 2^exposure_ev, then clamped to [0, 1].
  bool srgb = true;          ///< Floats: stored encoded. Bytes: filtered in linear light, stored encoded.
};

enum class EnvironmentLayout : std::uint8_t { horizontal_cross, vertical_cross, latitude_longitude, unknown };

/// By the ratio of the sides: 4:3, 3:4 and 2:1.
EnvironmentLayout environment_layout(int width, int height);

/// A whole square picture as straight RGBA8, row by row as it stands.
std::vector<std::uint8_t> environment_face(const Picture& picture, const EnvironmentEncoding& encoding);

/// The crosses as they are drawn on paper, seen so that neighbouring faces meet:
///
///          +Y                      +Y
///       −X +Z +X −Z             −X +Z +X
///          −Y                      −Y
///                                  −Z, upside down
CubeMapImage cube_map_from_cross(const Picture& picture, EnvironmentLayout layout,
                                 const EnvironmentEncoding& encoding);

/// Bilinear in longitude and latitude; the face has half the picture's height, at most 2048. The picture's
/// middle is −Z, its right quarter +X, its upper edge +Y.
CubeMapImage cube_map_from_latitude_longitude(const Picture& picture, const EnvironmentEncoding& encoding);

int picture_width(const Picture& picture);
int picture_height(const Picture& picture);

}  // namespace barrido::scene
