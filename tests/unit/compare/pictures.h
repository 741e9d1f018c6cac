// Pictures that the tests of comparisons make, and folders for them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "pipeline/pictures/image_io.h"
#include "pipeline/pictures/stored_picture.h"
#include "tests/unit/scene/image_test_support.h"

namespace barrido::compare::test {

using scene::test::Bytes;
using scene::test::TemporaryFolder;

/// A byte of channel c (0..2) at (x, y) from the upper left corner.
using ByteAt = std::function<int(int x, int y, int c)>;

/// An opaque picture of bytes.
inline scene::StoredPicture picture_of(int width, int height, const ByteAt& byte_at) {
  scene::StoredPicture picture{width, height, 3, false, false, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) picture.rgba.push_back(static_cast<float>(byte_at(x, y, c)) / 255.0f);
      picture.rgba.push_back(1.0f);
    }
  }
  return picture;
}

inline scene::StoredPicture flat(int width, int height, int byte) {
  return picture_of(width, height, [byte](int, int, int) { return byte; });
}

/// Writes it as PNG, opaque.
inline void write_png(const std::filesystem::path& path, const scene::StoredPicture& picture) {
  Bytes rgba;
  for (const float value : picture.rgba) rgba.push_back(static_cast<std::uint8_t>(value * 255.0f + 0.5f));
  std::filesystem::create_directories(path.parent_path());
  scene::write_image(path, {picture.width, picture.height, rgba, {}});
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace barrido::compare::test
