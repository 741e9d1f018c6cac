// Helpers of the picture tests: a folder that removes itself, reproducible noise, PNG files of every kind
// built by hand, so that the decoder is not tested against itself.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "pipeline/pictures/image_io.h"
#include "temporary_folder.h"

namespace barrido::scene::test {

using Bytes = std::vector<std::uint8_t>;

inline Bytes pixels(const Image& image) { return {image.rgba.begin(), image.rgba.end()}; }

/// A linear congruential generator (Knuth's MMIX constants), the same numbers everywhere.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed) {}
  std::uint32_t next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>(state_ >> 33);
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(next() >> 8); }

 private:
  std::uint64_t state_;
};

inline Bytes noise_rgba(int width, int height, bool opaque, std::uint64_t seed) {
  Noise noise(seed);
  Bytes rgba(static_cast<std::size_t>(width * height) * 4);
  for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = opaque && i % 4 == 3 ? 255 : noise.byte();
  return rgba;
}

inline Bytes bytes_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// The message of the InputError that `action` throws; a test failure when it throws none.
inline std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return {};
}

/// Whether the module that reads `what` can be loaded here.
inline bool module_is_here(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return std::string(error.what()).find("needs the module") == std::string::npos;
  }
  return true;
}

/// A PNG file put together by the specification, with stored (not compressed) deflate blocks.
struct PngFile {
  std::uint32_t width = 1, height = 1;
  std::uint32_t claimed_side = 0;  ///< Not 0: what the header says of both sides instead.
  std::uint8_t bit_depth = 8, color_type = 6;
  bool interlaced = false;
  Bytes palette;       ///< RGB triples
  Bytes transparency;  ///< tRNS
  Bytes filters{0};    ///< Row y is marked with filters[y % size]; the samples are stored as they are.
  int data_chunks = 1;
  /// Sample of channel c at (x, y), in [0, 2^bit_depth).
  std::function<std::uint32_t(std::uint32_t x, std::uint32_t y, int c)> sample;

  Bytes build() const;
};

}  // namespace barrido::scene::test
