// Random numbers without state: a number for each thing that is counted, the same on every machine, whoever
// asks for it first. Integers only.
#pragma once

#include <cstdint>

namespace barrido {

inline constexpr std::uint32_t kHashOdd1 = 0x9e3779b1u;  ///< 2³² over the golden ratio, made odd.
inline constexpr std::uint32_t kHashOdd2 = 0x85ebca6bu;
inline constexpr std::uint32_t kHashOdd3 = 0xc2b2ae35u;

/// Each bit of the result depends on each of `v`; no two numbers have the same result.
constexpr std::uint32_t mixed(std::uint32_t v) {
  v = (v ^ (v >> 16)) * kHashOdd2;
  v = (v ^ (v >> 13)) * kHashOdd3;
  return v ^ (v >> 16);
}

/// Of two numbers in this order.
constexpr std::uint32_t hash_of(std::uint32_t a, std::uint32_t b) { return mixed(mixed(a * kHashOdd1) + b); }
constexpr std::uint32_t hash_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return hash_of(hash_of(a, b), c);
}

/// The place of `i` < `count` in an order of the numbers below `count` that `key` chooses: a walk through a
/// one-to-one map of the next power of two until it comes to a number below `count`.
constexpr std::uint32_t permuted(std::uint32_t i, std::uint32_t count, std::uint32_t key) {
  std::uint32_t mask = 0;
  int bits = 0;
  while (mask < count - 1) mask = mask << 1 | 1, ++bits;
  const int half = bits > 1 ? bits / 2 : 1;
  do {
    for (std::uint32_t round = 0; round < 4; ++round) {
      const std::uint32_t h = hash_of(key, round);
      i = (i * (h | 1) + (h >> 8)) & mask;
      i ^= i >> half;
    }
  } while (i >= count);
  return i;
}

/// In [0, 1): the upper 24 bits.
constexpr float unit_float(std::uint32_t h) { return static_cast<float>(h >> 8) * 0x1p-24f; }

}  // namespace barrido
