// How fast the error of a picture falls with the number of samples, pattern by pattern. Enters: a scene and
// the settings of a frame; leaves: figures, as JSON and as a plot.
#pragma once

#include <string>
#include <vector>

#include "pipeline/scene/render_scene.h"

namespace barrido::cli {

struct SamplingPoint {
  double samples = 0.0;  ///< A pixel, on the average.
  double error = 0.0;    ///< Root of the mean square over pixels and channels, of linear light.
};

struct SamplingCurve {
  std::string name;
  std::vector<SamplingPoint> points;
  double slope = 0.0;  ///< Of the logarithm of the mean square over that of the samples, least squares.
};

struct SamplingFigures {
  int width = 0, height = 0;
  int reference_samples = 0;  ///< Of the picture that errors are taken from.
  std::vector<SamplingCurve> curves;
};

SamplingFigures measure_sampling(scene::SceneRenderer& renderer, scene::RenderSettings settings);

std::string figures_json(const SamplingFigures& figures, const std::string& model);
std::string figures_svg(const SamplingFigures& figures, const std::string& model);

}  // namespace barrido::cli
