#include "tests/bench/harness.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>

namespace barrido::bench {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

Timing summary(std::vector<double> times_ms) {
  if (times_ms.empty()) return {};
  std::sort(times_ms.begin(), times_ms.end());
  return {times_ms[times_ms.size() / 2], times_ms.front()};
}

class MemsetDrawer final : public Drawer {
 public:
  explicit MemsetDrawer(std::size_t pixels) : color_(pixels), depth_(pixels) {}
  void draw() override {
    std::memset(color_.data(), ++value_, color_.size() * sizeof color_[0]);
    std::memset(depth_.data(), value_, depth_.size() * sizeof depth_[0]);
  }
  crosscheck::Picture picture() override { return {}; }

 private:
  std::vector<std::uint32_t> color_, depth_;
  unsigned char value_ = 0;
};

}  // namespace

Unlikeness compare(const crosscheck::Picture& a, const crosscheck::Picture& b) {
  Unlikeness unlike;
  std::uint64_t sum = 0, far = 0;
  for (std::size_t i = 0; i < a.color.size(); ++i) {
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int difference = std::abs(int{a.color[i][c]} - int{b.color[i][c]});
      sum += static_cast<std::uint64_t>(difference);
      largest = std::max(largest, difference);
    }
    unlike.largest = std::max(unlike.largest, largest);
    far += largest > 8;
  }
  const auto pixels = static_cast<double>(std::max<std::size_t>(1, a.color.size()));
  unlike.mean = static_cast<double>(sum) / (3.0 * pixels);
  unlike.far_ppm = 1e6 * static_cast<double>(far) / pixels;
  return unlike;
}

std::vector<Timing> time_interleaved(std::span<Drawer* const> drawers, const HarnessOptions& options) {
  std::vector<std::vector<double>> times_ms(drawers.size());
  const auto begin = Clock::now();
  for (int round = 0; round < options.most_rounds; ++round) {
    if (round >= options.least_rounds && milliseconds_since(begin) > options.seconds * 1e3) break;
    for (std::size_t i = 0; i < drawers.size(); ++i) {
      if (drawers[i] == nullptr) continue;
      const auto start = Clock::now();
      drawers[i]->draw();
      times_ms[i].push_back(milliseconds_since(start));
    }
  }
  std::vector<Timing> timings;
  for (auto& times : times_ms) timings.push_back(summary(std::move(times)));
  return timings;
}

Timing time_memset(int width, int height, const HarnessOptions& options) {
  MemsetDrawer drawer(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  Drawer* const drawers[] = {&drawer};
  HarnessOptions brief = options;
  brief.seconds = std::min(brief.seconds, 0.3);
  return time_interleaved(drawers, brief).front();
}

}  // namespace barrido::bench
