// barrido-models: writes the files of models/. Only the command line is here.
#include <charconv>
#include <cstdio>
#include <exception>
#include <optional>
#include <string_view>

#include "models/tool/write_models.h"

namespace {

using barrido::models::WriteOptions;

constexpr const char* kUsage =
    "usage: barrido-models FOLDER [--teapot-cells N] [--textures FOLDER]\n"
    "  FOLDER             where the GLB files, textures/ and sky/ are written\n"
    "  --teapot-cells N   cut each of the teapot's 32 patches into N x N cells (1..100, default 10)\n"
    "  --textures FOLDER  embed the PNG files found there in place of newly compressed ones\n";

std::optional<WriteOptions> parse(int count, char** arguments) {
  WriteOptions options;
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument == "--textures" && i + 1 < count) {
      options.textures = arguments[++i];
    } else if (argument == "--teapot-cells" && i + 1 < count) {
      const std::string_view text = arguments[++i];
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), options.teapot_cells);
      if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    } else if (options.folder.empty() && !argument.starts_with('-')) {
      options.folder = argument;
    } else {
      return std::nullopt;
    }
  }
  if (options.folder.empty() || options.teapot_cells < 1 || options.teapot_cells > 100) return std::nullopt;
  return options;
}

}  // namespace

int main(int count, char** arguments) {
  const auto options = parse(count, arguments);
  if (!options) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  try {
    barrido::models::write_models(*options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "barrido-models: %s\n", error.what());
    return 2;
  }
  return 0;
}
