#include "raster/reference/resolve.h"

#include "raster/base/portable_math.h"
#include "raster/reference/fragment_operations.h"

namespace barrido::raster::reference {

float exposed(float c, float scale) { return c * scale; }

float tone_mapped(float c, ToneMap map) {
  if (map == ToneMap::reinhard) {
    c = maximum(c, 0.0f);
    c = c / (1.0f + c);
  }
  return clamp_to_unit(c);
}

float srgb_encoded(float c) {
  return c <= 0.0031308f ? c * 12.92f : 1.055f * portable_pow(c, 1.0f / 2.4f) - 0.055f;
}

float display_channel(const DisplayTransform& display, float c) {
  const float mapped = tone_mapped(exposed(c, display.exposure_scale), display.tone_map);
  return display.srgb_encode ? srgb_encoded(mapped) : mapped;
}

std::uint32_t display_color(const DisplayTransform& display, const Color& color) {
  Color shown = color;
  for (std::size_t c = 0; c < 3; ++c) shown[c] = display_channel(display, color[c]);
  return pack_rgba8(shown);
}

}  // namespace barrido::raster::reference
