// What every pixel of a picture ought to be, in double precision and independently of the renderer: the
// course's notation for the equation of illumination.h, and triangles by projecting every pixel. Enters:
// lights, materials, points; leaves: colours. Shares no code with pipeline/.
#pragma once

#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/state.h"

namespace barrido::oracle {

struct OracleLight {
  glm::dvec3 color{1, 1, 1};        ///< I_p, diffuse and specular alike
  glm::dvec4 position{0, 0, 1, 0};  ///< w = 0: the direction to the light
  double kc = 1, kl = 0, kq = 0;
};

struct OracleMaterial {
  glm::dvec3 ka{0, 0, 0}, kd{0, 0, 0}, ks{0, 0, 0};
  double n = 1;
};

struct OracleModel {
  glm::dvec3 ambient{0, 0, 0};  ///< I_a
  std::vector<OracleLight> lights;
  OracleMaterial material;
  bool phong = false;         ///< (R·V)^n, else (N·H)^n
  bool local_viewer = false;  ///< V to the eye at the origin, else (0, 0, 1)
};

/// The model as fixed-function state.
pipeline::Lighting lighting_of(const OracleModel& model);

/// What cheap Phong interpolates for one light: N·L and R·V (or N·H), negative where they are.
struct Dots {
  double diffuse = 0;
  double highlight = 0;
};
Dots dots_at(const OracleModel& model, const OracleLight& light, const glm::dvec3& p, const glm::dvec3& n);

/// [N·L > 0] h^n
double highlight_of(const Dots& dots, double exponent);

/// 1/(kc + kl·d + kq·d²) of positional lights, 1 of others.
double attenuation(const OracleLight& light, const glm::dvec3& p);

/// I = I_a k_a + Σ f I_p (k_d max(0, N·L) + k_s h^n [N·L > 0]), `n` of unit length.
glm::dvec3 illuminated(const OracleModel& model, const glm::dvec3& p, const glm::dvec3& n);

/// Triangles seen by an eye at the origin that looks along −Z; everything evaluated by projecting in double
/// precision, pixel by pixel.
class OracleMesh {
 public:
  OracleMesh(std::vector<glm::dvec3> positions, std::vector<std::uint32_t> indices,
             const glm::dmat4& clip_from_eye, int width, int height);

  struct Hit {
    int triangle = -1;            ///< −1: nothing, or too near an edge to say
    glm::dvec3 screen{0, 0, 0};   ///< Barycentric coordinates on the screen: linear in window space
    glm::dvec3 weights{0, 0, 0};  ///< Perspective-correct ones: Σ(b f/w)/Σ(b/w) as weights of f
  };
  /// The triangle under a window position; pixels closer than `margin` pixels to an edge are no hit.
  Hit at(double x, double y, double margin) const;

  std::uint32_t vertex(int triangle, int corner) const {
    return indices_[static_cast<std::size_t>(triangle * 3 + corner)];
  }
  const std::vector<glm::dvec3>& positions() const { return positions_; }
  int triangle_count() const { return static_cast<int>(indices_.size() / 3); }

 private:
  std::vector<glm::dvec3> positions_;
  std::vector<std::uint32_t> indices_;
  std::vector<glm::dvec2> window_;
  std::vector<double> w_;
};

/// Σ weight_k · values[vertex k of the triangle]
template <class Value>
Value mixed(const OracleMesh& mesh, int triangle, const glm::dvec3& weights,
            const std::vector<Value>& values) {
  return weights.x * values[mesh.vertex(triangle, 0)] + weights.y * values[mesh.vertex(triangle, 1)] +
         weights.z * values[mesh.vertex(triangle, 2)];
}

}  // namespace barrido::oracle
