// Maps as stages of fragments: pictures or procedures that are read before light, and change the normal
// (course T14; Blinn 1978, "Simulation of wrinkled surfaces") or weaken ambient light. Each has a texture
// unit of its own, with coordinates, filters and level of detail like any other. Only fragments that are lit
// have them.
#pragma once

#include <optional>

#include <glm/mat3x3.hpp>

#include "pipeline/state.h"
#include "raster/fragments/fragment_batch.h"
#include "raster/fragments/fragment_stage.h"

namespace barrido::pipeline {

struct DrawPlan;

/// N' = x T + y B + z N with (x, y, z) = (2t − 1)·(strength, strength, 1). T, B and N are taken as they are
/// interpolated, from unit vectors at the vertices, as those who make such maps take them (MikkTSpace).
extern const raster::StageKind kNormalMap;
/// N' = N + D with D = [(N × P_v) F_u − (N × P_u) F_v]/|N|, or the scale-invariant D' (raster::BumpForm).
/// Slopes F_u and F_v are differences over one texel to either side.
extern const raster::StageKind kBumpMap;
/// Makes Meaning::occlusion = 1 + strength·(red − 1).
extern const raster::StageKind kOcclusionMap;

/// The stage that reads the unit before light; none where its role asks for none.
std::optional<raster::FragmentStage> map_stage(const DrawPlan& plan, int unit);

/// Whether the coordinates are places in a plane picture, whose tangents the surface must have.
constexpr bool is_flat(raster::TexcoordKind kind) { return kind != raster::TexcoordKind::direct; }

/// Of a unit with heights in space: column i is the gradient, in eye space, of its coordinate i. Coordinates
/// that are not generated count as the place in object space.
glm::mat3 solid_gradient(const State& state, std::size_t unit);

/// Of a procedure's coordinates, how far to either side its slope is taken.
inline constexpr float kProcedureStep = 1.0f / 512.0f;

/// Where the slopes of a unit are taken, and what a difference of heights is multiplied by.
struct BumpSteps {
  int axes = 2;  ///< Coordinates that have a slope.
  float step[3] = {kProcedureStep, kProcedureStep, kProcedureStep};
  float scale[3] = {1, 1, 1};
};
BumpSteps bump_steps(const raster::TextureUnit& unit, raster::TexcoordKind kind);

// On vectors (kernels/map_stages.cpp), for all fragments of a batch.

using BatchRow = float[raster::kBatchStride];

void apply_normal_map(float strength, const BatchRow* texel, raster::FragmentBatch& batch);
/// to = from + step, times q where that is given.
void shift_coordinate(const float* from, const float* q, float step, int count, float* to);
/// Means of R, G and B.
void take_heights(const BatchRow* texel, int count, float* heights);
/// slope = (slope − heights) · scale
void take_slopes(const float* heights, float scale, int count, float* slope);
void tilt_normals(raster::BumpForm form, const BatchRow* slopes, raster::FragmentBatch& batch);
void tilt_normals_in_space(raster::BumpForm form, const glm::mat3& eye_gradient, const BatchRow* slopes,
                           raster::FragmentBatch& batch);
void apply_occlusion(float strength, const BatchRow* texel, raster::FragmentBatch& batch);

}  // namespace barrido::pipeline
