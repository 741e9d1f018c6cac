// barrido-golden: draws the scenes of the golden pictures that need more than the command line offers, and
// compares two pictures exactly. Exit status 0 for the same, 1 for different, 2 for what cannot be done.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "pipeline/pictures/image_io.h"
#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

constexpr const char* kUsage =
    "usage: barrido-golden list                             names of all scenes\n"
    "       barrido-golden draw SCENE FILE                  draw one\n"
    "       barrido-golden compare EXPECTED ACTUAL FILE     status 1 when they differ; FILE is then\n"
    "                                                       expected | difference | actual\n";

std::vector<Scene> all_scenes() {
  std::vector<Scene> all;
  for (const auto group : {visibility_scenes, primitive_scenes, lighting_scenes, texture_scenes,
                           texgen_scenes, map_scenes, environment_scenes, fragment_scenes}) {
    for (const Scene& scene : group()) all.push_back(scene);
  }
  return all;
}

void write(const std::filesystem::path& file, int width, int height, const std::uint8_t* rgba) {
  const auto bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
  scene::WriteOptions options;
  options.png_compression = 9;
  scene::write_image(file, {width, height, {rgba, bytes}, {}}, options);
}

int draw(std::string_view name, const std::filesystem::path& file) {
  for (const Scene& scene : all_scenes()) {
    if (scene.name != name) continue;
    Stage stage = scene.frame == nullptr ? Stage() : Stage(scene.frame());
    scene.draw(stage);
    const raster::Framebuffer& frame = stage.finish();
    write(file, frame.width(), frame.height(), reinterpret_cast<const std::uint8_t*>(frame.color8().data()));
    return 0;
  }
  throw std::runtime_error("there is no scene '" + std::string(name) + "'");
}

/// Expected | difference | actual, 2 pixels apart; the difference is opaque, 8 times as large, never
/// below 32.
std::vector<std::uint8_t> side_by_side(const scene::Image& expected, const scene::Image& actual, int& width) {
  const int w = expected.width;
  width = 3 * w + 4;
  std::vector<std::uint8_t> out(static_cast<std::size_t>(width * expected.height) * 4, 255);
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < w; ++x) {
      const auto from = static_cast<std::size_t>(y * w + x) * 4;
      const auto to = static_cast<std::size_t>(y * width + x) * 4;
      const auto second = to + static_cast<std::size_t>(w + 2) * 4;
      const auto third = second + static_cast<std::size_t>(w + 2) * 4;
      const int alpha = std::abs(int{expected.rgba[from + 3]} - int{actual.rgba[from + 3]});
      for (std::size_t c = 0; c < 4; ++c) {
        out[to + c] = expected.rgba[from + c];
        out[third + c] = actual.rgba[from + c];
        const int d = std::max(alpha, std::abs(int{expected.rgba[from + c]} - int{actual.rgba[from + c]}));
        out[second + c] = static_cast<std::uint8_t>(c == 3   ? 255
                                                    : d == 0 ? 0
                                                             : std::min(255, std::max(32, 8 * d)));
      }
    }
  }
  return out;
}

int compare(const std::filesystem::path& expected_file, const std::filesystem::path& actual_file,
            const std::filesystem::path& file) {
  const scene::Image expected = scene::read_image(expected_file);
  const scene::Image actual = scene::read_image(actual_file);
  if (expected.width != actual.width || expected.height != actual.height) {
    std::printf("%d x %d pixels, expected %d x %d\n", actual.width, actual.height, expected.width,
                expected.height);
    return 1;
  }
  std::size_t different = 0;
  int worst = 0;
  for (std::size_t i = 0; i < expected.rgba.size(); i += 4) {
    different += std::memcmp(&expected.rgba[i], &actual.rgba[i], 4) != 0;
    for (std::size_t c = 0; c < 4; ++c)
      worst = std::max(worst, std::abs(int{expected.rgba[i + c]} - int{actual.rgba[i + c]}));
  }
  if (different == 0) return 0;
  int width = 0;
  const auto picture = side_by_side(expected, actual, width);
  write(file, width, expected.height, picture.data());
  std::printf("%zu of %zu pixels differ, by up to %d/255\n", different, expected.rgba.size() / 4, worst);
  return 1;
}

int run(int argc, char** argv) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (command == "list" && argc == 2) {
    for (const Scene& scene : all_scenes()) std::printf("%s\n", scene.name);
    return 0;
  }
  if (command == "draw" && argc == 4) return draw(argv[2], argv[3]);
  if (command == "compare" && argc == 5) return compare(argv[2], argv[3], argv[4]);
  std::fputs(kUsage, stderr);
  return 2;
}

}  // namespace
}  // namespace barrido::golden

int main(int argc, char** argv) {
  try {
    return barrido::golden::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "barrido-golden: %s\n", error.what());
    return 2;
  }
}
