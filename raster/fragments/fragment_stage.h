// A fragment's journey as data: the list of stages between interpolation and the frame. The list is compiled
// once a draw; the vector kernels (shade_batch.cpp), the scalar reference (reference/shading.cpp) and the
// stories of pixels all follow it. A stage may stand before light (a normal is changed), be light, stand in
// place of a texture's picture (a procedure), or after the textures (fog).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "raster/base/stage_profile.h"
#include "raster/fragments/varyings.h"

namespace barrido::raster {

inline constexpr int kBatchCapacity = 128;
/// Every array of a batch may be read and written in whole vectors up to this many elements past its count.
inline constexpr int kBatchPadding = 16;
inline constexpr int kBatchStride = kBatchCapacity + kBatchPadding;

struct FragmentBatch;
struct FragmentStage;
struct FragmentState;
struct TextureUnit;
struct TileWorkspace;

namespace reference {
struct Fragment;
struct ShadingTrace;
struct UnitTrace;
}  // namespace reference

/// The facts of a stage. Both functions give every fragment the same bits, whatever its place in a batch.
struct StageKind {
  std::string_view name;
  Meanings reads = 0;   ///< What it may read; colours are the varyings, or what a stage before made of them.
  Meanings writes = 0;  ///< What it may change.
  /// All fragments of the workspace's batch.
  void (*vector)(const FragmentStage& stage, TileWorkspace& workspace) = nullptr;
  /// One fragment. The numbers are remembered in `trace` unless that is null.
  void (*scalar)(const FragmentStage& stage, reference::Fragment& fragment,
                 reference::ShadingTrace* trace) = nullptr;
  std::string_view story;        ///< What it does, in a sentence for people.
  Stage clock = Stage::texture;  ///< Where its time is counted.
  bool clamps = false;           ///< Leaves colours in [0, 1] where the state clamps them.
};

/// A stage of one draw.
struct FragmentStage {
  const StageKind* kind = nullptr;
  int unit = 0;                      ///< Texture unit, where it belongs to one.
  const void* parameters = nullptr;  ///< Whatever the kind's functions want; must outlive the frame.
  std::array<Varying, 3> reads{};    ///< What the vertices have to give for it.
  Varying makes{};                   ///< What it computes that no vertex gives.
};

/// Where procedures are evaluated: `count` points, in arrays of whole vectors. `extent` is the width, along
/// each coordinate, of the box that a pixel covers there; what is finer must fade.
struct ProcedurePoints {
  int count = 0;
  std::array<const float*, 3> at{};
  std::array<const float*, 3> extent{};
};

/// What makes the texels of a unit in place of a picture: a function of the unit's coordinates. Its
/// parameters are the unit's (TextureUnit::pattern).
struct TextureProcedure {
  std::string_view name;
  int coordinates = 3;  ///< How many it reads: 2 (s, t; the third is ½) or 3 (s, t, r).
  /// texel[channel][point] of all points. @return how often it evaluated noise.
  std::uint64_t (*vector)(const TextureUnit& unit, const ProcedurePoints& points,
                          float (*texel)[kBatchStride]) = nullptr;
  /// The same for one. Remembers what it used in the trace unless that is null.
  std::array<float, 4> (*scalar)(const TextureUnit& unit, const float (&at)[3], const float (&extent)[3],
                                 reference::UnitTrace* trace) = nullptr;
  std::string_view story;
};

/// TextureUnit::pattern: in space, and on a surface with two coordinates.
extern const TextureProcedure kSolidPattern, kSurfacePattern;

/// Takes the colours that light made, the vertices gave or the primitive has, and clamps them.
extern const StageKind kTakeColors;
/// One texture unit: sample or procedure, then the texture environment.
extern const StageKind kApplyTexture;
/// Multiplies the secondary colour by the texels of a unit whose role is `shine`.
extern const StageKind kApplyShine;
/// Adds the secondary colour.
extern const StageKind kAddSecondary;
extern const StageKind kApplyFog;

/// What the stages of a draw are chosen by, beside its state.
struct StageInputs {
  bool color = false;     ///< Vertices give the primary colour,
  bool specular = false;  ///< and the secondary.
  /// Floats of each unit's coordinates; 0: the unit is off.
  std::array<int, kMaxTextureUnits> coordinates{};
};

/// The stages of a draw in order; `before` is light and what comes before it.
std::vector<FragmentStage> make_stages(const FragmentState& state, std::span<const FragmentStage> before,
                                       const StageInputs& inputs);

}  // namespace barrido::raster
