// What the frames of a call cost (course S8): times, and counts of illuminations, interpolations, additions
// and powers per frame, polygon and scanline, for each shading mode. Enters: what was measured; leaves: text.
#pragma once

#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "pipeline/renderer.h"

namespace barrido::cli {

/// Time since it was made, by the steady clock.
class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct FrameCost {
  std::string name;  ///< As in --hash: file name, or "teapot/phong" where the frame has no file.
  std::string model;
  pipeline::ShadeModel shading = pipeline::ShadeModel::phong;
  int width = 0;
  int height = 0;
  pipeline::Statistics counts;
  double draw_ms = 0.0;
  /// By raster::Stage, summed over threads: more than draw_ms where several work.
  std::array<double, raster::kStageCount> stage_ms{};
  double write_ms = 0.0;  ///< Encoding and writing; runs beside the drawing of later frames.
  std::string sha256;     ///< Of the pixels; empty unless asked for.
};

struct ModelCost {
  std::string path;
  double load_ms = 0.0;
};

struct CostReport {
  std::vector<ModelCost> models;
  double environment_ms = 0.0;
  std::vector<FrameCost> frames;
  double total_ms = 0.0;  ///< Of the whole command, by the clock.
  int threads = 0;
  std::string simd;  ///< "avx2"
};

/// A table for each shading mode, summed over its frames, and the times of the stages.
std::string cost_text(const CostReport& report);
/// Everything, frame by frame and summed by mode, as one JSON object ending in a line feed.
std::string cost_json(const CostReport& report);

/// The quantities of the course's table, from the renderer's counters.
struct CourseCounts {
  std::uint64_t illuminations = 0;   ///< Of one light at one place: at vertices, centroids and fragments.
  std::uint64_t interpolations = 0;  ///< Of one quantity at one fragment.
  std::uint64_t additions = 0;       ///< Incremental form (S5): one for each interpolation.
  std::uint64_t powers = 0;
  std::uint64_t polygons = 0;   ///< Drawn, after culling and clipping.
  std::uint64_t scanlines = 0;  ///< Pieces of scanlines inside a polygon (spans).
  std::uint64_t fragments = 0;  ///< Interpolated and shaded.
};

CourseCounts course_counts(const pipeline::Statistics& statistics);
CourseCounts& operator+=(CourseCounts& sum, const CourseCounts& counts);

}  // namespace barrido::cli
