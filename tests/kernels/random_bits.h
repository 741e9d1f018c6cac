// Random choices for generated scenes: only the raw bits of std::mt19937_64, which the language defines
// exactly (its distributions are not), so that a seed means the same scene everywhere.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace barrido::raster::testing {

class RandomBits {
 public:
  explicit RandomBits(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  /// An integer in [low, high].
  int between(int low, int high) {
    const auto span = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
    return static_cast<int>(low + static_cast<std::int64_t>(engine_() % span));
  }
  /// True `percent` times of a hundred.
  bool chance(int percent) { return between(0, 99) < percent; }
  /// A number in [low, high), a multiple of (high − low)/2²⁴.
  float number(float low, float high) {
    return low + (high - low) * (static_cast<float>(engine_() >> 40) * 0x1p-24f);
  }
  /// One of the first `count` values of an enumeration.
  template <class Enumeration>
  Enumeration one_of_first(int count) {
    return static_cast<Enumeration>(between(0, count - 1));
  }
  template <class Value>
  Value pick(std::initializer_list<Value> values) {
    return values.begin()[between(0, static_cast<int>(values.size()) - 1)];
  }
  std::array<float, 4> color(float low, float high) {
    std::array<float, 4> result{};
    for (float& channel : result) channel = number(low, high);
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace barrido::raster::testing
