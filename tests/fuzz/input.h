// Choices out of bytes. Reads from the front, so that what is appended to an input changes nothing before it;
// past the end every byte is 0. Must not know what is chosen.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

#include "targets.h"

namespace barrido::fuzz {

class Input {
 public:
  explicit Input(Bytes bytes) : bytes_(bytes) {}

  bool is_empty() const { return next_ == bytes_.size(); }
  std::uint8_t byte() { return is_empty() ? std::uint8_t{0} : bytes_[next_++]; }
  std::uint32_t bits32() {
    std::uint32_t bits = 0;
    for (int shift = 0; shift < 32; shift += 8) bits |= std::uint32_t{byte()} << shift;
    return bits;
  }
  bool flag() { return (byte() & 1) != 0; }

  /// An integer in [low, high], from as few bytes as its range needs.
  int between(int low, int high) {
    const std::uint64_t count = static_cast<std::uint64_t>(std::int64_t{high} - low) + 1;
    std::uint64_t value = byte();
    for (std::uint64_t reach = 256; reach < count; reach <<= 8) value = value << 8 | byte();
    return static_cast<int>(low + static_cast<std::int64_t>(value % count));
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

  /// A multiple of 1/255 in [0, 1].
  float fraction() { return static_cast<float>(byte()) / 255.0f; }
  /// A multiple of 1/4096 in [-8, 8).
  float small_number() {
    const auto low = byte();
    return static_cast<float>(static_cast<std::int8_t>(byte())) / 16.0f + static_cast<float>(low) / 4096.0f;
  }
  /// Any float: small ones mostly, then those where arithmetic breaks, then any bits.
  float number() {
    constexpr float kMax = std::numeric_limits<float>::max();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr std::array<float, 24> kSpecial{
        0.0f,   -0.0f,     1.0f,          -1.0f,
        0.5f,   1e-45f,    -1e-45f,       1.1754942e-38f,
        1e-20f, -1e-20f,   255.5f,        32768.0f,
        -1e5f,  16384.5f,  2147483648.0f, -4294967296.0f,
        1e19f,  -1e22f,    3e30f,         kMax,
        -kMax,  kInfinity, -kInfinity,    std::numeric_limits<float>::quiet_NaN()};
    const std::uint8_t kind = byte();
    if (kind < 192) return small_number();
    if (kind < 240) return kSpecial[byte() % kSpecial.size()];
    return std::bit_cast<float>(bits32());
  }

  /// The next `count` bytes, as many as there are.
  Bytes take(std::size_t count) {
    const Bytes taken = bytes_.subspan(next_, std::min(count, bytes_.size() - next_));
    next_ += taken.size();
    return taken;
  }

 private:
  Bytes bytes_;
  std::size_t next_ = 0;
};

}  // namespace barrido::fuzz
