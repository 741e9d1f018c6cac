// Fragments that wait to be blended by depth (an A-buffer: L. Carpenter, "The A-buffer, an antialiased hidden
// surface method", SIGGRAPH 1984), for the pixels of one tile. Enter: fragments that passed their tests, in
// the order of drawing. Leave: the tile's pixels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace barrido::raster {

struct FragmentState;
struct RasterStatistics;
struct TileSurface;
struct TileWorkspace;

/// How many fragments of a pixel wait at most. When one more comes, the farthest of them all is blended at
/// once: it lies over what has been blended so far, and under all that comes.
inline constexpr std::size_t kMaxPixelLayers = 64;

class PixelLayers {
 public:
  /// A fragment of the tile's pixel with its colour as it is blended. Of equally deep ones the first that
  /// came counts as the farthest.
  void add(std::size_t pixel, const FragmentState& state, const std::array<float, 4>& color, float depth,
           TileSurface& surface, RasterStatistics& statistics);

  /// Blends what waits, in each pixel from the farthest to the nearest, after which nothing waits.
  void blend(TileSurface& surface);

 private:
  struct Layer {
    const FragmentState* state;
    std::array<float, 4> color;
    float depth;
    std::int32_t next;  ///< The next farther one of the pixel, or -1.
  };

  std::int32_t take_farthest(std::size_t pixel);

  std::vector<Layer> layers_;
  std::vector<std::int32_t> nearest_;  ///< One a pixel, or -1; empty before the first fragment ever.
  std::vector<std::uint8_t> counts_;
  std::int32_t free_ = -1;  ///< A place in layers_ that nothing stands in, or -1.
};

/// The end of the way for a batch of sorted fragments: alpha test and late depth as for all others, then they
/// wait.
void keep_layers(TileWorkspace& workspace);

}  // namespace barrido::raster
