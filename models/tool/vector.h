// Small vector helpers shared by the model tool: double precision, and only operations that IEEE rounds
// correctly, so that the files come out the same everywhere.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace barrido::models {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;

inline double length_of(const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

/// v scaled to unit length; v must not be zero.
inline Vec3 unit(const Vec3& v) { return v / length_of(v); }

inline double lerp(double a, double b, double t) { return a + (b - a) * t; }
inline Vec3 lerp(const Vec3& a, const Vec3& b, double t) { return a + (b - a) * t; }

}  // namespace barrido::models
