#include "pipeline/matrix.h"

#include <cmath>
#include <stdexcept>

#include "raster/base/portable_math.h"

namespace barrido::pipeline {
namespace {

double dot(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Unit vector; zero stays zero.
glm::dvec3 normalized(const glm::dvec3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0.0 ? v / length : v;
}

void require(bool condition, const char* message) {
  if (!condition) throw std::invalid_argument(message);
}

}  // namespace

glm::mat4 frustum(double left, double right, double bottom, double top, double near_plane, double far_plane) {
  require(left != right && bottom != top, "frustum: a side is empty");
  require(near_plane > 0.0, "frustum: the near plane must be in front of the eye");
  require(far_plane == 0.0 || far_plane > near_plane, "frustum: the far plane must lie behind the near one");
  const bool infinite = far_plane == 0.0 || std::isinf(far_plane);
  glm::dmat4 m(0.0);
  m[0][0] = 2.0 * near_plane / (right - left);
  m[1][1] = 2.0 * near_plane / (top - bottom);
  m[2][0] = (right + left) / (right - left);
  m[2][1] = (top + bottom) / (top - bottom);
  m[2][2] = infinite ? -1.0 : -(far_plane + near_plane) / (far_plane - near_plane);
  m[2][3] = -1.0;
  m[3][2] = infinite ? -2.0 * near_plane : -2.0 * far_plane * near_plane / (far_plane - near_plane);
  return glm::mat4(m);
}

glm::mat4 perspective(double vertical_fov_rad, double aspect, double near_plane, double far_plane) {
  require(vertical_fov_rad > 0.0 && vertical_fov_rad < kPi, "perspective: the angle must be in (0, pi)");
  require(aspect > 0.0, "perspective: the aspect must be positive");
  const double top = near_plane * portable_tan(0.5 * vertical_fov_rad);
  const double right = top * aspect;
  return frustum(-right, right, -top, top, near_plane, far_plane);
}

glm::mat4 orthographic(double left, double right, double bottom, double top, double near_plane,
                       double far_plane) {
  require(left != right && bottom != top && near_plane != far_plane, "orthographic: a side is empty");
  glm::dmat4 m(1.0);
  m[0][0] = 2.0 / (right - left);
  m[1][1] = 2.0 / (top - bottom);
  m[2][2] = -2.0 / (far_plane - near_plane);
  m[3][0] = -(right + left) / (right - left);
  m[3][1] = -(top + bottom) / (top - bottom);
  m[3][2] = -(far_plane + near_plane) / (far_plane - near_plane);
  return glm::mat4(m);
}

glm::mat4 look_at(const glm::dvec3& eye, const glm::dvec3& focal_point, const glm::dvec3& up) {
  glm::dvec3 forward = normalized(focal_point - eye);
  if (dot(forward, forward) == 0.0) forward = {0, 0, -1};
  glm::dvec3 side = cross(forward, normalized(up));
  for (const glm::dvec3& other : {glm::dvec3{0, 0, 1}, glm::dvec3{0, 1, 0}}) {
    if (dot(side, side) < 1e-16) side = cross(forward, other);
  }
  side = normalized(side);
  const glm::dvec3 true_up = cross(side, forward);
  glm::dmat4 m(1.0);
  for (int column = 0; column < 3; ++column) {
    m[column][0] = side[column];
    m[column][1] = true_up[column];
    m[column][2] = -forward[column];
  }
  m[3] = {-dot(side, eye), -dot(true_up, eye), dot(forward, eye), 1.0};
  return glm::mat4(m);
}

glm::mat4 rotation(double angle_rad, const glm::dvec3& axis) {
  const glm::dvec3 a = normalized(axis);
  if (dot(a, a) == 0.0) return glm::mat4(1.0f);
  const double c = portable_cos(angle_rad);
  const double s = portable_sin(angle_rad);
  const glm::dvec3 b = (1.0 - c) * a;
  glm::dmat4 m(1.0);
  m[0] = {b.x * a.x + c, b.x * a.y + s * a.z, b.x * a.z - s * a.y, 0.0};
  m[1] = {b.y * a.x - s * a.z, b.y * a.y + c, b.y * a.z + s * a.x, 0.0};
  m[2] = {b.z * a.x + s * a.y, b.z * a.y - s * a.x, b.z * a.z + c, 0.0};
  return glm::mat4(m);
}

glm::dmat3 normal_matrix(const glm::mat4& eye_from_object) {
  const glm::dvec3 x(eye_from_object[0]), y(eye_from_object[1]), z(eye_from_object[2]);
  const glm::dmat3 cofactors(cross(y, z), cross(z, x), cross(x, y));
  const double determinant = dot(x, cofactors[0]);
  return determinant == 0.0 ? cofactors : cofactors / determinant;
}

glm::mat4 product(const glm::mat4& a, const glm::mat4& b) { return glm::mat4(glm::dmat4(a) * glm::dmat4(b)); }

}  // namespace barrido::pipeline
