#include "tests/bench/machine.h"

#include <fstream>
#include <thread>

#include "tests/bench/tile_store.h"

namespace barrido::bench {
namespace {

class TileDrawer final : public Drawer {
 public:
  void draw() override {
    for (int layer = 0; layer < kLayers; ++layer) {
      tile_.store_layer(1.0f - static_cast<float>(layer) / kLayers, static_cast<std::uint32_t>(layer));
    }
    tile_.clear();
  }
  crosscheck::Picture picture() override { return {}; }

  static constexpr int kLayers = 512;
  static constexpr double kMegapixels = kLayers * static_cast<double>(CachedTile::kPixels) * 1e-6;

 private:
  CachedTile tile_;
};

}  // namespace

std::string processor_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

unsigned processor_threads() { return std::thread::hardware_concurrency(); }

Limits measure_limits(int width, int height, const HarnessOptions& options) {
  HarnessOptions brief = options;
  brief.seconds = std::min(brief.seconds, 0.3);
  TileDrawer tile;
  Drawer* const drawers[] = {&tile};
  const Timing store = time_interleaved(drawers, brief).front();
  return {time_memset(width, height, options).median_ms, TileDrawer::kMegapixels / store.median_ms * 1e3};
}

}  // namespace barrido::bench
