// Where the time of a frame goes: the clock of each thread is handed from stage to stage, and what each stage
// took is summed over threads. Nothing is read from a clock unless somebody asked for a profile. Knows what
// the stages are called, and nothing that they do.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string_view>

namespace barrido::raster {

enum class Stage : std::uint8_t {
  vertices,      ///< Transformation and illumination at the vertices.
  assembly,      ///< Primitives, culling, clipping.
  binning,       ///< Primitives into tiles.
  clear,         ///< Tiles to the clear colour, or from the frame.
  visibility,    ///< Which triangle is seen where, before shading.
  spans,         ///< Scan conversion, depth test, interpolation; simple colours up to the pixel.
  illumination,  ///< Per fragment: Phong, cheap Phong.
  texture,       ///< Addresses, fetches, filters, texture environment.
  write,         ///< Fog, alpha test, blending, stores into the tile.
  resolve,       ///< Tone reproduction, and tiles into the frame.
};
inline constexpr int kStageCount = 10;
inline constexpr std::array<std::string_view, kStageCount> kStageNames{
    "vertices", "assembly",     "binning", "clear", "visibility",
    "spans",    "illumination", "texture", "write", "resolve"};

/// Sums over threads, so that with several threads the stages together take longer than the frame.
class StageProfile {
 public:
  void add(Stage stage, std::int64_t nanoseconds) {
    nanoseconds_[static_cast<std::size_t>(stage)].fetch_add(nanoseconds, std::memory_order_relaxed);
  }
  double milliseconds(Stage stage) const {
    return static_cast<double>(nanoseconds_[static_cast<std::size_t>(stage)].load()) * 1e-6;
  }

 private:
  std::array<std::atomic<std::int64_t>, kStageCount> nanoseconds_{};
};

/// One thread's clock: runs for one stage at a time. Does nothing without a profile.
class StageClock {
 public:
  StageClock() = default;
  StageClock(StageProfile* profile, Stage stage) { start(profile, stage); }
  ~StageClock() { stop(); }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

  void start(StageProfile* profile, Stage stage) {
    stop();
    profile_ = profile;
    stage_ = stage;
    if (profile_ != nullptr) since_ = Clock::now();
  }
  /// The time from now on is `stage`'s. @return the stage before.
  Stage switch_to(Stage stage) {
    const Stage before = stage_;
    stage_ = stage;
    if (profile_ != nullptr && stage != before) charge(before);
    return before;
  }
  void stop() {
    if (profile_ != nullptr) charge(stage_);
    profile_ = nullptr;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void charge(Stage stage) {
    const Clock::time_point now = Clock::now();
    profile_->add(stage, std::chrono::duration_cast<std::chrono::nanoseconds>(now - since_).count());
    since_ = now;
  }

  StageProfile* profile_ = nullptr;
  Stage stage_ = Stage::clear;
  Clock::time_point since_;
};

}  // namespace barrido::raster
