// A draw's triangles in double precision, for classifying pixels: where each is seen, its outline, and the
// weights of its corners at any place of the window. From the OpenGL specification's definitions; looks at no
// picture and uses nothing of Barrido but the structs.
#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "tests/osmesa/scene_pair.h"

namespace barrido::crosscheck {

/// A point of the window, pixels, y up.
struct WindowPoint {
  double x, y;
};

struct ExactTriangle {
  std::array<std::size_t, 3> vertex{};  ///< Of the mesh.
  std::array<glm::dvec4, 3> clip{};     ///< Clip coordinates.
  std::array<std::vector<double>, 3> plane_distance;
  /// b/w of the corners is this times (x, y, 1): rows are the corners.
  std::array<glm::dvec3, 3> over_w{};
  bool back = false;
  double depth_scale = 0.5, depth_bias = 0.5;  ///< Window depth of z/w, polygon offset included.
  bool depth_clamp = false;
  std::vector<WindowPoint> outline;  ///< After clipping.

  glm::dvec3 weights_over_w(double x, double y) const;
  double depth(const glm::dvec3& weights) const;
  /// Of depth, per pixel: max(|dz/dx|, |dz/dy|).
  double depth_slope() const;
  bool covers(const glm::dvec3& weights) const;
};

/// Filled triangles that are not culled; none for points, lines and outlined polygons.
std::vector<ExactTriangle> exact_triangles(const DrawCall& draw, int frame_width, int frame_height);

/// Segments that points, lines and polygon edges are drawn along; a point is a segment of no length.
std::vector<std::array<WindowPoint, 2>> exact_strokes(const DrawCall& draw, int frame_width,
                                                      int frame_height);

/// Distance of a place to a segment.
double distance_to_segment(const WindowPoint& p, const WindowPoint& a, const WindowPoint& b);

/// The part of a segment within `margin` pixels around the frame. @return false when there is none.
bool cut_to_frame(WindowPoint& a, WindowPoint& b, int width, int height, double margin);

}  // namespace barrido::crosscheck
