// Drawing for the oracle tests: a state, geometry and a float frame in, colours out. Window coordinates have
// their origin at the lower left.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/renderer.h"
#include "tests/oracle/closed_form.h"

namespace barrido::oracle {

/// Positions, normals and texture coordinates in eye space, as the renderer wants them.
struct DrawnMesh {
  std::vector<float> positions, normals, texcoords;
  std::vector<std::uint32_t> indices;

  void add(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& texcoord = {0, 0});
  pipeline::Geometry geometry() const;
  /// The same vertices after rounding to float.
  std::vector<glm::dvec3> rounded_positions() const { return vectors(positions); }
  std::vector<glm::dvec3> rounded_normals() const { return vectors(normals); }

 private:
  static std::vector<glm::dvec3> vectors(const std::vector<float>& values);
};

/// A frame of straight floats, not clamped.
class FloatFrame {
 public:
  FloatFrame(int width, int height);
  /// Clears to transparent black, depth 1, and draws.
  void draw(const pipeline::State& state, const pipeline::Geometry& geometry);
  glm::dvec4 at(int x, int window_y) const;
  int width() const { return frame_.width(); }
  int height() const { return frame_.height(); }

 private:
  raster::Framebuffer frame_;
};

/// Lights, material and switches of `model` as fixed-function state.
void set_lighting(pipeline::State& state, const OracleModel& model);

/// The differences of a frame from what it should be.
struct Comparison {
  double largest = 0;
  int compared = 0;
  int worst_x = 0, worst_y = 0;

  void add(int x, int y, const glm::dvec3& got, const glm::dvec3& wanted) {
    const glm::dvec3 difference = glm::abs(got - wanted);
    const double d = std::max({difference.x, difference.y, difference.z});
    ++compared;
    if (d > largest || d != d) {
      largest = d == d ? d : 1e9;
      worst_x = x;
      worst_y = y;
    }
  }
};

}  // namespace barrido::oracle
