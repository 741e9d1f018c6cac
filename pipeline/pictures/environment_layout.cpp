#include "pipeline/pictures/environment_layout.h"

#include <algorithm>
#include <span>

#include "pipeline/pictures/environment_texels.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

/// A cell of a cross, counted from its upper left, and whether its face stands on its head there.
struct Cell {
  int column;
  int row;
  bool upside_down;
};

/// In the order of faces: +X −X +Y −Y +Z −Z.
constexpr std::array<Cell, raster::kCubeFaces> kHorizontalCells{
    {{2, 1, false}, {0, 1, false}, {1, 0, false}, {1, 2, false}, {1, 1, false}, {3, 1, false}}};
constexpr std::array<Cell, raster::kCubeFaces> kVerticalCells{
    {{2, 1, false}, {0, 1, false}, {1, 0, false}, {1, 2, false}, {1, 1, false}, {1, 3, true}}};

/// A square part of a picture as bytes.
std::vector<std::uint8_t> cut_out(const Picture& picture, int left, int top, int size, bool upside_down,
                                  const EnvironmentEncoding& encoding) {
  const TexelReader reader(picture, false);
  // Bytes pass unchanged: as fractions and back.
  const bool floats = reader.holds_floats();
  const TexelEncoder encoder(floats ? portable_exp2(encoding.exposure_ev) : 1.0f, floats && encoding.srgb);
  std::vector<std::uint8_t> face(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4);
  std::uint8_t* out = face.data();
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i, out += 4) {
      const int x = upside_down ? size - 1 - i : i;
      const int y = upside_down ? size - 1 - j : j;
      const auto texel = reader.texel(left + x, top + y);
      for (std::size_t c = 0; c < 3; ++c) out[c] = encoder.color(texel[c]);
      out[3] = TexelEncoder::alpha(texel[3]);
    }
  }
  return face;
}

}  // namespace

int picture_width(const Picture& picture) {
  return std::visit([](const auto& image) { return image.width; }, picture);
}

int picture_height(const Picture& picture) {
  return std::visit([](const auto& image) { return image.height; }, picture);
}

EnvironmentLayout environment_layout(int width, int height) {
  if (width % 4 == 0 && width / 4 * 3 == height) return EnvironmentLayout::horizontal_cross;
  if (height % 4 == 0 && height / 4 * 3 == width) return EnvironmentLayout::vertical_cross;
  if (width % 2 == 0 && width / 2 == height) return EnvironmentLayout::latitude_longitude;
  return EnvironmentLayout::unknown;
}

std::vector<std::uint8_t> environment_face(const Picture& picture, const EnvironmentEncoding& encoding) {
  return cut_out(picture, 0, 0, picture_width(picture), false, encoding);
}

CubeMapImage cube_map_from_cross(const Picture& picture, EnvironmentLayout layout,
                                 const EnvironmentEncoding& encoding) {
  const bool horizontal = layout == EnvironmentLayout::horizontal_cross;
  CubeMapImage cube;
  cube.size = (horizontal ? picture_width(picture) : picture_height(picture)) / 4;
  const auto& cells = horizontal ? kHorizontalCells : kVerticalCells;
  for (std::size_t face = 0; face < cells.size(); ++face) {
    const Cell& cell = cells[face];
    cube.faces_rgba[face] = cut_out(picture, cell.column * cube.size, cell.row * cube.size, cube.size,
                                    cell.upside_down, encoding);
  }
  return cube;
}

}  // namespace barrido::scene
