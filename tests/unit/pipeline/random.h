// Repeatable random numbers for tests.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace barrido::pipeline {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2 + 1) {}

  /// [0, 1)
  double unit() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 40) / static_cast<double>(std::uint64_t{1} << 24);
  }
  float in(double low, double high) { return static_cast<float>(low + (high - low) * unit()); }
  int below(int end) { return static_cast<int>(unit() * end); }
  bool chance(double probability) { return unit() < probability; }
  glm::vec3 vec3(double low, double high) { return {in(low, high), in(low, high), in(low, high)}; }
  glm::vec4 vec4(double low, double high) {
    return {in(low, high), in(low, high), in(low, high), in(low, high)};
  }

 private:
  std::uint64_t state_;
};

}  // namespace barrido::pipeline
