// The workloads W1 to W17 that speed is measured with: scenes of 1920 × 1080 pixels, each of which stresses
// one part of the pipeline. Only plain data; knows neither renderer and no clock.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/osmesa/scene_pair.h"

namespace barrido::bench {

using crosscheck::DrawCall;
using crosscheck::Mesh;
using crosscheck::ScenePair;

/// Width and height of the frames, pixels.
struct Scale {
  int width = 1920;
  int height = 1080;
};

/// What a workload's throughput is told in.
enum class Unit { pixels, triangles };

struct Workload {
  std::string id;     ///< "W1" …
  std::string title;  ///< What is drawn.
  double goal;        ///< How many times the peer's speed is aimed at.
  std::function<ScenePair(const Scale&)> build;
  Unit unit = Unit::pixels;
};

/// All workloads in the order of their numbers. There is no W11, W17, W18.
const std::vector<Workload>& workloads();

// The families, one file each.

enum class Coloring { flat, smooth };
/// Full-screen quads back to front, window depth 0.95 down to 0.05 (z from 0.9 to −0.9 in clip space).
ScenePair screen_layers(const Scale& scale, int layers, Coloring coloring, bool blended);

struct GroundOptions {
  raster::MinFilter min_filter = raster::MinFilter::linear;
  raster::MagFilter mag_filter = raster::MagFilter::linear;
  int max_anisotropy = 1;
  bool blended = false;
  bool front_to_back = false;
  int layers = 8;
  int texture_side = 1024;
};
/// Ground planes in perspective below a camera pitched 40° down, textured and modulated by vertex colours.
ScenePair ground_layers(const Scale& scale, const GroundOptions& options);

/// A wavy grid that fills the screen and reflects a cube map.
ScenePair reflecting_grid(const Scale& scale, raster::MinFilter min_filter);

struct EllipsoidOptions {
  int slices = 265;
  int stacks = 133;
  double silhouette = 0.874;  ///< Of half the frame's height and width.
  pipeline::ShadeModel shading = pipeline::ShadeModel::gouraud;
  int lights = 1;
  int normal_map_side = 0;  ///< Texels; 0: none.
  bool marble = false;      ///< Of six octaves, computed at each fragment.
};
/// A lit ellipsoid with culled back faces.
ScenePair ellipsoid(const Scale& scale, const EllipsoidOptions& options);

}  // namespace barrido::bench
