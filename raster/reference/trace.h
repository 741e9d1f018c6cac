// What is remembered of a pixel while the reference draws it: every fragment that covers it, with each number
// between interpolation and the frame. Filled by the functions that compute the pixel, so that a trace cannot
// differ from it. Plain records; knows no scene and no light.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "raster/fragments/primitive.h"
#include "raster/reference/arithmetic.h"
#include "raster/reference/planes.h"
#include "raster/reference/spans.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::raster::reference {

/// One texel that a filter read.
struct TexelTrace {
  int i = 0;  ///< Column; −1 and the level's width are the apron.
  int j = 0;
  Color color{};        ///< In [0, 1]; of pictures in sRGB the linear light that is stored.
  float weight = 1.0f;  ///< Within the level; the weights of a level sum to 1.
};

/// What one mip level gave.
struct LevelTrace {
  int probe = 0;  ///< Which of the samples along the footprint, or at its corners.
  int level = 0;
  int width = 0;
  int height = 0;
  std::vector<TexelTrace> texels;  ///< One (nearest), four (linear), or all under the footprint.
  Color color{};                   ///< Filtered, in [0, 1].
};

/// The shape of the pixel on the texture, for filters that follow it.
struct FootprintTrace {
  float along_x[2] = {0, 0};  ///< In texels of level 0, from a pixel to its right neighbour,
  float along_y[2] = {0, 0};  ///< and to the one above.
  int probes = 0;             ///< Samples whose mean is taken; 0: all texels under the footprint.
};

struct SampleTrace {
  int face = 0;    ///< Of a cube map, OpenGL's order; else 0.
  float u = 0.0f;  ///< Place on the face or texture before wrapping; 1 is the width.
  float v = 0.0f;
  float lod = 0.0f;  ///< λ with the unit's bias.
  bool magnified = false;
  std::vector<LevelTrace> levels;  ///< One or two, of each probe.
  std::optional<FootprintTrace> footprint;
  float far_weight = 0.0f;  ///< Share of the second level, in steps of 1/256.
  Color color{};
};

/// Numbers that a stage or a procedure tells beside the records below.
struct Note {
  std::string_view name;
  std::vector<float> values;
};

/// One texture unit's part in a fragment.
struct UnitTrace {
  int unit = 0;
  float coordinates[3] = {0, 0, 0};  ///< As interpolated: (s, t), (s, t, q) or a direction.
  float lod = 0.0f;                  ///< λ without the bias.
  SampleTrace sample;                ///< Of a procedure only its colour.
  std::vector<Note> notes;           ///< Of a procedure.
  Color previous{};                  ///< What the unit got.
  Color result{};                    ///< What its environment made of it, before clamping.
  Color color{};                     ///< What the next one gets.
};

struct FogTrace {
  float distance = 0.0f;
  float fraction = 0.0f;  ///< Share of the fragment's own colour.
  Color color{};          ///< Afterwards.
};

/// From the fragment's light to its colour.
struct ShadingTrace {
  Color lit_primary{};  ///< Before clamping.
  Color lit_secondary{};
  Color primary{};  ///< As the texture units get it.
  Color secondary{};
  std::vector<UnitTrace> maps;  ///< Of stages that read a map; what they made of it stands in the notes.
  std::vector<UnitTrace> units;
  std::optional<Color> sum;  ///< With the secondary colour, where it is added after texturing.
  std::optional<FogTrace> fog;
  Color color{};
  std::vector<Note> notes;  ///< Of stages that have no record of their own.
  /// Where there are maps: the fragment's varyings and what stages made of them and beside them.
  std::vector<float> varyings;
};

/// What the tests and the frame did with a fragment. Later stages are not reached by fragments that fail.
struct FateTrace {
  bool alpha_passed = true;
  bool depth_passed = true;
  float depth_before = 0.0f;
  float depth_after = 0.0f;
  Color before{};         ///< The pixel's colour.
  Color incoming{};       ///< Source colour as blended: clamped in rgba8 frames.
  Color source_factor{};  ///< 1 and 0 when blending is off.
  Color destination_factor{};
  Color blended{};  ///< Before it is stored.
  Color after{};    ///< The pixel's colour as read back.
  int layer = 0;    ///< Of a sorted fragment its place from the farthest on, from 1.
  int turn = 0;     ///< Rises in the order in which fragments reach the pixel.
};

/// A fragment that covers the pixel.
struct FragmentTrace {
  std::size_t chunk = 0;      ///< In the chunks that were given.
  std::size_t primitive = 0;  ///< In the chunk.
  bool back_facing = false;   ///< As its state has to know it; see kBackFacing.
  Span span;                  ///< The piece of scanline, within its tile.
  SpanQuantities along;       ///< Depth, 1/w and varyings along it.
  float depth = 0.0f;
  float q = 1.0f;                ///< 1/w
  std::vector<float> varyings;   ///< Interpolated and perspective-corrected.
  bool outside_scissor = false;  ///< Then nothing below was computed.
  ShadingTrace shading;
  FateTrace fate;
};

struct PixelTrace {
  Color clear{};  ///< The pixel's first colour, as read back.
  float clear_depth = 1.0f;
  std::vector<FragmentTrace> fragments;  ///< In the order in which they reach the pixel.
  Color color{};                         ///< In the end, as the frame's format holds it.
  float depth = 1.0f;
  std::uint32_t color8 = 0;  ///< Packed R, G, B, A after the display transform.
};

/// Draws what `chunks` leave in pixel (x, y) of a frame with these options, and remembers it. Window
/// coordinates, within the frame.
PixelTrace trace_pixel(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
                       const FramebufferOptions& frame, int x, int y);

}  // namespace barrido::raster::reference
