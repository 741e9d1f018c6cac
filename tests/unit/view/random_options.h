// Options of one picture drawn at random, every field among them, for tests of what must survive being
// written and read.
#pragma once

#include <cstdint>
#include <random>

#include "viewer/barrido/render_options.h"

namespace barrido::view::testing {

class RandomOptions {
 public:
  explicit RandomOptions(std::uint32_t seed) : engine_(seed) {}

  cli::RenderOptions next();

 private:
  bool coin() { return whole(2) == 1; }
  int whole(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }
  /// Any float of this size or smaller, of either sign; all its bits are drawn.
  float number(float largest);
  float share();  ///< In [0, 1]
  glm::vec3 vector(float largest);
  glm::vec3 color(float largest);
  scene::UserLight light();
  void set_camera(cli::RenderOptions& options);
  void set_looks(scene::RenderSettings& settings);
  void set_texture(cli::RenderOptions& options);
  void set_samples(scene::RenderSettings& s);
  void set_material(scene::MaterialOverride& material);

  std::mt19937 engine_;
};

/// Fails the test where a field differs.
void expect_same(const cli::RenderOptions& a, const cli::RenderOptions& b);

}  // namespace barrido::view::testing
