// Finds the files of an environment and has them turned into faces.
#include "pipeline/pictures/environment.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "pipeline/pictures/environment_layout.h"
#include "pipeline/pictures/read.h"

namespace barrido::scene {
namespace {

namespace fs = std::filesystem;

using FaceNames = std::array<const char*, raster::kCubeFaces>;

/// The ways in which the six files are called, in the order of faces; +Z is in front of who stands in
/// OpenGL's own cube.
constexpr std::array<FaceNames, 3> kNamings{{{"px", "nx", "py", "ny", "pz", "nz"},
                                             {"posx", "negx", "posy", "negy", "posz", "negz"},
                                             {"right", "left", "top", "bottom", "front", "back"}}};
constexpr std::array<const char*, 8> kExtensions{".png", ".jpg", ".jpeg", ".exr",
                                                 ".hdr", ".tif", ".tiff", ".tga"};
constexpr std::string_view kPlaceholder = "{face}";

std::string replace_placeholder(std::string text, const std::string& name) {
  for (std::size_t at = text.find(kPlaceholder); at != std::string::npos;
       at = text.find(kPlaceholder, at + name.size())) {
    text.replace(at, kPlaceholder.size(), name);
  }
  return text;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// The path of `pattern` whose {face} is replaced by the name of +X, by the first naming that has such a
/// file.
const FaceNames* find_naming(const std::string& pattern) {
  for (const FaceNames& names : kNamings) {
    if (is_file(replace_placeholder(pattern, names[0]))) return &names;
  }
  return nullptr;
}

/// A pattern with {face} and its naming for the files in a folder.
std::optional<std::pair<std::string, const FaceNames*>> find_in_folder(const fs::path& folder) {
  for (const char* extension : kExtensions) {
    std::string pattern = (folder / (std::string(kPlaceholder) + extension)).string();
    if (const FaceNames* names = find_naming(pattern)) return std::pair{std::move(pattern), names};
  }
  return std::nullopt;
}

/// Six faces, and the texture with its mip levels that is made of them.
void take_faces(const fs::path& path, int size, const ImageLimits& limits) {
  constexpr std::uint64_t kBytes = std::uint64_t{raster::kCubeFaces} * 10;
  const auto side = static_cast<std::uint64_t>(size);
  if (limits.budget != nullptr) limits.budget->take(kBytes * side * side, path.string(), "");
}

CubeMapImage read_six_files(const std::string& pattern, const FaceNames& names,
                            const EnvironmentEncoding& encoding, const ImageLimits& limits) {
  CubeMapImage cube;
  for (std::size_t face = 0; face < names.size(); ++face) {
    const std::string path = replace_placeholder(pattern, names[face]);
    const Picture picture = read_picture(path, limits);
    const int width = picture_width(picture), height = picture_height(picture);
    const std::string size = std::to_string(width) + " × " + std::to_string(height) + " pixels";
    if (width != height) throw InputError(path, "", size + ": a face of a cube map must be square");
    if (face == 0) take_faces(path, width, limits);
    if (face == 0) cube.size = width;
    if (width != cube.size) {
      throw InputError(path, "",
                       size + ", but " + replace_placeholder(pattern, names[0]) + " has " +
                           std::to_string(cube.size) + " a side: the six faces must be of one size");
    }
    cube.faces_rgba[face] = environment_face(picture, encoding);
  }
  return cube;
}

CubeMapImage read_one_file(const fs::path& path, const EnvironmentEncoding& encoding,
                           const ImageLimits& limits) {
  const Picture picture = read_picture(path, limits);
  const int width = picture_width(picture), height = picture_height(picture);
  const EnvironmentLayout layout = environment_layout(width, height);
  take_faces(path, std::max(width, height) / 4, limits);
  switch (layout) {
    case EnvironmentLayout::horizontal_cross:
    case EnvironmentLayout::vertical_cross:
      return cube_map_from_cross(picture, layout, encoding);
    case EnvironmentLayout::latitude_longitude:
      return cube_map_from_latitude_longitude(picture, encoding);
    case EnvironmentLayout::unknown:
      break;
  }
  throw InputError(path.string(), "",
                   std::to_string(width) + " × " + std::to_string(height) +
                       " pixels are neither a cross (4:3 or 3:4) nor latitude-longitude (2:1)");
}

}  // namespace

CubeMapImage read_environment(const fs::path& path, float exposure_ev, bool srgb, const ImageLimits& limits) {
  const EnvironmentEncoding encoding{exposure_ev, srgb};
  const std::string text = path.string();
  if (text.find(kPlaceholder) != std::string::npos) {
    const FaceNames* names = find_naming(text);
    if (names == nullptr) {
      throw InputError(text, "", "no file with px, posx or right in place of " + std::string(kPlaceholder));
    }
    return read_six_files(text, *names, encoding, limits);
  }
  std::error_code error;
  if (!fs::is_directory(path, error)) return read_one_file(path, encoding, limits);
  const auto found = find_in_folder(path);
  if (!found) {
    throw InputError(text, "", "the folder holds no px, posx or right (.png .jpg .exr .hdr .tif .tga)");
  }
  return read_six_files(found->first, *found->second, encoding, limits);
}

}  // namespace barrido::scene
