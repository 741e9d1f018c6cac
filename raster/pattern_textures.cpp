// The procedures whose patterns are data (textures/pattern.h): from values to texels, for batches and for
// one.
#include "raster/kernels/kernels.h"
#include "raster/reference/pattern.h"
#include "raster/reference/trace.h"

namespace barrido::raster {
namespace {

/// Each channel of the texels is the mixture of the pattern's two colours.
std::uint64_t make_texels(const TextureUnit& unit, const ProcedurePoints& points,
                          float (*texel)[kBatchStride]) {
  const auto& [dark, light] = unit.pattern.colors;
  const std::uint64_t noise = pattern_values(unit.pattern, points, texel[3]);
  for (std::size_t c = 0; c < 4; ++c) {
    const float step = light[c] - dark[c];
    for (int i = 0; i < points.count; ++i) texel[c][i] = dark[c] + texel[3][i] * step;
  }
  return noise;
}

void remember(const Pattern& pattern, const float (&extent)[3], const reference::PatternTrace& made,
              reference::UnitTrace& trace) {
  trace.notes.push_back({"box of the pixel", {extent[0], extent[1], extent[2]}});
  if (most_octaves(pattern) > 0) {
    trace.notes.push_back({"octaves that a pixel can show", {made.octaves}});
    trace.notes.push_back({"sum of the octaves", {made.sum}});
  }
  if (pattern.kind == PatternKind::wood) trace.notes.push_back({"ring", {made.place}});
  if (pattern.kind == PatternKind::marble) trace.notes.push_back({"layer", {made.place}});
  trace.notes.push_back({"value", {made.value}});
}

std::array<float, 4> make_texel(const TextureUnit& unit, const float (&at)[3], const float (&extent)[3],
                                reference::UnitTrace* trace) {
  const reference::PatternTrace made = reference::pattern_at(unit.pattern, at, extent);
  if (trace != nullptr) remember(unit.pattern, extent, made, *trace);
  const auto& [dark, light] = unit.pattern.colors;
  std::array<float, 4> texel{};
  for (std::size_t c = 0; c < 4; ++c) texel[c] = dark[c] + made.value * (light[c] - dark[c]);
  return texel;
}

constexpr std::string_view kStory = "a texel computed from a point, between two colours";

}  // namespace

constinit const TextureProcedure kSolidPattern{"solid pattern", 3, make_texels, make_texel, kStory};
constinit const TextureProcedure kSurfacePattern{"pattern on a surface", 2, make_texels, make_texel, kStory};

}  // namespace barrido::raster
