// The matrices of OpenGL and its utility library, computed in double precision with
// raster/base/portable_math.h, so that they are the same bits on every machine (glm's own use the C library's
// sine and tangent).
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace barrido::pipeline {

/// Clip from eye space as glFrustum (OpenGL 1.3, section 2.10.2); the eye looks along −Z. A `far_plane` of 0
/// (or infinity) is infinitely far away: the limit of the same matrix.
/// @throws std::invalid_argument when near_plane ≤ 0, far_plane is neither 0 nor beyond near_plane, or a side
/// is empty.
glm::mat4 frustum(double left, double right, double bottom, double top, double near_plane, double far_plane);

/// As gluPerspective, the field of view in radians. `aspect` is width over height.
/// @throws std::invalid_argument as frustum, and when the angle is not in (0, π) or aspect ≤ 0.
glm::mat4 perspective(double vertical_fov_rad, double aspect, double near_plane, double far_plane);

/// As glOrtho. @throws std::invalid_argument when a side is empty.
glm::mat4 orthographic(double left, double right, double bottom, double top, double near_plane,
                       double far_plane);

/// Eye from world space as gluLookAt. When `up` is parallel to the line of sight, or one is zero, another up
/// is chosen (+Z, or +Y where that is parallel too).
glm::mat4 look_at(const glm::dvec3& eye, const glm::dvec3& focal_point, const glm::dvec3& up);

/// As glRotate, the angle in radians: counter-clockwise when the axis points at the viewer. A zero axis gives
/// the identity.
glm::mat4 rotation(double angle_rad, const glm::dvec3& axis);

/// What takes normals (as columns) from object to eye space: the transposed inverse of the upper left 3 × 3
/// matrix (OpenGL 1.3, section 2.10.3). Of a singular matrix the cofactors, which still are perpendicular to
/// what is left of a surface.
glm::dmat3 normal_matrix(const glm::mat4& eye_from_object);

/// a·b computed in double precision and rounded once.
glm::mat4 product(const glm::mat4& a, const glm::mat4& b);

}  // namespace barrido::pipeline
